#pragma once

#include "tangent_openings.hpp"

namespace planish::brep {

/// A part of a window's outline that is cut along the other skin, where it is narrower.
struct FarRun {
  LoopRun here;              ///< of the reference skin
  std::vector<CoEdge> uses;  ///< of the other skin, as the face here runs along them

  /// The use of the loop here for which one across counts; −1 if there are fewer.
  int stands_for(int use, std::ptrdiff_t of_loop) const {
    return use < here.count ? static_cast<int>((here.first + use) % of_loop) : -1;
  }
};

/// Those of all windows over bends whose walls lean one way only, so that the other skin lets
/// nothing through beyond its own outline. May throw the kernel's exceptions.
std::vector<FarRun> far_runs(const Recognition& of);

/// The run at a use of a loop; null if it is cut along the reference skin.
const FarRun* far_run_at(const Recognition& of, const LoopRef& ref, int use);

/// The part of the rim along the outline: the largest one. Requires a part.
int outermost(const Recognition& of);

}  // namespace planish::brep
