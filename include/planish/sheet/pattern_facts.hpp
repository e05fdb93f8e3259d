#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace planish {

/// What reports and drawings derive from a pattern. Lengths in mm.

std::string_view kind_name(BendKind kind);
std::string_view direction_name(BendDirection direction);
double outer_cutting_length(const FlatPattern& flat);
double inner_cutting_length(const FlatPattern& flat);
/// How many slits: lines and arcs that go on where the one before ends are one.
int slit_count(const FlatPattern& flat);

/// The longest segment of the bend line; empty if the bend has no material at its middle.
std::optional<Segment> longest_line(const FlatBend& bend);

/// "2 countersinks up, 1 pocket down": the usual reason why flat area times thickness differs from
/// the volume. Empty without forms.
std::string forms_text(const FlatPattern& flat);

}  // namespace planish
