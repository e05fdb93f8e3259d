// A sheet on the ground as one rigid body (math.md#standing): it tips about an edge of the convex
// hull of what touches the ground once its forces turn it outwards there. Tilted by α about that
// edge the moment of forces that keep their direction is T cos α + B sin α, so that it stands up to
// tan α = −T/B; for weight alone that is the angle at which the centre of mass is above the edge.
#include "design_load.hpp"
#include "strip_load.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/slit/equilibrium.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace planish {
namespace {

using namespace slit_detail;

constexpr double kTouches = 1e-6;  // of the sheet's reach: the ground is kept to a tenth of it
constexpr double kStands = tolerance::kComputed;  // radians

Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

struct Acting {
  Vec3 at, force;
};

/// Forces and skin of the whole sheet, both halves of symmetric ones.
class Body {
 public:
  Body(const FoldedSlitSheet& folded, const SlitDesign& design)
      : folded_(folded), weight_(weight_per_area(design)) {
    for (const auto* panel : {&folded.panel, &folded.second_panel})
      for (const PanelFacet& facet : *panel)
        add_face(facet.frame, {facet.corners.begin(), facet.corners.end()});
    for (const FoldedStrip& strip : folded.strips)
      for (std::size_t i = 0; i < strip.quads.size(); ++i) {
        const auto &near = strip.ridges[i].flat, &far = strip.ridges[i + 1].flat;
        add_face(strip.quads[i], {near[0], far[0], far[1], near[1]});
      }
    for (const SlitLoad& load : design.loads)
      add_load(design, load);
  }

  const std::vector<Acting>& forces() const { return forces_; }

  /// The lowest points of the skin, and how high they are.
  double ground() const {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& point : skin_)
      lowest = std::min(lowest, point.y());
    return lowest;
  }
  std::vector<Vec2> support() const {
    std::vector<Vec2> points;
    const double below = ground() + kTouches * folded_.reach;
    for (const Vec3& point : skin_)
      if (point.y() <= below) points.emplace_back(point.x(), point.z());
    return hull_of(std::move(points));
  }

 private:
  void add(const Vec3& at, const Vec3& force) {
    forces_.push_back({at, force});
    if (folded_.symmetric) forces_.push_back({mirrored(at), mirrored(force)});
  }

  /// `corners` of a face without curved sides, on the flat sheet.
  void add_face(const Frame& frame, const std::vector<Vec2>& corners) {
    double twice = 0.0;
    Vec2 middle = Vec2::Zero();
    const double half = 0.5 * folded_.thickness * std::abs(frame.z.y());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
      const double area = a.x() * b.y() - a.y() * b.x();
      twice += area;
      middle += area * (a + b) / 3.0;
      const Vec3 lowest = frame.point(corners[i]) - half * Vec3::UnitY();
      skin_.push_back(lowest);
      if (folded_.symmetric) skin_.push_back(mirrored(lowest));
    }
    if (twice == 0.0) return;
    const double weight = 0.5 * std::abs(twice) * weight_;
    add(frame.point(corners[0] + middle / twice), -weight * Vec3::UnitY());
  }

  void add_load(const SlitDesign& design, const SlitLoad& load) {
    const FoldedStrip& strip = folded_.strips[load.strip];
    add(load.at ? middle_of(strip, *load.at) : centroid_of(strip), force_on(design, load));
  }

  static Vec3 middle_of(const FoldedStrip& strip, double at) {
    const MiddlePoint place = middle_point(static_cast<int>(strip.quads.size()), at);
    const auto middle = [&](int ridge) -> Vec3 {
      return 0.5 * (strip.ridges[ridge].folded[0] + strip.ridges[ridge].folded[1]);
    };
    return (1.0 - place.share) * middle(place.ridge) + place.share * middle(place.ridge + 1);
  }

  static Vec3 centroid_of(const FoldedStrip& strip) {
    Vec3 sum = Vec3::Zero();
    double all = 0.0;
    for (std::size_t i = 0; i < strip.quads.size(); ++i) {
      const auto &near = strip.ridges[i].folded, &far = strip.ridges[i + 1].folded;
      for (const std::array<Vec3, 3>& corners :
           {std::array{near[0], near[1], far[0]}, std::array{near[1], far[1], far[0]}}) {
        const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
        sum += area * (corners[0] + corners[1] + corners[2]) / 3.0;
        all += area;
      }
    }
    return sum / all;
  }

  const FoldedSlitSheet& folded_;
  double weight_;  ///< N/mm²
  std::vector<Acting> forces_;
  std::vector<Vec3> skin_;
};

/// By how much a body may be tilted about an edge of its support.
Angle margin_about(const std::vector<Acting>& forces, const Vec2& from, const Vec2& to,
                   double ground) {
  const Vec2 along = (to - from).normalized(), outwards(along.y(), -along.x());
  double turns = 0.0, holds = 0.0;
  for (const Acting& one : forces) {
    const double out = outwards.dot(Vec2(one.at.x(), one.at.z()) - from), up = one.at.y() - ground,
                 push = outwards.dot(Vec2(one.force.x(), one.force.z()));
    turns += up * push - out * one.force.y();
    holds -= out * push + up * one.force.y();
  }
  return Angle::radians(std::atan2(-turns, holds));
}

}  // namespace

std::optional<SlitStanding> standing_of(const FoldedSlitSheet& folded, const SlitDesign& design) {
  const Body body(folded, design);
  double down = 0.0;
  Vec3 sum = Vec3::Zero();
  for (const Acting& one : body.forces()) {
    down -= one.force.y();
    sum -= one.force.y() * one.at;
  }
  if (!(down > 0.0)) return std::nullopt;
  SlitStanding standing{false, Angle(), sum / down, body.support()};
  const std::vector<Vec2>& support = standing.support;
  if (support.size() < 2) return standing;
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < support.size(); ++i)
    margin = std::min(margin, margin_about(body.forces(), support[i],
                                           support[(i + 1) % support.size()], body.ground())
                                  .radians());
  standing.margin = Angle::radians(margin);
  standing.stands = margin > kStands;
  return standing;
}

}  // namespace planish
