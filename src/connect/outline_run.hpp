#pragma once

#include "bend_fit.hpp"

#include <utility>

namespace planish::connect_detail {

/// The run of edges, given by their numbers, between two points of the plate on the first and the
/// last of them, in the order of the edges.
OutlineRun outline_run(const PlacedPlate& plate, const std::vector<int>& edges,
                       const std::pair<Vec3, Vec3>& ends);

/// The run of a bend that joins one edge along its tangent ruling, without what its lateral
/// boundaries leave free of the edge, so that this can carry another bend. A rest shorter than the
/// thickness stays with the run.
OutlineRun trimmed(const OutlineRun& run, const PlacedPlate& plate, const BendSurface& surface,
                   const Boundaries& boundaries, int side, double thickness);

/// The outline and the holes of a plate where `surface.local` has them.
std::vector<std::vector<Vec2>> local_rings(const PlacedPlate& plate, const BendSurface& surface,
                                           int side);

/// Marks what a run uses.
void take(const PlacedPlate& plate, const OutlineRun& run, UsedEdges& used);

/// Puts a chain's edges, or parts of them, into `parts`, as chains that end where it is told.
class ChainParts {
 public:
  ChainParts(EdgeKind kind, std::vector<Chain>& parts) : part_{kind, {}, {}}, parts_(parts) {}

  void add(const Vec2& from, const Vec2& to, int edge);
  void end();

 private:
  Chain part_;
  std::vector<Chain>& parts_;
};

/// The chains of a side without the parts of edges that are taken. A rest shorter than `least` is
/// left out.
std::vector<Chain> free_chains(const std::vector<Chain>& chains,
                               const std::map<int, EdgeParts>& taken, const PlacedPlate& plate,
                               const BendFrame& frame, int side, double least);

}  // namespace planish::connect_detail
