#include "crossing.hpp"
#include "sample_sheets.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/slit/mould.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

// Neighbours that run into each other where each is solved by itself: of designs as a person draws
// them none is left through another, and what is not touched stays.

namespace planish::test {
namespace {

/// Four to eight strips between drawn curves, scaled to the sheet.
SlitDesign drawn(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto between = [&](double low, double high) { return low + (high - low) * unit(random); };
  const int strips = 4 + static_cast<int>(random() % 5);
  const double width = 10.0 * (3 + static_cast<int>(random() % 5)), all = strips * width;
  SlitDesign design;
  design.objective = SlitObjective::energy;
  design.sheet.thickness = between(1.5, 4.0);
  design.sheet.panel_height = between(300, 450);
  design.sheet.strips = equal_strips(strips, width);
  const double x = between(300, 420), y = design.sheet.panel_height * between(0.7, 1.0);
  design.leg_curve = {{{x, 0},
                       {x + between(-60, 60), all / 3},
                       {x + between(-60, 60), 2 * all / 3},
                       {x + between(-80, 80), all}}};
  design.seat_curve = BezierCurve{{{y, 0},
                                   {y + between(-100, 60), all / 3},
                                   {y + between(-80, 120), 2 * all / 3},
                                   {y + between(0, 300), all}}};
  design.fit = design.fit_seat = true;
  double farthest = 0.0;
  for (const Vec2& pole : design.leg_curve.poles)
    farthest = std::max(farthest, pole.x());
  design.sheet.half_length = farthest * between(1.1, 1.4);
  return design;
}

double energy_of(const SlitSession& session) {
  double sum = 0.0;
  for (int strip = 0; strip < session.strip_count(); ++strip)
    sum += session.state(strip).objective;
  return sum;
}

/// Height over the base, straight above or below p, of the middle of a quad; none if it is not
/// there.
std::optional<double> height_over(const std::array<Vec3, 4>& quad, const Frame& base,
                                  const Vec2& p) {
  for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    const Vec2 o = base.local2(quad[i]), u = base.local2(quad[j]) - o, v = base.local2(quad[k]) - o;
    const double area = cross(u, v), s = cross(Vec2(p - o), v) / area,
                 t = cross(u, Vec2(p - o)) / area;
    if (std::abs(area) < 1e-6 || s < 0.0 || t < 0.0 || s + t > 1.0) continue;
    return (1.0 - s - t) * base.local(quad[i]).z() + s * base.local(quad[j]).z() +
           t * base.local(quad[k]).z();
  }
  return std::nullopt;
}

/// No point of a rib's top is as high as the middle of a strip above it, its own or another.
void expect_below_the_sheet(const FoldedSlitSheet& folded, const Mould& mould, unsigned seed) {
  std::vector<std::array<Vec3, 4>> quads;
  const auto image = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
  for (const FoldedStrip& strip : folded.strips)
    for (std::size_t i = 0; i + 1 < strip.ridges.size(); ++i) {
      const auto &near = strip.ridges[i].folded, &far = strip.ridges[i + 1].folded;
      quads.push_back({near[0], near[1], far[1], far[0]});
      quads.push_back({image(near[0]), image(near[1]), image(far[1]), image(far[0])});
    }
  for (const MouldRib& rib : mould.ribs)
    for (const auto& facet : rib.facets)
      for (const double along : {0.1, 0.5, 0.9})
        for (const double across : {0.02, 0.5, 0.98}) {
          const Vec3 p = (1 - along) * ((1 - across) * facet[0] + across * facet[3]) +
                         along * ((1 - across) * facet[1] + across * facet[2]);
          for (const auto& quad : quads) {
            const auto height = height_over(quad, mould.base, mould.base.local2(p));
            EXPECT_LT(mould.base.local(p).z(), height.value_or(1e9)) << seed << ' ' << rib.strip;
          }
        }
}

TEST(PartTogether, NoStripOfADrawnDesignIsLeftThroughAnotherAndAllHaveMoulds) {
  constexpr unsigned kDesigns = 24;
  for (unsigned seed = 0; seed < kDesigns; ++seed) {
    const SlitSession session = solved(drawn(seed));
    const FoldedSlitSheet folded = session.folded();
    for (int i = 0; i < session.strip_count(); ++i) {
      EXPECT_EQ(session.state(i).status, StripStatus::solved) << seed;
      EXPECT_LE(session.state(i).gap, 1e-9 * folded.reach) << seed;
      for (int j = i + 1; j < session.strip_count(); ++j)
        EXPECT_FALSE(
            slit_detail::cross(folded.strips[i], folded.strips[j], 0.25 * folded.thickness))
            << "strips " << i << " and " << j << " of design " << seed;
    }
    for (const MouldForm form : {MouldForm::ribs, MouldForm::body}) {
      const auto mould = mould_of(folded, {.form = form});
      ASSERT_TRUE(mould) << seed << ": " << mould.error().message;
      expect_below_the_sheet(folded, *mould, seed);
    }
  }
}

/// Left and right exchanged: the panel's curve backwards, mirrored in z.
SlitDesign mirrored(SlitDesign design) {
  const double end = design.leg_curve.poles.back().y();
  for (BezierCurve* curve : {&design.leg_curve, &*design.seat_curve}) {
    std::ranges::reverse(curve->poles);
    for (Vec2& pole : curve->poles)
      pole.y() = end - pole.y();
  }
  return design;
}

TEST(PartTogether, AMirroredSheetGivesTheMirroredShape) {
  // Those that are parted in few rounds: where many are needed rounding decides between shapes.
  for (const unsigned seed : {1u, 5u}) {
    SlitDesign design = started(drawn(seed)).design();  // with its curves scaled
    design.fit = design.fit_seat = false;
    const double one = energy_of(solved(design)), other = energy_of(solved(mirrored(design)));
    EXPECT_NEAR(one, other, 2e-3 * one) << seed;
  }
}

/// Five straight strips between an upright panel and one that leans.
SlitDesign leaning() {
  SlitDesign design = arcade();
  design.objective = SlitObjective::energy;
  design.sheet.strips = equal_strips(5, 36.0);
  design.second_panel->lean = Angle::degrees(20);
  return design;
}

TEST(PartTogether, StripsToALeaningPanelAreParted) {
  const FoldedSlitSheet folded = solved(leaning()).folded();
  for (std::size_t i = 0; i + 1 < folded.strips.size(); ++i)
    EXPECT_FALSE(
        slit_detail::cross(folded.strips[i], folded.strips[i + 1], 0.25 * folded.thickness));
}

TEST(PartTogether, WhatIsNotEditedStays) {
  SlitDesign design = drawn(3);
  SlitSession session = solved(design);
  const FoldedSlitSheet before = session.folded();
  SlitAnchor anchor{.strip = 1, .ridge = 5};
  anchor.at = before.strips[1].ridges[5].folded[0] + Vec3(0, 15, 0);
  design = session.design();
  design.anchors = {anchor};
  ASSERT_TRUE(session.set_design(design));
  ASSERT_TRUE(session.solve());
  const FoldedSlitSheet after = session.folded();
  for (std::size_t strip = 0; strip < before.strips.size(); ++strip) {
    double moved = 0.0;
    for (std::size_t ridge = 0; ridge < before.strips[strip].ridges.size(); ++ridge)
      for (std::size_t side = 0; side < 2; ++side)
        moved = std::max(moved, (after.strips[strip].ridges[ridge].folded[side] -
                                 before.strips[strip].ridges[ridge].folded[side])
                                    .norm());
    EXPECT_EQ(moved > 0.0, strip == 1) << strip;
  }
}

TEST(PartTogether, GoesOnFromWhatPressedBefore) {
  // The same design begun anew takes more steps, and has no less energy.
  for (const unsigned seed : {1u, 3u, 8u}) {
    SlitSession session = solved(drawn(seed));
    SlitDesign design = session.design();
    design.fit = design.fit_seat = false;
    SlitAnchor anchor{.strip = session.strip_count() - 1, .ridge = 5};
    anchor.at = session.folded().strips.back().ridges[5].folded[0] + Vec3(0, 2, 0);
    design.anchors = {anchor};
    ASSERT_TRUE(session.set_design(design));
    const auto edited = session.solve();
    auto anew = SlitSession::start(design);
    const auto from_nothing = anew->solve();
    ASSERT_TRUE(edited && from_nothing);
    EXPECT_LT(2 * edited->iterations, from_nothing->iterations) << seed;
    EXPECT_LT(energy_of(session), 1.02 * energy_of(*anew)) << seed;
    const FoldedSlitSheet folded = session.folded();
    for (int i = 0; i + 1 < session.strip_count(); ++i)
      EXPECT_FALSE(
          slit_detail::cross(folded.strips[i], folded.strips[i + 1], 0.25 * folded.thickness))
          << seed << ' ' << i;
  }
}

}  // namespace
}  // namespace planish::test
