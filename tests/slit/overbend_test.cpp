#include "sample_sheets.hpp"

#include <planish/slit/codes.hpp>
#include <planish/slit/overbend.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Strips bent so far that they keep the wanted shape: against the moment of layers through the
// thickness, in closed form, and bent, let go and folded again.

namespace planish::test {
namespace {

const SlitMaterial kSteel{210000.0, 0.3, 7.85, 235.0};

/// Curvature that is left after bending to one and letting go: the stress of thin layers, each
/// elastic up to the yield stress, and the elastic curvature of their moment.
double left_of(double thickness, double curvature) {
  constexpr int kLayers = 200'000;
  const double plane = kSteel.young / (1.0 - kSteel.poisson * kSteel.poisson);
  double moment = 0.0;
  for (int i = 0; i < kLayers; ++i) {
    const double y = thickness * ((i + 0.5) / kLayers - 0.5);
    const double stress = std::clamp(plane * curvature * y, -*kSteel.yield, *kSteel.yield);
    moment += stress * y * thickness / kLayers;
  }
  return curvature - moment * 12.0 / (plane * thickness * thickness * thickness);
}

TEST(Overbend, FoldKeepsWhatLayersOfItDo) {
  const double t = 2.0, width = 20.0;
  for (const double radius : {40.0, 150.0, 600.0}) {
    const Angle fold = Angle::radians(width / radius);
    EXPECT_NEAR(kept_fold(kSteel, t, {width, width}, fold).radians(),
                width * left_of(t, 1.0 / radius), 1e-9);
    EXPECT_NEAR(kept_fold(kSteel, t, {width, width}, -fold).radians(),
                -width * left_of(t, 1.0 / radius), 1e-9);
  }
  // Below the yield stress nothing is kept.
  const double yields = 2.0 * *kSteel.yield * 0.91 / (kSteel.young * t);
  EXPECT_EQ(kept_fold(kSteel, t, {width, width}, Angle::radians(0.99 * yields * width)).radians(),
            0.0);
}

/// The strip of constant curvature: R is wanted, R' is bent, in closed form far beyond yielding:
/// 1/R' = 1/R + 3/2 κ_y − κ_y³ R'²/2.
TEST(Overbend, BendsToTheRadiusThatKeepsTheWantedOne) {
  const double t = 2.0, width = 20.0, wanted = 1.0 / 150.0;
  const double yields = 2.0 * *kSteel.yield * 0.91 / (kSteel.young * t);
  double bent = wanted + 1.5 * yields;
  for (int i = 0; i < 100; ++i)
    bent = wanted + 1.5 * yields - 0.5 * yields * yields * yields / (bent * bent);
  const Angle fold = overbent_fold(kSteel, t, {width, width}, Angle::radians(wanted * width));
  EXPECT_NEAR(fold.radians(), bent * width, 1e-12);
  EXPECT_EQ(overbent_fold(kSteel, t, {width, width}, Angle()).radians(), 0.0);
}

/// Of a fold whose material widens along its ridge, the moments of narrow pieces add up.
TEST(Overbend, WidthsThatDifferSpringBackTogether) {
  const double t = 2.0, fold = 0.12;
  constexpr int kPieces = 4000;
  double lost = 0.0, stiffness = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const double width = 10.0 + 15.0 * (i + 0.5) / kPieces;
    lost += fold / width - kSteel.kept_curvature(t, fold / width);
    stiffness += 1.0 / width;
  }
  EXPECT_NEAR(kept_fold(kSteel, t, {10.0, 25.0}, Angle::radians(fold)).radians(),
              fold - lost / stiffness, 1e-5 * fold);
}

TEST(Overbend, ShareOfMaterialAddsUpToTheStrip) {
  for (const SlitDesign& design : {small_chair(), arcade(), asymmetric()}) {
    const FoldedSlitSheet folded = solved(design).folded();
    for (const FoldedStrip& strip : folded.strips) {
      double mean = 0.0;
      const int last = static_cast<int>(strip.quads.size());
      const bool whole = strip.ends_directed || !folded.second_panel.empty();
      const int until = folded.second_panel.empty() ? last - 1 : last;
      for (int ridge = 0; ridge <= until; ++ridge) {
        const BentWidths bent = bent_widths(strip, ridge);
        mean += 0.5 * (bent[0] + bent[1]);
        EXPECT_GT(std::min(bent[0], bent[1]), 0.0);
      }
      const auto along = [&](int ridge) {
        return 0.5 * (strip.ridges[ridge].flat[0].x() + strip.ridges[ridge].flat[1].x());
      };
      const double end = whole ? along(last) : 0.5 * (along(last) + along(last - 1));
      EXPECT_NEAR(mean, end - along(0), 0.05 * (end - along(0)));
    }
  }
}

/// Bent over what is overbent and let go, every strip has its shape again.
TEST(Overbend, SheetLetGoIsTheWantedOne) {
  for (SlitDesign design : {small_chair(), arcade()}) {
    const FoldedSlitSheet folded = solved(design, 1).folded();
    const auto bent = overbent(folded, kSteel);
    ASSERT_TRUE(bent);
    for (std::size_t i = 0; i < folded.strips.size(); ++i) {
      const FoldedStrip &wanted = folded.strips[i], &over = bent->strips[i];
      const int last = static_cast<int>(wanted.quads.size());
      double most = 0.0;
      // Let go, fold by fold: dihedral angles of the bent strip's own quads.
      for (int ridge = 1; ridge < last; ++ridge) {
        const Frame &a = over.quads[ridge - 1], &b = over.quads[ridge];
        const Vec3 axis = (over.ridges[ridge].folded[1] - over.ridges[ridge].folded[0])
                              .normalized();
        const double fold = std::atan2(axis.dot(a.z.cross(b.z)), a.z.dot(b.z));
        const Angle kept = kept_fold(kSteel, folded.thickness, bent_widths(over, ridge),
                                     Angle::radians(fold));
        EXPECT_NEAR(kept.radians(), wanted.ridges[ridge].fold.radians(), 1e-9) << i << ' ' << ridge;
        EXPECT_GE(std::abs(fold), std::abs(wanted.ridges[ridge].fold.radians()));
        most = std::max(most, std::abs(fold) - std::abs(wanted.ridges[ridge].fold.radians()));
      }
      EXPECT_GT(most, 1e-3);
      // It is the same flat strip, with its end where it was.
      for (int ridge = 0; ridge <= last; ++ridge) {
        const auto& flat = wanted.ridges[ridge].flat;
        EXPECT_EQ(over.ridges[ridge].flat[0], flat[0]);
        EXPECT_NEAR((over.ridges[ridge].folded[1] - over.ridges[ridge].folded[0]).norm(),
                    (flat[1] - flat[0]).norm(), 1e-10);
      }
      for (std::size_t side = 0; side < 2; ++side)
        EXPECT_NEAR((over.ridges[last].folded[side] - wanted.ridges[last].folded[side]).norm(), 0.0,
                    1e-9 * 1000);
    }
  }
}

TEST(Overbend, NeedsAYieldStress) {
  const FoldedSlitSheet folded = solved(small_chair()).folded();
  SlitMaterial elastic = kSteel;
  elastic.yield.reset();
  const auto refused = overbent(folded, elastic);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::bad_option);
  SlitMaterial rubber{10.0, 0.45, 1.0, 20.0};
  const auto springy = overbent(folded, rubber);
  ASSERT_FALSE(springy);
  EXPECT_EQ(springy.error().code, code::radius_too_small);
}

}  // namespace
}  // namespace planish::test
