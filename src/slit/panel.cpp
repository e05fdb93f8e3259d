#include "panel.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

// The panel over its leg curve: the sheet's widths are stepped along the curve as chords, so each
// facet is plane and exactly as wide as in the flat sheet (math.md#slit-model). The first point at
// a chord's distance is bracketed by walking and found by bisection, and the chord is made exact
// afterwards. `fit` bisects the scale at which the chords end with the curve; chords are shorter
// than the curve, which bounds it.

namespace planish::slit_detail {
namespace {

/// Walks along a curve in chords of given lengths.
class ChordWalk {
 public:
  explicit ChordWalk(const BezierCurve& curve) : curve_(curve), at_(bezier_at(curve, 0.0).point) {
    constexpr int kStepsPerDegree = 64;
    samples_ = kStepsPerDegree * std::max(1, static_cast<int>(curve.poles.size()) - 1);
  }

  const Vec2& at() const { return at_; }

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

  /// Straight from the present point through the curve's end, and on in its direction.
  Vec2 step_beyond(double chord) {
    const BezierPoint end = bezier_at(curve_, 1.0);
    const Vec2 to_end = end.point - at_, beyond = (chord - rest()) * end.first.normalized();
    t_ = 1.0;
    return advance(to_end + beyond, chord);
  }

  /// The rest of the curve, as a chord; negative beyond its end.
  double rest() const { return t_ < 1.0 ? distance(1.0) : -distance(1.0); }

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

/// The facets before folding, between lines along the sheet through the corners of the strips at
/// one panel.
std::vector<PanelFacet> flat_facets(const SlitSheet& sheet, PanelAt at) {
  std::vector<PanelFacet> facets;
  const bool at_end = at == PanelAt::end;
  double across = at_end ? sheet.sides_at_end(0)[0] - sheet.strips.front().gap : 0.0, begun = 0.0;
  const auto add = [&](double until, double left, double right, int strip) {
    if (!(until > across)) return;
    facets.push_back(
        {{Vec2(0.0, across), Vec2(left, across), Vec2(right, until), Vec2(0.0, until)}, {}, strip});
    across = until;
  };
  for (int i = 0; i < static_cast<int>(sheet.strips.size()); ++i) {
    const SlitStrip& strip = sheet.strips[i];
    const auto start = sheet.start_of(i);
    std::array<double, 2> sides{begun + strip.gap, begun + strip.gap + strip.width};
    begun = sides[1];
    for (std::size_t side = 0; at_end && side < 2; ++side)
      if (const auto& edge = strip.edges[side]; !edge.empty()) sides[side] = edge.back().y();
    add(sides[0], sheet.panel_height, sheet.panel_height, -1);
    add(sides[1], start[0], start[1], i);
  }
  add(across + sheet.margin, sheet.panel_height, sheet.panel_height, -1);
  return facets;
}

/// The facets at the far ends of the strips.
std::vector<PanelFacet> flat_far_facets(const SlitSheet& sheet, double height) {
  const double top = sheet.panel_height + sheet.half_length, free_edge = top + height;
  std::vector<PanelFacet> facets = flat_facets(sheet, PanelAt::end);
  for (PanelFacet& facet : facets) {
    const std::array<double, 2> ends = facet.strip < 0 ? std::array{top, top}
                                                       : sheet.ends_of(facet.strip);
    facet.corners[0].x() = facet.corners[3].x() = free_edge;
    facet.corners[1].x() = ends[0], facet.corners[2].x() = ends[1];
  }
  return facets;
}

double width_of(const PanelFacet& facet) { return facet.corners[3].y() - facet.corners[0].y(); }

/// `along`: the direction in space in which the flat sheet's first coordinate grows, up or down.
Frame upright(const Vec2& from, const Vec2& to, const Vec2& flat_from, const Vec3& along) {
  const Vec2 direction = (to - from).normalized();
  Frame frame;
  frame.x = along;
  frame.y = Vec3(direction.x(), 0.0, direction.y());
  frame.z = frame.x.cross(frame.y);
  frame.origin = Vec3(from.x(), 0.0, from.y()) - flat_from.x() * frame.x - flat_from.y() * frame.y;
  return frame;
}

tl::unexpected<Error> too_short(const BezierCurve& curve, double missing, double width,
                                const std::string& where) {
  return fail(refuse::leg_curve_too_short, {{"length", length(curve), unit::mm},
                                            {"missing", missing, unit::mm},
                                            {"width", width, unit::mm},
                                            {"field", place::pointer(where)}});
}

tl::unexpected<Error> too_long(const BezierCurve& curve, double rest, double width,
                               const std::string& where) {
  return fail(refuse::leg_curve_too_long, {{"length", length(curve), unit::mm},
                                           {"rest", rest, unit::mm},
                                           {"width", width, unit::mm},
                                           {"field", place::pointer(where)}});
}

/// Places the facets over a leg curve.
Result<std::vector<PanelFacet>> stood_on(std::vector<PanelFacet> facets, const BezierCurve& curve,
                                         const Vec3& along, const std::string& where) {
  const double width = facets.back().corners[3].y() - facets.front().corners[0].y(),
               tolerance = kLegTolerance * width;
  ChordWalk walk(curve);
  double to_come = width;
  for (PanelFacet& facet : facets) {
    const Vec2 from = walk.at();
    const double chord = width_of(facet);
    auto to = walk.step(chord);
    if (!to) {
      const double missing = to_come - walk.rest();
      if (missing > tolerance) return too_short(curve, missing, width, where);
      to = walk.step_beyond(chord);
    }
    to_come -= chord;
    facet.frame = upright(from, *to, facet.corners[0], along);
  }
  if (const double rest = walk.rest(); rest > tolerance) return too_long(curve, rest, width, where);
  return facets;
}

/// Turns a panel about the line through the ends of its leg curve.
void turn(std::vector<PanelFacet>& facets, const BezierCurve& curve, Angle by) {
  if (by == Angle()) return;
  const auto on_ground = [](const Vec2& p) { return Vec3(p.x(), 0.0, p.y()); };
  const Vec3 pivot = on_ground(curve.poles.front());
  const Vec3 axis = (on_ground(curve.poles.back()) - pivot).normalized();
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(by.radians(), axis).toRotationMatrix();
  for (PanelFacet& facet : facets) {
    Frame& frame = facet.frame;
    frame = {pivot + rotation * (frame.origin - pivot), rotation * frame.x, rotation * frame.y,
             rotation * frame.z};
  }
}

/// Whether the chords of the sheet, made smaller by a scale, fit on a curve.
bool fits(const std::vector<PanelFacet>& facets, const BezierCurve& curve, double scale) {
  ChordWalk walk(curve);
  for (const PanelFacet& facet : facets)
    if (!walk.step(scale * width_of(facet))) return false;
  return true;
}

}  // namespace

Result<std::vector<PanelFacet>> panel_of(const SlitSheet& sheet, const BezierCurve& leg_curve,
                                         Angle lean) {
  auto panel = stood_on(flat_facets(sheet, PanelAt::start), leg_curve, Vec3::UnitY(), "/leg_curve");
  if (panel) turn(*panel, leg_curve, lean);
  return panel;
}

Result<std::vector<PanelFacet>> second_panel_of(const SlitSheet& sheet, const SecondPanel& second) {
  auto panel = stood_on(flat_far_facets(sheet, second.height), second.leg_curve, -Vec3::UnitY(),
                        "/second_panel/leg_curve");
  // Its front is on the other side of the direction in which the leg curve runs.
  if (panel) turn(*panel, second.leg_curve, -second.lean);
  return panel;
}

Result<BezierCurve> fitted(const SlitSheet& sheet, const BezierCurve& curve, PanelAt at,
                           const std::string& where) {
  const std::vector<PanelFacet> facets = flat_facets(sheet, at);
  constexpr int kBisections = 100;
  // Chords are shorter than the curve, so they fit at most at this scale.
  const double width = facets.back().corners[3].y() - facets.front().corners[0].y();
  double high = length(curve) / width * (1.0 + tolerance::kComputed), low = 0.0;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(facets, curve, middle) ? low : high) = middle;
  }
  if (!(low > 0.0)) return fail(refuse::curve_cannot_be_scaled, {{"field", place::pointer(where)}});
  if (std::abs(low - 1.0) <= tolerance::kComputed) return curve;
  BezierCurve scaled = curve;
  for (Vec2& pole : scaled.poles)
    pole = curve.poles.front() + (pole - curve.poles.front()) / low;
  return scaled;
}

}  // namespace planish::slit_detail
