#pragma once

#include "mould_clear.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/slit/mould.hpp>

#include <array>
#include <vector>

namespace planish::slit_detail {

/// A rib is narrower than this share of its strip nowhere; what would be is bare.
constexpr double kNarrowestRib = 0.25;

bool has_rib(const WholeStrip& strip, int quad);

/// Shares of the width that the rib of quads `first` to `last` leaves to others at the ridge `at`,
/// left and right.
std::array<double, 2> left_at(const WholeStrip& strip, int first, int last, int at);

/// Narrows ribs where they come up through strips, until they are `clearance` (mm) beside them, or
/// leaves quads without one. `through`: as `ribs_through` finds them; `offset`: half the thickness.
void make_room(std::vector<std::vector<WholeStrip>>& strips, const std::vector<RibThrough>& through,
               const Frame& plan, double offset, double clearance);

}  // namespace planish::slit_detail
