#pragma once

#include "schema.hpp"

namespace planish::job {

/// Schemas of the makers' input files; the parsers accept nothing else.
const Schema& plates_schema();
const Schema& transition_schema();
const Schema& slits_schema();
const Schema& rules_schema();
const Schema& material_schema();
const Schema& tools_schema();
const Schema& shop_schema();

}  // namespace planish::job
