#pragma once

#include "stage_cache.hpp"

#include <vector>

namespace planish::brake_detail {

/// All strokes that may be made in a stage: the lines that lie on one line pressed together, and
/// each of them alone; with each pair of tools that fits, towards both sides. Gauged wherever an
/// edge reaches the gauge. A hem is closed once it is bent.
std::vector<StrokeChoice> choices(StageCache& cache, const LineSet& formed);

/// What covers the choices of all stages (`StrokeProblem::possible`).
std::vector<StrokeChoice> possible(const StrokeInputs& inputs);

/// Whether everything on one side of what is pressed is formed: bending from the outside in.
bool is_outermost(StageCache& cache, const LineSet& formed, const StrokeChoice& choice);

}  // namespace planish::brake_detail
