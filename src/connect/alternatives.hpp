#pragma once

#include "bend_fit.hpp"

namespace planish::connect_detail {

/// The other efficient ways to join the plates of a task (math.md#efficient-bends), the widest
/// first: at most `options.alternatives`, the shortest always among them. Those on the edges of
/// `taken` are left out.
std::vector<BendAlternative> alternatives_to(const FittedBend& taken, const FitTask& task,
                                             const ConnectOptions& options);

}  // namespace planish::connect_detail
