#pragma once

#include <planish/schema/schema.hpp>

namespace planish::job {

/// Schemas of the makers' input files; the parsers accept nothing else.
const schema::Schema& plates_schema();
const schema::Schema& transition_schema();
const schema::Schema& slits_schema();

}  // namespace planish::job
