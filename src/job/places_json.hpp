#pragma once

#include <planish/inspect/findings.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/schema.hpp>
#include <planish/schema/units.hpp>

#include <optional>
#include <vector>

namespace planish::job {

using schema::Field;
using schema::Json;
using schema::Schema;
using schema::Units;

/// formats.md#places: `{ "kind", "id", "at" }`, without `id` for a point, without `at` where it is
/// not known.
Json place_json(const Place& place, const Units& units);
Json places_json(const std::vector<Place>& places, const Units& units);

/// `{ "name": { "value", "unit" } }`; values keep the unit that they state.
Json numbers_json(const std::vector<NamedQuantity>& numbers);

/// The pieces of a sentence, where one names an option or a place; else none.
Json wording_json(const std::vector<Piece>& pieces, const Units& units);

/// Adds `remedy`, the first, and `remedies` if there are several.
void add_remedies(Json& json, const std::vector<Remedy>& remedies);

/// formats.md#reason, its places in `units`; null without an error.
Json reason_json(const std::optional<Error>& error, const Units& units);

/// One of `checks`.
Json check_json(const Finding& finding, const Units& units);

/// What these write.
std::vector<Field> place_fields();
Schema wording_schema();
Schema numbers_schema();
std::vector<Field> remedy_fields();

}  // namespace planish::job
