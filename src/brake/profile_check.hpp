#pragma once

#include <planish/base/message.hpp>
#include <planish/brake/tools.hpp>

#include <optional>
#include <string>

namespace planish::brake_detail {

/// What is wrong, with what its refusal needs except the subject, and where below the profile
/// ("/3", or "").
struct ProfileFault {
  std::string where;
  const Refusal& refusal;
  Facts facts = {};
};

/// Why a profile is not the outline of a body, run counter-clockwise: corners missing, not finite
/// or repeated, an outline that touches itself, no area, run clockwise. O(n²) for n corners.
std::optional<ProfileFault> fault_of(const ToolProfile& profile);

/// Corners nearer to each other than this are one, mm: the digits in which profiles are written.
double corner_tolerance(const ToolProfile& profile);

/// The corner at a place, and the one at fault if it is not there; see `corner_tolerance`.
std::optional<std::size_t> corner_at(const ToolProfile& profile, const Vec2& place);

/// Whether a place is on the outline.
bool on_outline(const ToolProfile& profile, const Vec2& place);

/// Angle within the body at a corner of a counter-clockwise profile, radians, in (0, 2π).
double angle_within(const ToolProfile& profile, std::size_t corner);

/// Why a radius cannot round a corner: what it takes of the edges beside it is longer than they
/// are. Straight corners take nothing.
std::optional<ProfileFault> fault_of_rounding(const ToolProfile& profile, std::size_t corner,
                                              double radius);

}  // namespace planish::brake_detail
