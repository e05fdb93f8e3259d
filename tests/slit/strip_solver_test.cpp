#include "sample_sheets.hpp"

#include <cmath>
#include <numbers>

// Shapes whose solution is known beforehand are found.

namespace planish::test {
namespace {

using std::numbers::pi;

/// One strip, its panel in the plane x = 100 with its front towards +x; both ends free.
SlitDesign one_strip(int ridges) {
  SlitDesign design;
  design.sheet.thickness = 1.0;
  design.sheet.panel_height = 50.0;
  design.sheet.half_length = 200.0;
  design.sheet.symmetric = false;
  design.sheet.strips = equal_strips(1, 30.0);
  design.leg_curve = {{{100, 0}, {100, 30}}};
  design.ridges = ridges;
  design.objective = SlitObjective::smooth;  // whose least is known here
  return design;
}

TEST(KnownShape, ArcOfAPolygonIsFoundFromItsEnd) {
  // Ten equal folds of 9° on equal spacings: the smoothest curve to its own end, with no cost at
  // all.
  SlitDesign design = one_strip(10);
  const double fold = pi / 20;
  Vec3 end(100, 50, 15);
  for (int i = 1; i <= 10; ++i)
    end += 20.0 * Vec3(-std::sin(i * fold), std::cos(i * fold), 0);
  design.ends = {{.position = end, .direction = Vec3(-1, 0, 0)}};
  const SlitSession session = solved(design);
  EXPECT_EQ(session.state(0).status, StripStatus::solved);
  EXPECT_LE(session.state(0).gap, 1e-9 * 250);
  EXPECT_LE(session.state(0).objective, 1e-12);
  const auto folded = session.folded();
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(folded.strips[0].ridges[i].fold.radians(), fold, 1e-5) << i;
  // The whole first fold is on half a quad: the panel beside it is not bent.
  EXPECT_NEAR(session.state(0).min_radius, 5.0 / std::tan(fold / 2), 1e-2);
}

/// Ends of ridges of a strip folded by given angles at given flat abscissae, by rotations of points
/// one after the other, last fold first.
std::vector<std::array<Vec3, 2>> folded_by_hand(const std::vector<double>& folds,
                                                const std::vector<std::array<double, 2>>& along) {
  std::vector<std::array<Vec3, 2>> flat;
  for (const auto& x : along)
    flat.push_back({Vec3(100, x[0], 0), Vec3(100, x[1], 30)});
  std::vector<std::array<Vec3, 2>> ends = flat;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (auto& p : ends[i])
      for (std::size_t k = std::min(i, folds.size()); k-- > 0;)
        p = flat[k][0] +
            Eigen::AngleAxisd(folds[k], (flat[k][1] - flat[k][0]).normalized()) * (p - flat[k][0]);
  return ends;
}

TEST(KnownShape, StripOfKnownAnglesIsFoundFromItsCorners) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 5; ++trial) {
    const int quads = 6;
    std::vector<double> folds;
    std::vector<std::array<double, 2>> along{{50, 50}};
    for (int i = 0; i < quads; ++i)
      folds.push_back(0.25 + 0.15 * unit(random));
    for (int i = 1; i < quads; ++i)
      along.push_back({50 + 200.0 / quads * (i + 0.25 * unit(random)),
                       50 + 200.0 / quads * (i + 0.25 * unit(random))});
    along.push_back({250, 250});
    const auto ends = folded_by_hand(folds, along);
    SlitDesign design = one_strip(quads);
    design.weights = {.smooth = 0.0, .spacing = 0.0, .anchors = 1.0};
    for (int ridge = 1; ridge <= quads; ++ridge)
      for (const StripEdge side : {StripEdge::left, StripEdge::right})
        design.anchors.push_back({0, ridge, side, ends[ridge][side == StripEdge::left ? 0 : 1]});
    SlitSession session = started(design);
    ASSERT_TRUE(session.solve({.max_iterations = 500, .function_tolerance = 1e-14}));
    EXPECT_LE(session.state(0).anchor_distance, 1e-6) << trial;
    const auto folded = session.folded();
    for (std::size_t i = 0; i < folds.size(); ++i)
      EXPECT_NEAR(folded.strips[0].ridges[i].fold.radians(), folds[i], 1e-6) << trial << " " << i;
  }
}

TEST(KnownShape, StripThatNothingBendsGoesOnStraight) {
  const SlitSession session = solved(one_strip(8));
  const auto folded = session.folded();
  for (const SlitRidge& ridge : folded.strips[0].ridges)
    for (std::size_t side = 0; side < 2; ++side)
      EXPECT_NEAR(
          (ridge.folded[side] - Vec3(100, ridge.flat[side].x(), ridge.flat[side].y())).norm(), 0.0,
          1e-9);
}

TEST(KnownShape, StripTooShortStopsShortByWhatIsMissing) {
  SlitDesign design = one_strip(10);
  design.sheet.symmetric = true;
  design.sheet.half_length = 80.0;
  const SlitSession session = solved(design);
  EXPECT_EQ(session.state(0).status, StripStatus::out_of_reach);
  // Straight towards the plane it leaves 100 − 80 mm.
  EXPECT_NEAR(session.state(0).shortfall, 20.0, 0.05);
}

TEST(KnownShape, SymmetricArchOfRightLengthIsAQuarterOfAPolygon) {
  // From upright to level: ten folds of 8.18…° (ten of eleven parts, the last quad is half of one
  // across the plane).
  SlitDesign design = one_strip(10);
  design.sheet.symmetric = true;
  const double fold = pi / 20, h = 20.0;
  double away = 0.0;
  for (int i = 1; i <= 10; ++i)
    away += h * std::sin(i * fold);
  design.leg_curve = {{{away, 0}, {away, 30}}};
  const SlitSession session = solved(design);
  const auto folded = session.folded();
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(folded.strips[0].ridges[i].fold.radians(), fold, 1e-5) << i;
  EXPECT_LE(session.state(0).gap, 1e-9 * 250);
}

}  // namespace
}  // namespace planish::test
