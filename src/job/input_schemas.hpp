#pragma once

#include "schema.hpp"

namespace planish::job {

/// What the files that makers read must hold; the parsers take nothing else.
const Schema& plates_schema();
const Schema& transition_schema();
const Schema& slits_schema();
const Schema& rules_schema();

}  // namespace planish::job
