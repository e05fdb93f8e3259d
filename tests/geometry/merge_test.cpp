#include "geometry/comparisons.hpp"
#include "geometry/random_curves.hpp"

#include <planish/geometry/fit.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

double worst_gap(const Loop& loop) {
  double worst = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 gap = end_of(loop[i]) - start_of(loop[(i + 1) % loop.size()]);
    worst = std::max(worst, gap.norm());
  }
  return worst;
}

Loop loop_through(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  }
  return loop;
}

/// Every curve cut into `n` parts.
Loop cut_up(const Loop& loop, int n) {
  Loop made;
  for (const Curve2& c : loop) {
    for (int i = 0; i < n; ++i)
      made.push_back(trimmed(c, i / double(n), (i + 1) / double(n)));
  }
  return made;
}

/// A slot: two straight sides 40 long, two half circles of radius 5, counter-clockwise.
Loop slot() {
  return {Segment{{-20, -5}, {20, -5}}, Arc{{20, 0}, 5, -pi / 2, pi}, Segment{{20, 5}, {-20, 5}},
          Arc{{-20, 0}, 5, pi / 2, pi}};
}

TEST(Merged, JoinsPartsOfALineAndTellsWhereTheyBegan) {
  const Loop square = cut_up(loop_through({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 3);
  const MergedLoop found = merged(square, 1e-6);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{0, 3, 6, 9}));
  EXPECT_DOUBLE_EQ(signed_area(found.loop), 100.0);
  EXPECT_EQ(worst_gap(found.loop), 0.0);
}

TEST(Merged, JoinsAcrossTheStart) {
  Loop square = cut_up(loop_through({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 3);
  std::rotate(square.begin(), square.begin() + 1, square.end());  // begins within the first side
  const MergedLoop found = merged(square, 1e-6);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{11, 2, 5, 8}));
  EXPECT_DOUBLE_EQ(signed_area(found.loop), 100.0);
}

TEST(Merged, MakesOneCircleOfItsPieces) {
  for (const double sense : {1.0, -1.0}) {
    const Loop spans = cut_up({Arc{{3, 4}, 5, 0.7, sense * 2 * pi}}, 7);
    const MergedLoop found = merged(spans, 1e-6);
    ASSERT_EQ(found.loop.size(), 1u);
    const Arc& arc = std::get<Arc>(found.loop[0]);
    EXPECT_EQ(arc.sweep, sense * 2 * pi);
    EXPECT_EQ(arc.radius, 5.0);
    EXPECT_EQ(arc.center, Vec2(3, 4));
    EXPECT_EQ(found.first_input, std::vector<int>{0});
  }
}

TEST(Merged, MakesOneCircleOfInaccuratePieces) {
  Loop spans = cut_up({Arc{{3, 4}, 5, 0.7, 2 * pi}}, 4);
  std::get<Arc>(spans[1]).center += Vec2(2e-5, -1e-5);
  std::get<Arc>(spans[2]).radius += 2e-5;
  const MergedLoop found = merged(spans, 1e-4);
  ASSERT_EQ(found.loop.size(), 1u);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).sweep, 2 * pi);
  EXPECT_NEAR(std::get<Arc>(found.loop[0]).radius, 5, 1e-4);
}

TEST(Merged, LeavesALoopThatIsSimpleAlready) {
  const MergedLoop found = merged(slot(), 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(std::get<Arc>(found.loop[1]).radius, 5.0);
  EXPECT_NEAR(signed_area(found.loop), 400 + 25 * pi, 1e-11);
}

RC_GTEST_PROP(Merged, FindsASlotAgainHoweverCutMovedAndStarted, ()) {
  const Isometry2 motion = *any_motion();
  Loop spans = transformed(cut_up(slot(), *rc::gen::inRange(1, 12)), motion);
  if (*rc::gen::arbitrary<bool>()) spans = reversed(spans);
  const auto shift = *rc::gen::inRange<std::size_t>(0, spans.size());
  std::rotate(spans.begin(), spans.begin() + static_cast<std::ptrdiff_t>(shift), spans.end());
  const MergedLoop found = merged(spans, 1e-6);
  RC_ASSERT(found.loop.size() == 4u);
  RC_ASSERT(std::abs(signed_area(found.loop) - signed_area(spans)) <= 1e-9);
  RC_ASSERT(std::abs(length(found.loop) - (80 + 10 * pi)) <= 1e-9);
  RC_ASSERT(worst_gap(found.loop) <= 1e-12 * 300);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 begins = start_of(spans[found.first_input[i]]);
    RC_ASSERT((start_of(found.loop[i]) - begins).norm() <= 1e-9);
  }
}

TEST(Merged, DoesNotJoinArcsThatTurnApart) {
  // An S of two arcs with one radius, and its way back.
  const Loop loop{Arc{{0, 0}, 1, pi, pi}, Arc{{2, 0}, 1, pi, -pi}, Segment{{3, 0}, {3, 5}},
                  Segment{{3, 5}, {-1, 5}}, Segment{{-1, 5}, {-1, 0}}};
  EXPECT_EQ(merged(loop, 1e-3).loop.size(), 5u);
}

TEST(Merged, KeepsASpike) {
  const Loop spike = loop_through({{0, 0}, {10, 0}, {10, 5}, {10, -3}, {10, 10}, {0, 10}});
  EXPECT_EQ(merged(spike, 1e-3).loop.size(), 6u);
}

TEST(Merged, AbsorbsAShortChamferInTheCorner) {
  const Loop chamfered = loop_through({{0, 0}, {10 - 2e-4, 0}, {10, 2e-4}, {10, 10}, {0, 10}});
  const MergedLoop found = merged(chamfered, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(worst_gap(found.loop), 0.0);
  EXPECT_EQ(found.first_input, (std::vector<int>{0, 2, 3, 4}));
  EXPECT_LE((end_of(found.loop[0]) - Vec2(10, 0)).norm(), 1e-12);  // both sides keep their lines
}

TEST(Merged, AbsorbsAShortCurveAtTheStartOfTheLoop) {
  const Loop chamfered = loop_through({{0, 2e-4}, {2e-4, 0}, {10, 0}, {10, 10}, {0, 10}});
  const MergedLoop found = merged(chamfered, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(worst_gap(found.loop), 0.0);
}

TEST(Merged, AbsorbsAShortCurveBesideAnArcWithoutMovingTheArc) {
  Loop loop = slot();
  loop[0] = Segment{{-20, -5}, {20 - 3e-4, -5.0002}};
  loop.insert(loop.begin() + 1, Segment{{20 - 3e-4, -5.0002}, {20, -5}});
  const MergedLoop found = merged(loop, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(std::get<Arc>(found.loop[1]).center, Vec2(20, 0));
  EXPECT_EQ(std::get<Arc>(found.loop[1]).radius, 5.0);
  EXPECT_LE(worst_gap(found.loop), 1e-14);
}

TEST(Merged, ClosesACircleThatLacksLessThanTheTolerance) {
  const Arc almost{{0, 0}, 10, 0, 2 * pi - 5e-5};
  const MergedLoop found = merged({almost, Segment{end_of(almost), start_of(almost)}}, 1e-3);
  ASSERT_EQ(found.loop.size(), 1u);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).sweep, 2 * pi);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).radius, 10.0);
}

TEST(Merged, KeepsASliver) {
  EXPECT_EQ(merged(loop_through({{0, 0}, {100, 0}, {100, 5e-4}}), 1e-3).loop.size(), 3u);
}

TEST(Merged, OfNothingIsNothing) { EXPECT_TRUE(merged({}, 1e-3).loop.empty()); }

TEST(Merged, RecognisesSplinesAndJoinsThem) {
  // A circle of radius 8 as four splines.
  Loop loop;
  for (int i = 0; i < 4; ++i) {
    loop.push_back(fit_cubics(ellipse(8, 8), i * pi / 2, (i + 1) * pi / 2, 1e-6).spline);
  }
  const MergedLoop found = merged(loop, 1e-4);
  ASSERT_EQ(found.loop.size(), 1u);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).sweep, 2 * pi);
  EXPECT_NEAR(std::get<Arc>(found.loop[0]).radius, 8, 1e-5);
}

TEST(Merged, ThinsAChainOfShortCurvesWithoutLosingIt) {
  // A circle of radius 1 as 10,000 chords of 0.0006 with a tolerance of 0.001.
  std::vector<Vec2> corners;
  for (int i = 0; i < 10000; ++i) {
    corners.emplace_back(std::cos(2 * pi * i / 10000), std::sin(2 * pi * i / 10000));
  }
  const MergedLoop found = merged(loop_through(corners), 1e-3);
  EXPECT_GE(found.loop.size(), 30u);
  EXPECT_LE(found.loop.size(), 200u);
  EXPECT_NEAR(signed_area(found.loop), pi, 2 * pi * 1e-3);
  EXPECT_EQ(worst_gap(found.loop), 0.0);
}

TEST(Merged, TakesTenThousandCurves) {
  // Fine curves of a big slot: everything joins.
  const MergedLoop found = merged(cut_up(scaled(slot(), 100), 2500), 1e-3);
  EXPECT_EQ(found.loop.size(), 4u);
  // A saw: nothing joins.
  std::vector<Vec2> saw;
  for (int i = 0; i < 10000; ++i)
    saw.emplace_back(i, i % 2);
  saw.emplace_back(5000, 20000);
  EXPECT_EQ(merged(loop_through(saw), 1e-3).loop.size(), saw.size());
}

TEST(Merged, SnapsJointsThatMissEachOther) {
  Loop loop = slot();
  std::get<Segment>(loop[0]).b += Vec2(3e-5, -2e-5);
  std::get<Segment>(loop[2]).a += Vec2(-1e-5, 4e-5);
  const MergedLoop found = merged(loop, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_LE(worst_gap(found.loop), 1e-14 * 50);
  EXPECT_EQ(std::get<Segment>(found.loop[0]).b, start_of(found.loop[1]));
  EXPECT_EQ(std::get<Segment>(found.loop[2]).a, end_of(found.loop[1]));
}

}  // namespace
}  // namespace planish::test
