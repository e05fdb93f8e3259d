#include "large_radius.hpp"

#include "brake/stroke_room.hpp"

#include <planish/brake/proposals.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kPi = std::numbers::pi;

/// n pieces of an arc of radius R leave R (1 − cos(α/2n)): as few as the error allows, on both
/// sides of it, at the pitch BA/n.
TEST(LargeRadius, TakesAsFewBumpsAsTheChordErrorAllows) {
  for (const double radius : {15.0, 30.0, 80.0})
    for (const int bumps : {2, 3, 5, 9}) {
      const double error = radius * (1.0 - std::cos(kPi / 2.0 / (2.0 * bumps)));
      const double allowance = kPi / 2.0 * (radius + 0.44);
      const Angle angle = Angle::degrees(90);
      const LargeBend at = bumps_of(angle, radius, allowance, 1.0, error * 1.0001);
      EXPECT_EQ(at.bumps, bumps);
      EXPECT_NEAR(at.chord_error, error, 1e-9);
      EXPECT_NEAR(at.pitch, allowance / bumps, 1e-9);
      EXPECT_NEAR(at.angle.degrees(), 90.0 / bumps, 1e-9);
      EXPECT_EQ(bumps_of(angle, radius, allowance, 1.0, error * 0.9999).bumps, bumps + 1);
    }
}

/// No closer than one thickness, and never one alone.
TEST(LargeRadius, LeavesAThicknessBetweenBumps) {
  const double allowance = kPi / 2.0 * 10.0;
  EXPECT_EQ(bumps_of(Angle::degrees(90), 9.5, allowance, 2.0, 1e-6).bumps, 7);
  EXPECT_EQ(bumps_of(Angle::degrees(90), 9.5, allowance, 2.0, 100.0).bumps, 2);
}

Sheet bent_by(double radius, double flange = 80.0) {
  return strip(
      {Straight{flange}, Turn{Angle::degrees(90), radius, BendDirection::up}, Straight{flange}}, 50,
      2.0);
}

std::vector<LargeBend> of(const Sheet& sheet, const BrakeTools& tools,
                          const PlanOptions& options = {}) {
  return large_bends(sheet, flat_sheet(sheet)->layout, tools, options);
}

/// Steel of 2 mm: a V of 24 leaves 3.84, which meets 5.76 within a third.
TEST(LargeRadius, BeginsWhereNoUsualVLeavesIt) {
  EXPECT_TRUE(of(bent_by(5.75), plain_tools()).empty());
  ASSERT_EQ(of(bent_by(5.77), plain_tools()).size(), 1u);
  PlanOptions wanted;
  wanted.v = VChoice::wanted;
  EXPECT_TRUE(of(bent_by(19.9), plain_tools(), wanted).empty());
  EXPECT_EQ(of(bent_by(20.1), plain_tools(), wanted).size(), 1u);
}

/// Over a V of the shop, else by bumps, or as it is asked for; what takes too many bumps is rolled.
TEST(LargeRadius, IsFormedOverAVOrByBumps) {
  BrakeTools tools = plain_tools();
  const Sheet sheet = bent_by(8.0);
  EXPECT_EQ(of(sheet, tools).front().forming, Forming::bumps);
  tools.dies.push_back(die({50.0, Angle::degrees(80), 1.0, 40.0}));
  EXPECT_EQ(of(sheet, tools).front().forming, Forming::over_v);
  PlanOptions options;
  for (const Forming forming : {Forming::over_v, Forming::bumps, Forming::rolled}) {
    options.large_radii = forming;
    EXPECT_EQ(of(sheet, tools, options).front().forming, forming);
  }
  // 60 bumps of 1.5° each leave an error of 1e-4 R.
  EXPECT_EQ(of(bent_by(2300.0), plain_tools()).front().forming, Forming::bumps);
  EXPECT_EQ(of(bent_by(2400.0), plain_tools()).front().forming, Forming::rolled);
}

/// A bend of 170° and more is a hem only if its radius is not large.
TEST(LargeRadius, IsNoHem) {
  for (const double degrees : {170.5, 180.0, 200.0})
    for (const double radius : {1.0, 5.7, 6.0, 25.0}) {
      const Sheet sheet = strip({Straight{80}, Turn{Angle::degrees(degrees), radius}, Straight{80}},
                                50, 2.0);
      const auto large = of(sheet, plain_tools());
      ASSERT_EQ(large.size(), radius < 5.76 ? 0u : 1u) << radius;
      PlanOptions options;
      for (const Forming forming : {Forming::bumps, Forming::rolled}) {
        options.large_radii = forming;
        if (!large.empty()) {
          EXPECT_EQ(of(sheet, plain_tools(), options)[0].forming, forming);
        }
      }
      if (large.empty()) continue;
      const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, plain_tools(), options);
      ASSERT_TRUE(plan) << plan.error().message;
      EXPECT_EQ(plan->status, PlanStatus::optimal);
    }
}

/// The plan of 30 mm in 2 mm: 5 bumps of 18°, one after the other, from an end to the other.
TEST(LargeRadius, IsPlannedBumpByBump) {
  PlanOptions options;
  options.chord_error = 0.4;
  const Sheet sheet = bent_by(30.0);
  const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, plain_tools(), options);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->status, PlanStatus::optimal);
  ASSERT_EQ(plan->strokes.size(), 5u);
  const int step = *plan->strokes[1].press_line - *plan->strokes[0].press_line;
  EXPECT_EQ(std::abs(step), 1);
  for (std::size_t i = 0; i < 5; ++i) {
    const Stroke& stroke = plan->strokes[i];
    EXPECT_NEAR(stroke.angle.degrees(), 18.0, 1e-9);
    EXPECT_EQ(*stroke.press_line, *plan->strokes[0].press_line + static_cast<int>(i) * step);
    EXPECT_EQ(stroke.radius_drawn, 30.0);
    EXPECT_NEAR(stroke.radius_made, 0.16 * 12.0, 1e-9);
  }
  ASSERT_EQ(plan->large.size(), 1u);
  EXPECT_EQ(plan->large[0].bumps, 5);
}

/// The bump beside an end 2.5 from the bend, 5.5 from its line, goes over the V of 8 only. It takes
/// them all, rather than a second set-up; where the end is far away, all go over the V of 12.
TEST(LargeRadius, IsBumpedOverOneV) {
  BrakeTools tools = plain_tools();
  tools.dies.push_back(die({8.0, Angle::degrees(80)}));
  tools.dies.back().id = "V8";
  PlanOptions options;
  options.chord_error = 0.145;
  for (const double side : {2.5, 80.0}) {
    const Sheet sheet = strip(
        {Straight{80.0}, Turn{Angle::degrees(90), 30.0, BendDirection::up}, Straight{side}}, 50,
        2.0);
    const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, tools, options);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->status, PlanStatus::optimal);
    ASSERT_EQ(plan->strokes.size(), 8u);
    EXPECT_EQ(plan->tool_changes, 0);
    const std::string die = side < 80.0 ? "V8" : tools.dies.front().id;
    EXPECT_TRUE(std::ranges::all_of(plan->strokes, [&](const Stroke& s) { return s.die == die; }));
  }
}

/// A V of 50 needs a side of 25 mm and its shoulder: beside shorter ones the bend is bumped, and
/// rolled where not even bumps have room.
TEST(LargeRadius, IsBumpedOrRolledWhereSidesAreShort) {
  BrakeTools tools = plain_tools({.half_width = 4.0});
  tools.dies.push_back(die({50.0, Angle::degrees(80), 1.0, 40.0}));
  tools.dies.back().id = "V50";
  const auto formed = [&](double flange) {
    const Sheet sheet = bent_by(8.0, flange);
    const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, tools);
    EXPECT_TRUE(plan);
    return plan ? plan->large.at(0).forming : Forming::over_v;
  };
  EXPECT_EQ(formed(80.0), Forming::over_v);
  EXPECT_EQ(formed(12.0), Forming::bumps);
  EXPECT_EQ(formed(1.0), Forming::rolled);
}

/// Of 4 bumps the third is pressed last, from one end two are formed and from the other one. The
/// side of the two then leans by 56.25°. It begins between where sharp bumps would have it, on
/// pieces p = BA/4 long with slopes of 11.25° and 33.75° and its inside K T before that, and where
/// the drawn arc ends. The wedge of a punch 2 b wide ends b / tan 40° high: so far the first is
/// away at b = 17.2, the second at b = 21. Wider punches leave rolling only, which the plan
/// proposes if it is asked for bumps.
TEST(LargeRadius, IsRolledWhereTheOtherSideRunsIntoThePunch) {
  const Sheet sheet = bent_by(8.0, 30.0);
  const Layout layout = flat_sheet(sheet)->layout;
  const double bump = kPi / 8.0, leans = 2.5 * bump, pitch = kPi / 2.0 * (8.0 + 0.44 * 2.0) / 4.0;
  Vec2 sharp = 0.44 * 2.0 * Vec2(-std::sin(leans), std::cos(leans));
  for (const double slope : {0.5 * bump, 1.5 * bump})
    sharp += pitch * Vec2(std::cos(slope), std::sin(slope));
  const Vec2 round = 8.0 * Vec2(std::sin(leans), 1.0 - std::cos(leans));
  const auto limit = [&](const Vec2& from) {
    const double slope = std::tan(leans), wedge = 1.0 / std::tan(kPi * 40.0 / 180.0);
    return (from.x() - from.y() / slope) / (1.0 - wedge / slope);
  };
  for (const bool is_wide : {false, true}) {
    constexpr double kMargin = 0.2;
    const BrakeTools tools = plain_tools(
        {.half_width = is_wide ? limit(round) + kMargin : limit(sharp) - kMargin});
    PlanOptions options;
    const auto plan = plan_bending(sheet, layout, tools, options);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->status, PlanStatus::optimal);
    EXPECT_EQ(plan->large.at(0).forming, is_wide ? Forming::rolled : Forming::bumps);
    EXPECT_EQ(plan->strokes.empty(), is_wide);
    EXPECT_EQ(plan->remarks.at(0).code, is_wide ? "rolled" : "bumped");
    options.large_radii = Forming::bumps;
    const auto asked = plan_bending(sheet, layout, tools, options);
    ASSERT_TRUE(asked) << asked.error().message;
    EXPECT_EQ(asked->status, is_wide ? PlanStatus::infeasible : PlanStatus::optimal);
    if (!is_wide) continue;
    const auto helps = proposals(sheet, layout, tools, options, *asked);
    ASSERT_FALSE(helps.empty());
    EXPECT_EQ(helps[0].kind, Proposal::Kind::rolled);
    EXPECT_EQ(helps[0].bends, std::vector{BendId(0)});
  }
}

/// A U of 180° is closed from both ends: its sides stand 2 R apart when the bump in the middle is
/// pressed, so that a punch between them may be as wide. From one end the other side would lie over
/// the last bump, whatever punch there is.
TEST(LargeRadius, AHalfTurnIsBumpedByAPunchBetweenItsSides) {
  for (const double radius : {6.0, 25.0}) {
    const Sheet sheet = strip({Straight{80}, Turn{Angle::degrees(180), radius}, Straight{80}}, 50,
                              2.0);
    for (const double half_width : {radius - 1.0, radius + 1.0}) {
      const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout,
                                     plain_tools({.half_width = half_width}));
      ASSERT_TRUE(plan) << plan.error().message;
      EXPECT_EQ(plan->status, PlanStatus::optimal);
      EXPECT_EQ(plan->large.at(0).forming, half_width < radius ? Forming::bumps : Forming::rolled)
          << radius;
    }
  }
}

/// First the bends that no order forms; where it leaves others only, all.
TEST(LargeRadius, TakesTheNextWayOfWhatIsLeft) {
  const Turn turn{Angle::degrees(90), 8.0, BendDirection::up},
      small{Angle::degrees(90), 2.0, BendDirection::up};
  const Sheet sheet = strip(
      {Straight{80}, turn, Straight{80}, turn, Straight{80}, small, Straight{80}}, 50, 2.0);
  const Layout layout = flat_sheet(sheet)->layout;
  const std::vector<LargeBend> bumped = large_bends(sheet, layout, plain_tools(), {});
  const auto next = [&](std::vector<LargeBend> large, const std::vector<BendId>& left) {
    EXPECT_TRUE(take_next(large, left, sheet, layout, {}));
    return mapped(large, &LargeBend::forming);
  };
  using Ways = std::vector<Forming>;
  EXPECT_EQ(next(bumped, {BendId(1)}), (Ways{Forming::bumps, Forming::rolled}));
  EXPECT_EQ(next(bumped, {BendId(2)}), (Ways{Forming::rolled, Forming::rolled}));
  EXPECT_EQ(next({{BendId(0)}, {BendId(1)}}, {BendId(0), BendId(2)}),
            (Ways{Forming::bumps, Forming::over_v}));
  std::vector<LargeBend> rolled{{BendId(0), Forming::rolled}};
  EXPECT_FALSE(take_next(rolled, {BendId(0)}, sheet, layout, {}));
}

}  // namespace
}  // namespace planish::test
