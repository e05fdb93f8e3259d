// What the fingers of the back gauge may touch: straight borders of what lies in the plane of the
// sheet, neighbours on one line as one, outer faces of flanges that stand upright, and the folds of
// those that lean back over the sheet, where they go out farthest (math.md#gauging).
#include "gauge_edges.hpp"

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kParallel = 0.1 * 3.14159265358979 / 180.0;  // edges that a finger touches flat
constexpr double kLevel = 0.2;     // mm: by which the ends of a line may be off, one from the other
constexpr double kOneEdge = 1e-3;  // mm: edges that go on

/// How much of a direction runs away from the line, at most: so that the line, or what is touched
/// if that is longer, is off by no more than a shop allows.
double most_slope(const BrakeLine& pressed, double touched = 0.0) {
  return std::min(std::tan(kParallel), kLevel / std::max(pressed.to() - pressed.from(), touched));
}

/// The edges of a body or zone, seen from the line; `left`: those that face away to the left.
void add_gauge_edges(const std::vector<FreeEdge>& edges, const BrakeLine& pressed, bool left,
                     std::vector<GaugeEdge>& found) {
  const Eigen::Isometry3d frame = line_frame(pressed);
  for (const FreeEdge& edge : edges) {
    const Vec3 a = frame * Vec3(edge.a.x(), edge.a.y(), 0.0),
               b = frame * Vec3(edge.b.x(), edge.b.y(), 0.0);
    const Vec2 outward(edge.b.y() - edge.a.y(), edge.a.x() - edge.b.x());
    const double out = (frame.linear() * Vec3(outward.x(), outward.y(), 0.0)).y();
    const double wide = std::abs(b.x() - a.x());
    if (std::abs(b.y() - a.y()) > most_slope(pressed, wide) * wide) continue;
    if ((left ? out : -out) <= 0.0) continue;
    const double away = left ? std::max(a.y(), b.y()) : std::max(-a.y(), -b.y());
    found.push_back({away,
                     {std::min(a.x(), b.x()), std::max(a.x(), b.x())},
                     Segment{edge.a, edge.b},
                     edge.in_opening});
  }
}

/// Neighbouring edges on one line as one, also beyond gaps.
std::vector<GaugeEdge> joined_edges(std::vector<GaugeEdge> edges, double gap) {
  std::ranges::sort(edges, [](const GaugeEdge& a, const GaugeEdge& b) {
    if (std::abs(a.away - b.away) > kOneEdge) return a.away < b.away;
    return a.along.lo < b.along.lo;
  });
  std::vector<GaugeEdge> joined;
  for (const GaugeEdge& edge : edges) {
    GaugeEdge* last = joined.empty() ? nullptr : &joined.back();
    if (!last || std::abs(last->away - edge.away) > kOneEdge ||
        edge.along.lo - last->along.hi > gap || edge.in_opening != last->in_opening) {
      joined.push_back(edge);
      continue;
    }
    last->along.hi = std::max(last->along.hi, edge.along.hi);
    const bool goes_on = (last->in_pattern.b - edge.in_pattern.a).norm() <=
                         (last->in_pattern.a - edge.in_pattern.b).norm();
    last->in_pattern = goes_on ? Segment{last->in_pattern.a, edge.in_pattern.b}
                               : Segment{edge.in_pattern.a, last->in_pattern.b};
  }
  return joined;
}

/// How high a finger is, as near to the lying sheet as can be, to touch a face between two heights
/// with all its front, or over all the face if that is lower; where its lift ends before, as near
/// to that as it gets.
double height_at(const Interval& face, const BackGauge& gauge) {
  const Interval front = front_of(gauge);
  const double a = face.lo - front.lo, b = face.hi - front.hi;
  return std::clamp(std::clamp(0.0, std::min(a, b), std::max(a, b)), gauge.lowest, gauge.highest);
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
    if (std::abs(normal.x()) > most_slope(work.lines[stroke.line]) ||
        std::abs(normal.z()) > kParallel)
      continue;
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

/// How high a finger is, as near to the lying sheet as can be, to touch a fold that goes out
/// farthest at a height; empty if its lift ends before.
std::optional<double> height_at_fold(double fold, double thickness, const BackGauge& gauge) {
  const Interval front = front_of(gauge);
  const double margin = 0.5 * std::min(thickness, front.hi - front.lo);
  const double height = std::clamp(
      std::clamp(0.0, fold + margin - front.hi, fold - margin - front.lo), gauge.lowest,
      gauge.highest);
  if (fold < height + front.lo || fold > height + front.hi) return std::nullopt;
  return height;
}

/// A bend that turns what is beyond it back over what lies, as it is in a stage.
struct Fold {
  const BrakeLine& line;
  double radius = 0.0;  ///< inside
  Angle angle;
};

std::optional<Fold> fold_of(const Workpiece& work, int number, const LineSet& formed) {
  const BrakeLine& line = work.lines[number];
  if (!holds(formed, number)) return std::nullopt;
  const bool closed = line.closed_by && holds(formed, *line.closed_by);
  const Angle angle = closed ? line.closed : line.angle;
  if (angle.radians() <= 0.5 * Angle::degrees(180).radians() + kParallel) return std::nullopt;
  return Fold{line, std::max(0.0, line.bend.allowance / angle.radians() - line.bend.neutral),
              angle};
}

/// Where a fold beyond a body that lies can be touched: at a quarter of a turn, R + T beyond the
/// line at which it begins.
void add_fold(const Fold& fold, const std::vector<Convex>& zone, const BrakeLine& pressed,
              double side, const BackGauge& gauge, std::vector<GaugeEdge>& found) {
  const BrakeLine& line = fold.line;
  const double thickness = line.bend.thickness, half = 0.5 * line.bend.allowance;
  const Eigen::Isometry3d lying = line_frame(pressed);
  const auto seen = [&](const Vec2& p) { return Vec3(lying * Vec3(p.x(), p.y(), 0.0)); };
  const Vec3 at = seen(line.origin), along = seen(line.origin + line.along) - at;
  const double away = side * at.y() - half + fold.radius + thickness;
  if (std::abs(along.y()) > most_slope(pressed) || away <= 0.0) return;
  const auto height = height_at_fold(line.up == pressed.up ? fold.radius : -thickness - fold.radius,
                                     thickness, gauge);
  if (!height) return;
  const Vec2 outward = side * pressed.across();
  const double quarter = line.bend.allowance * Angle::degrees(90).radians() / fold.angle.radians();
  const auto in_pattern = [&](double x) {
    return Vec2(line.origin + x * line.along + (quarter - half) * outward);
  };
  std::vector<Interval> pieces;
  for (const Convex& piece : zone)
    if (const auto one = crossing(piece, 0.0)) pieces.push_back(*one);
  for (const Interval& one : joined(std::move(pieces), kOneEdge)) {
    const double a = seen(in_pattern(one.lo)).x(), b = seen(in_pattern(one.hi)).x();
    found.push_back({.away = away,
                     .along = {std::min(a, b), std::max(a, b)},
                     .in_pattern = Segment{in_pattern(one.lo), in_pattern(one.hi)},
                     .height = *height,
                     .fold = line.bends.front()});
  }
}

void add_folds(StageCache& cache, const Setting& stroke, const BackGauge& gauge,
               std::vector<GaugeEdge>& found) {
  const Workpiece& work = cache.inputs().work;
  const std::vector<PartTree::Part>& parts = cache.tree(stroke.line).parts();
  const bool left = stroke.direction > 0;
  for (const PartTree::Part& part : parts) {
    if (!part.is_zone || part.before < 0) continue;
    const PlacedPart& before = *cache.parts(stroke)[part.before];
    if (!before.flat || before.left != left) continue;
    if (const auto fold = fold_of(work, part.index, *stroke.formed))
      add_fold(*fold, work.zones[part.index].pieces, work.lines[stroke.line], left ? 1.0 : -1.0,
               gauge, found);
  }
}

}  // namespace

bool is_in_range(const GaugeEdge& edge, const BackGauge& gauge) {
  return edge.away >= gauge.from && edge.away <= gauge.to;
}

Interval front_of(const BackGauge& gauge) {
  constexpr double kAtFront = 1e-6;  // mm
  Interval front{0.0, 0.0};
  for (const Vec2& corner : gauge.finger)
    if (std::abs(corner.x()) < kAtFront)
      front = {std::min(front.lo, corner.y()), std::max(front.hi, corner.y())};
  return front;
}

std::vector<GaugeEdge> edges_facing(StageCache& cache, const Setting& stroke, double gap) {
  const Workpiece& work = cache.inputs().work;
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<const PlacedPart*>& parts = cache.parts(stroke);
  std::vector<GaugeEdge> edges;
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    if (parts[part]->flat) {
      const PartTree::Part& at = tree.parts()[part];
      add_gauge_edges(at.is_zone ? work.zones[at.index].edges : work.bodies[at.index].edges,
                      work.lines[stroke.line], stroke.direction > 0, edges);
    }
  edges = joined_edges(std::move(edges), std::max(gap, kOneEdge));
  std::erase_if(edges, [](const GaugeEdge& edge) { return edge.away <= 0.0; });
  return edges;
}

std::vector<GaugeEdge> formed_facing(StageCache& cache, const Setting& stroke,
                                     const BackGauge& gauge) {
  const Eigen::Isometry3d lying = line_frame(cache.inputs().work.lines[stroke.line]);
  const double side = stroke.direction > 0 ? 1.0 : -1.0, middle = lying.translation().z();
  const Interval front = front_of(gauge);
  std::vector<GaugeEdge> lines;
  for (const UprightFace& face : upright_faces(cache, stroke)) {
    const double height = height_at(face.heights, gauge);
    const Interval touched{std::max(face.heights.lo, height + front.lo),
                           std::min(face.heights.hi, height + front.hi)};
    const double level = std::clamp(0.5 * (touched.lo + touched.hi), face.heights.lo,
                                    face.heights.hi);
    std::vector<Interval> along;
    for (const std::vector<Vec2>& piece : face.pieces)
      if (const auto one = crossing(piece, level)) along.push_back(*one);
    const auto in_pattern = [&](double x) {
      return Vec2((lying.inverse() * Vec3(x, side * face.away, middle)).head<2>());
    };
    for (const Interval& one : joined(std::move(along), kOneEdge))
      lines.push_back({.away = face.away,
                       .along = one,
                       .in_pattern = Segment{in_pattern(one.lo), in_pattern(one.hi)},
                       .height = height,
                       .flange = face.flange,
                       .touched = std::max(0.0, touched.hi - touched.lo),
                       .needed = cache.inputs().work.thickness});
  }
  add_folds(cache, stroke, gauge, lines);
  return lines;
}

bool has_edge_aside(StageCache& cache, const Setting& stroke) {
  const PartTree& tree = cache.tree(stroke.line);
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    const PartTree::Part& at = tree.parts()[part];
    const PlacedPart& placed = *cache.parts(stroke)[part];
    if (at.is_zone || placed.flat) continue;
    for (const FreeEdge& edge : cache.inputs().work.bodies[at.index].edges) {
      const Vec2 along = (edge.b - edge.a).normalized();
      const Vec3 seen = placed.at.linear() * Vec3(along.x(), along.y(), 0.0);
      if (seen.tail<2>().norm() < std::sin(kParallel)) return true;
    }
  }
  return false;
}

}  // namespace planish::brake_detail
