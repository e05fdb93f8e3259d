#pragma once

#include "bend_fit.hpp"

namespace planish::connect_detail {

/// Whether the request is for a fold of inside radius 0.
bool asks_for_fold(const BendRequest& request);

/// A fold of inside radius 0 along an edge that both plates have on the line where their planes
/// meet: the longest such stretch of free edges, or the edges given. The sheets are cut back to
/// where their inner skins meet. Errors: `no_bend_fits`, `overlap` (a plate has no room for that).
Result<BendFit> fit_fold(const FitTask& task, const ConnectOptions& options);

}  // namespace planish::connect_detail
