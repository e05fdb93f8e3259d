// The lateral hull of two convex profiles (math.md#lateral-hull): a plane that rolls around both,
// found by its events. At the tangent line at each end of an element, the plane through it that
// leaves the other profile inside touches where the slope over the line is largest; det(T₁, T₂, q −
// p) = 0 holds there. Events of both profiles, merged in order, bound the patches: planes, cones,
// general developables. Order must be kept.

#include "hull.hpp"

#include "refusals.hpp"
#include "roots.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The lateral hull of two convex profiles (math.md#lateral-hull): planes that touch both. A plane
// is carried over from the tangent line where an element of one begins or ends to the place of the
// other where the slope over that line is largest. These events are sorted once round; between two
// of them the plane touches one element of each side, and the patch there is a plane, a cone, or
// ruled. Two that continue each other are one.

namespace planish::transition_detail {
namespace {

/// Share of the extent within which a point lies in a plane.
constexpr double kInPlane = 1e-10;

/// A plane within this share of the extent of a profile touches it.
constexpr double kTouching = tolerance::kComputed;

/// Places nearer to each other are one: the tangents of the other boundary lead to them.
constexpr double kSamePlace = 5.0 * tolerance::kComputed;

/// How far a place may lie before the last one and still count as the same.
constexpr double kBack = 100.0 * tolerance::kComputed;

/// A place on a boundary: element plus share of its parameter. Whole numbers are where elements
/// meet. Places continue past the end, round after round.
using BoundaryPlace = double;

/// A plane that touches both boundaries: on each from one place to another, the same unless the
/// plane holds an edge.
struct Event {
  std::array<BoundaryPlace, 2> from{}, to{};
};

using Boundaries = std::array<Boundary, 2>;

/// Where the slope of the second boundary's points over a tangent line of the first is largest
/// within an element.
BoundaryPlace place_on(int element, const Element& curve, const SpaceCurvePoint& line) {
  const double t = falling_root(
      [&](double s) {
        const SpaceCurvePoint q = curve.curve(s);
        return std::pair{-ahead(line, q),
                         -line.derivative.cross(q.second).dot(q.point - line.point)};
      },
      curve.t0, curve.t1);
  return element + (t - curve.t0) / (curve.t1 - curve.t0);
}

/// Where the plane through a tangent line of the first boundary touches the second, all of which
/// lies on the inner side: where the slope of its points over the line, out over up, is largest.
std::pair<BoundaryPlace, BoundaryPlace> support(const Boundaries& boundaries,
                                                const SpaceCurvePoint& line, double in_plane) {
  const auto& [first, second] = boundaries;
  const Vec3 along = line.derivative.normalized(), out = along.cross(first.axis);
  const int n = second.count();
  int best = 0;
  double steepest = -std::numeric_limits<double>::infinity();
  Vec3 normal = out;
  for (int k = 0; k < n; ++k) {
    const Element& element = second.element(k);
    const Vec3 arm = element.curve(element.t0).point - line.point;
    const double up = first.axis.dot(arm), slope = out.dot(arm) / up;
    if (slope <= steepest) continue;
    steepest = slope;
    best = k;
    normal = (out - slope * first.axis).normalized();
  }
  const Element &before = second.element(best - 1), &after = second.element(best);
  const auto in_the_plane = [&](const Vec3& p) {
    return std::abs(normal.dot(p - line.point)) <= in_plane;
  };
  const auto at = [&](BoundaryPlace place) { return std::pair{place, place}; };
  const bool on_after = after.straight && in_the_plane(after.curve(after.t1).point);
  const bool on_before = before.straight && in_the_plane(before.curve(before.t0).point);
  // Of the two sides of a ridge the plane holds the one that runs its way.
  const bool runs_back = after.curve(after.t0).derivative.dot(along) < 0.0;
  if (on_after && !(on_before && runs_back)) return {best, best + 1};
  if (on_before) return {best - 1 + (best == 0 ? n : 0), best + (best == 0 ? n : 0)};
  if (!after.straight && normal.dot(after.curve(after.t0).derivative) > 0.0)
    return at(place_on(best, after, line));
  if (!before.straight && normal.dot(before.curve(before.t1).derivative) < 0.0)
    return at(place_on((best + n - 1) % n, before, line));
  return at(best);
}

/// Tangent lines of the first boundary at which an element begins or ends, in order, and what
/// their planes touch.
std::vector<Event> first_side_events(const Boundaries& boundaries, double in_plane) {
  const Boundary& first = boundaries[0];
  std::vector<Event> events;
  const auto add = [&](BoundaryPlace from, BoundaryPlace to, const SpaceCurvePoint& line) {
    const auto [low, high] = support(boundaries, line, in_plane);
    events.push_back({{from, low}, {to, high}});
  };
  for (int i = 0; i < first.count(); ++i) {
    const Element &before = first.element(i - 1), &here = first.element(i);
    if (first.corner_at(i) && !before.straight) add(i, i, before.curve(before.t1));
    if (!here.straight && (first.corner_at(i) || !before.straight)) add(i, i, here.curve(here.t0));
    if (here.straight) add(i, i + 1, here.curve(here.t0));
  }
  return events;
}

/// Places of one round of a boundary; none of an apex.
double round_of(const Boundary& boundary) { return boundary.is_point() ? 0.0 : boundary.count(); }

/// The same events, their places on the second boundary (`n` a round) growing with those on the
/// first, once round.
Result<std::vector<Event>> unwrapped(std::vector<Event> events, double n) {
  const double start = events.front().from[1];
  double last = start;
  for (Event& event : events) {
    const double length = event.to[1] - event.from[1];
    double from = event.from[1];
    if (n > 0.0) from += n * std::ceil((last - kBack - from) / n);
    event.from[1] = std::max(from, last);
    event.to[1] = std::max(from + length, event.from[1]);
    last = event.to[1];
  }
  if (last > start + n + kBack) return fail(refuse::one_behind_other);
  return events;
}

/// Where the plane through a tangent line of the second boundary touches a curve of the first.
BoundaryPlace first_place(const Boundary& first, const SpaceCurvePoint& line, BoundaryPlace low,
                          BoundaryPlace high) {
  const int element = static_cast<int>(std::floor(0.5 * (low + high)));
  const Element& curve = first.element(element);
  const auto t_of = [&](BoundaryPlace place) {
    return std::lerp(curve.t0, curve.t1, place - element);
  };
  const double t = falling_root(
      [&](double s) {
        const SpaceCurvePoint p = curve.curve(s);
        return std::pair{ahead(p, line), p.second.cross(line.derivative).dot(line.point - p.point)};
      },
      t_of(low), t_of(high));
  return std::clamp(element + (t - curve.t0) / (curve.t1 - curve.t0), low, high);
}

/// Tangent lines of the second boundary at which an element begins or ends between two events, and
/// what their planes touch on the first boundary meanwhile.
std::vector<Event> events_between(const Boundaries& boundaries, const Event& last,
                                  const Event& next) {
  const auto& [first, second] = boundaries;
  std::vector<Event> events;
  BoundaryPlace here = last.to[0];
  const auto add = [&](BoundaryPlace from, BoundaryPlace to, const SpaceCurvePoint& line) {
    here = next.from[0] > here ? first_place(first, line, here, next.from[0]) : here;
    events.push_back({{here, from}, {here, to}});
  };
  const BoundaryPlace begin = last.to[1], end = next.from[1];
  for (int j = static_cast<int>(std::ceil(begin)); j <= end; ++j) {
    const Element &before = second.element(j - 1), &after = second.element(j);
    if (j > begin && !before.straight && second.corner_at(j)) add(j, j, before.curve(before.t1));
    if (after.straight && j + 1 <= end) add(j, j + 1, after.curve(after.t0));
    if (!after.straight && j < end && (second.corner_at(j) || !before.straight))
      add(j, j, after.curve(after.t0));
  }
  return events;
}

/// The same event a round later.
Event a_round_on(Event event, const Boundaries& boundaries) {
  for (std::size_t side = 0; side < 2; ++side) {
    event.from[side] += round_of(boundaries[side]);
    event.to[side] += round_of(boundaries[side]);
  }
  return event;
}

/// All planes that touch both boundaries where an element of one of them begins or ends, in order.
Result<std::vector<Event>> events_of(const Boundaries& boundaries, double in_plane) {
  const auto known = unwrapped(first_side_events(boundaries, in_plane), round_of(boundaries[1]));
  if (!known) return known;
  std::vector<Event> events;
  for (std::size_t i = 0; i < known->size(); ++i) {
    events.push_back((*known)[i]);
    const bool last = i + 1 == known->size();
    const Event next = last ? a_round_on(known->front(), boundaries) : (*known)[i + 1];
    for (const Event& event : events_between(boundaries, (*known)[i], next))
      events.push_back(event);
  }
  return events;
}

/// The stretch of a boundary between two places in one element.
Stretch stretch_between(const Boundary& boundary, BoundaryPlace from, BoundaryPlace to) {
  if (to - from < kSamePlace)
    to = from = std::abs(from - std::round(from)) < kSamePlace ? std::round(from) : from;
  const int element = static_cast<int>(std::floor(from == to ? from : 0.5 * (from + to)));
  const Element& curve = boundary.element(element);
  const auto t_of = [&](BoundaryPlace place) {
    return std::lerp(curve.t0, curve.t1, place - element);
  };
  return {((element % boundary.count()) + boundary.count()) % boundary.count(), t_of(from),
          from == to ? t_of(from) : t_of(to)};
}

/// Whether `next` continues along the curve on which `last` ends.
bool runs_on(const Boundary& boundary, const Stretch& last, const Stretch& next) {
  const Element &a = boundary.element(last.element), &b = boundary.element(next.element);
  if (last.moves() != next.moves()) return false;
  if (!last.moves()) return (a.curve(last.t1).point - b.curve(next.t0).point).norm() == 0.0;
  return a.source == b.source && !a.straight && !b.straight;
}

/// Makes two consecutive patches one, if they are parts of one curved surface.
bool join(const Hull& hull, HullPatch& last, const HullPatch& next) {
  if (last.plane || next.plane) return false;
  for (std::size_t side = 0; side < 2; ++side)
    if (!runs_on(hull.boundaries[side], last.sides[side], next.sides[side])) return false;
  const std::array<double, 2> behind{last.sides[0].t1 - next.sides[0].t0,
                                     last.sides[1].t1 - next.sides[1].t0};
  for (std::size_t i = 1; i < next.stops.size(); ++i)
    last.stops.push_back({next.stops[i][0] + behind[0], next.stops[i][1] + behind[1]});
  for (std::size_t side = 0; side < 2; ++side)
    last.sides[side].t1 = last.stops.back()[side];
  return true;
}

/// Adds the patch between two rulings, unless they are the same; a continuation of the last patch
/// becomes part of it.
void add_patch(Hull& hull, const std::array<BoundaryPlace, 2>& from,
               const std::array<BoundaryPlace, 2>& to, bool plane) {
  HullPatch patch{plane,
                  {stretch_between(hull.boundaries[0], from[0], to[0]),
                   stretch_between(hull.boundaries[1], from[1], to[1])},
                  {}};
  patch.stops = {{patch.sides[0].t0, patch.sides[1].t0}, {patch.sides[0].t1, patch.sides[1].t1}};
  if (!patch.sides[0].moves() && !patch.sides[1].moves()) return;
  if (hull.patches.empty() || !join(hull, hull.patches.back(), patch))
    hull.patches.push_back(patch);
}

/// Where an element is highest or lowest between its ends; else one of the ends.
double turning_point(const Element& element, const Vec3& up) {
  return root_between(
      [&](double t) {
        const SpaceCurvePoint p = element.curve(t);
        return std::pair{up.dot(p.derivative), up.dot(p.second)};
      },
      element.t0, element.t1);
}

Result<void> check_apart(const Boundary& plane_of, const Boundary& other, double side, double size,
                         bool from) {
  const Vec3 origin = plane_of.elements.front().curve(plane_of.elements.front().t0).point;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  Vec3 lowest = origin;
  const Vec3 up = side * plane_of.axis;
  for (const Element& element : other.elements)
    for (const double t : {element.t0, turning_point(element, up), element.t1}) {
      const Vec3 p = element.curve(t).point;
      const double h = up.dot(p - origin);
      if (h < low) lowest = p;
      low = std::min(low, h);
      high = std::max(high, h);
    }
  if (low > kTouching * size) return {};
  if (high <= kTouching * size)
    return fail(refuse::in_one_plane, {{"field", place::pointer("/to/frame")}});
  const char* which = from ? "second" : "first";
  if (low >= -kTouching * size)
    return fail(
        refuse::touches_plane,
        {{"which", which}, {"at", place::point(lowest)}, {"field", place::pointer("/to/frame")}});
  return fail(refuse::on_both_sides, {{"which", which},
                                      {"below", -low, unit::mm},
                                      {"above", high, unit::mm},
                                      {"at", place::point(lowest)},
                                      {"field", place::pointer("/to/frame")}});
}

}  // namespace

double ahead(const SpaceCurvePoint& p, const SpaceCurvePoint& q) {
  return p.derivative.cross(q.derivative).dot(q.point - p.point);
}

Result<Hull> lateral_hull(Boundary first, Boundary second, double size) {
  if (auto apart = check_apart(first, second, 1.0, size, true); !apart) return pass_on(apart);
  if (auto apart = check_apart(second, first, -1.0, size, false); !apart) return pass_on(apart);
  Hull hull{{std::move(first), std::move(second)}, {}};
  const auto events = events_of(hull.boundaries, kInPlane * size);
  if (!events) return pass_on(events);
  for (std::size_t i = 0; i < events->size(); ++i) {
    const Event& here = (*events)[i];
    const bool last = i + 1 == events->size();
    const Event next = last ? a_round_on(events->front(), hull.boundaries) : (*events)[i + 1];
    add_patch(hull, here.from, here.to, true);
    add_patch(hull, here.to, next.from, false);
  }
  // The first and the last patch may also be one.
  if (hull.patches.size() > 1 && join(hull, hull.patches.back(), hull.patches.front()))
    hull.patches.erase(hull.patches.begin());
  return hull;
}

}  // namespace planish::transition_detail
