// Where the back gauge touches. Straight borders of what lies in the plane of the sheet that face
// the gauge, neighbours on one line as one, are tried from the longest on; at each the finger's
// section is swept over all parts, and the edge must be clear over a finger's width
// (math.md#gauging).
#include "gauge.hpp"

#include "sentences.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kParallel = 0.1 * 3.14159265358979 / 180.0;  // edges that a finger touches flat
constexpr double kOneEdge = 1e-3;                             // mm: edges that go on

/// An edge that faces the gauge, in the frame of the line.
struct GaugeEdge {
  double away = 0.0;  ///< from the bend line
  Interval along;
  Segment in_pattern;
};

/// The edges of a body or zone, seen from the line; `left`: those that face away to the left.
void add_gauge_edges(const std::vector<FreeEdge>& edges, const Eigen::Isometry3d& frame, bool left,
                     std::vector<GaugeEdge>& found) {
  for (const FreeEdge& edge : edges) {
    const Vec3 a = frame * Vec3(edge.a.x(), edge.a.y(), 0.0),
               b = frame * Vec3(edge.b.x(), edge.b.y(), 0.0);
    const Vec2 outward(edge.b.y() - edge.a.y(), edge.a.x() - edge.b.x());
    const double out = (frame.linear() * Vec3(outward.x(), outward.y(), 0.0)).y();
    if (std::abs(b.y() - a.y()) > std::tan(kParallel) * std::abs(b.x() - a.x())) continue;
    if ((left ? out : -out) <= 0.0) continue;
    const double away = left ? std::max(a.y(), b.y()) : std::max(-a.y(), -b.y());
    found.push_back({away, {std::min(a.x(), b.x()), std::max(a.x(), b.x())}, edge});
  }
}

/// Neighbouring edges on one line as one.
std::vector<GaugeEdge> joined_edges(std::vector<GaugeEdge> edges) {
  std::ranges::sort(edges, [](const GaugeEdge& a, const GaugeEdge& b) {
    if (std::abs(a.away - b.away) > kOneEdge) return a.away < b.away;
    return a.along.lo < b.along.lo;
  });
  std::vector<GaugeEdge> joined;
  for (const GaugeEdge& edge : edges) {
    GaugeEdge* last = joined.empty() ? nullptr : &joined.back();
    if (!last || std::abs(last->away - edge.away) > kOneEdge ||
        std::abs(edge.along.lo - last->along.hi) > kOneEdge) {
      joined.push_back(edge);
      continue;
    }
    last->along.hi = edge.along.hi;
    const bool goes_on = (last->in_pattern.b - edge.in_pattern.a).norm() < kOneEdge;
    last->in_pattern = goes_on ? Segment{last->in_pattern.a, edge.in_pattern.b}
                               : Segment{edge.in_pattern.a, last->in_pattern.b};
  }
  return joined;
}

bool has_room(const Interval& along, std::vector<Interval> blocked, double width) {
  double from = along.lo;
  for (const Interval& wall : joined(std::move(blocked), 0.0)) {
    if (std::min(wall.lo + kPenetration, along.hi) - from >= width) return true;
    from = std::max(from, wall.hi - kPenetration);
  }
  return along.hi - from >= width;
}

/// The straight edges of all flat parts that face the gauge, parallel to the line.
std::vector<GaugeEdge> edges_facing(StageCache& cache, const Setting& stroke) {
  const Workpiece& work = cache.inputs().work;
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<const PlacedPart*>& parts = cache.parts(stroke);
  std::vector<GaugeEdge> edges;
  const Eigen::Isometry3d frame = line_frame(work.lines[stroke.line]);
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    if (parts[part]->flat) {
      const PartTree::Part& at = tree.parts()[part];
      add_gauge_edges(at.is_zone ? work.zones[at.index].edges : work.bodies[at.index].edges, frame,
                      stroke.direction > 0, edges);
    }
  edges = joined_edges(std::move(edges));
  std::erase_if(edges, [](const GaugeEdge& edge) { return edge.away <= 0.0; });
  return edges;
}

bool is_in_range(const GaugeEdge& edge, const BackGauge& gauge) {
  return edge.away >= gauge.from && edge.away <= gauge.to;
}

double length(const GaugeEdge& edge) { return edge.along.hi - edge.along.lo; }

/// Those that the gauge reaches and that are long enough, the longest first.
std::vector<GaugeEdge> edges_in_reach(StageCache& cache, const Setting& stroke,
                                      const BackGauge& gauge) {
  std::vector<GaugeEdge> edges = edges_facing(cache, stroke);
  std::erase_if(edges, [&](const GaugeEdge& edge) {
    return !is_in_range(edge, gauge) || length(edge) < gauge.finger_width;
  });
  std::ranges::stable_sort(edges, [](const GaugeEdge& a, const GaugeEdge& b) {
    return length(a) > length(b) + kOneEdge;
  });
  return edges;
}

}  // namespace

std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke) {
  const StrokeInputs& inputs = cache.inputs();
  if (!inputs.tools.machine.gauge) return std::nullopt;
  const BackGauge& gauge = *inputs.tools.machine.gauge;
  const std::vector<GaugeEdge> edges = edges_in_reach(cache, stroke, gauge);
  if (edges.empty()) return std::nullopt;
  const bool left = stroke.direction > 0;
  const PressMotion lying = motion(inputs, stroke);
  const Obstacle& finger = cache.tools().finger();
  for (const GaugeEdge& edge : edges) {
    const Obstacle here = moved(finger, {edge.away, 0.0}), there = mirrored(here);
    std::vector<Interval> blocked;
    for (const PlacedPart* part : cache.parts(stroke)) {
      const auto walls = blocked_along(lying, *part, left ? here : there, left ? there : here, 0.0,
                                       edge.along);
      blocked.insert(blocked.end(), walls.begin(), walls.end());
    }
    if (has_room(edge.along, std::move(blocked), gauge.finger_width))
      return GaugeStop{edge.away, edge.in_pattern};
  }
  return std::nullopt;
}

Remark why_ungauged(StageCache& cache, const Setting& stroke) {
  const auto& machine = cache.inputs().tools.machine;
  if (!machine.gauge) return remark_of(say::no_back_gauge);
  const BackGauge& gauge = *machine.gauge;
  std::vector<GaugeEdge> edges = edges_facing(cache, stroke);
  if (edges.empty()) return remark_of(say::no_parallel_edge);
  const auto off = [&](const GaugeEdge& edge) {
    return std::max({gauge.from - edge.away, edge.away - gauge.to, 0.0});
  };
  const GaugeEdge nearest = *std::ranges::min_element(edges, {}, off);
  if (!is_in_range(nearest, gauge))
    return remark_of(say::edge_out_of_range, {{"away", nearest.away, unit::mm},
                                              {"from", gauge.from, unit::mm},
                                              {"to", gauge.to, unit::mm}});
  std::erase_if(edges, [&](const GaugeEdge& edge) { return !is_in_range(edge, gauge); });
  const double longest = length(*std::ranges::max_element(edges, {}, length));
  if (longest < gauge.finger_width)
    return remark_of(say::edge_too_short,
                     {{"longest", longest, unit::mm}, {"width", gauge.finger_width, unit::mm}});
  return remark_of(say::finger_blocked);
}

}  // namespace planish::brake_detail
