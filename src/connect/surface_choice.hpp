#pragma once

#include "bend_fit.hpp"
#include "general_fit.hpp"
#include "pair_search.hpp"

namespace planish::connect_detail {

/// The mid-surface of a bend, with its tangent line and the plate extension that it takes.
struct ChosenSurface {
  BendSurface surface;
  TangentLine line;            ///< of general cones that of the first plate
  std::optional<double> apex;  ///< of general cones
  double extension_area = 0.0;
  bool round_end = false;  ///< its far end goes from tip to tip (math.md#choice-of-surface)
};

/// Whether a request leaves open of what kind the surface is.
bool leaves_surface_free(const BendRequest& request);

/// The surface that the request asks for; if it leaves that free, the one of least extension of
/// cylinder, right cone and general cone, and the simpler one where they are equal
/// (math.md#choice-of-surface). Errors: those of `connect` for one bend.
Result<ChosenSurface> chosen_surface(const FitTask& task, const PairChoice& choice,
                                     const ConnectOptions& options);

/// Whether a general cone may need so much less extension than `right`, mm², of a cylinder or right
/// cone that it is taken in its place.
bool saves_extension(const std::array<std::vector<Vec2>, 2>& corners, double right,
                     const ConnectOptions& options);

/// The lines of a general cone if it needs so much less extension than `right` that it is taken.
std::optional<GeneralLines> less_extended(const std::array<std::vector<Vec2>, 2>& corners,
                                          double right, const ConnectOptions& options);

}  // namespace planish::connect_detail
