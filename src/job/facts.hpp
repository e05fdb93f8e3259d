#pragma once

#include <planish/job/unfold.hpp>

#include <optional>
#include <string_view>

namespace planish::job {

/// What reports say of a pattern and do not find in it ready-made. Lengths in mm.

std::string_view kind_name(BendKind kind);
std::string_view direction_name(BendDirection direction);
std::string_view severity_name(Severity severity);
std::string_view status_name(Status status);

double outer_cutting_length(const FlatPattern& flat);
double inner_cutting_length(const FlatPattern& flat);

/// The longest piece of the bend line; none where the bend has no material at its middle.
std::optional<Segment> longest_line(const FlatBend& bend);

/// A report may hold part of the story only (see UnfoldReport).
bool sheet_known(const UnfoldReport& report);
bool flat_known(const UnfoldReport& report);
bool certificate_known(const UnfoldReport& report);

}  // namespace planish::job
