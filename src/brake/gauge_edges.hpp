#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

/// What a finger may touch, in the frame of the line: an edge that faces the gauge, a level line on
/// the outer face of a flange that stands upright, or the fold of one that leans back over the
/// sheet, as that of a hem.
struct GaugeEdge {
  double away = 0.0;  ///< from the bend line
  Interval along;
  Segment in_pattern;
  bool in_opening = false;
  double height = 0.0;                  ///< of the finger
  std::optional<FlangeId> flange = {};  ///< of whose outer face it is a level line
  double touched = 0.0, needed = 0.0;   ///< of that face, across the line
  std::optional<BendId> fold = {};      ///< whose fold it is

  double length() const { return along.hi - along.lo; }
  bool is_formed() const { return flange || fold; }
};

bool is_in_range(const GaugeEdge& edge, const BackGauge& gauge);

/// Whether a finger touches enough of a face.
inline bool is_touched(const GaugeEdge& edge) { return edge.touched >= edge.needed; }

/// The front of a finger, from its lowest to its highest corner there.
Interval front_of(const BackGauge& gauge);

/// The straight edges of all flat parts that face the gauge, parallel to the line; those on one
/// line are one, also beyond gaps so wide.
std::vector<GaugeEdge> edges_facing(StageCache& cache, const Setting& stroke, double gap = 0.0);

/// Level lines on the outer faces of upright flanges, where a finger comes nearest to touching them
/// with all its front (of some it may touch nothing), and folds that its front touches.
std::vector<GaugeEdge> formed_facing(StageCache& cache, const Setting& stroke,
                                     const BackGauge& gauge);

/// Whether a straight edge on some formed flange is parallel to the line.
bool has_edge_aside(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
