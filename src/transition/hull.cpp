#include "hull.hpp"

#include "roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace planish::transition_detail {
namespace {

/// Share of the extent within which a point lies in a plane.
constexpr double kInPlane = 1e-10;

/// Places nearer to each other are one: rounding, of places that the other boundary's tangents lead
/// to.
constexpr double kSamePlace = 5e-9;

/// A place on a boundary: element plus share of its parameter. Whole numbers are where elements
/// meet. Places count on past the end, round after round.
using Place = double;

/// A plane that touches both boundaries: on each from one place to another, the same unless the
/// plane holds an edge.
struct Event {
  std::array<Place, 2> from{}, to{};
};

class Walker {
 public:
  Walker(std::array<Boundary, 2> boundaries, double size)
      : boundaries_(std::move(boundaries)), in_plane_(kInPlane * size) {}

  Result<std::vector<Event>> events() {
    first_side_events();
    if (auto round = unwrap(); !round) return tl::unexpected(round.error());
    const std::vector<Event> known = std::move(events_);
    events_.clear();
    for (std::size_t i = 0; i < known.size(); ++i) {
      events_.push_back(known[i]);
      Event next = known[(i + 1) % known.size()];
      if (i + 1 == known.size())
        for (std::size_t side = 0; side < 2; ++side) {
          next.from[side] += boundaries_[side].count();
          next.to[side] += boundaries_[side].count();
        }
      fill(known[i], next);
    }
    return std::move(events_);
  }

 private:
  const Boundary& first() const { return boundaries_[0]; }
  const Boundary& second() const { return boundaries_[1]; }

  static SpaceCurvePoint at(const Boundary& boundary, int element, double t) {
    return boundary.element(element).curve(t);
  }

  /// Tangent lines of the first boundary that end or begin something, in order, and what they
  /// touch.
  void first_side_events() {
    for (int i = 0; i < first().count(); ++i) {
      const Element &before = first().element(i - 1), &here = first().element(i);
      if (first().corner_at(i) && !before.straight) add_first(i, i, before.curve(before.t1));
      if (!here.straight && (first().corner_at(i) || !before.straight))
        add_first(i, i, here.curve(here.t0));
      if (here.straight) add_first(i, i + 1, here.curve(here.t0));
    }
  }

  void add_first(Place from, Place to, const SpaceCurvePoint& line) {
    const auto [low, high] = support(line);
    events_.push_back({{from, low}, {to, high}});
  }

  /// Where the plane through a tangent line of the first boundary touches the second, all of it on
  /// the inner side: where the slope of the points over the line, out over up, is largest.
  std::pair<Place, Place> support(const SpaceCurvePoint& line) const {
    const Vec3 along = line.derivative.normalized(), out = along.cross(first().axis);
    const int n = second().count();
    int best = 0;
    double steepest = -std::numeric_limits<double>::infinity();
    Vec3 normal = out;
    for (int k = 0; k < n; ++k) {
      const Element& element = second().element(k);
      const Vec3 arm = element.curve(element.t0).point - line.point;
      const double up = first().axis.dot(arm), slope = out.dot(arm) / up;
      if (slope <= steepest) continue;
      steepest = slope;
      best = k;
      normal = (out - slope * first().axis).normalized();
    }
    const Element &before = second().element(best - 1), &after = second().element(best);
    const auto height = [&](const Vec3& p) { return normal.dot(p - line.point); };
    if (after.straight && std::abs(height(after.curve(after.t1).point)) <= in_plane_)
      return {best, best + 1};
    if (before.straight && std::abs(height(before.curve(before.t0).point)) <= in_plane_)
      return {best - 1 + (best == 0 ? n : 0), best + (best == 0 ? n : 0)};
    if (!after.straight && normal.dot(after.curve(after.t0).derivative) > 0.0)
      return point_on(best, after, line);
    if (!before.straight && normal.dot(before.curve(before.t1).derivative) < 0.0)
      return point_on((best + n - 1) % n, before, line);
    return {best, best};
  }

  /// Where the slope is largest within an element.
  std::pair<Place, Place> point_on(int element, const Element& curve,
                                   const SpaceCurvePoint& line) const {
    const double t = falling_root(
        [&](double s) {
          const SpaceCurvePoint q = curve.curve(s);
          return std::pair{-ahead(line, q),
                           -line.derivative.cross(q.second).dot(q.point - line.point)};
        },
        curve.t0, curve.t1);
    const Place place = element + (t - curve.t0) / (curve.t1 - curve.t0);
    return {place, place};
  }

  /// Places on the second boundary grow with those on the first, once round.
  Result<void> unwrap() {
    const double n = second().count();
    constexpr double kBack = 1e-7;  // rounding may put a place a little before the last
    const double start = events_.front().from[1];
    double last = start;
    for (Event& event : events_) {
      const double length = event.to[1] - event.from[1];
      double from = event.from[1];
      from += n * std::ceil((last - kBack - from) / n);
      event.from[1] = std::max(from, last);
      event.to[1] = std::max(from + length, event.from[1]);
      last = event.to[1];
    }
    if (last > start + n + kBack)
      return fail(ErrorCode::profile_hidden,
                  "the planes that touch both profiles do not follow each other once round: a part "
                  "of one profile is hidden behind "
                  "the other");
    return {};
  }

  /// Tangent lines of the second boundary that end or begin something between two planes, and what
  /// they touch of what the first runs through meanwhile.
  void fill(const Event& last, const Event& next) {
    Place here = last.to[0];
    const auto add = [&](Place from, Place to, const SpaceCurvePoint& line) {
      here = next.from[0] > here ? first_place(line, here, next.from[0]) : here;
      events_.push_back({{here, from}, {here, to}});
    };
    const Place begin = last.to[1], end = next.from[1];
    for (int j = static_cast<int>(std::ceil(begin)); j <= end; ++j) {
      const Element &before = second().element(j - 1), &after = second().element(j);
      if (j > begin && !before.straight && second().corner_at(j))
        add(j, j, before.curve(before.t1));
      if (after.straight && j + 1 <= end) add(j, j + 1, after.curve(after.t0));
      if (!after.straight && j < end && (second().corner_at(j) || !before.straight))
        add(j, j, after.curve(after.t0));
    }
  }

  /// Where a plane through a tangent line of the second boundary touches a curve of the first.
  Place first_place(const SpaceCurvePoint& line, Place low, Place high) const {
    const int element = static_cast<int>(std::floor(0.5 * (low + high)));
    const Element& curve = first().element(element);
    const auto t_of = [&](Place place) { return std::lerp(curve.t0, curve.t1, place - element); };
    const double t = falling_root(
        [&](double s) {
          const SpaceCurvePoint p = curve.curve(s);
          return std::pair{ahead(p, line),
                           p.second.cross(line.derivative).dot(line.point - p.point)};
        },
        t_of(low), t_of(high));
    return std::clamp(element + (t - curve.t0) / (curve.t1 - curve.t0), low, high);
  }

  std::array<Boundary, 2> boundaries_;
  double in_plane_;
  std::vector<Event> events_;
};

/// What a boundary runs through between two places, within one element.
Stretch stretch_between(const Boundary& boundary, Place from, Place to) {
  if (to - from < kSamePlace)
    to = from = std::abs(from - std::round(from)) < kSamePlace ? std::round(from) : from;
  const int element = static_cast<int>(std::floor(from == to ? from : 0.5 * (from + to)));
  const Element& curve = boundary.element(element);
  const auto t_of = [&](Place place) { return std::lerp(curve.t0, curve.t1, place - element); };
  return {((element % boundary.count()) + boundary.count()) % boundary.count(), t_of(from),
          from == to ? t_of(from) : t_of(to)};
}

/// True where `next` runs on along the curve on which `last` ends.
bool runs_on(const Boundary& boundary, const Stretch& last, const Stretch& next) {
  const Element &a = boundary.element(last.element), &b = boundary.element(next.element);
  if (last.moves() != next.moves()) return false;
  if (!last.moves()) return (a.curve(last.t1).point - b.curve(next.t0).point).norm() == 0.0;
  return a.source == b.source && !a.straight && !b.straight;
}

/// One patch of two that follow each other, if they are parts of one curved surface.
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

/// Where an element is highest or lowest between its ends; one of them where it is not.
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
  const Vec3 up = side * plane_of.axis;
  for (const Element& element : other.elements)
    for (const double t : {element.t0, turning_point(element, up), element.t1}) {
      const double h = up.dot(element.curve(t).point - origin);
      low = std::min(low, h);
      high = std::max(high, h);
    }
  constexpr double kTouching = 1e-9;
  if (low > kTouching * size) return {};
  if (high <= kTouching * size)
    return fail(ErrorCode::profiles_meet, "both profiles lie in one plane: set their frames apart",
                "/to/frame");
  const char* whose = from ? "second" : "first";
  if (low >= -kTouching * size)
    return fail(
        ErrorCode::profiles_meet,
        fmt::format("the {} profile touches the plane of the other: move them apart", whose),
        "/to/frame");
  return fail(ErrorCode::profile_hidden,
              fmt::format("the {} profile lies on both sides of the plane of the other, by {:.4g} "
                          "and {:.4g} mm, so that a part of it would be "
                          "hidden inside the transition: move or turn one of them",
                          whose, -low, high),
              "/to/frame");
}

}  // namespace

double ahead(const SpaceCurvePoint& p, const SpaceCurvePoint& q) {
  return p.derivative.cross(q.derivative).dot(q.point - p.point);
}

Result<Hull> lateral_hull(Boundary first, Boundary second, double size) {
  if (auto apart = check_apart(first, second, 1.0, size, true); !apart)
    return tl::unexpected(apart.error());
  if (auto apart = check_apart(second, first, -1.0, size, false); !apart)
    return tl::unexpected(apart.error());
  auto events = Walker({first, second}, size).events();
  if (!events) return tl::unexpected(events.error());
  Hull hull{{std::move(first), std::move(second)}, {}};
  const auto add = [&](const Event& a, const Event& b, bool plane) {
    const std::array<Place, 2>& from = plane ? a.from : a.to;
    const std::array<Place, 2>& to = plane ? a.to : b.from;
    HullPatch patch{plane,
                    {stretch_between(hull.boundaries[0], from[0], to[0]),
                     stretch_between(hull.boundaries[1], from[1], to[1])},
                    {}};
    patch.stops = {{patch.sides[0].t0, patch.sides[1].t0}, {patch.sides[0].t1, patch.sides[1].t1}};
    if (!patch.sides[0].moves() && !patch.sides[1].moves()) return;
    if (hull.patches.empty() || !join(hull, hull.patches.back(), patch))
      hull.patches.push_back(patch);
  };
  for (std::size_t i = 0; i < events->size(); ++i) {
    Event next = (*events)[(i + 1) % events->size()];
    if (i + 1 == events->size())
      for (std::size_t side = 0; side < 2; ++side)
        next.from[side] += hull.boundaries[side].count();
    add((*events)[i], next, true);
    add((*events)[i], next, false);
  }
  // What begins and ends the round may be one patch too.
  if (hull.patches.size() > 1 && join(hull, hull.patches.back(), hull.patches.front()))
    hull.patches.erase(hull.patches.begin());
  return hull;
}

}  // namespace planish::transition_detail
