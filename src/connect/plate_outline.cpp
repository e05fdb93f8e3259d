#include "plate_outline.hpp"

#include "parts.hpp"
#include "refusals.hpp"
#include "tolerances.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>

// A plate's outline with its extensions (math.md#tangent-lines). From each end of a run the outline
// goes on to the lateral boundary by the shortest path that does not cut the plate, the convex hull
// of the corners between; then along the tangent ruling. An extension that runs back over an edge
// becomes one with it, and an outline that crosses itself is refused.

namespace planish::connect_detail {
namespace {

using Edge = ExtendedOutline::Edge;

// Points closer than this share of the plate's extent are one.
constexpr double kSame = tolerance::kComputed;

// Corners of the run in (v, h), in the order of the outline.
std::vector<Vec2> run_corners(const BendFit& fit, int side, const PlacedPlate& plate) {
  return mapped(run_points(plate, fit.runs[side]),
                [&](const Vec2& p) { return fit.surface.local(side, plate.frame.point(p)); });
}

// v of the lateral boundary at the run's first end in the outline, and at the other.
std::pair<double, double> boundary_ends(const BendFit& fit, int side,
                                        const std::vector<Vec2>& corners) {
  const double low = fit.boundaries.low.v[side], high = fit.boundaries.high.v[side];
  return corners.front().x() < corners.back().x() ? std::pair{low, high} : std::pair{high, low};
}

// Where the joint begins at the run's corner: at the boundary, but at a corner on the ruling if it
// is there, and not past it.
double joint_end(const Vec2& corner, double boundary, double inward) {
  const bool on_ruling = corner.y() <= kDrawn;
  const bool past = (corner.x() - boundary) * inward > -kDrawn;
  return on_ruling && past ? corner.x() : boundary;
}

// Shortest path from a corner of the run to the point v on the ruling that keeps the run on the
// plate's side: the hull of the corners between, ordered from the corner; below them if the path
// leads in under the run, above them if it leads out past its end.
std::vector<Vec2> taut(const std::vector<Vec2>& corners, const Vec2& target) {
  const double inward = target.x() >= corners.front().x() ? 1.0 : -1.0;
  const double below = (corners.back().x() - corners.front().x()) * inward > 0.0 ? 1.0 : -1.0;
  std::vector<Vec2> way{corners.front()};
  const auto add = [&](const Vec2& p) {
    while (way.size() > 1) {
      const Vec2& a = way[way.size() - 2];
      if (below * inward * cross(way.back() - a, p - a) > 0.0) break;
      way.pop_back();
    }
    way.push_back(p);
  };
  for (std::size_t j = 1; j < corners.size(); ++j) {
    if ((target.x() - corners[j].x()) * inward <= 0.0) break;
    if ((corners[j].x() - way.front().x()) * inward > 0.0) add(corners[j]);
  }
  add(target);
  return way;
}

struct Path {
  std::vector<Vec2> points;  // (v, h), in the order of the outline
  std::size_t joint = 0;     // the joint runs from points[joint] to the next
};

Path path_of(const BendFit& fit, int side, const PlacedPlate& plate) {
  std::vector<Vec2> corners = run_corners(fit, side, plate);
  const auto [first, last] = boundary_ends(fit, side, corners);
  const double inward = last > first ? 1.0 : -1.0;
  const Vec2 from(joint_end(corners.front(), first, inward), 0.0);
  const Vec2 to(joint_end(corners.back(), last, -inward), 0.0);
  Path path{taut(corners, from), 0};
  path.joint = path.points.size() - 1;
  std::ranges::reverse(corners);
  std::vector<Vec2> back = taut(corners, to);
  path.points.insert(path.points.end(), back.rbegin(), back.rend());
  return path;
}

void append(ExtendedOutline& outline, const Vec2& a, const Vec2& b, std::optional<int> bend,
            double same) {
  if ((b - a).norm() > same) outline.edges.push_back({a, b, bend});
}

// The run, an edge on the intersection line, with the fold's line in place of its part: at `reach`
// inside the plate, or beyond it if the reference skin is the outer one. Where it ends at a corner
// of the plate, the edge beside it is run back over; `with_runs_joined` removes that.
void append_fold(ExtendedOutline& outline, const PlacedPlate& plate, const BendOnPlate& on) {
  const Fold& fold = *on.fit->fold;
  const std::vector<Vec2> corners = run_corners(*on.fit, on.side, plate);  // h = −reach
  const bool ascending = corners.front().x() < corners.back().x();
  const double height = fold.reference_inside ? 0.0 : -2.0 * fold.reach;
  const double from = ascending ? fold.low : fold.high, to = ascending ? fold.high : fold.low;
  const EdgePlace edge{on.fit->runs[on.side].ring, on.fit->runs[on.side].first};
  const auto& at_corner = fold.at_corner[on.side];
  // On the edge beside a corner of the plate, at the height of the fold; else on the run.
  const auto step = [&](const Vec2& corner, int beyond, bool corner_here, double end) -> Vec2 {
    if (!fold.reference_inside || !corner_here) return {end, corner.y()};
    const Vec2 far = on.fit->surface.local(on.side, plate.corner(edge, beyond));
    const double share = corner.y() / (far.y() - corner.y());
    return {corner.x() - share * (far.x() - corner.x()), 0.0};
  };
  const std::vector<Vec2> path{corners.front(),
                               step(corners.front(), -1, at_corner[ascending ? 0 : 1], from),
                               {from, height},
                               {to, height},
                               step(corners.back(), 2, at_corner[ascending ? 1 : 0], to),
                               corners.back()};
  for (std::size_t j = 0; j + 1 < path.size(); ++j)
    append(outline, plate.frame.local2(on.fit->surface.point(on.side, path[j])),
           plate.frame.local2(on.fit->surface.point(on.side, path[j + 1])),
           j == 2 ? std::optional(on.bend) : std::nullopt, kSame * plate.extent);
}

// Two edges of which the second runs back over the first become one: an extension fills the corner
// of an opening, or a fold cuts the edge beside it. With `on_too`, so do two of which the second
// runs on along the first.
void with_runs_joined(ExtendedOutline& outline, bool on_too, double same) {
  std::vector<Edge>& edges = outline.edges;
  for (std::size_t i = 0; i < edges.size() && edges.size() > 3;) {
    Edge& e = edges[i];
    const std::size_t next = (i + 1) % edges.size();
    const Vec2 there = e.b - e.a, on = edges[next].b - edges[next].a;
    const bool along = !e.bend && !edges[next].bend && (on_too || there.dot(on) < 0.0) &&
                       std::abs(cross(there, on)) <= same * std::max(there.norm(), on.norm());
    if (!along) {
      ++i;
      continue;
    }
    e.b = edges[next].b;
    const bool nothing_left = (e.b - e.a).norm() <= same;
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(next));
    if (nothing_left)
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(next < i ? i - 1 : i));
  }
}

void append_bend(ExtendedOutline& outline, const PlacedPlate& plate, const BendOnPlate& on) {
  if (on.fit->fold) return append_fold(outline, plate, on);
  const Path path = path_of(*on.fit, on.side, plate);
  auto points = mapped(path.points, [&](const Vec2& vh) {
    return plate.frame.local2(on.fit->surface.point(on.side, vh));
  });
  // The ends are exactly corners of the plate.
  const std::vector<Vec2> run = run_points(plate, on.fit->runs[on.side]);
  points.front() = run.front();
  points.back() = run.back();
  const double same = kSame * plate.extent;
  // If the joint begins or ends at a corner of the plate, use that corner exactly.
  if (path.joint == 1 && (points[1] - points[0]).norm() <= same) points[1] = points[0];
  const std::size_t last = points.size() - 1;
  if (path.joint + 2 == last && (points[last] - points[last - 1]).norm() <= same)
    points[last - 1] = points[last];
  for (std::size_t j = 0; j < last; ++j)
    append(outline, points[j], points[j + 1],
           j == path.joint ? std::optional(on.bend) : std::nullopt, same);
}

const OutlineRun& run_of(const BendOnPlate& on) { return on.fit->runs[on.side]; }

// What is free of the ring from the end of one run to the start of the next; `around` if that is
// the first one again.
void append_free(ExtendedOutline& outline, const PlacedPlate& plate, const OutlineRun& from,
                 const OutlineRun& to, bool around) {
  const std::vector<Vec2>& corners = plate.ring(from.ring);
  const int n = static_cast<int>(corners.size());
  const int edge = (from.first + from.count - 1) % n;
  int edges = (to.first - edge + n) % n;
  if (edges == 0 && around) edges = n;
  const double same = kSame * plate.extent;
  Vec2 at = run_points(plate, from).back();
  for (int j = 1; j <= edges; ++j) {
    const Vec2& corner = corners[(edge + j) % n];
    append(outline, at, corner, std::nullopt, same);
    at = corner;
  }
  append(outline, at, run_points(plate, to).front(), std::nullopt, same);
}

// A corner that lies on an edge that does not end there: the extension runs back over the plate.
std::optional<Vec2> touching(const std::vector<Vec2>& ring, double same) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i || (j + 1) % n == i) continue;
      if (nearest(Segment{ring[j], ring[(j + 1) % n]}, ring[i]).distance <= same) return ring[i];
    }
  return std::nullopt;
}

Result<void> check_simple(const ExtendedOutline& outline, const PlacedPlate& plate,
                          const std::string& id, int number) {
  const auto ring = mapped(outline.edges, &Edge::a);
  const auto crossings = self_crossings(ring);
  if (crossings.empty() && (number == 0 ? 1.0 : -1.0) * ring_area(ring) > 0.0) {
    if (const auto at = touching(ring, kSame * plate.extent))
      return fail(refuse::begins_beside_edges, plate_at(id, plate.frame.point(*at)));
    return {};
  }
  const Vec3 p = plate.frame.point(crossings.empty() ? ring.front() : crossings.front());
  return fail(refuse::extensions_meet, plate_at(id, p));
}

}  // namespace

JointRange joint_range(const BendFit& fit, int side, const PlacedPlate& plate) {
  const Path path = path_of(fit, side, plate);
  const double a = path.points[path.joint].x(), b = path.points[path.joint + 1].x();
  return {std::min(a, b), std::max(a, b)};
}

Result<ExtendedOutline> extended_outline(const PlacedPlate& plate, std::vector<BendOnPlate> bends,
                                         const std::string& id, int ring) {
  std::erase_if(bends, [&](const BendOnPlate& on) { return run_of(on).ring != ring; });
  std::ranges::sort(bends, {}, [](const BendOnPlate& on) {
    return std::pair{run_of(on).first, run_of(on).start};
  });
  ExtendedOutline outline;
  const std::vector<Vec2>& corners = plate.ring(ring);
  if (bends.empty())
    for (const auto& [a, b] : sides_of(corners))
      outline.edges.push_back({a, b});
  // Once around the ring, from the first bend's run (which may include corner 0).
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const bool last = i + 1 == bends.size();
    append_bend(outline, plate, bends[i]);
    append_free(outline, plate, run_of(bends[i]), run_of(bends[last ? 0 : i + 1]), last);
  }
  const bool folded = std::ranges::any_of(
      bends, [](const BendOnPlate& on) { return on.fit->fold.has_value(); });
  with_runs_joined(outline, folded, kSame * plate.extent);
  if (ring > 0 && bends.empty()) return outline;  // as it was given
  if (auto simple = check_simple(outline, plate, id, ring); !simple) return pass_on(simple);
  return outline;
}

}  // namespace planish::connect_detail
