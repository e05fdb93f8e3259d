// Takes stretches that a contour runs there and back out of it, as a stack: a curve that comes back
// along the one before removes it, or what both share, and may then meet the one before that. The
// last and the first follow each other too. What was removed are slits; collinear ones that touch
// become one.

#include "spurs.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

// Stretches that a contour runs there and back. The path is built curve by curve, and where it
// reverses on its own line the common part is taken off both, starting at the tips: one pass finds
// spurs on spurs. The last curve and the first follow each other too. Collinear stretches that
// touch become one.

namespace planish::sheet_detail {
namespace {

struct TracedCurve {
  Curve2 curve;
  std::vector<Origin> origins;
};

double distance_to_line(const Vec2& p, const Segment& line) {
  const Vec2 along = (line.b - line.a).normalized(), d = p - line.a;
  return std::abs(cross(along, d));
}

/// Whether the path reverses between the two curves and comes back on its own line.
bool turns_round(const Segment& there, const Segment& back, double tolerance) {
  if ((there.b - there.a).dot(back.b - back.a) >= 0.0) return false;
  return length(there) > length(back) ? distance_to_line(back.b, there) <= tolerance
                                      : distance_to_line(there.a, back) <= tolerance;
}

/// The path so far, in which no curve runs back along the one before.
class Path {
 public:
  explicit Path(double tolerance) : tolerance_(tolerance) {}

  void append(TracedCurve curve) {
    while (auto rest = folded_back(curves_.empty() ? nullptr : &curves_.back(), curve)) {
      curves_.pop_back();
      if (rest->before) return curves_.push_back(std::move(*rest->before));
      if (!rest->after) return;
      curve = std::move(*rest->after);
    }
    curves_.push_back(std::move(curve));
  }

  /// The last curve and the first follow each other too.
  void close() {
    while (curves_.size() > 1) {
      auto rest = folded_back(&curves_.back(), curves_.front());
      if (!rest) return;
      curves_.pop_back();
      curves_.pop_front();
      if (rest->before) curves_.push_back(std::move(*rest->before));
      if (rest->after) curves_.push_front(std::move(*rest->after));
    }
  }

  const std::deque<TracedCurve>& curves() const { return curves_; }
  const std::vector<Segment>& slits() const { return slits_; }

 private:
  struct Rest {
    std::optional<TracedCurve> before, after;
  };

  /// What is left of two curves if the path reverses between them; empty if it does not.
  std::optional<Rest> folded_back(const TracedCurve* before, const TracedCurve& after) {
    if (before == nullptr) return std::nullopt;
    const auto* there = std::get_if<Segment>(&before->curve);
    const auto* back = std::get_if<Segment>(&after.curve);
    if (there == nullptr || back == nullptr || !turns_round(*there, *back, tolerance_))
      return std::nullopt;
    const double longer = length(*there) - length(*back);
    Rest rest;
    if (longer > tolerance_) {
      slits_.push_back({back->a, back->b});
      rest.before = TracedCurve{Segment{there->a, back->b}, before->origins};
    } else {
      slits_.push_back({there->b, there->a});
      if (longer < -tolerance_) rest.after = TracedCurve{Segment{there->a, back->b}, after.origins};
    }
    return rest;
  }

  double tolerance_;
  std::deque<TracedCurve> curves_;
  std::vector<Segment> slits_;
};

/// Both as one segment if they are collinear and touch.
std::optional<Segment> joined(const Segment& a, const Segment& b, double tolerance) {
  const auto apart = [&](int axis) {
    return std::min(a.a[axis], a.b[axis]) > std::max(b.a[axis], b.b[axis]) + tolerance ||
           std::min(b.a[axis], b.b[axis]) > std::max(a.a[axis], a.b[axis]) + tolerance;
  };
  if (apart(0) || apart(1)) return std::nullopt;
  const Segment& longer = length(a) < length(b) ? b : a;
  const Segment& other = length(a) < length(b) ? a : b;
  if (distance_to_line(other.a, longer) > tolerance ||
      distance_to_line(other.b, longer) > tolerance)
    return std::nullopt;
  const Vec2 along = (longer.b - longer.a).normalized();
  const auto at = [&](const Vec2& p) { return along.dot(p - longer.a); };
  const auto [from, to] = std::minmax({at(other.a), at(other.b)});
  if (from > length(longer) + tolerance || to < -tolerance) return std::nullopt;
  const Vec2 &first = at(other.a) < at(other.b) ? other.a : other.b,
             &last = at(other.a) < at(other.b) ? other.b : other.a;
  return Segment{from < 0.0 ? first : longer.a, to > length(longer) ? last : longer.b};
}

std::vector<Segment> joined(const std::vector<Segment>& slits, double tolerance) {
  std::vector<Segment> whole;
  for (Segment slit : slits) {
    std::erase_if(whole, [&](const Segment& other) {
      const auto both = joined(slit, other, tolerance);
      if (both) slit = *both;
      return both.has_value();
    });
    whole.push_back(slit);
  }
  return whole;
}

}  // namespace

WithoutSpurs without_spurs(const Contour& contour, double tolerance) {
  Path path(tolerance);
  for (std::size_t i = 0; i < contour.loop.size(); ++i)
    path.append(
        {contour.loop[i], i < contour.origins.size() ? contour.origins[i] : std::vector<Origin>{}});
  path.close();
  WithoutSpurs result;
  if (path.slits().empty()) return {contour, {}};
  for (const TracedCurve& curve : path.curves()) {
    result.contour.loop.push_back(curve.curve);
    result.contour.origins.push_back(curve.origins);
  }
  result.slits = joined(path.slits(), tolerance);
  return result;
}

}  // namespace planish::sheet_detail
