#include "set_back.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish {
namespace {

/// One straight border of a loop, moved into the face.
class BorderMover {
 public:
  BorderMover(BorderLoop& loop, int border, double distance) : loop_(loop), border_(border) {
    const Vec2 a = start_of(at(0).curve);
    direction_ = (end_of(at(0).curve) - a).normalized();
    inwards_ = Vec2(-direction_.y(), direction_.x());
    origin_ = a + distance * inwards_;
  }

  /// False when a neighbour does not reach the new line before the loop is used up.
  bool run() {
    const auto end = cut(+1);
    const auto start = cut(-1);
    if (!end || !start || (*end - *start).dot(direction_) <= 0.0) return false;
    at(0).curve = Segment{*start, *end};
    at(0).edge_length = 0.0;
    return true;
  }

 private:
  Border& at(int steps) {
    const int n = static_cast<int>(loop_.size());
    return loop_[((border_ + steps) % n + n) % n];
  }

  bool beyond(const Vec2& p) const { return (p - origin_).dot(inwards_) >= 0.0; }

  /// Walks away from the border to the first crossing with the line, cuts there and shrinks what
  /// was passed.
  std::optional<Vec2> cut(int step) {
    for (int k = 1; k < static_cast<int>(loop_.size()); ++k) {
      Border& neighbour = at(step * k);
      const std::vector<double> hits = crossings(neighbour.curve, origin_, direction_);
      const Vec2 far = step > 0 ? end_of(neighbour.curve) : start_of(neighbour.curve);
      if (hits.empty() && !beyond(far)) continue;
      const double t = hits.empty() ? (step > 0 ? 0.0 : 1.0)
                                    : (step > 0 ? hits.front() : hits.back());
      const Vec2 corner = point_at(neighbour.curve, t);
      if (t > 0.0 && t < 1.0) {
        neighbour.curve = step > 0 ? trimmed(neighbour.curve, t, 1.0)
                                   : trimmed(neighbour.curve, 0.0, t);
        neighbour.edge_length = 0.0;
      }
      for (int passed = 1; passed < k; ++passed) {
        at(step * passed).curve = Segment{corner, corner};
        at(step * passed).edge_length = 0.0;
      }
      return corner;
    }
    return {};
  }

  BorderLoop& loop_;
  int border_;
  Vec2 origin_, direction_, inwards_;
};

bool outward(const Sheet& sheet, const Joint& joint) {
  return joint.sharp && !sheet.bends[index_of(*joint.sharp)].reference_inside;
}

}  // namespace

bool needs_setback(const Sheet& sheet) {
  return sheet.reference_depth == 0.0 &&
         std::any_of(sheet.joints.begin(), sheet.joints.end(),
                     [&](const Joint& joint) { return outward(sheet, joint); });
}

Result<Sheet> with_setback(const Sheet& sheet) {
  Sheet moved = sheet;
  for (const Joint& joint : sheet.joints) {
    if (!outward(sheet, joint)) continue;
    const double half_turn = sheet.bends[index_of(*joint.sharp)].angle.radians() / 2;
    const double setback = sheet.thickness * std::tan(half_turn);
    for (const BorderRef& ref : {joint.a, joint.b}) {
      Face& face = moved.faces[index_of(ref.face)];
      const bool flat = std::holds_alternative<Frame>(face.surface);
      if (flat && BorderMover(face.loops[ref.loop], ref.border, setback).run()) continue;
      return fail(ErrorCode::unsupported_shape,
                  fmt::format("Face {} has no room for the setback of {:.4g} mm that its sharp "
                              "bend of {:.1f}° needs; model "
                              "the bend with a radius.",
                              face.source_face, setback, 2 * half_turn * 180 / std::numbers::pi),
                  fmt::format("face {}", face.source_face));
    }
  }
  return moved;
}

}  // namespace planish
