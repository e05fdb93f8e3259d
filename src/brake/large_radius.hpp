#pragma once

#include "workpiece.hpp"

#include <planish/brake/plan.hpp>

#include <vector>

namespace planish::brake_detail {

/// The bumps by which a bend of a radius and an allowance is formed, so that the drawn radius lies
/// within `chord_error` of the plane pieces between them (math.md#large-radii). At least two; no
/// closer than one thickness, which may leave a larger error.
LargeBend bumps_of(Angle angle, double radius, double allowance, double thickness,
                   double chord_error);

/// How each bend of a radius that no usual V leaves is formed. Bends with press lines are not
/// asked: these are how they are pressed. What the options know stays.
std::vector<LargeBend> large_bends(const Sheet& sheet, const Layout& layout,
                                   const BrakeTools& tools, const PlanOptions& options);

/// Takes the next way to form a bend that has no room for this one: bumps instead of a V, rolls
/// instead of bumps; false if the way was asked for or there is no other.
bool take_next(std::vector<LargeBend>& large, BendId bend, const Sheet& sheet, const Layout& layout,
               const PlanOptions& options);

/// Whether there is such a way for any.
bool has_next(const std::vector<LargeBend>& large, const PlanOptions& options);

/// Takes the next way for those among the bends that no order formed; where there are none, for
/// all, since what stays flat is in no other bend's way. False if there is no other way.
bool take_next(std::vector<LargeBend>& large, const std::vector<BendId>& unformed,
               const Sheet& sheet, const Layout& layout, const PlanOptions& options);

}  // namespace planish::brake_detail
