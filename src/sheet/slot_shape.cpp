// The outline of a slit that is cut with a width: its two banks, and a round end or a stop hole at
// each end in the material. Where a slit leaves the sheet, the banks end on the contour's lines or,
// where a line falls away behind the mouth, in the round end about it; then contour and slot become
// one loop.

#include "slot_shape.hpp"

#include "refusals.hpp"
#include "slit_axis.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

// The shape of a slit as cut: banks half the kerf beside its axis, round ends or stop holes inside
// the material. Where it opens into a contour its banks leave the contour's lines; a line that
// leads away under a flat angle may meet the round end about the mouth first. Lines end where they
// enter a disc or the band about the axis, both of which are convex, so each leaves one stretch.

namespace planish::sheet_detail {
namespace {

using std::numbers::pi;

/// Curves that follow one another from a point.
class Chain {
 public:
  explicit Chain(const Vec2& from) : at_(from) {}
  void line_to(const Vec2& to) {
    if ((to - at_).norm() > 0.0) curves_.push_back(Segment{at_, to});
    at_ = to;
  }
  /// Clockwise about a centre, to a point on its circle.
  void arc_to(const Vec2& center, const Vec2& to) {
    const Vec2 from = at_ - center, radius = to - center;
    double sweep = std::atan2(cross(from, radius), from.dot(radius));
    if (sweep >= 0.0) sweep -= 2.0 * pi;
    curves_.push_back(Arc{center, radius.norm(), angle_of(from), sweep});
    at_ = to;
  }
  /// Along curves that begin where it is, or nearly so.
  void run_along(const Loop& curves) {
    if (curves.empty()) return;
    constexpr double kMeets = tolerance::kComputed;  // mm: a root was found on them
    if ((start_of(curves.front()) - at_).norm() > kMeets) line_to(start_of(curves.front()));
    curves_.insert(curves_.end(), curves.begin(), curves.end());
    at_ = end_of(curves.back());
  }
  const Loop& curves() const { return curves_; }

 private:
  Vec2 at_;
  Loop curves_;
};

/// Where the banks meet the hole or the round end about the end of the axis, left then right of the
/// axis.
std::array<Vec2, 2> banks_at_end(const Slot& slot, const Vec2& end, const Vec2& along) {
  const double radius = slot.end_radius(),
               back = std::sqrt(std::max(0.0, radius * radius - slot.half_width * slot.half_width));
  const Vec2 foot = end - back * along, aside = slot.half_width * perpendicular(along);
  return {foot + aside, foot - aside};
}

/// Where the bank of an open slot leaves the contour's line that comes from (or goes to) `away`, a
/// unit vector seen from the slot's mouth: on the bank itself, or on the round end about the mouth.
struct MouthCorner {
  double along_line = 0.0;  ///< distance from the mouth
  Vec2 on_bank;             ///< where the bank begins
  bool round = false;       ///< an arc about the mouth leads there
};

MouthCorner mouth_corner(const Slot& slot, const Vec2& along, const Vec2& bank_side,
                         const Vec2& away) {
  const Vec2 mouth = slot.axis.a, beside = slot.half_width * bank_side;
  const double forward = along.dot(away), aside = bank_side.dot(away);
  constexpr double kLevel = tolerance::kComputed;  // radians: a mouth this near to perpendicular is
  if (forward > kLevel && aside > 0.0) {
    const double distance = slot.half_width / aside;
    return {distance, mouth + distance * away, false};
  }
  return {slot.half_width, mouth + beside, forward < -kLevel || aside < 0.0};
}

tl::unexpected<Error> no_room(const Slot& slot) {
  return fail(refuse::kerf_too_wide, {{"field", place::pointer("/kerf")},
                                      {"kerf", 2.0 * slot.half_width, unit::mm},
                                      {"at", place::point(slot.axis.a)}});
}

/// Parts of the line's parameter range 0 … 1 inside a disc and inside the band along the axis.
using Stretch = std::pair<double, double>;

std::optional<Stretch> inside_disc(const Segment& line, const Vec2& center, double radius) {
  const Vec2 d = line.b - line.a, from = line.a - center;
  const double a = d.squaredNorm(), half_b = d.dot(from),
               discriminant = half_b * half_b - a * (from.squaredNorm() - radius * radius);
  if (!(discriminant > 0.0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Stretch{(-half_b - root) / a, (-half_b + root) / a};
}

std::optional<Stretch> inside_band(const Segment& line, const Segment& chord, double half_width) {
  const Vec2 axis = chord.b - chord.a, along = axis.normalized(), across = perpendicular(along);
  Stretch range{0.0, 1.0};
  const auto clip = [&](const Vec2& direction, double low, double high) {
    const double at = direction.dot(line.a - chord.a), speed = direction.dot(line.b - line.a);
    if (speed == 0.0) {
      if (at <= low || at >= high) range.second = -1.0;
      return;
    }
    const auto [enter, leave] = std::minmax({(low - at) / speed, (high - at) / speed});
    range = {std::max(range.first, enter), std::min(range.second, leave)};
  };
  clip(along, 0.0, axis.norm());
  clip(across, -half_width, half_width);
  return range.first < range.second ? std::optional(range) : std::nullopt;
}

}  // namespace

std::vector<Vec2> chain_of(const Curve2& curve) {
  if (const auto* line = std::get_if<Segment>(&curve)) return {line->a, line->b};
  constexpr double kChordShare = 1e-3;  // share of the length
  std::vector<Vec2> points = sampled(curve, kChordShare * length(curve));
  points.push_back(end_of(curve));
  return points;
}

std::vector<Segment> Slot::chords() const {
  std::vector<Segment> chords;
  for (const Curve2& curve : whole_axis()) {
    const std::vector<Vec2> points = chain_of(curve);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      chords.push_back({points[i], points[i + 1]});
  }
  return chords;
}

namespace {

/// The banks of a slot whose axis is a curve, left and right, in its direction, without what lies
/// in holes at its ends.
std::array<Loop, 2> banks_of(const Slot& slot) {
  std::array<Loop, 2> banks{beside(slot.curves, slot.half_width),
                            beside(slot.curves, -slot.half_width)};
  for (Loop& bank : banks) {
    if (!(slot.hole > slot.half_width)) continue;
    bank = without_end(std::move(bank), slot.axis.b, slot.hole);
    if (!slot.opens_at) bank = without_start(bank, slot.axis.a, slot.hole);
  }
  return banks;
}

Loop closed_curve(const Slot& slot) {
  const auto [left, right] = banks_of(slot);
  const Loop back = reversed(right);
  Chain chain(start_of(left.front()));
  chain.run_along(left);
  chain.arc_to(slot.axis.b, start_of(back.front()));
  chain.run_along(back);
  chain.arc_to(slot.axis.a, start_of(left.front()));
  return chain.curves();
}

/// Curves from the first place that is farther along than a point.
Loop ahead_of(Loop curves, const Vec2& along, const Vec2& point) {
  const auto is_ahead = [&](const Vec2& p) { return along.dot(p - point) > 0.0; };
  while (!curves.empty() && !is_ahead(end_of(curves.front())))
    curves.erase(curves.begin());
  if (curves.empty() || is_ahead(start_of(curves.front()))) return curves;
  double low = 0.0, high = 1.0;
  constexpr int kBisections = 60;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (is_ahead(point_at(curves.front(), middle)) ? high : low) = middle;
  }
  curves.front() = trimmed(curves.front(), high, 1.0);
  return curves;
}

}  // namespace

Loop closed_slot(const Slot& slot) {
  if (!slot.curves.empty()) return closed_curve(slot);
  const Vec2 along = (slot.axis.b - slot.axis.a).normalized();
  const auto [far_left, far_right] = banks_at_end(slot, slot.axis.b, along);
  const auto [near_right, near_left] = banks_at_end(slot, slot.axis.a,
                                                    -along);  // seen the other way
  Chain chain(near_left);
  chain.line_to(far_left);
  chain.arc_to(slot.axis.b, far_right);
  chain.line_to(near_right);
  chain.arc_to(slot.axis.a, near_left);
  return chain.curves();
}

namespace {

/// The banks of an open slot, from where they leave the contour.
std::array<Loop, 2> open_banks(const Slot& slot, const Vec2& along, const MouthCorner& in,
                               const MouthCorner& out) {
  if (!slot.curves.empty()) {
    const auto [left, right] = banks_of(slot);
    return {ahead_of(left, along, in.on_bank), ahead_of(right, along, out.on_bank)};
  }
  const auto [left, right] = banks_at_end(slot, slot.axis.b, along);
  return {Loop{Segment{in.on_bank, left}}, Loop{Segment{out.on_bank, right}}};
}

}  // namespace

Result<Contour> with_open_slot(const Contour& contour, const Slot& slot, double tolerance) {
  const std::size_t count = contour.loop.size(), next = static_cast<std::size_t>(slot.opens_at->at),
                    before = (next + count - 1) % count;
  const auto *coming = std::get_if<Segment>(&contour.loop[before]),
             *going = std::get_if<Segment>(&contour.loop[next]);
  if (coming == nullptr || going == nullptr || before == next)
    return fail(refuse::slit_meets_curve, {{"at", place::point(slot.axis.a)}});
  const Vec2 mouth = slot.axis.a,
             along = derivative_at(slot.whole_axis().front(), 0.0).normalized();
  const Vec2 from = (coming->a - mouth).normalized(), to = (going->b - mouth).normalized();
  const MouthCorner in = mouth_corner(slot, along, perpendicular(along), from),
                    out = mouth_corner(slot, along, -perpendicular(along), to);
  const std::array<Loop, 2> banks = open_banks(slot, along, in, out);
  const auto goes_on = [&](const Loop& bank, const Vec2& from_bank) {
    return !bank.empty() && along.dot(end_of(bank.front()) - from_bank) > 0.0;
  };
  const bool long_enough = goes_on(banks[0], in.on_bank) && goes_on(banks[1], out.on_bank);
  if ((coming->a - mouth).norm() <= in.along_line + tolerance ||
      (going->b - mouth).norm() <= out.along_line + tolerance || !long_enough)
    return no_room(slot);

  const Vec2 leaves = mouth + in.along_line * from, returns = mouth + out.along_line * to;
  Chain chain(leaves);
  if (in.round) chain.arc_to(mouth, in.on_bank);
  const Loop back = reversed(banks[1]);
  chain.run_along(banks[0]);
  chain.arc_to(slot.axis.b, start_of(back.front()));
  chain.run_along(back);
  chain.line_to(out.round ? out.on_bank : returns);
  if (out.round) chain.arc_to(mouth, returns);

  Contour opened = contour;
  opened.loop[before] = Segment{coming->a, leaves};
  opened.loop[next] = Segment{returns, going->b};
  opened.loop.insert(opened.loop.begin() + static_cast<std::ptrdiff_t>(next),
                     chain.curves().begin(), chain.curves().end());
  opened.origins.insert(opened.origins.begin() + static_cast<std::ptrdiff_t>(next),
                        chain.curves().size(), {});
  return opened;
}

std::vector<Segment> outside(const Segment& line, const std::vector<Slot>& slots) {
  std::vector<Stretch> cuts;
  const auto cut = [&](const std::optional<Stretch>& range) {
    if (range && range->second > 0.0 && range->first < 1.0) cuts.push_back(*range);
  };
  for (const Slot& slot : slots) {
    if (slot.half_width > 0.0)
      for (const Segment& chord : slot.chords()) {
        cut(inside_band(line, chord, slot.half_width));
        cut(inside_disc(line, chord.a, slot.half_width));
      }
    if (slot.end_radius() > 0.0)
      for (const Vec2& hole : slot.holes())
        cut(inside_disc(line, hole, slot.end_radius()));
  }
  std::ranges::sort(cuts);
  const auto at = [&](double t) -> Vec2 {
    return t <= 0.0 ? line.a : t >= 1.0 ? line.b : Vec2(line.a + t * (line.b - line.a));
  };
  std::vector<Segment> pieces;
  double done = 0.0;
  constexpr double kNothing = tolerance::kComputed;  // share of the line
  for (const auto& [enter, leave] : cuts) {
    if (enter > done + kNothing) pieces.push_back({at(done), at(enter)});
    done = std::max(done, leave);
  }
  if (done < 1.0 - kNothing) pieces.push_back({at(done), line.b});
  return pieces;
}

}  // namespace planish::sheet_detail
