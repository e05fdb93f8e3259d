#pragma once

#include "bend_fit.hpp"

namespace planish::connect_detail {

/// The further stretches of an interrupted bend: wherever free edges of both plates lie on the
/// tangent lines of `fit` and opposite each other, apart from the stretch that it has already.
/// `task` is that of the fit, with all that bends use by now. Cylinders and right cones have such
/// stretches; none is shorter than the thickness.
std::vector<BendBand> further_stretches(const BendFit& fit, const FitTask& task);

/// Makes one of stretches between which an edge of one plate goes on unbroken: the bend goes on
/// along it, past the recess of the other plate. `bands` holds that of the fit too.
std::vector<BendBand> merged_stretches(std::vector<BendBand> bands, const BendFit& fit,
                                       const FitTask& task);

/// What the edges of both plates on the tangent lines of `fit` leave free, by side; `task` as
/// above, with the stretches.
std::array<double, 2> unused_edges(const BendFit& fit, const FitTask& task);

}  // namespace planish::connect_detail
