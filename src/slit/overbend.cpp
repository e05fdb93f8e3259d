// Strips bent further than wanted, so that they keep the wanted shape when they are let go
// (math.md#overbend). A fold turns the material beside its ridge by one angle, over widths that may
// change along it; its moment is the sum over the ridge, elastic and perfectly plastic through the
// thickness, and it springs back as that moment turns an elastic sheet. What must be bent is found
// by bisection, as what is kept grows with what is bent.
#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/slit/overbend.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace planish {
namespace {

constexpr double kMostFold = std::numbers::pi;

/// Shares of a ridge and weights of Gauss's rule with five places.
constexpr std::array<std::array<double, 2>, 5> kPlaces{{{0.0469100770306680, 0.1184634425280945},
                                                        {0.2307653449471584, 0.2393143352496833},
                                                        {0.5, 0.2844444444444444},
                                                        {0.7692346550528416, 0.2393143352496833},
                                                        {0.9530899229693320, 0.1184634425280945}}};

Vec2 middle(const Vec2& a, const Vec2& b) { return 0.5 * (a + b); }

Frame turned(const Frame& frame, const SlitRidge& ridge, Angle fold) {
  const Vec3 left = frame.point(ridge.flat[0]), right = frame.point(ridge.flat[1]);
  const Eigen::AngleAxisd turn(fold.radians(), (right - left).normalized());
  Frame next{Vec3::Zero(), turn * frame.x, turn * frame.y, turn * frame.z};
  next.origin = left - ridge.flat[0].x() * next.x - ridge.flat[0].y() * next.y;
  return next;
}

/// The rigid move that takes one frame to another, of a frame.
Frame carried(const Frame& frame, const Frame& from, const Frame& to) {
  const auto turn = [&](const Vec3& v) -> Vec3 {
    return from.x.dot(v) * to.x + from.y.dot(v) * to.y + from.z.dot(v) * to.z;
  };
  return {to.origin + turn(frame.origin - from.origin), turn(frame.x), turn(frame.y),
          turn(frame.z)};
}

const PanelFacet* facet_of(const std::vector<PanelFacet>& panel, int strip) {
  const auto found = std::ranges::find(panel, strip, &PanelFacet::strip);
  return found == panel.end() ? nullptr : &*found;
}

/// The strip with other folds, from the panel's facet on; `end`: the facet at its end.
FoldedStrip refolded(FoldedStrip strip, const Frame& facet, const Frame* end) {
  Frame before = facet;
  std::vector<Frame> frames{facet};
  for (const SlitRidge& ridge : strip.ridges) {
    if (&ridge == &strip.ridges.back() && !end) break;
    before = turned(before, ridge, ridge.fold);
    frames.push_back(before);
  }
  const Frame from = frames.back(), to = end ? *end : strip.quads.back();
  for (std::size_t quad = 0; quad < strip.quads.size(); ++quad)
    strip.quads[quad] = carried(frames[quad + 1], from, to);
  for (std::size_t i = 0; i < strip.ridges.size(); ++i)
    for (std::size_t side = 0; side < 2; ++side)
      strip.ridges[i].folded[side] = strip.quads[std::min(i, strip.quads.size() - 1)].point(
          strip.ridges[i].flat[side]);
  return strip;
}

}  // namespace

BentWidths bent_widths(const FoldedStrip& strip, int ridge) {
  PLANISH_ASSERT(ridge >= 0 && ridge < std::ssize(strip.ridges));
  const int last = static_cast<int>(strip.quads.size());
  const Vec2 along = strip.ridges[ridge].flat[1] - strip.ridges[ridge].flat[0];
  BentWidths widths{};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto at = [&](int i) { return strip.ridges[std::clamp(i, 0, last)].flat[side]; };
    const bool takes_last = strip.ends_directed && ridge + 1 == last;
    const Vec2 from = middle(at(ridge - 1), at(ridge)),
               to = takes_last ? at(last) : middle(at(ridge), at(ridge + 1));
    widths[side] = cross(to - from, along) / along.norm();
  }
  return widths;
}

Angle kept_fold(const SlitMaterial& material, double thickness, const BentWidths& bent,
                Angle fold) {
  const double angle = std::abs(fold.radians());
  double lost = 0.0, stiffness = 0.0;  // curvatures that spring back, and 1/width
  for (const auto& [share, weight] : kPlaces) {
    const double width = bent[0] + share * (bent[1] - bent[0]), curvature = angle / width;
    if (curvature > 0.0)
      lost += weight * (curvature - material.kept_curvature(thickness, curvature));
    stiffness += weight / width;
  }
  const double kept = std::max(0.0, angle - lost / stiffness);
  return Angle::radians(std::copysign(kept, fold.radians()));
}

Angle overbent_fold(const SlitMaterial& material, double thickness, const BentWidths& bent,
                    Angle kept) {
  constexpr int kBisections = 100;
  const double wanted = std::abs(kept.radians());
  if (wanted == 0.0) return Angle();
  double low = wanted, high = kMostFold;
  for (int i = 0; i < kBisections; ++i) {
    const double between = 0.5 * (low + high);
    (kept_fold(material, thickness, bent, Angle::radians(between)).radians() < wanted
         ? low
         : high) = between;
  }
  return Angle::radians(std::copysign(0.5 * (low + high), kept.radians()));
}

Result<FoldedSlitSheet> overbent(const FoldedSlitSheet& folded, const SlitMaterial& material) {
  require_valid(folded);
  if (!material.yield || !(material.young > 0.0)) return fail(refuse::overbend_without_yield);
  FoldedSlitSheet sheet = folded;
  for (int number = 0; number < std::ssize(sheet.strips); ++number) {
    FoldedStrip& strip = sheet.strips[number];
    for (int i = 0; i < std::ssize(strip.ridges); ++i) {
      Angle& fold = strip.ridges[i].fold;
      if (fold == Angle()) continue;
      const BentWidths bent = bent_widths(strip, i);
      const Angle more = overbent_fold(material, folded.thickness, bent, fold);
      if (std::abs(more.radians()) > kMostFold * (1.0 - tolerance::kWrittenDigits))
        return fail(refuse::overbend_too_far,
                    {{"strip", place::strip(number)}, {"ridge", place::ridge(i)}});
      fold = more;
    }
    const PanelFacet *first = facet_of(folded.panel, number),
                     *end = facet_of(folded.second_panel, number);
    PLANISH_ASSERT(first);
    strip = refolded(std::move(strip), first->frame, end ? &end->frame : nullptr);
  }
  return sheet;
}

}  // namespace planish
