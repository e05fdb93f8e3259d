#include "panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace planish::slit_detail {
namespace {

/// Walks along a curve in chords of given lengths.
class ChordWalk {
 public:
  explicit ChordWalk(const BezierCurve& curve) : curve_(curve), at_(bezier_at(curve, 0.0).point) {
    constexpr int kSamplesPerDegree = 64;
    samples_ = kSamplesPerDegree * std::max(1, static_cast<int>(curve.poles.size()) - 1);
  }

  const Vec2& at() const { return at_; }
  double t() const { return t_; }

  /// The first point on the rest of the curve at this distance; empty if the curve ends before.
  std::optional<Vec2> step(double chord) {
    for (int i = static_cast<int>(std::floor(t_ * samples_)) + 1; i <= samples_; ++i) {
      const double t = static_cast<double>(i) / samples_;
      if (distance(t) < chord) continue;
      t_ = crossing(std::max(t_, t - 1.0 / samples_), t, chord);
      return advance(bezier_at(curve_, t_).point - at_, chord);
    }
    return std::nullopt;
  }

  /// Straight from the present point through the curve's end.
  Vec2 step_beyond(double chord) {
    const BezierPoint end = bezier_at(curve_, 1.0);
    const Vec2 rest = end.point - at_;
    const double missing = std::max(0.0, chord - rest.norm());
    t_ = 1.0;
    return advance(rest + missing * end.first.normalized(), chord);
  }

  /// The rest of the curve, as a chord.
  double rest() const { return distance(1.0); }

 private:
  double distance(double t) const { return (bezier_at(curve_, t).point - at_).norm(); }

  /// Exactly the chord, despite rounding of the parameter.
  Vec2 advance(const Vec2& towards, double chord) {
    at_ += chord * towards.normalized();
    return at_;
  }

  double crossing(double low, double high, double chord) const {
    constexpr int kBisections = 60;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (low + high);
      (distance(middle) < chord ? low : high) = middle;
    }
    return high;
  }

  const BezierCurve& curve_;
  int samples_ = 0;
  double t_ = 0.0;
  Vec2 at_;
};

/// The facets before folding; one ends at every long edge of a strip.
std::vector<PanelFacet> flat_facets(const SlitSheet& sheet) {
  std::vector<PanelFacet> facets;
  double across = 0.0;
  const auto add = [&](double width, double left, double right, int strip) {
    if (!(width > 0.0)) return;
    facets.push_back({{Vec2(0.0, across), Vec2(left, across), Vec2(right, across + width),
                       Vec2(0.0, across + width)},
                      {},
                      strip});
    across += width;
  };
  for (int i = 0; i < static_cast<int>(sheet.strips.size()); ++i) {
    const SlitStrip& strip = sheet.strips[i];
    add(strip.gap, sheet.panel_height, sheet.panel_height, -1);
    const auto start = sheet.start_of(i);
    add(strip.width, start[0], start[1], i);
  }
  add(sheet.margin, sheet.panel_height, sheet.panel_height, -1);
  return facets;
}

double width_of(const PanelFacet& facet) { return facet.corners[3].y() - facet.corners[0].y(); }

Frame upright(const Vec2& from, const Vec2& to, double across) {
  const Vec2 direction = (to - from).normalized();
  Frame frame;
  frame.x = Vec3::UnitY();
  frame.y = Vec3(direction.x(), 0.0, direction.y());
  frame.z = frame.x.cross(frame.y);
  frame.origin = Vec3(from.x(), 0.0, from.y()) - across * frame.y;
  return frame;
}

tl::unexpected<Error> too_short(const BezierCurve& curve, double missing, double width) {
  return fail(ErrorCode::curve_too_short,
              fmt::format("the leg curve is {:.6g} mm long, {:.4g} mm too short for the chords of "
                          "a sheet {:.6g} mm wide; make it longer or the "
                          "sheet narrower",
                          length(curve), missing, width),
              "/leg_curve");
}

}  // namespace

Result<std::vector<PanelFacet>> panel_of(const SlitSheet& sheet, const BezierCurve& leg_curve) {
  const double width = sheet.width(), tolerance = kLegTolerance * width;
  ChordWalk walk(leg_curve);
  std::vector<PanelFacet> facets = flat_facets(sheet);
  double to_come = width;
  for (PanelFacet& facet : facets) {
    const Vec2 from = walk.at();
    const double chord = width_of(facet);
    auto to = walk.step(chord);
    if (!to) {
      const double missing = to_come - walk.rest();
      if (missing > tolerance) return too_short(leg_curve, missing, width);
      to = walk.step_beyond(chord);
    }
    to_come -= chord;
    facet.frame = upright(from, *to, facet.corners[0].y());
  }
  if (const double rest = walk.t() < 1.0 ? walk.rest() : 0.0; rest > tolerance)
    return fail(ErrorCode::curve_too_long,
                fmt::format("the leg curve is {:.6g} mm long, {:.4g} mm too long for the chords of "
                            "a sheet {:.6g} mm wide; make it shorter or the "
                            "sheet wider",
                            length(leg_curve), rest, width),
                "/leg_curve");
  return facets;
}

}  // namespace planish::slit_detail
