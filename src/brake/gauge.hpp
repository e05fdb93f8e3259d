#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

struct GaugeEdge;

/// Where the back gauge may touch in the stage before a stroke. What is found out for some tools
/// counts for others too. The cache, and the stage of the stroke, must outlive it.
class GaugeStops {
 public:
  static constexpr double kLeastTouching = 0.5;  ///< of a finger's width, and of the sheet's edge

  /// `openings`: as last resort fingers may touch in one.
  GaugeStops(StageCache& cache, const Setting& stroke, bool openings);
  GaugeStops(StageCache& cache, const Setting& stroke)
      : GaugeStops(cache, stroke, cache.inputs().options.gauge_openings) {}
  ~GaugeStops();

  /// Whether a finger reaches and touches something that these tools leave free: an edge, the outer
  /// face or the fold of what is formed, or, where the options ask for it, the edge of an opening.
  bool touch(int punch, int die);

  /// Where: at the longest edge along a finger's width, else at what is formed, else over an end;
  /// of these the first at which the fingers hold the sheet square, else that at which they stand
  /// farthest apart; only else in an opening. Empty if `touch` is false (math.md#gauging).
  std::optional<GaugeStop> best(int punch, int die);

  /// A place that all but these tools leave free.
  struct InTool {
    double away = 0.0;  ///< of the edge from the bend line
    ToolKind kind = ToolKind::die;
  };
  std::optional<InTool> in_tool(int punch, int die);

 private:
  struct Place;
  static constexpr int kFirstInOpenings = 4, kKinds = 6;  ///< of places
  void add(std::vector<GaugeEdge> edges, bool by_nose, double share);
  bool add_next();
  static bool stand_side_by_side(const Place& a, const Place& b);
  const std::vector<Interval>& room_at(Place& place);
  double held(const Place& at, int punch, int die);
  bool is_clear_of(ToolKind kind, int tool, const Place& place);
  std::optional<ToolKind> tool_at(Place& place, int punch, int die);

  StageCache& cache_;
  Setting stroke_;
  const std::optional<BackGauge>& gauge_;
  bool openings_;
  int kind_ = 0;  ///< of places that come next
  std::vector<Place> places_;
};

/// How much of a finger's width touches at least where it stands over an end: half of it, or what
/// holds the sheet square if that is less, mm.
double least_touch(StageCache& cache, const Setting& stroke);

/// The best place with the tools of the stroke, and whether there is any: quicker.
std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke);
bool is_gauged(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
