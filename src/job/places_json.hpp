#pragma once

#include "json_parts.hpp"
#include "schema.hpp"

#include <planish/inspect/findings.hpp>

#include <vector>

namespace planish::job {

/// formats.md#places: `{ "kind", "id", "at" }`, without `id` for a point, without `at` where it is
/// not known.
Json place_json(const Place& place, const Units& units);
Json places_json(const std::vector<Place>& places, const Units& units);

/// `{ "name": { "value", "unit" } }`; values keep the unit that they state.
Json numbers_json(const std::vector<NamedQuantity>& numbers);

/// Adds `remedy`, the first, and `remedies` if there are several.
void add_remedies(Json& json, const std::vector<Remedy>& remedies);

/// One of `checks`.
Json check_json(const Finding& finding, const Units& units);

/// What these write.
std::vector<Field> place_fields();
Schema numbers_schema();
std::vector<Field> remedy_fields();

}  // namespace planish::job
