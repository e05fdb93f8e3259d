#include "strip.hpp"

#include "integral.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace planish::transition_detail {
namespace {

/// Directions that differ by less (sine), lengths by less (share), are the same: of right cones.
constexpr double kRight = 1e-12;
/// Share of its distance from the origin by which a point may be off, from rounding.
constexpr double kRounding = 1e-15;

/// Knots of an element's curve after t0 and before t1, of a closed one round after round;
/// ascending.
std::vector<double> knots_between(const Element& element, double t0, double t1) {
  std::vector<double> knots;
  for (const double t : element.knots) {
    if (element.period == 0.0) {
      if (t > t0 && t < t1) knots.push_back(t);
      continue;
    }
    for (double here = t + element.period * std::ceil((t0 - t) / element.period); here < t1;
         here += element.period)
      if (here > t0) knots.push_back(here);
  }
  std::sort(knots.begin(), knots.end());
  return knots;
}

Border border(const Curve2& curve, double length) {
  Border border;
  border.curve = curve;
  border.edge_length = length;
  return border;
}

}  // namespace

double arc_length(const Element& element, double t0, double t1) {
  if (t1 < t0) return -arc_length(element, t1, t0);
  std::vector<double> breaks = knots_between(element, t0, t1);
  breaks.insert(breaks.begin(), t0);
  breaks.push_back(t1);
  return integral_over([&](double t) { return element.curve(t).derivative.norm(); }, breaks);
}

Strip::Strip(std::shared_ptr<const Hull> hull, const HullPatch& patch, double tolerance)
    : hull_(std::move(hull)),
      patch_(patch),
      curves_{&hull_->element(0, patch.sides[0]), &hull_->element(1, patch.sides[1])},
      tolerance_(tolerance) {
  if (patch_.plane) return;
  find_right();
  if (right_) {
    base_ = patch_.sides[0].moves() ? 0 : 1;
    return;
  }
  // The surface is written about the side that nowhere stands still, or nearly so.
  std::array<double, 2> slowest{1.0, 1.0};
  constexpr int kSamples = 16;
  for (std::size_t side = 0; side < 2; ++side)
    for (int i = 0; i <= kSamples; ++i) {
      const double whole = patch_.sides[side].t1 - patch_.sides[side].t0;
      slowest[side] = whole == 0.0 ? 0.0
                                   : std::min(slowest[side],
                                              pairing(i / double(kSamples)).rate[side] / whole);
    }
  base_ = slowest[1] > slowest[0] ? 1 : 0;
  find_breaks();
}

PatchKind Strip::kind() const {
  if (patch_.plane) return PatchKind::plane;
  const bool apex = !patch_.sides[0].moves() || !patch_.sides[1].moves();
  return apex || right_ ? PatchKind::cone : PatchKind::general;
}

BendKind Strip::bend_kind() const {
  if (!right_) return BendKind::general;
  return std::holds_alternative<Cylinder>(right_->surface) ? BendKind::cylinder : BendKind::cone;
}

void Strip::find_right() {
  const std::array<std::optional<Circle>, 2> circles{curves_[0]->circle, curves_[1]->circle};
  const int moving = patch_.sides[0].moves() ? 0 : 1;
  const auto m = static_cast<std::size_t>(moving), o = 1 - m;
  if (!circles[m]) return;
  const SpaceCurvePoint start = point(moving, patch_.sides[m].t0);
  const Vec3 centre = circles[m]->centre;
  const double radius = circles[m]->radius;
  const double near = kRight + kRounding * centre.norm() / radius;
  const double turned = patch_.sides[m].t1 - patch_.sides[m].t0;
  const Vec3 up = (start.point - centre).cross(start.derivative).normalized();
  const auto on_axis = [&](const Vec3& p) {
    return (p - centre).cross(up).norm() <= near * (p - centre).norm();
  };
  double other_radius = 0.0;
  Vec3 other = point(static_cast<int>(o), patch_.sides[o].t0).point;
  if (patch_.sides[o].moves()) {
    if (!circles[o]) return;
    const SpaceCurvePoint there = point(static_cast<int>(o), patch_.sides[o].t0);
    const Vec3 arm = there.point - circles[o]->centre;
    if (arm.cross(start.point - centre).norm() > near * arm.norm() * radius) return;
    if (std::abs(up.dot(arm)) > near * arm.norm() ||
        up.cross(arm.cross(there.derivative)).norm() > near * arm.cross(there.derivative).norm())
      return;
    other = circles[o]->centre;
    other_radius = circles[o]->radius;
  }
  if (!on_axis(other)) return;
  const double rise = up.dot(other - centre);  // from the moving side's circle to the other
  const Vec3 x = (start.point - centre) / radius;
  Right right;
  const double slant = std::hypot(rise, radius - other_radius);
  if (std::abs(radius - other_radius) <= near * radius) {
    right.surface = Cylinder{{centre, x, up.cross(x), up}, radius};
    right.u1 = turned;
    right.v[o] = rise;
  } else {
    // The apex beyond the smaller circle; the cone opens away from it.
    const double to_apex = rise * radius / (radius - other_radius);
    const Vec3 z = to_apex > 0.0 ? Vec3(-up) : up;
    right.surface = Cone{{centre + to_apex * up, x, z.cross(x), z},
                         std::atan2(std::abs(radius - other_radius), std::abs(rise))};
    right.u1 = to_apex > 0.0 ? -turned : turned;
    const double scale = slant / std::abs(radius - other_radius);
    right.v[m] = scale * radius;
    right.v[o] = scale * other_radius;
  }
  right_ = right;
}

Strip::Pairing Strip::pairing(double at) const {
  const bool both = patch_.sides[0].moves() && patch_.sides[1].moves();
  if (both && !patch_.plane && !right_) return solved(at);
  Pairing pairing;
  for (std::size_t side = 0; side < 2; ++side) {
    const Stretch& stretch = patch_.sides[side];
    pairing.t[side] = std::lerp(stretch.t0, stretch.t1, at);
    pairing.rate[side] = stretch.t1 - stretch.t0;
  }
  return pairing;
}

// Rulings are numbered by the mean of the shares of both curves that lie behind them, since either
// may stand still for a moment. MATH 5.3 then fixes both.
Strip::Pairing Strip::solved(double at) const {
  const Stretch &a = patch_.sides[0], &b = patch_.sides[1];
  const double whole_a = a.t1 - a.t0, whole_b = b.t1 - b.t0;
  const auto share_of = [&](const std::array<double, 2>& stop) {
    return (stop[0] - a.t0) / whole_a;
  };
  const auto number_of = [&](const std::array<double, 2>& stop) {
    return 0.5 * (share_of(stop) + (stop[1] - b.t0) / whole_b);
  };
  const auto above = std::find_if(patch_.stops.begin() + 1, patch_.stops.end() - 1,
                                  [&](const auto& stop) { return number_of(stop) > at; });
  const auto slopes = [&](double share) {
    const SpaceCurvePoint p = point(0, a.t0 + share * whole_a),
                          q = point(1, b.t0 + (2.0 * at - share) * whole_b);
    const Vec3 arm = q.point - p.point;
    return std::array{ahead(p, q), p.second.cross(q.derivative).dot(arm) * whole_a,
                      p.derivative.cross(q.second).dot(arm) * whole_b};
  };
  const double low = share_of(*(above - 1)), high = share_of(*above);
  const double high_b = 2.0 * number_of(*above) - high, low_b = 2.0 * number_of(*(above - 1)) - low;
  const double share = falling_root(
      [&](double s) {
        const auto [value, by_a, by_b] = slopes(s);
        return std::pair{value, by_a - by_b};
      },
      std::max(low, 2.0 * at - high_b), std::min(high, 2.0 * at - low_b));
  const auto [value, by_a, by_b] = slopes(share);
  const double rate_a = by_b == by_a ? 1.0 : 2.0 * by_b / (by_b - by_a);
  return {{a.t0 + share * whole_a, b.t0 + (2.0 * at - share) * whole_b},
          {rate_a * whole_a, (2.0 - rate_a) * whole_b}};
}

std::array<Vec3, 2> Strip::ruling(double at) const {
  const Pairing pair = pairing(at);
  return {point(0, pair.t[0]).point, point(1, pair.t[1]).point};
}

Vec3 Strip::normal(double at) const {
  if (!patch_.plane) return local(at).normal;
  const int edge = patch_.sides[0].moves() ? 0 : 1;
  const auto [p, q] = ruling(at);
  return point(edge, patch_.sides[edge].t0).derivative.cross(q - p).normalized();
}

double Strip::ruling_at(int side, double t) const {
  const Stretch& stretch = patch_.sides[side];
  const double share = (t - stretch.t0) / (stretch.t1 - stretch.t0);
  const bool both = patch_.sides[0].moves() && patch_.sides[1].moves();
  if (!both || patch_.plane || right_) return share;
  const auto s = static_cast<std::size_t>(side);
  return root_between(
      [&](double at) {
        const Pairing pair = pairing(at);
        return std::pair{pair.t[s] - t, pair.rate[s]};
      },
      0.0, 1.0);
}

Strip::Local Strip::local(double at) const {
  const Pairing pair = pairing(at);
  const std::array<SpaceCurvePoint, 2> ends{point(0, pair.t[0]), point(1, pair.t[1])};
  const auto base = static_cast<std::size_t>(base_);
  const Vec3 arm = ends[1].point - ends[0].point;
  const Vec3 arm_rate = pair.rate[1] * ends[1].derivative - pair.rate[0] * ends[0].derivative;
  Local local;
  local.length = arm.norm();
  const Vec3 g = arm / local.length;
  local.length_rate = g.dot(arm_rate);
  const Vec3 g_rate = (arm_rate - local.length_rate * g) / local.length;
  const Vec3 b_rate = pair.rate[base] * ends[base].derivative;
  local.knot = {at, ends[base].point, b_rate, g, g_rate};
  local.normal = b_rate.cross(g).normalized();
  const Vec3 across = g.cross(local.normal);
  local.across = b_rate.dot(across);
  local.far_across = local.across + (base_ == 0 ? 1.0 : -1.0) * local.length * g_rate.dot(across);
  // n · b′ = 0 all along, so n′ · b′ = −n · b″, and n′ is across the ruling.
  local.turn_rate = std::abs(local.normal.dot(ends[base].second)) * pair.rate[base] *
                    pair.rate[base] / local.across;
  return local;
}

double Strip::area(double from, double to) const {
  if (patch_.plane) {
    const auto [p0, q0] = ruling(from);
    const auto [p1, q1] = ruling(to);
    return 0.5 * (q1 - p0).cross(q0 - p1).norm();
  }
  return integral_over(
      [&](double at) {
        const Local l = local(at);
        return 0.5 * l.length * (l.across + l.far_across);
      },
      breaks_between(from, to));
}

double Strip::border_length(int side, double from, double to) const {
  if (!patch_.sides[side].moves()) return 0.0;
  if (patch_.plane) return (ruling(to)[side] - ruling(from)[side]).norm();
  const auto s = static_cast<std::size_t>(side);
  return arc_length(*curves_[s], pairing(from).t[s], pairing(to).t[s]);
}

double Strip::turn(double from, double to) const {
  return patch_.plane || from == to ? 0.0
                                    : integral_over([&](double at) { return local(at).turn_rate; },
                                                    breaks_between(from, to));
}

double Strip::turned(double from, double to) const {
  const Vec3 a = normal(from), b = normal(to);
  const double between = std::atan2(a.cross(b).norm(), a.dot(b));
  // How far the normals go round their common axis, in steps of less than half a turn.
  constexpr int kSteps = 16;
  std::vector<Vec3> normals;
  Vec3 axis = Vec3::Zero();
  for (int i = 0; i <= kSteps; ++i) {
    normals.push_back(normal(std::lerp(from, to, i / double(kSteps))));
    if (i > 0) axis += normals[static_cast<std::size_t>(i) - 1].cross(normals.back());
  }
  axis.normalize();
  double round = 0.0;
  for (std::size_t i = 1; i < normals.size(); ++i) {
    const Vec3 p = normals[i - 1] - axis.dot(normals[i - 1]) * axis,
               q = normals[i] - axis.dot(normals[i]) * axis;
    round += std::atan2(axis.dot(p.cross(q)), p.dot(q));
  }
  return round > std::numbers::pi ? 2.0 * std::numbers::pi - between : between;
}

Strip::Radii Strip::smallest_radii(double from, double to) const {
  constexpr int kSamples = 64;
  Radii radii{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const bool apex = !patch_.sides[0].moves() || !patch_.sides[1].moves();
  for (int i = 0; i <= kSamples; ++i) {
    const Local l = local(std::lerp(from, to, i / double(kSamples)));
    if (l.turn_rate == 0.0) continue;
    const auto [tight, wide] = std::minmax(l.across, l.far_across);
    radii.middle = std::min(radii.middle, 0.5 * (tight + wide) / l.turn_rate);
    radii.end = std::min(radii.end, (apex ? wide : tight) / l.turn_rate);
  }
  return radii;
}

double Strip::distance_of_radius(double radius) const {
  // On cones the radius grows with the distance from the apex.
  constexpr int kSamples = 64;
  double distance = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const Local l = local(i / double(kSamples));
    distance = std::max(distance,
                        radius * l.turn_rate * l.length / std::max(l.across, l.far_across));
  }
  return distance;
}

double Strip::tip_area(double from, double to, const Tips& tips) const {
  double area = 0.0;
  if (patch_.plane) {
    for (const PanelCorner& corner : panel_corners(from, to, tips))
      area += 0.5 * (corner.cut_before - corner.at).cross(corner.cut_after - corner.at).norm();
    return area;
  }
  for (std::size_t side = 0; side < 2; ++side)
    if (const double cut = tips.at_from[side]; cut > 0.0 && stands(static_cast<int>(side)))
      area += 0.5 * cut * cut *
              integral(
                  [&](double at) {
                    const Local l = local(at);
                    return std::max(l.across, l.far_across) / l.length;
                  },
                  from, to);
  return area;
}

std::vector<Strip::PanelCorner> Strip::panel_corners(double from, double to,
                                                     const Tips& tips) const {
  const auto [p0, q0] = ruling(from);
  const auto [p1, q1] = ruling(to);
  struct Corner {
    Vec3 at;
    double cut = 0.0;
    bool edge_after = false;  ///< what follows is an edge of a profile
  };
  std::vector<Corner> corners{{p0, tips.at_from[0], !stands(0)}};
  if (!stands(0)) corners.push_back({p1, tips.at_to[0], false});
  if (!stands(1)) corners.push_back({q1, tips.at_to[1], true});
  corners.push_back({q0, tips.at_from[1], false});
  // Room is needed beside folds; of a profile's edge a part is enough.
  constexpr double kMostOfEdge = 0.4;
  const auto cut_on = [](const Corner& corner, const Vec3& towards, bool edge) -> Vec3 {
    const Vec3 way = towards - corner.at;
    const double cut = edge ? std::min(corner.cut, kMostOfEdge * way.norm()) : corner.cut;
    return corner.at + cut * way.normalized();
  };
  std::vector<PanelCorner> cut;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner &before = corners[(i + corners.size() - 1) % corners.size()], &here = corners[i],
                 &after = corners[(i + 1) % corners.size()];
    cut.push_back({here.at, cut_on(here, before.at, before.edge_after),
                   cut_on(here, after.at, here.edge_after)});
  }
  return cut;
}

Strip::Part Strip::part(double from, double to, const Tips& tips) const {
  if (patch_.plane) return plane_part(from, to, tips);
  return right_ ? right_part(from, to, tips) : ruled_part(from, to, tips);
}

Strip::Part Strip::plane_part(double from, double to, const Tips& tips) const {
  const std::vector<PanelCorner> corners = panel_corners(from, to, tips);
  Part part;
  part.from = from;
  part.to = to;
  const Frame frame = frame_from_axes(corners[0].at, normal(0.5 * (from + to)),
                                      (stands(0) ? corners.back() : corners[1]).at - corners[0].at);
  part.face.surface = frame;
  BorderLoop loop;
  const auto add = [&](const Vec3& a, const Vec3& b) {
    loop.push_back(border(Segment{frame.local2(a), frame.local2(b)}, (b - a).norm()));
  };
  const std::size_t over = stands(0) ? 0 : 1;  // the ruling at `to` begins here
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PanelCorner &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (i == over) part.ruling_borders[1] = static_cast<int>(loop.size());
    if (i + 1 == corners.size()) part.ruling_borders[0] = static_cast<int>(loop.size());
    add(a.cut_after, b.cut_before);
    if (b.cut_before != b.cut_after) add(b.cut_before, b.cut_after);
  }
  part.face.loops.push_back(std::move(loop));
  return part;
}

Strip::Part Strip::right_part(double from, double to, const Tips& tips) const {
  Part part;
  part.from = from;
  part.to = to;
  part.u0 = std::lerp(right_->u0, right_->u1, from);
  part.u1 = std::lerp(right_->u0, right_->u1, to);
  part.face.surface = right_->surface;
  const double v0 = right_->v[0] + (stands(0) ? tips.at_from[0] : 0.0),
               v1 = right_->v[1] + (stands(1) ? tips.at_from[1] : 0.0);
  const Vec2 p0(part.u0, v0), p1(part.u1, v0), q0(part.u0, v1), q1(part.u1, v1);
  const double length = std::abs(v1 - v0);
  part.face.loops.push_back(
      {border(Segment{p0, p1}, border_length(0, from, to)), border(Segment{p1, q1}, length),
       border(Segment{q1, q0}, border_length(1, from, to)), border(Segment{q0, p0}, length)});
  part.ruling_borders = {3, 1};
  return part;
}

void Strip::find_breaks() {
  for (std::size_t side = 0; side < 2; ++side) {
    const Stretch& stretch = patch_.sides[side];
    if (!stretch.moves()) continue;
    for (const double t : knots_between(*curves_[side], stretch.t0, stretch.t1))
      breaks_.push_back(ruling_at(static_cast<int>(side), t));
  }
  std::sort(breaks_.begin(), breaks_.end());
}

std::vector<double> Strip::breaks_between(double from, double to) const {
  constexpr double kApart = 1e-9;
  std::vector<double> breaks{from};
  for (const double at : breaks_)
    if (at > breaks.back() + kApart && at < to - kApart) breaks.push_back(at);
  breaks.push_back(to);
  return breaks;
}

Strip::Part Strip::ruled_part(double from, double to, const Tips& tips) const {
  const double cut = (stands(0) ? tips.at_from[0] : 0.0) + (stands(1) ? tips.at_from[1] : 0.0);
  const double sign = base_ == 0 ? 1.0 : -1.0;
  const std::vector<double> breaks = breaks_between(from, to);
  Part part;
  part.from = part.u0 = from;
  part.to = part.u1 = to;
  part.face.surface = ruled_through(
      [&](double at) -> Ruling {
        const Local l = local(at);
        return {l.knot, sign * l.length};
      },
      breaks, tolerance_);
  const double speed = std::max(border_length(0, from, to), border_length(1, from, to)) /
                       (to - from);
  const CubicSpline far = fit_cubics_on_surface(
      [&](double at) -> CurveSample {
        const Local l = local(at);
        return {{at, sign * (l.length - cut)}, {1.0, sign * l.length_rate}};
      },
      from, to, speed, tolerance_);
  const Curve2 near = Segment{{from, 0.0}, {to, 0.0}};
  const auto length = [&](double at) { return local(at).length - cut; };
  const Curve2 bottom = base_ == 0 ? near : Curve2(far);
  const Curve2 top = reversed(base_ == 0 ? Curve2(far) : near);
  const Vec2 p0 = start_of(bottom), p1 = end_of(bottom), q1 = start_of(top), q0 = end_of(top);
  part.face.loops.push_back(
      {border(bottom, border_length(0, from, to)), border(Segment{p1, q1}, length(to)),
       border(top, border_length(1, from, to)), border(Segment{q0, p0}, length(from))});
  part.ruling_borders = {3, 1};
  return part;
}

}  // namespace planish::transition_detail
