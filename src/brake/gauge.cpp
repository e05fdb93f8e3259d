// Where the back gauge touches. Straight borders of what lies in the plane of the sheet that face
// the gauge, neighbours on one line as one, are tried from the longest on, then outer faces of
// flanges that stand upright, and on request edges of openings by the finger's nose; at each the
// section of finger or nose is swept over all parts, and it must be clear over its width. Where no
// finger can touch with all its width, one may stand over an end (math.md#gauging).
#include "gauge.hpp"

#include "sentences.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace planish::brake_detail {
namespace {

constexpr double kParallel = 0.1 * 3.14159265358979 / 180.0;  // edges that a finger touches flat
constexpr double kLeastTouching = 0.5;                        // of a finger's width
constexpr double kOneEdge = 1e-3;                             // mm: edges that go on

/// An edge that faces the gauge, in the frame of the line.
struct GaugeEdge {
  double away = 0.0;  ///< from the bend line
  Interval along;
  Segment in_pattern;
  bool in_opening = false;
  double height = 0.0;                  ///< of the finger
  std::optional<FlangeId> flange = {};  ///< of whose outer face it is a level line
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
    found.push_back({away,
                     {std::min(a.x(), b.x()), std::max(a.x(), b.x())},
                     Segment{edge.a, edge.b},
                     edge.in_opening});
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

/// The front of a finger, from its lowest to its highest corner there.
Interval front_of(const BackGauge& gauge) {
  constexpr double kAtFront = 1e-6;  // mm
  Interval front{0.0, 0.0};
  for (const Vec2& corner : gauge.finger)
    if (std::abs(corner.x()) < kAtFront)
      front = {std::min(front.lo, corner.y()), std::max(front.hi, corner.y())};
  return front;
}

/// How high a finger is, as near to the lying sheet as can be, to touch a face between two heights
/// with all its front, or over all the face if that is lower; where its lift ends before, as near
/// to that as it gets.
double height_at(const Interval& face, const BackGauge& gauge) {
  const Interval front = front_of(gauge);
  const double a = face.lo - front.lo, b = face.hi - front.hi;
  return std::clamp(std::clamp(0.0, std::min(a, b), std::max(a, b)), gauge.lowest, gauge.highest);
}

/// What of a face a finger touches at a height: empty if less than is told.
std::optional<Interval> touched_at(double height, const Interval& face, const BackGauge& gauge) {
  constexpr double kLeastTouch = 5.0;  // mm of a face, across its level line
  const Interval front = front_of(gauge);
  const Interval touched{std::max(face.lo, height + front.lo),
                         std::min(face.hi, height + front.hi)};
  if (touched.hi - touched.lo < kLeastTouch) return std::nullopt;
  return touched;
}

/// Where a level line crosses a polygon in (x, z).
std::optional<Interval> crossing(const std::vector<Vec2>& polygon, double level) {
  std::optional<Interval> found;
  const auto take = [&](double x) {
    found = found ? Interval{std::min(found->lo, x), std::max(found->hi, x)} : Interval{x, x};
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() - level) * (b.y() - level) > 0.0 || a.y() == b.y()) continue;
    take(a.x() + (level - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  return found;
}

/// A flange that stands upright at the gauge: its plane pieces in (x, z).
struct UprightFace {
  std::vector<std::vector<Vec2>> pieces;
  Interval heights;
  double away = 0.0;  ///< of its outer face from the bend line
  std::optional<FlangeId> flange;
};

std::vector<UprightFace> upright_faces(StageCache& cache, const Setting& stroke) {
  const Workpiece& work = cache.inputs().work;
  const PartTree& tree = cache.tree(stroke.line);
  const double side = stroke.direction > 0 ? 1.0 : -1.0;
  std::vector<UprightFace> faces;
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    const PartTree::Part& at = tree.parts()[part];
    const PlacedPart& placed = *cache.parts(stroke)[part];
    const Vec3 normal = placed.at.linear().col(2);
    if (at.is_zone || placed.flat || placed.left != (stroke.direction > 0)) continue;
    if (std::abs(normal.x()) > kParallel || std::abs(normal.z()) > kParallel) continue;
    const Body& body = work.bodies[at.index];
    UprightFace face{{}, {kEverywhere.hi, kEverywhere.lo}, 0.0, body.flange};
    for (const Convex& piece : body.pieces)
      face.pieces.push_back(mapped(piece, [&](const Vec2& corner) {
        const Vec3 p = placed.at * Vec3(corner.x(), corner.y(), 0.0);
        face.heights = {std::min(face.heights.lo, p.z()), std::max(face.heights.hi, p.z())};
        face.away = side * p.y() + 0.5 * work.thickness;
        return Vec2(p.x(), p.z());
      }));
    if (face.away > 0.0) faces.push_back(std::move(face));
  }
  return faces;
}

/// Level lines on the outer faces of upright flanges, where a finger would touch them.
std::vector<GaugeEdge> faces_facing(StageCache& cache, const Setting& stroke,
                                    const BackGauge& gauge) {
  const Eigen::Isometry3d lying = line_frame(cache.inputs().work.lines[stroke.line]);
  const double side = stroke.direction > 0 ? 1.0 : -1.0, middle = lying.translation().z();
  std::vector<GaugeEdge> lines;
  for (const UprightFace& face : upright_faces(cache, stroke)) {
    const double height = height_at(face.heights, gauge);
    const auto touched = touched_at(height, face.heights, gauge);
    if (!touched) continue;
    std::vector<Interval> along;
    for (const std::vector<Vec2>& piece : face.pieces)
      if (const auto one = crossing(piece, 0.5 * (touched->lo + touched->hi)))
        along.push_back(*one);
    const auto in_pattern = [&](double x) {
      return Vec2((lying.inverse() * Vec3(x, side * face.away, middle)).head<2>());
    };
    for (const Interval& one : joined(std::move(along), kOneEdge))
      lines.push_back({.away = face.away,
                       .along = one,
                       .in_pattern = Segment{in_pattern(one.lo), in_pattern(one.hi)},
                       .height = height,
                       .flange = face.flange});
  }
  return lines;
}

bool is_in_range(const GaugeEdge& edge, const BackGauge& gauge) {
  return edge.away >= gauge.from && edge.away <= gauge.to;
}

double length(const GaugeEdge& edge) { return edge.along.hi - edge.along.lo; }

/// What touches an edge: a finger or its nose.
struct Touch {
  const Obstacle& shape;  ///< where it touches at the origin
  double width = 0.0;
  double least = 0.0;  ///< of the width, that touches; the rest may stand over an end
};

/// Those that the gauge reaches and that are long enough, the longest first.
std::vector<GaugeEdge> in_reach(std::vector<GaugeEdge> edges, const BackGauge& gauge,
                                const Touch& touch) {
  std::erase_if(edges, [&](const GaugeEdge& edge) {
    return !is_in_range(edge, gauge) || length(edge) < touch.least;
  });
  std::ranges::stable_sort(edges, [](const GaugeEdge& a, const GaugeEdge& b) {
    return length(a) > length(b) + kOneEdge;
  });
  return edges;
}

/// The longest at which there is room for what touches it.
std::optional<GaugeStop> first_clear(StageCache& cache, const Setting& stroke,
                                     const std::vector<GaugeEdge>& edges, const Touch& touch) {
  const bool left = stroke.direction > 0;
  const PressMotion lying = motion(cache.inputs(), stroke);
  for (const GaugeEdge& edge : in_reach(edges, *cache.inputs().tools.machine.gauge, touch)) {
    const Obstacle here = moved(touch.shape, {edge.away, edge.height}), there = mirrored(here);
    const double over = touch.width - touch.least;
    const Interval room{edge.along.lo - over, edge.along.hi + over};
    std::vector<Interval> blocked;
    for (const PlacedPart* part : cache.parts(stroke)) {
      const auto walls = blocked_along(lying, *part, left ? here : there, left ? there : here, 0.0,
                                       room);
      blocked.insert(blocked.end(), walls.begin(), walls.end());
    }
    if (has_room(room, std::move(blocked), touch.width))
      return GaugeStop{edge.away, edge.in_pattern, edge.height, edge.flange};
  }
  return std::nullopt;
}

/// The nose of a finger at the edge of an opening.
std::optional<GaugeStop> in_opening(StageCache& cache, const Setting& stroke,
                                    const std::vector<GaugeEdge>& edges) {
  const auto& nose = cache.inputs().tools.machine.gauge->nose;
  if (!nose || edges.empty()) return std::nullopt;
  auto stop = first_clear(cache, stroke, edges, {cache.tools().nose(), nose->width, nose->width});
  if (stop) stop->in_opening = true;
  return stop;
}

}  // namespace

std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke) {
  const StrokeInputs& inputs = cache.inputs();
  if (!inputs.tools.machine.gauge) return std::nullopt;
  const BackGauge& gauge = *inputs.tools.machine.gauge;
  const double width = gauge.finger_width;
  const Touch whole{cache.tools().finger(), width, width},
      part{cache.tools().finger(), width, kLeastTouching * width};
  std::vector<GaugeEdge> edges = edges_facing(cache, stroke), openings;
  if (inputs.options.gauge_openings) {  // then they come last
    std::ranges::copy_if(edges, std::back_inserter(openings), &GaugeEdge::in_opening);
    std::erase_if(edges, [](const GaugeEdge& edge) { return edge.in_opening; });
  }
  if (const auto stop = first_clear(cache, stroke, edges, whole)) return stop;
  const std::vector<GaugeEdge> faces = faces_facing(cache, stroke, gauge);
  if (const auto stop = first_clear(cache, stroke, faces, whole)) return stop;
  if (const auto stop = first_clear(cache, stroke, edges, part)) return stop;
  if (const auto stop = first_clear(cache, stroke, faces, part)) return stop;
  if (const auto stop = in_opening(cache, stroke, openings)) return stop;
  return first_clear(cache, stroke, openings, part);
}

namespace {

/// A flange that a finger would touch if it went higher or lower.
std::optional<Remark> beyond_lift(StageCache& cache, const Setting& stroke,
                                  const BackGauge& gauge) {
  for (const UprightFace& face : upright_faces(cache, stroke)) {
    const bool in_range = face.away >= gauge.from && face.away <= gauge.to;
    const double height = height_at(face.heights, gauge);
    const bool at_end = height == gauge.lowest || height == gauge.highest;
    if (!in_range || !at_end || touched_at(height, face.heights, gauge)) continue;
    return remark_of(say::face_beyond_lift, {{"away", face.away, unit::mm},
                                             {"lowest", gauge.lowest, unit::mm},
                                             {"highest", gauge.highest, unit::mm}});
  }
  return std::nullopt;
}

}  // namespace

Remark why_ungauged(StageCache& cache, const Setting& stroke) {
  const auto& machine = cache.inputs().tools.machine;
  if (!machine.gauge) return remark_of(say::no_back_gauge);
  const BackGauge& gauge = *machine.gauge;
  if (const auto lift = beyond_lift(cache, stroke, gauge)) return *lift;
  std::vector<GaugeEdge> edges = edges_facing(cache, stroke);
  if (edges.empty()) {  // the sheet lies either way
    Setting turned = stroke;
    turned.direction = -stroke.direction;
    edges = edges_facing(cache, turned);
  }
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
  if (longest < kLeastTouching * gauge.finger_width)
    return remark_of(say::edge_too_short,
                     {{"longest", longest, unit::mm}, {"width", gauge.finger_width, unit::mm}});
  return remark_of(say::finger_blocked);
}

}  // namespace planish::brake_detail
