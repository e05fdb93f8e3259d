// Why a stroke has no gauge: the first of these that holds. There is none; nothing faces it, or
// only on the other side; what does is out of its reach, too little of it is touched, it is too
// short, it is in a tool; else the part is in the way (math.md#gauging).
#include "ungauged.hpp"

#include "gauge.hpp"
#include "gauge_edges.hpp"
#include "sentences.hpp"

#include <algorithm>
#include <iterator>

namespace planish::brake_detail {
namespace {

/// A flange that fingers would touch, or touch more of, if they went higher or lower.
bool is_beyond_lift(const GaugeEdge& face, const BackGauge& gauge) {
  return !is_touched(face) && (face.height == gauge.lowest || face.height == gauge.highest);
}

/// Edges and faces on the gauge's side of the line.
std::vector<GaugeEdge> all_facing(StageCache& cache, const Setting& stroke,
                                  const BackGauge& gauge) {
  std::vector<GaugeEdge> all = edges_facing(cache, stroke);
  if (!cache.inputs().options.gauge_openings) std::erase_if(all, &GaugeEdge::in_opening);
  std::ranges::move(formed_facing(cache, stroke, gauge), std::back_inserter(all));
  return all;
}

/// Of faces that are touched too little: that the fingers' lift ends before one, or that there is
/// nothing else.
std::optional<Remark> untouched(const std::vector<GaugeEdge>& edges, const BackGauge& gauge) {
  const auto beyond = std::ranges::find_if(
      edges, [&](const GaugeEdge& edge) { return is_beyond_lift(edge, gauge); });
  if (beyond != edges.end())
    return remark_of(say::face_beyond_lift, {{"away", beyond->away, unit::mm},
                                             {"least", beyond->needed, unit::mm},
                                             {"lowest", gauge.lowest, unit::mm},
                                             {"highest", gauge.highest, unit::mm}});
  if (std::ranges::none_of(edges, is_touched))
    return remark_of(say::face_too_low, {{"away", edges.front().away, unit::mm},
                                         {"touched", edges.front().touched, unit::mm},
                                         {"least", edges.front().needed, unit::mm}});
  return std::nullopt;
}

/// The stop in an opening on either side that would do, and that nobody asked for.
std::optional<GaugeStop> opening_that_would_do(StageCache& cache, Setting stroke) {
  if (cache.inputs().options.gauge_openings) return std::nullopt;
  for (const int turn : {1, -1}) {
    stroke.direction *= turn;
    if (auto stop = GaugeStops(cache, stroke, true).best(stroke.punch, stroke.die)) return stop;
  }
  return std::nullopt;
}

/// Of edges on both sides that are, the one that lacks least.
Remark out_of_range(std::vector<GaugeEdge> edges, const BackGauge& gauge) {
  std::erase_if(edges, [&](const GaugeEdge& edge) { return is_in_range(edge, gauge); });
  const GaugeEdge nearest = *std::ranges::min_element(edges, {}, [&](const GaugeEdge& edge) {
    return std::max({gauge.from - edge.away, edge.away - gauge.to, 0.0});
  });
  return remark_of(nearest.flange ? say::face_out_of_range : say::edge_out_of_range,
                   {{"away", nearest.away, unit::mm},
                    {"from", gauge.from, unit::mm},
                    {"to", gauge.to, unit::mm}});
}

Remark what_is_untouched(StageCache& cache, const Setting& stroke) {
  const auto& machine = cache.inputs().tools.machine;
  if (!machine.gauge) return remark_of(say::no_back_gauge);
  const BackGauge& gauge = *machine.gauge;
  std::vector<GaugeEdge> edges = all_facing(cache, stroke, gauge);
  Setting told = stroke;
  if (edges.empty()) {  // the sheet lies either way
    told.direction = -stroke.direction;
    edges = all_facing(cache, told, gauge);
    if (is_gauged(cache, told)) return remark_of(say::edge_on_other_side);
  }
  if (edges.empty())
    return remark_of(has_edge_aside(cache, stroke) ? say::edge_leans : say::no_parallel_edge);
  if (std::ranges::none_of(edges, [&](const GaugeEdge& one) { return is_in_range(one, gauge); })) {
    told.direction = -told.direction;
    std::ranges::move(all_facing(cache, told, gauge), std::back_inserter(edges));
    return out_of_range(edges, gauge);
  }
  std::erase_if(edges, [&](const GaugeEdge& edge) { return !is_in_range(edge, gauge); });
  if (const auto faces = untouched(edges, gauge)) return *faces;
  std::erase_if(edges, [](const GaugeEdge& edge) { return !is_touched(edge); });
  const double longest = std::ranges::max_element(edges, {}, &GaugeEdge::length)->length();
  const double least = least_touch(cache, stroke);
  if (longest < least)
    return remark_of(say::edge_too_short,
                     {{"longest", longest, unit::mm}, {"least", least, unit::mm}});
  if (const auto in = GaugeStops(cache, told).in_tool(stroke.punch, stroke.die))
    return remark_of(say::finger_in_tool,
                     {{"away", in->away, unit::mm},
                      {"tool", text_of(cache.tools().name(in->kind, tool_of(in->kind, stroke)))}});
  return remark_of(say::finger_blocked);
}

}  // namespace

Remark why_ungauged(StageCache& cache, const Setting& stroke) {
  Remark why = what_is_untouched(cache, stroke);
  if (const auto stop = opening_that_would_do(cache, stroke))
    say_after(why.told, "; ",
              tell(stop->by_nose ? say::nose_would_touch : say::fingers_would_touch, {}));
  return why;
}

}  // namespace planish::brake_detail
