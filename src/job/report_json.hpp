#pragma once

#include <planish/job/unfold.hpp>
#include <planish/schema/json_parts.hpp>

#include <functional>
#include <string_view>

namespace planish::job {

/// A whole report as defined in formats.md#report.
schema::Json report_value(const UnfoldReport& report);

/// The ends of a line: [[x, y], [x, y]].
schema::Json line_json(const Segment& line, const schema::Units& units);

/// Whether a report lists its bends one by one.
enum class BendList { shown, left_out };

/// Keys that a command adds to those that every bend has.
using BendDetails = std::function<void(schema::Json& bend, const FlatBend& flat)>;
/// The first keys of every report, then those from "units" to the end; a command may put its own
/// between them.
schema::Json begun_report(const Report& report, std::string_view command);
void finish_report(schema::Json& json, const Report& report, BendList bends = BendList::shown,
                   const BendDetails& details = {});

}  // namespace planish::job
