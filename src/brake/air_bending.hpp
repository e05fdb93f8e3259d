#pragma once

#include "workpiece.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/brake/plan.hpp>
#include <planish/brake/tools.hpp>

namespace planish::brake_detail {

inline constexpr double kWritten = tolerance::kWrittenDigits;  ///< mm, radians: sizes of tools
inline constexpr double kMillimetres = 1000.0;                 ///< in a metre: N/mm times mm are N

/// The V opening for a thickness: 6 T up to 2.5 mm, 8 T to 8 mm, 10 T above.
double wanted_opening(double thickness);

/// The narrowest and the widest V that are taken unasked: 4 T, 12 T.
double narrowest_opening(double thickness);
double widest_opening(double thickness);

/// The V that is wanted for a line: as given; of a large radius R 2.2 R + 2 T if there is a punch
/// of it, else the one that leaves it in air bending; or that for the thickness.
double wanted_opening(const BrakeLine& line, const BrakeTools& tools, const PlanOptions& options);

/// Force of air bending, N per mm of line, which is kN per metre.
double force_per_length(double tensile_strength, double thickness, double opening);

/// Of closing a hem: four times that of bending over the wanted V, as shops reckon.
double closing_force(double tensile_strength, double thickness);

/// kN that a stroke on a line takes over a die: of air bending, or of closing a hem.
double force_of(const BrakeLine& line, const Die& die, const PlanOptions& options);

/// The largest angle of punch and die that bend a line as far as it goes, radians.
double largest_tool_angle(const BrakeLine& line, const PlanOptions& options);

/// Whether the V of a die is sharp enough for a line.
bool is_sharp_for(const BrakeLine& line, const Die& die, const PlanOptions& options);

/// The inside radius that is left: that of air bending over the V, or the tip's.
double made_radius(const Punch& punch, const Die& die, const PlanOptions& options);

/// Whether a radius is met in practice: within a third of the drawn one.
bool meets(double made, double drawn);

/// Whether the widest usual V leaves less than two thirds of a drawn radius.
bool is_large_radius(double radius, double thickness, const PlanOptions& options);

}  // namespace planish::brake_detail
