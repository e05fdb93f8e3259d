#pragma once

#include "silhouette.hpp"

namespace planish::brep {

/// A face of the solid as a face of the sheet, its part not yet set: on the surface of `leader`,
/// which represents its group; the outer loop first.
struct ReadFace {
  Face face;
  /// By loop of the solid's face: its loop in `face`, and by edge use its border (−1: it is not
  /// cut) and the loop of that, if a silhouette has parted them.
  struct Loop {
    int place = 0;
    std::vector<int> borders;
    std::vector<int> places = {};
    bool widened = false;  ///< cut wider than the skin's own outline, see `widest_edge`

    int place_of(std::size_t use) const { return places.empty() ? place : places[use]; }
  };
  std::vector<Loop> loops;
  std::optional<Silhouette> silhouette;  ///< that some of its loops are taken from
  /// By `Recognition::tangent_openings`, with their outline on this face: the borders of its outer
  /// loop along the tangent line, one or two; and where the loop and border of the cut begin.
  std::map<int, std::vector<int>> bridges;
  std::map<int, std::pair<int, int>> openings;
};
ReadFace read_face(const Recognition& of, int face, int leader);

/// The face with its borders moved along u by the whole turns nearest to `by`.
Face turned_by(Face face, double by);

}  // namespace planish::brep
