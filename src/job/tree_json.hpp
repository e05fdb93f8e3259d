#pragma once

#include <planish/job/report.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/schema.hpp>

namespace planish::job {

/// How the sheet hangs together (formats.md#tree): its parts, each after the part that it is joined
/// to, with the places of flanges in space. The root comes first.
schema::Json tree_json(const Report& report, const schema::Units& units);
schema::Schema tree_schema();

}  // namespace planish::job
