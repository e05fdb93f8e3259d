#include "plane_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

constexpr double kAllowed = 0.05, kUnsure = 0.03;  // mm
constexpr int kTurns = 90;
constexpr double kPointStep = 0.5;  // mm along borders
constexpr double kArcStep = 2.0 * std::numbers::pi / 180.0;

using Ring = std::vector<Vec2>;

/// A cross-section of the sheet: its middle and its direction there.
struct Station {
  Vec2 middle;
  double heading = 0.0;
};

/// One side of the pressed bend, from the middle of the bend outwards, upwards being inside.
struct Side {
  std::vector<Station> stations;
  double flat = 0.0;  ///< developed, from the bend line to where the plane side ends
};

struct Walker {
  Station at;
  std::vector<Station> stations;
  void straight(double length) {
    at.middle += length * Vec2(std::cos(at.heading), std::sin(at.heading));
    stations.push_back(at);
  }
  /// Turns by an angle, upwards if above 0, at a radius of the middle of the sheet.
  void turn(double angle, double radius) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / kArcStep)));
    const double sign = angle > 0.0 ? 1.0 : -1.0;
    const Vec2 center = at.middle +
                        sign * radius * Vec2(-std::sin(at.heading), std::cos(at.heading));
    for (int i = 0; i < steps; ++i) {
      at.heading += angle / steps;
      at.middle = center - sign * radius * Vec2(-std::sin(at.heading), std::cos(at.heading));
      stations.push_back(at);
    }
  }
};

double allowance_of(const Profile& profile, const ProfileBend& bend) {
  return bend.angle.radians() * (bend.radius + profile.k * profile.thickness);
}

Side side_of(const Profile& profile, const PlaneStroke& stroke, bool behind, double turn) {
  const double t = profile.thickness;
  const ProfileBend& pressed = profile.bends[stroke.pressed];
  Side side;
  Walker walker{{Vec2(0.0, -0.5 * t), 0.0}, {}};
  walker.stations.push_back(walker.at);
  const double allowance = allowance_of(profile, pressed);
  if (turn > 0.0)
    walker.turn(0.5 * turn, allowance / turn - profile.k * t + 0.5 * t);
  else
    walker.straight(0.5 * allowance);
  side.flat = 0.5 * allowance;
  bool in_plane = true;
  const int step = behind ? 1 : -1, count = static_cast<int>(profile.bends.size());
  for (int i = stroke.pressed;; i += step) {
    const int flange = behind ? i : i - 1;  // the flange behind bend `flange`
    const double length = flange < 0 ? profile.first : profile.bends[flange].after;
    walker.straight(length);
    if (in_plane) side.flat += length;
    const int next = i + step;
    if (next < 0 || next >= count) break;
    const ProfileBend& bend = profile.bends[next];
    if (stroke.formed[next]) {
      walker.turn((bend.up == pressed.up ? 1.0 : -1.0) * bend.angle.radians(),
                  bend.radius + 0.5 * t);
      in_plane = false;
    } else {
      walker.straight(allowance_of(profile, bend));
      if (in_plane) side.flat += allowance_of(profile, bend);
    }
  }
  side.stations = walker.stations;
  return side;
}

/// Points on both skins and across the ends of a side.
Ring points_of(const Side& side, double t) {
  Ring points;
  const auto add = [&](const Station& station) {
    const Vec2 up(-std::sin(station.heading), std::cos(station.heading));
    for (const double at : {-0.5, -0.25, 0.0, 0.25, 0.5})
      points.push_back(station.middle + at * t * up);
  };
  for (size_t i = 1; i < side.stations.size(); ++i) {
    const Station &a = side.stations[i - 1], &b = side.stations[i];
    const int steps = std::max(1, static_cast<int>((b.middle - a.middle).norm() / kPointStep));
    for (int k = 0; k < steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      add({a.middle + share * (b.middle - a.middle), a.heading + share * (b.heading - a.heading)});
    }
  }
  add(side.stations.back());
  return points;
}

/// A ring with the corner at `at` rounded: the circle of radius r that touches both its sides.
Ring rounded(Ring ring, const Vec2& at, double r) {
  const auto found = std::ranges::find_if(ring,
                                          [&](const Vec2& p) { return (p - at).norm() < 1e-9; });
  const size_t n = ring.size(), i = static_cast<size_t>(found - ring.begin());
  const Vec2 u = (ring[(i + n - 1) % n] - at).normalized(),
             v = (ring[(i + 1) % n] - at).normalized();
  const double half = 0.5 * std::acos(u.dot(v));
  const Vec2 center = at + (u + v).normalized() * (r / std::sin(half));
  Ring arc;
  const Vec2 a = at + u * (r / std::tan(half)) - center, b = at + v * (r / std::tan(half)) - center;
  for (int k = 0; k <= 24; ++k) {
    const Vec2 way = ((24 - k) * a + k * b) / 24.0;  // between the two ends, then onto the circle
    arc.push_back(center + r * way.normalized());
  }
  ring.erase(found);
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i), arc.begin(), arc.end());
  return ring;
}

Ring moved(Ring ring, const Vec2& by) {
  for (Vec2& p : ring)
    p += by;
  return ring;
}

/// How deep the deepest of the points is in the ring; 0 outside.
double depth_in(const Ring& ring, const Ring& points) {
  double deepest = 0.0;
  Box2 box;
  for (const Vec2& p : ring)
    box.add(p);
  for (const Vec2& p : points) {
    if ((p.array() < box.lo.array()).any() || (p.array() > box.hi.array()).any()) continue;
    bool within = false;
    double near = 1e9;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        within = !within;
      const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      near = std::min(near, (p - a - along * (b - a)).norm());
    }
    if (within) deepest = std::max(deepest, near);
  }
  return deepest;
}

/// Die and shoulder.
struct Lower {
  Ring ring;
  double across = 0.0, radius = 0.0;  ///< of the shoulder's middle, and of the shoulder
};

Lower lower_of(const Die& die) {
  const double half = 0.5 * die.opening, q = die.shoulder_radius;
  Lower lower{rounded(rounded(die.profile, {half, 0}, q), {-half, 0}, q), 0.0, q};
  // The circle touches the top, so its middle is q below; and the flank, which is A/2 from upright:
  // q from the line through (half, 0).
  const double a = 0.5 * die.angle.radians();
  lower.across = half + (q - q * std::sin(a)) / std::cos(a);
  return lower;
}

/// The height at which the shoulder's circle touches the outside of a side that rises.
double height_on(const Side& side, double t, const Lower& lower, double turn, double* touched) {
  const double h = 0.5 * turn;
  // The outside line of the plane side, by the first station that has its full slope.
  const auto plane = std::ranges::find_if(
      side.stations, [&](const Station& at) { return std::abs(at.heading - h) < 1e-12; });
  const Vec2 up(-std::sin(h), std::cos(h)), along(std::cos(h), std::sin(h));
  const Vec2 p = plane->middle - 0.5 * t * up;
  // (across, z) is `radius` below the line: up·((across, z) − p) = −radius.
  const double z = (up.dot(p) - lower.radius - up.x() * lower.across) / up.y();
  *touched = along.dot(Vec2(lower.across, z) - p);
  return z + lower.radius;
}

}  // namespace

std::vector<StripPart> Profile::strip() const {
  std::vector<StripPart> parts{Straight{first}};
  for (const ProfileBend& bend : bends) {
    parts.push_back(
        Turn{bend.angle, bend.radius, bend.up ? BendDirection::up : BendDirection::down});
    parts.push_back(Straight{bend.after});
  }
  return parts;
}

PlaneVerdict plane_verdict(const Profile& profile, const PlaneStroke& stroke, const Punch& punch,
                           const Die& die, const ToolProfile& upper_beam) {
  const double t = profile.thickness;
  const ProfileBend& bend = profile.bends[stroke.pressed];
  const double most = bend.angle.radians() + stroke.springback;
  Ring upper = rounded(punch.profile, {0, 0}, punch.tip_radius);
  double lowest = 1e9;
  for (const Vec2& p : upper)
    lowest = std::min(lowest, p.y());
  upper = moved(upper, {0, -lowest});
  const Ring beam = moved(upper_beam, {0, -lowest});
  const Lower lower = lower_of(die);
  double deepest = 0.0, shortest = 1e9;
  for (int i = 0; i <= kTurns; ++i) {
    const double turn = most * i / kTurns;
    for (const bool behind : {false, true}) {
      const Side side = side_of(profile, stroke, behind, turn);
      double touched = 0.0;
      const double z = height_on(side, t, lower, turn, &touched);
      const double half_zone = 0.5 * allowance_of(profile, bend);
      shortest = std::min({shortest, side.flat - 0.5 * die.opening - die.shoulder_radius,
                           side.flat - half_zone - touched, touched});
      Ring points = points_of(side, t);
      if (behind != stroke.gauge_behind)
        for (Vec2& p : points)
          p.x() = -p.x();
      deepest = std::max(
          {deepest, depth_in(upper, points), depth_in(moved(lower.ring, {0, z}), points)});
      if (!beam.empty()) deepest = std::max(deepest, depth_in(beam, points));
    }
  }
  if (shortest < -kUnsure || deepest > kAllowed + kUnsure) return PlaneVerdict::blocked;
  if (shortest > kUnsure && deepest < kAllowed - kUnsure) return PlaneVerdict::clear;
  return PlaneVerdict::close;
}

}  // namespace planish::test
