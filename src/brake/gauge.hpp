#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

struct GaugeEdge;

/// Where the back gauge may touch in the stage before a stroke: for the best place with any tools
/// what is found out of others counts too. The cache, and the stage of the stroke, must outlive it.
class GaugeStops {
 public:
  /// `openings`: as last resort the nose may touch in one.
  GaugeStops(StageCache& cache, const Setting& stroke, bool openings);
  GaugeStops(StageCache& cache, const Setting& stroke)
      : GaugeStops(cache, stroke, cache.inputs().options.gauge_openings) {}
  ~GaugeStops();

  /// The longest edge that a finger reaches and touches along its width, else the outer face of an
  /// upright flange, else, where the options ask for it, the edge of an opening that the nose
  /// touches; empty if there is none that these tools leave free, or no gauge (math.md#gauging).
  std::optional<GaugeStop> with(int punch, int die);

  /// A place that all but these tools leave free.
  struct InTool {
    double away = 0.0;  ///< of the edge from the bend line
    ToolKind kind = ToolKind::die;
  };
  std::optional<InTool> in_tool(int punch, int die);

 private:
  struct Place;
  void add(std::vector<GaugeEdge> edges, bool by_nose, double share);
  bool add_next();
  bool has_room_at(Place& place);
  bool is_clear_of(ToolKind kind, int tool, const Place& place);
  std::optional<ToolKind> tool_at(Place& place, int punch, int die);

  StageCache& cache_;
  Setting stroke_;
  const std::optional<BackGauge>& gauge_;
  bool openings_;
  int kind_ = 0;  ///< of places that come next
  std::vector<Place> places_;
};

/// The same with the tools of the stroke.
std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke);

/// Why there is none: goes on from "the back gauge has nothing to touch:".
Remark why_ungauged(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
