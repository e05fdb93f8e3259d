// Sections of tools as obstacles. The tip and the shoulders are rounded by the circle that touches
// both edges of their corner; the punch then comes down until the tip touches
// (math.md#machine-frame). What may be penetrated is taken off the section, which is cut into
// convex pieces; with a clearance the section stays whole and is kept away from
// (math.md#stroke-clearance).
#include "tool_shape.hpp"

#include "profile_check.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace planish::brake_detail {
namespace {

constexpr double kRoundingChord = 0.002;  // mm: far below what may be penetrated
constexpr double kAtCorner = 1e-6;        // mm: places of a profile that are one

/// A corner of a profile with the circle that rounds it.
struct Rounded {
  size_t corner = 0;
  Vec2 center;
  double radius = 0.0;
  Vec2 start, end;  ///< of the arc, along the profile
};

/// The circle of the radius in a convex corner; smaller where a side is too short for it.
std::optional<Rounded> rounding(const ToolProfile& profile, const Vec2& at, double radius) {
  const auto corner = corner_at(profile, at);
  if (!corner || radius <= 0.0) return std::nullopt;
  const size_t n = profile.size();
  const Vec2 back = profile[(*corner + n - 1) % n] - at, ahead = profile[(*corner + 1) % n] - at;
  const Vec2 u = back.normalized(), v = ahead.normalized();
  const double half = 0.5 * std::acos(std::clamp(u.dot(v), -1.0, 1.0));
  if (cross(u, v) >= 0.0 || std::cos(half) < tolerance::kAside)
    return std::nullopt;  // a straight or inner corner
  const double cut = std::min({radius / std::tan(half), back.norm(), ahead.norm()});
  const double r = cut * std::tan(half);
  return Rounded{*corner, at + (u + v).normalized() * (r / std::sin(half)), r, at + cut * u,
                 at + cut * v};
}

std::vector<Vec2> arc_points(const Rounded& rounded) {
  const Vec2 a = rounded.start - rounded.center, b = rounded.end - rounded.center;
  const double sweep = std::atan2(cross(a, b), a.dot(b));
  return sampled(Arc{rounded.center, rounded.radius, std::atan2(a.y(), a.x()), sweep},
                 kRoundingChord);
}

std::vector<Vec2> rounded_outline(const ToolProfile& profile,
                                  const std::vector<std::optional<Rounded>>& corners) {
  std::vector<Vec2> outline;
  for (size_t i = 0; i < profile.size(); ++i) {
    const auto at = std::ranges::find_if(
        corners, [&](const auto& rounded) { return rounded && rounded->corner == i; });
    if (at == corners.end()) {
      outline.push_back(profile[i]);
      continue;
    }
    const std::vector<Vec2> arc = arc_points(**at);
    outline.insert(outline.end(), arc.begin(), arc.end());
  }
  if (ring_area(outline) < 0.0) std::ranges::reverse(outline);
  return outline;
}

/// Profiles are counter-clockwise for `rounding`.
ToolProfile oriented(ToolProfile profile) {
  if (ring_area(profile) < 0.0) std::ranges::reverse(profile);
  return profile;
}

std::optional<Rounded> tip_of(const Punch& punch) {
  return rounding(oriented(punch.profile), Vec2::Zero(), punch.tip_radius);
}

void keep_away(Obstacle& obstacle, double distance) {
  obstacle.keeps.assign(obstacle.pieces.size(), distance);
  obstacle.keep = distance;
}

void add_boxes(Obstacle& obstacle) {
  obstacle.boxes.clear();
  obstacle.box = {};
  for (const Convex& piece : obstacle.pieces) {
    obstacle.boxes.push_back(box_of(piece));
    obstacle.box.add(obstacle.boxes.back());
  }
}

}  // namespace

double lowered(const Punch& punch) {
  const auto tip = tip_of(punch);
  return tip ? tip->center.y() - tip->radius : 0.0;
}

ToolSection section_of(const Punch& punch) {
  return {moved(rounded_outline(oriented(punch.profile), {tip_of(punch)}), {0.0, -lowered(punch)})};
}

ToolSection foot_of(const Punch& punch) {
  if (!punch.ears) return {};
  return {clipped(section_of(punch).outline, Vec2::UnitY(), punch.ears->height)};
}

ToolSection section_of(const Die& die) {
  const ToolProfile profile = oriented(die.profile);
  const double half = 0.5 * die.opening;
  return {rounded_outline(profile, {rounding(profile, {half, 0.0}, die.shoulder_radius),
                                    rounding(profile, {-half, 0.0}, die.shoulder_radius)})};
}

ToolSection section_of(const ToolProfile& profile, double lowered) {
  return {moved(oriented(profile), {0.0, -lowered})};
}

ToolSection upper_beam_over(const Punch& punch, const PressBrake& machine) {
  return section_of(machine.upper_beam, lowered(punch) - punch.raises_beam);
}

Shoulder shoulder_of(const Die& die) {
  const double half = 0.5 * die.opening;
  const auto round = rounding(oriented(die.profile), {half, 0.0}, die.shoulder_radius);
  if (!round) return {half, 0.0, 0.0};
  return {round->center.x(), round->center.y(), round->radius};
}

Obstacle obstacle_of(const ToolSection& section, double depth, double clearance) {
  Obstacle obstacle;
  if (section.outline.size() < 3) return obstacle;
  obstacle.pieces = convex_pieces({section.outline, {}}, clearance > 0.0 ? 0.0 : depth);
  keep_away(obstacle, clearance);
  add_boxes(obstacle);
  return obstacle;
}

Obstacle obstacle_beside_tip(const Punch& punch, double clearance) {
  Obstacle whole = obstacle_of(section_of(punch), 0.0, clearance), beside;
  const ToolProfile profile = oriented(punch.profile);
  const auto corner = corner_at(profile, Vec2::Zero());
  if (!corner) return whole;
  const size_t n = profile.size();
  const Vec2 down(0.0, lowered(punch));
  const Vec2 flanks[] = {profile[(*corner + 1) % n], profile[(*corner + n - 1) % n]};
  for (const int i : {0, 1}) {
    Vec2 out = Vec2(flanks[i].y(), -flanks[i].x()).normalized();
    if (out.dot(flanks[1 - i]) > 0.0) out = -out;  // away from the other flank
    for (const Convex& piece : whole.pieces)
      if (Convex rest = clipped(piece, -out, out.dot(down)); !is_thin(rest, kAtCorner))
        beside.pieces.push_back(std::move(rest));
  }
  keep_away(beside, clearance);
  add_boxes(beside);
  return beside;
}

Obstacle up_to(Obstacle obstacle, double height) {
  Obstacle low;
  for (std::size_t i = 0; i < obstacle.pieces.size(); ++i) {
    Convex rest = clipped(obstacle.pieces[i], Vec2::UnitY(), height);
    if (is_thin(rest, kAtCorner)) continue;
    low.pieces.push_back(std::move(rest));
    low.keeps.push_back(obstacle.keeps[i]);
  }
  low.keep = obstacle.keep;
  low.moves = obstacle.moves;
  add_boxes(low);
  return low;
}

Obstacle united(Obstacle a, const Obstacle& b) {
  a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
  a.keeps.insert(a.keeps.end(), b.keeps.begin(), b.keeps.end());
  a.keep = std::max(a.keep, b.keep);
  add_boxes(a);
  return a;
}

Obstacle mirrored(const Obstacle& obstacle) {
  Obstacle result = obstacle;
  for (Convex& piece : result.pieces)
    piece = mirrored(piece);
  add_boxes(result);
  return result;
}

Obstacle moved(Obstacle obstacle, const Vec2& by) {
  for (Convex& piece : obstacle.pieces)
    piece = moved(std::move(piece), by);
  add_boxes(obstacle);
  return obstacle;
}

bool is_symmetric(const ToolSection& section) {
  return std::ranges::all_of(section.outline, [&](const Vec2& p) {
    return std::ranges::any_of(section.outline, [&](const Vec2& q) {
      return std::abs(p.x() + q.x()) < kAtCorner && std::abs(p.y() - q.y()) < kAtCorner;
    });
  });
}

}  // namespace planish::brake_detail
