#include "bend_energy.hpp"
#include "sample_sheets.hpp"
#include "strip_fold.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/slit/slit_curves.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Strips between slits that are curves: where they lie, what is refused, and shapes in closed form.

namespace planish::test {
namespace {

using std::numbers::pi;

SlitSheet bare_sheet() {
  SlitSheet sheet = chair().sheet;
  sheet.strips.clear();
  return sheet;
}

CurvedSlits straight_slits() {
  CurvedSlits curves;
  curves.width = 360.0;
  for (int i = 1; i < 6; ++i)
    curves.slits.push_back({{420.0, 60.0 * i}, {884.0, 60.0 * i}});
  return curves;
}

/// Slits that lead together towards the symmetry plane.
CurvedSlits converging_slits() {
  CurvedSlits curves;
  curves.width = 360.0;
  for (int i = 1; i < 6; ++i) {
    const double from = 60.0 * i, to = 180.0 + 0.7 * (from - 180.0);
    curves.slits.push_back(
        chain_on({{{420.0, from}, {570.0, from}, {720.0, to}, {884.0, to}}}, 0.02));
  }
  return curves;
}

std::string refused(const CurvedSlits& curves) {
  const auto strips = strips_between(bare_sheet(), curves);
  return strips ? "made" : strips.error().message;
}

TEST(SlitCurves, ChainStaysWithinItsChordOfTheCurve) {
  const BezierCurve curve{{{0, 0}, {150, 10}, {90, 200}, {300, 90}}};
  for (const double chord : {1.0, 0.02}) {
    const std::vector<Vec2> chain = chain_on(curve, chord);
    EXPECT_EQ(chain.front(), curve.poles.front());
    EXPECT_EQ(chain.back(), curve.poles.back());
    double most = 0.0;
    for (int i = 0; i <= 5000; ++i) {
      const Vec2 p = bezier_at(curve, i / 5000.0).point;
      double off = 1e300;
      for (std::size_t k = 0; k + 1 < chain.size(); ++k)
        off = std::min(off, distance(p, Segment{chain[k], chain[k + 1]}));
      most = std::max(most, off);
    }
    EXPECT_LE(most, chord);
    EXPECT_GE(most, 0.05 * chord) << "more lines than it takes";
  }
  EXPECT_EQ(chain_on({{{0, 0}, {10, 5}}}, 0.02).size(), 2u);
}

TEST(SlitCurves, LinesAlongTheSheetMakeTheStripsOfOldFiles) {
  const auto strips = strips_between(bare_sheet(), straight_slits());
  ASSERT_TRUE(strips);
  EXPECT_EQ(*strips, equal_strips(6, 60.0));
}

TEST(SlitCurves, AreTheSameInAnyOrderAndDirection) {
  CurvedSlits curves = converging_slits();
  const auto strips = strips_between(bare_sheet(), curves);
  ASSERT_TRUE(strips);
  std::ranges::reverse(curves.slits);
  std::swap(curves.slits[0], curves.slits[2]);
  for (auto& slit : curves.slits)
    std::ranges::reverse(slit);
  EXPECT_EQ(*strips_between(bare_sheet(), curves), *strips);
  SlitSheet sheet = bare_sheet();
  sheet.strips = *strips;
  EXPECT_NEAR(sheet.width(), 360.0, 1e-12);
  double area = 0.0;
  for (int strip = 0; strip < 6; ++strip) {
    area += sheet.area_of(strip);
    EXPECT_NEAR(sheet.width_at_end(strip), strip == 0 || strip == 5 ? 96.0 : 42.0, 1e-9) << strip;
  }
  EXPECT_NEAR(area, 360.0 * 464.0, 1e-6);
}

TEST(SlitCurves, MayBeginInTheMiddleOfTheSheet) {
  CurvedSlits curves = straight_slits();
  curves.slits[2][0] = {600.0, 175.0};
  const auto strips = strips_between(bare_sheet(), curves);
  ASSERT_TRUE(strips);
  EXPECT_EQ((*strips)[2].right_start, 600.0);
  EXPECT_EQ((*strips)[3].left_start, 600.0);
  EXPECT_EQ((*strips)[2].width, 55.0);
  EXPECT_EQ((*strips)[2].edges[1].size(), 2u);
}

TEST(SlitCurves, MayEndInTheMiddleOfTheSheet) {
  CurvedSlits curves = straight_slits();
  curves.slits[2].back() = {700.0, 175.0};
  curves.slits[3] = {{420, 240}, {650, 230}, {884, 230}};
  const auto strips = strips_between(bare_sheet(), curves);
  ASSERT_TRUE(strips) << strips.error().message;
  EXPECT_EQ((*strips)[2].right_end, 700.0);
  EXPECT_EQ((*strips)[3].left_end, 700.0);
  EXPECT_FALSE((*strips)[3].right_end);
  EXPECT_FALSE((*strips)[4].left_end);
  // The strip's other edge is cut off where its last ridge lies, that of the next strip is not.
  EXPECT_EQ((*strips)[3].edges[1].back(), Vec2(700, 230));
  EXPECT_EQ((*strips)[4].edges[0].back(), Vec2(884, 230));
}

TEST(SlitCurves, LieWithinAnOutlineThatLeavesThePanelWhole) {
  CurvedSlits curves = straight_slits();
  curves.width = 0.0;
  curves.outline = {{0, 0},     {420, 0},   {600, -20}, {884, -50},
                    {884, 420}, {600, 380}, {420, 360}, {0, 360}};
  const auto strips = strips_between(bare_sheet(), curves);
  ASSERT_TRUE(strips) << strips.error().message;
  SlitSheet sheet = bare_sheet();
  sheet.strips = *strips;
  EXPECT_EQ(sheet.breadth(), 470.0);
  EXPECT_EQ(sheet.width(), 360.0);
  CurvedSlits turned = curves;
  std::ranges::reverse(turned.outline);
  std::ranges::rotate(turned.outline, turned.outline.begin() + 3);
  EXPECT_EQ(*strips_between(bare_sheet(), turned), *strips);
  curves.outline[1] = {400, 5};
  EXPECT_NE(refused(curves).find("leave the panel whole"), std::string::npos);
}

TEST(SlitCurves, AreRefusedWhereTheyMakeNoStrips) {
  const auto with = [](auto change) {
    CurvedSlits curves = straight_slits();
    change(curves.slits);
    return refused(curves);
  };
  using Slits = std::vector<std::vector<Vec2>>;
  EXPECT_NE(with([](Slits& s) {
              s[1].back() = {420.0, 130.0};
            }).find("begins and ends at 420"),
            std::string::npos);
  EXPECT_NE(with([](Slits& s) {
              s[1].back().x() = 600.0;
              s[2] = {{650, 120}, {884, 120}};
            }).find("one ends before the other begins"),
            std::string::npos);
  EXPECT_NE(with([](Slits& s) {
              s[1].back().x() = 700.0;
              s[2].insert(s[2].begin() + 1, Vec2(800, 200));
            }).find("Slit 3 is curved beside the uncut sheet, which begins at 700"),
            std::string::npos);
  EXPECT_NE(with([](Slits& s) { s[0].front().x() = -5.0; }).find("Slit 1 goes to"),
            std::string::npos);
  EXPECT_NE(with([](Slits& s) {
              s[2] = {{420, 180}, {420, 180}};
            }).find("no length"),
            std::string::npos);
  EXPECT_NE(with([](Slits& s) { s[2].back().y() = 250.0; }).find("no width"), std::string::npos);
  EXPECT_NE(with([](Slits& s) { s[2].insert(s[2].begin() + 1, Vec2(600, 250)); }).find("they meet"),
            std::string::npos);
}

/// Edges that are chains, though they lie on lines along the sheet, give the same shapes.
TEST(SlitCurves, ChainsOnLinesGiveTheShapesOfLines) {
  SlitDesign design = chair();
  const SlitSession lines = solved(design, 1);
  for (int i = 0; i < 6; ++i)
    for (int side = 0; side < 2; ++side)
      for (const double along : {420.0, 500.0, 710.0, 884.0})
        design.sheet.strips[i].edges[side].emplace_back(along, 60.0 * (i + side));
  const SlitSession chains = solved(design, 1);
  for (int strip = 0; strip < 6; ++strip)
    EXPECT_NEAR(chains.state(strip).energy, lines.state(strip).energy,
                1e-6 * lines.state(strip).energy)
        << strip;
}

/// A wedge whose end is only turned has one moment all along: its curvature is inverse to its width
/// b, and its energy Φ² / 2∫ds/b.
TEST(SlitCurves, WedgeThatIsTurnedHasTheEnergyOfOneMoment) {
  SlitDesign design;
  design.sheet.thickness = 1.0;
  design.sheet.panel_height = 100.0;
  design.sheet.half_length = 400.0;
  design.sheet.symmetric = false;
  CurvedSlits curves;
  curves.width = 150.0;
  curves.slits.push_back({Vec2(100, 25), Vec2(500, 45)});
  curves.slits.push_back({Vec2(100, 125), Vec2(500, 105)});
  const auto strips = strips_between(design.sheet, curves);
  ASSERT_TRUE(strips);
  design.sheet.strips = {(*strips)[1]};
  design.sheet.strips[0].gap = 25.0;
  design.sheet.margin = 25.0;
  design.leg_curve = {{{300, 0}, {300, 150}}};
  design.ridges = 40;
  design.ends.resize(1);
  design.ends[0].direction = Vec3(-1, 0, 0);  // a quarter turn from straight up
  design.ends[0].across = Vec3(0, 0, 1);
  const SlitSession session = solved(design);
  const double turn = 0.5 * pi, mean = 400.0 * std::log(100.0 / 60.0) / 40.0;
  EXPECT_NEAR(session.state(0).energy, 0.5 * turn * turn / mean, 1e-3 * 0.5 * turn * turn / mean);
  const FoldedSlitSheet folded = session.folded();
  for (const SlitRidge& ridge : folded.strips[0].ridges)
    EXPECT_NEAR(ridge.flat[0].x(), ridge.flat[1].x(), 1.0);
}

/// On a cylinder ridges are parallel to its axis, whatever the edges: ½ κ² A.
TEST(SlitCurves, StripOnACylinderHasTheEnergyOfItsArea) {
  using namespace slit_detail;
  StripProblem problem;
  StripBase& base = problem.base;
  base.facet = frame_from_axes({0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX());
  base.quads = 200;
  base.end = {400.0, 400.0};
  const auto left = [](double x) { return 20.0 * std::sin(x / 60.0); };
  const auto right = [](double x) { return 120.0 - 70.0 * x * x / 160000.0; };
  std::vector<Vec2> chains[2];
  for (int i = 0; i <= 400; ++i) {
    chains[0].emplace_back(i, left(i));
    chains[1].emplace_back(i, right(i));
  }
  base.sides = {EdgeCurve(chains[0], 0.0, 400.0), EdgeCurve(chains[1], 0.0, 400.0)};
  problem.ends = {{EndCondition::Of::normal, Vec3::UnitX(), 0.0}};
  const double radius = 150.0, fold = 2.0 / radius;
  StripParameters p = flat_parameters(base);
  p.head(200).setConstant(fold);
  p[0] = 0.5 * fold;
  p[199] = 1.5 * fold;
  for (int ridge = 1; ridge < 200; ++ridge)
    for (int side = 0; side < 2; ++side) {
      double low = 0.0, high = 400.0;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (base.sides[side].place(middle).at.x() < 2.0 * ridge ? low : high) = middle;
      }
      p[abscissa_index(200, ridge, side)] = low / base.unit();
    }
  double area = 0.0;
  for (int i = 0; i < 4000; ++i)
    area += 0.1 * (right(0.1 * (i + 0.5)) - left(0.1 * (i + 0.5)));
  EXPECT_NEAR(base.area(), area, 1e-3 * area);
  EXPECT_NEAR(bend_energy(problem, p), 0.5 * area / (radius * radius),
              2e-3 * area / (radius * radius));
  // All its places are on a polygon about the cylinder; its ends lie on the edges as cut.
  const FoldedStrip strip = folded_strip(base, p);
  ASSERT_EQ(strip.borders.size(), 200u);
  for (std::size_t quad = 0; quad < 200; ++quad) {
    EXPECT_LT(std::abs(strip.quads[quad].y.dot(Vec3::UnitY()) - 1.0), 1e-12);
    EXPECT_GE(strip.borders[quad][0].size() + strip.borders[quad][1].size(), 2u) << quad;
  }
}

}  // namespace
}  // namespace planish::test
