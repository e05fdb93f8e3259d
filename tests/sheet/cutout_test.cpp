#include <planish/geometry/region.hpp>
#include <planish/sheet/cutout.hpp>
#include <planish/sheet/one_piece.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace planish::test {
namespace {

constexpr double kPi = std::numbers::pi;

Contour ring_of(const std::vector<Vec2>& corners) {
  Contour contour;
  for (size_t i = 0; i < corners.size(); ++i)
    contour.loop.emplace_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  contour.origins.resize(corners.size());
  return contour;
}

FlatPattern pattern_of(const std::vector<Vec2>& corners) {
  FlatPattern pattern;
  pattern.thickness = 1.0;
  pattern.outer = ring_of(corners);
  pattern.area = signed_area(pattern.outer.loop);
  pattern.perimeter = length(pattern.outer.loop);
  return pattern;
}

FlatPattern plain() { return pattern_of({{0, 0}, {100, 0}, {100, 60}, {0, 60}}); }

Cutout rectangle_at(const Vec2& middle, const Vec2& half, double corner_radius = 0.0) {
  return {middle, Vec2::UnitX(), half, corner_radius};
}

FlatPattern cut_out(const FlatPattern& pattern, const Cutout& cutout) {
  auto left = without_cutout(pattern, cutout);
  if (!left) throw std::runtime_error(left.error().message);
  EXPECT_TRUE(check(*left)) << check(*left).error().message;
  EXPECT_EQ(left->outer.loop.size(), left->outer.origins.size());
  for (size_t i = 0; i < left->outer.loop.size(); ++i)
    EXPECT_LT((end_of(left->outer.loop[i]) -
               start_of(left->outer.loop[(i + 1) % left->outer.loop.size()]))
                  .norm(),
              1e-9);
  return *left;
}

TEST(Cutout, HasTheAreaOfItsRoundedRectangle) {
  const Cutout cutout{{3, 4}, Vec2(0.6, 0.8), {5, 2}, 1.5};
  EXPECT_NEAR(signed_area(cutout.outline()), 40 - (4 - kPi) * 1.5 * 1.5, 1e-12);
  EXPECT_NEAR(cutout.distance({3, 4}), -2.0, 1e-12);
  EXPECT_NEAR(cutout.distance(Vec2(3, 4) + 7 * Vec2(0.6, 0.8)), 2.0, 1e-12);
  for (const Curve2& curve : cutout.outline())
    EXPECT_NEAR(cutout.distance(point_at(curve, 0.37)), 0.0, 1e-12);
}

TEST(Cutout, BitesIntoAStraightEdge) {
  const FlatPattern left = cut_out(plain(), rectangle_at({40, 60}, {3, 5}));
  EXPECT_NEAR(left.area, 6000 - 6 * 5, 1e-9);
  EXPECT_NEAR(left.perimeter, 320 + 2 * 5, 1e-9);
}

TEST(Cutout, BitesTheSameWhereverTheContourStarts) {
  for (const Vec2& middle : {Vec2(0, 0), Vec2(100, 0), Vec2(100, 60), Vec2(0, 60)}) {
    const FlatPattern left = cut_out(plain(), rectangle_at(middle, {3, 5}));
    EXPECT_NEAR(left.area, 6000 - 15, 1e-9);
    EXPECT_NEAR(left.perimeter, 320, 1e-9);
  }
}

TEST(Cutout, EndsRound) {
  const FlatPattern left = cut_out(plain(), rectangle_at({40, 60}, {2, 5}, 2));
  EXPECT_NEAR(left.area, 6000 - 4 * 3 - kPi * 2, 1e-9) << "half of a slot with round ends";
}

TEST(Cutout, OpensAnOpeningToTheEdge) {
  FlatPattern pattern = plain();
  pattern.openings.push_back({{Arc{{50, 30}, 10, 0, -2 * kPi}}, {{}}});
  pattern.area -= 100 * kPi;
  // From the edge y = 60 into the circle: 2 mm wide, to the circle's chord at half-width 1.
  const FlatPattern left = cut_out(pattern, rectangle_at({50, 50}, {1, 15}));
  EXPECT_TRUE(left.openings.empty());
  const double cap = 100 * std::asin(0.1) + std::sqrt(99.0);  // of the circle, above y = 30
  EXPECT_NEAR(left.area, 6000 - 100 * kPi - (2 * 30 - cap), 1e-9);
}

TEST(Cutout, PartsTwoProngsThatCoverEachOther) {
  // Prongs from x = 30 to 51 and from 50 to 70, 40 mm long, cover 1 mm by 40 mm twice.
  const FlatPattern pattern = pattern_of({{0, 0},
                                          {100, 0},
                                          {100, 20},
                                          {70, 20},
                                          {70, 60},
                                          {50, 60},
                                          {50, 20},
                                          {51, 20},
                                          {51, 60},
                                          {30, 60},
                                          {30, 20},
                                          {0, 20}});
  ASSERT_NEAR(pattern.area, 2000 + 21 * 40 + 20 * 40, 1e-9);
  const FlatPattern left = cut_out(pattern, rectangle_at({50.5, 40}, {0.6, 20.1}));
  EXPECT_NEAR(left.area, 2000 - 1.2 * 0.1 + 19.9 * 40 + 18.9 * 40, 1e-9);
  EXPECT_TRUE(left.openings.empty());
}

TEST(Cutout, RefusesWhatStillCoversItself) {
  const FlatPattern pattern = pattern_of({{0, 0},
                                          {100, 0},
                                          {100, 20},
                                          {70, 20},
                                          {70, 60},
                                          {50, 60},
                                          {50, 20},
                                          {51, 20},
                                          {51, 60},
                                          {30, 60},
                                          {30, 20},
                                          {0, 20}});
  const auto left = without_cutout(pattern, rectangle_at({50.5, 60}, {0.2, 10}));
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().code, code::unsupported_shape);
}

TEST(Cutout, KeepsTheSlitsThatLeadToIt) {
  // A tongue between two slits from x = 50 is 10 mm long, its window 7 mm: 3 mm lie on the far
  // side.
  FlatPattern pattern = plain();
  pattern.openings.push_back(ring_of({{50, 30}, {40, 30}, {40, 20}, {50, 20}, {43, 20}, {43, 30}}));
  pattern.area += 30;
  const FlatPattern left = with_slits_drawn_once(
      cut_out(pattern, rectangle_at({41.5, 25}, {1.6, 5.1})));
  EXPECT_NEAR(left.area, 6000 - 3.2 * 10.2, 1e-9);
  ASSERT_EQ(left.openings.size(), 1u);
  ASSERT_EQ(left.slits.size(), 2u);
  for (const Curve2& slit : left.slits)
    EXPECT_NEAR(length(slit), 6.9, 1e-9);
  EXPECT_NEAR(left.perimeter, 320 + 2 * (3.2 + 10.2) + 2 * 6.9, 1e-9);
}

// ---- against another program

/// The shared area of two loops, by GEOS.
double shared_area(const Loop& a, const Loop& b) {
  constexpr double kFine = 2e-4;  // mm
  double sum = 0.0;
  for (const Overlap& overlap :
       overlaps({polygon_of({a, {}}, kFine), polygon_of({b, {}}, kFine)}, 0.0, 0.0))
    sum += overlap.area;
  return sum;
}

Cutout random_cutout(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0), x(-5, 65), y(-5, 45), half(0.4, 9.0);
  const double angle = 2 * kPi * share(random);
  Cutout cutout{
      {x(random), y(random)}, Vec2(std::cos(angle), std::sin(angle)), {half(random), half(random)}};
  if (share(random) < 0.6) cutout.corner_radius = share(random) * cutout.half.minCoeff();
  if (share(random) < 0.3) cutout.sharp_corner = static_cast<int>(4 * share(random));
  return cutout;
}

TEST(Cutout, TakesFromAConvexPlateAndFromItsHoleWhatItSharesWithThem) {
  // Half of a disc on a rectangle, with a round hole.
  const Loop outer{Segment{{0, 0}, {60, 0}}, Segment{{60, 0}, {60, 20}}, Arc{{30, 20}, 30, 0, kPi},
                   Segment{{0, 20}, {0, 0}}};
  const Loop hole{Arc{{30, 20}, 8, 0.4, -2 * kPi}};
  std::mt19937 random(4);
  int bitten = 0, opened = 0;
  for (int i = 0; i < 250; ++i) {
    const Cutout cutout = random_cutout(random);
    FlatPattern pattern;
    pattern.thickness = 1.0;
    pattern.outer = {outer, std::vector<std::vector<Origin>>(outer.size())};
    pattern.openings = {{hole, {{}}}};
    const auto left = without_cutout(pattern, cutout);
    if (!left) continue;  // it falls into pieces
    const double in_hole = shared_area(hole, cutout.outline());
    const double taken = shared_area(outer, cutout.outline()) - in_hole;
    const double whole = 1200 + 450 * kPi - 64 * kPi;
    EXPECT_NEAR(left->area, whole - taken, 0.05) << i << ", " << cutout.middle.transpose();
    bitten += taken > 1e-6 && left->openings.size() == 1;
    opened += left->openings.empty();
  }
  EXPECT_GT(bitten, 50);
  EXPECT_GE(opened, 3);
}

TEST(Cutout, OfManySizesTakesTheSameFromAnEdgeWhereverItsCornerIsBetweenSamples) {
  // A square on its tip that reaches `deep` over the edge takes a triangle of deep².
  const double diagonal = std::sqrt(0.5);
  for (const double deep : {0.2, 0.01, 0.001})
    for (int i = 0; i < 40; ++i) {
      const double x = 20 + 0.731 * i, half = 2.0;
      const Cutout cutout{{x, 60 + half / diagonal - deep}, {diagonal, diagonal}, {half, half}};
      const FlatPattern left = cut_out(plain(), cutout);
      EXPECT_NEAR(left.area, 6000 - deep * deep, 1e-8) << deep << ' ' << x;
      EXPECT_NEAR(left.perimeter, 320 + 2 * deep * (std::numbers::sqrt2 - 1), 1e-6);
    }
}

TEST(Cutout, LeavesOfLinesWhatLiesOutsideAsClippingByItsFourSides) {
  // Bend lines and slits in an unbounded plate: the distance along a line to each of the four
  // sides.
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(-20.0, 20.0), share(0.0, 1.0);
  const FlatPattern plate = pattern_of({{-500, -500}, {500, -500}, {500, 500}, {-500, 500}});
  for (int i = 0; i < 400; ++i) {
    Cutout cutout = random_cutout(random);
    cutout.middle = Vec2(any(random), any(random)) / 4;
    cutout.corner_radius = 0.0;
    FlatPattern pattern = plate;
    FlatBend bend;
    bend.id = "B1";
    const Segment line{{any(random), any(random)}, {any(random), any(random)}};
    bend.lines = {line};
    bend.line_angles = {Angle::degrees(90)};
    bend.tangent_lines = {line};
    bend.length = (line.b - line.a).norm();
    pattern.bends = {bend};
    pattern.slits = {line, Arc{{300, 300}, 5, 0, 1}};
    const FlatPattern left = cut_out(pattern, cutout);

    double enter = 0.0, leave = 1.0;
    for (const auto& [axis, half] :
         {std::pair{cutout.along, cutout.half.x()},
          std::pair{Vec2(-cutout.along.y(), cutout.along.x()), cutout.half.y()}}) {
      const double at = axis.dot(line.a - cutout.middle), speed = axis.dot(line.b - line.a);
      enter = std::max(enter, std::min((-half - at) / speed, (half - at) / speed));
      leave = std::min(leave, std::max((-half - at) / speed, (half - at) / speed));
    }
    const double whole = (line.b - line.a).norm();
    std::vector<double> wanted;  // where parts begin and end, along the line
    if (enter >= leave) wanted = {0.0, whole};
    if (enter < leave && enter > 0.0) wanted = {0.0, enter * whole};
    if (enter < leave && leave < 1.0) wanted.insert(wanted.end(), {leave * whole, whole});
    double rest = 0.0;
    std::vector<double> found;
    for (const Segment& part : left.bends[0].lines) {
      found.insert(found.end(), {(part.a - line.a).norm(), (part.b - line.a).norm()});
      rest += (part.b - part.a).norm();
    }
    ASSERT_EQ(found.size(), wanted.size()) << i;
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], wanted[k], 1e-9) << i;
    EXPECT_NEAR(left.bends[0].length, rest, 1e-9);
    EXPECT_EQ(left.bends[0].line_angles.size(), left.bends[0].lines.size());
    EXPECT_EQ(left.bends[0].tangent_lines.size(), left.bends[0].lines.size());
    EXPECT_EQ(left.slits.size(), left.bends[0].lines.size() + 1) << "curved slits stay";
  }
}

TEST(Cutout, KeepsOfEachCurveWhereItCameFrom) {
  FlatPattern pattern = plain();
  for (int i = 0; i < 4; ++i)
    pattern.outer.origins[i] = {Origin{{FaceId{0}, 0, i}, false, pattern.outer.loop[i]}};
  // At the corner where the contour starts, and in the middle of a side.
  for (const Vec2& middle : {Vec2(0, 0), Vec2(40, 60)}) {
    const FlatPattern left = cut_out(pattern, rectangle_at(middle, {3, 5}));
    for (std::size_t i = 0; i < left.outer.loop.size(); ++i) {
      const Vec2 at = point_at(left.outer.loop[i], 0.5);
      const bool on_outline = rectangle_at(middle, {3, 5}).distance(at) < 1e-9;
      if (on_outline) {
        EXPECT_TRUE(left.outer.origins[i].empty());
        continue;
      }
      ASSERT_EQ(left.outer.origins[i].size(), 1u) << at.transpose();
      EXPECT_LT(nearest(left.outer.origins[i][0].image, at).distance, 1e-9);
    }
  }
}

TEST(Cutout, LeavesAPatternWithoutOriginsWithout) {
  FlatPattern pattern = plain();
  pattern.outer.origins.clear();
  EXPECT_NEAR(cut_out(pattern, rectangle_at({40, 60}, {3, 5})).area, 6000 - 30, 1e-9);
}

/// A slit of no width, 40 long, that comes in from the upper edge at `x`.
FlatPattern slit_at(double x) {
  return pattern_of({{0, 0}, {100, 0}, {100, 60}, {x, 60}, {x, 20}, {x, 60}, {0, 60}});
}

TEST(Cutout, AtTheEndOfASlitHasItsArea) {
  // At whichever side of the window its two banks are found first.
  const double window = 2.0 * 4.0 - (4.0 - kPi) * 0.2 * 0.2;
  for (const double x : {30.1, 41.0 / 3.0, 50.0, 61.7, 77.77})
    for (const double beside : {-0.9, 0.0, 0.3}) {
      const Cutout cutout = rectangle_at({x + beside, 20.5}, {1.0, 2.0}, 0.2);
      EXPECT_NEAR(cut_out(slit_at(x), cutout).area, 6000 - window, 1e-9) << x << ' ' << beside;
      const FlatPattern drawn = cut_out(with_slits_drawn_once(slit_at(x)), cutout);
      EXPECT_NEAR(drawn.area, 6000 - window, 1e-9) << x << ' ' << beside;
      ASSERT_EQ(drawn.openings.size(), 1u);
      ASSERT_EQ(drawn.slits.size(), 1u);
      const double corner = 0.2 - std::sqrt(0.2 * 0.2 - 0.1 * 0.1);
      EXPECT_NEAR(length(drawn.slits.front()), 37.5 + (beside < -0.5 ? corner : 0.0), 1e-9);
      EXPECT_NEAR(drawn.perimeter, 320 + 12 - (8 - 2 * kPi) * 0.2 + length(drawn.slits.front()),
                  1e-9);
    }
}

TEST(Cutout, LeavesOutSlitsThatNoLaserCuts) {
  for (const double deep : {0.04, 0.06, 0.11, 0.3}) {
    const FlatPattern drawn = with_slits_drawn_once(
        pattern_of({{0, 0}, {100, 0}, {100, 60}, {30, 60}, {30, 60 - deep}, {30, 60}, {0, 60}}));
    EXPECT_EQ(drawn.slits.size(), deep > 0.1 ? 1u : 0u) << deep;
    EXPECT_NEAR(drawn.area, 6000, 1e-9);
    EXPECT_NEAR(length(drawn.outer.loop), 320, 1e-9) << "gone from the outline";
  }
}

TEST(Cutout, KeepsACornerSharp) {
  for (int corner = 0; corner < 4; ++corner) {
    Cutout cutout = rectangle_at({60, 30}, {5, 2}, 1.5);
    cutout.sharp_corner = corner;
    const double area = 40 - 3 * (1 - kPi / 4) * 1.5 * 1.5;
    EXPECT_NEAR(signed_area(cutout.outline()), area, 1e-9);
    EXPECT_NEAR(cut_out(plain(), cutout).area, 6000 - area, 1e-9);
    const Vec2 tip(corner == 0 || corner == 3 ? 65 : 55, corner < 2 ? 32 : 28);
    EXPECT_NEAR(cutout.distance(tip), 0.0, 1e-12);
  }
}

/// Straight slits in a plate with a window.
FlatPattern slit_plate(const std::vector<Segment>& slits) {
  FlatPattern pattern = plain();
  pattern.openings.push_back(ring_of({{20, 20}, {20, 40}, {40, 40}, {40, 20}}));
  for (const Segment& slit : slits)
    pattern.slits.emplace_back(slit);
  return pattern;
}

TEST(OnePiece, IsPartedBySlitsThatJoinWhatIsJoined) {
  const auto whole = [](const std::vector<Segment>& slits) {
    return is_one_piece(slit_plate(slits), 1e-6);
  };
  const Segment to_edge{{40, 30}, {100, 30}}, other{{0, 30}, {20, 30}};
  EXPECT_TRUE(whole({}));
  EXPECT_TRUE(whole({{{50, 10}, {60, 10}}})) << "free at both ends";
  EXPECT_TRUE(whole({to_edge}));
  EXPECT_FALSE(whole({to_edge, other})) << "above and below the window";
  EXPECT_FALSE(whole({{{60, 0}, {60, 60}}})) << "from edge to edge";
  EXPECT_TRUE(whole({to_edge, {{70, 30}, {70, 50}}})) << "a branch";
  EXPECT_FALSE(whole({to_edge, {{70, 30}, {70, 60}}}));
  EXPECT_TRUE(whole({{{50, 10}, {60, 10}}, {{60, 10}, {60, 20}}, {{60, 20}, {50, 20}}}));
  EXPECT_FALSE(whole({{{50, 10}, {60, 10}}, {{60, 10}, {60, 20}}, {{60, 20}, {50, 10}}}))
      << "around a triangle";
}

TEST(Cutout, WithinTheMaterialIsAnOpening) {
  FlatPattern pattern = plain();
  pattern.openings.push_back(ring_of({{20, 20}, {20, 40}, {40, 40}, {40, 20}}));
  pattern.area -= 400;
  const FlatPattern left = cut_out(pattern, rectangle_at({60, 30}, {5, 2}));
  EXPECT_NEAR(left.area, 5600 - 40, 1e-9);
  ASSERT_EQ(left.openings.size(), 2u);
  EXPECT_LT(signed_area(left.openings.back().loop), 0.0);
  EXPECT_NEAR(cut_out(pattern, rectangle_at({30, 30}, {5, 2})).area, 5600, 1e-9) << "in the hole";
  EXPECT_NEAR(cut_out(pattern, rectangle_at({130, 30}, {5, 2})).area, 5600, 1e-9) << "in the air";
  EXPECT_NEAR(cut_out(pattern, rectangle_at({30, 30}, {12, 12})).area, 6000 - 24 * 24, 1e-9)
      << "around the hole";
}

TEST(Cutout, GoesOnFromALineThatItsSideLiesOn) {
  // Beside the step at x = 40, and a thousandth of a micrometre into it.
  const FlatPattern pattern = pattern_of(
      {{0, 0}, {100, 0}, {100, 60}, {40, 60}, {40, 30}, {0, 30}});
  const FlatPattern left = cut_out(pattern, rectangle_at({39 + 1e-6, 30}, {1.0, 5.0}));
  EXPECT_EQ(left.outer.loop.size(), 8u) << "from the step's top to the window's bottom one line";
  EXPECT_NEAR(left.area, pattern.area - 2.0 * 5.0, 1e-4);
}

TEST(Cutout, RefusesAPatternThatFallsIntoPieces) {
  const auto left = without_cutout(plain(), rectangle_at({40, 30}, {1, 40}));
  ASSERT_FALSE(left);
  EXPECT_EQ(left.error().code, code::unsupported_shape);
}

TEST(Cutout, EndsBendLines) {
  FlatPattern pattern = plain();
  FlatBend bend;
  bend.id = "B1";
  bend.lines = {Segment{{40, 0}, {40, 60}}};
  bend.line_angles = {Angle::degrees(90)};
  bend.length = 60;
  pattern.bends.push_back(bend);
  const FlatPattern left = cut_out(pattern, rectangle_at({40, 60}, {3, 5}));
  ASSERT_EQ(left.bends.front().lines.size(), 1u);
  EXPECT_NEAR(left.bends.front().length, 55.0, 1e-9);
  EXPECT_NEAR(left.bends.front().lines.front().b.y(), 55.0, 1e-9);
}

TEST(Slits, ThatRunThereAndBackAreDrawnOnce) {
  FlatPattern pattern = pattern_of(
      {{0, 0}, {100, 0}, {100, 30}, {60, 30}, {100, 30}, {100, 60}, {0, 60}});
  ASSERT_NEAR(pattern.perimeter, 320 + 2 * 40, 1e-9);
  const FlatPattern drawn = with_slits_drawn_once(pattern);
  EXPECT_NEAR(drawn.area, 6000.0, 1e-9);
  EXPECT_NEAR(drawn.perimeter, 320 + 40, 1e-9);
  ASSERT_EQ(drawn.slits.size(), 1u);
  EXPECT_NEAR(length(drawn.slits.front()), 40.0, 1e-9);
  const FlatPattern ripped = cut_out(drawn, rectangle_at({80, 30}, {20.25, 0.25}));
  EXPECT_NEAR(ripped.area, 6000 - 0.5 * 40.25, 1e-9) << "a quarter of a millimetre past its tip";
}

}  // namespace
}  // namespace planish::test
