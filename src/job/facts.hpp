#pragma once

#include <planish/job/report.hpp>

#include <optional>
#include <string_view>

namespace planish::job {

/// What reports derive from a pattern. Lengths in mm.

std::string_view kind_name(BendKind kind);
std::string_view direction_name(BendDirection direction);
std::string_view severity_name(Severity severity);
std::string_view status_name(Status status);

double outer_cutting_length(const FlatPattern& flat);
double inner_cutting_length(const FlatPattern& flat);

/// The longest segment of the bend line; empty if the bend has no material at its middle.
std::optional<Segment> longest_line(const FlatBend& bend);

/// A report may be incomplete (see Report).
bool sheet_known(const Report& report);
bool flat_known(const Report& report);
bool certificate_known(const Report& report);

/// NaN if not known, which fails comparisons and becomes null in JSON.
double or_nan(const std::optional<double>& value);

}  // namespace planish::job
