#include "fits.hpp"

#include "brake/hemming_tools.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace planish::test {
namespace {

using namespace brake_detail;

TEST(Fits, BendsAHemAsFarAsTheSharpestToolsGo) {
  BrakeTools tools = hemming_tools();  // a punch of 28°, a die of 30°
  PlanOptions options;
  options.springback = Angle::degrees(3);
  EXPECT_NEAR(angle_before_closing(tools, options).degrees(), 180.0 - 30.0 - 3.0, 1e-9);
  tools.punches.front().angle = Angle::degrees(40);
  EXPECT_NEAR(angle_before_closing(tools, options).degrees(), 180.0 - 40.0 - 3.0, 1e-9);
  BrakeTools without = tools;
  without.punches.pop_back();
  EXPECT_EQ(angle_before_closing(without, options).radians(), 0.0);
  without = tools;
  without.dies.pop_back();
  EXPECT_EQ(angle_before_closing(without, options).radians(), 0.0);
}

TEST(Fits, GivesWhatIsDrawnSharpTheRadiusOfTheV) {
  PlanOptions options;
  options.radius_of_opening = 0.2;
  EXPECT_NEAR(workpiece_options(2.0, plain_tools(), options).air_radius, 0.2 * 12.0, 1e-12);
  options.opening = 20.0;
  EXPECT_NEAR(workpiece_options(2.0, plain_tools(), options).air_radius, 0.2 * 20.0, 1e-12);
}

/// Any catalogue, without the words: which punches over which dies bend a line by what math.md
/// says, and how many sizes of the catalogue their V is from the wanted one.
std::vector<ToolPair> by_hand(const BrakeLine& line, const BrakeTools& tools,
                              const PlanOptions& options) {
  const double t = line.bend.thickness, rho = options.radius_of_opening;
  const double most = 180.0 - line.angle.degrees() - options.springback.degrees() + 1e-4;
  const auto force = [&](double opening) {
    return 1.42 * options.tensile_strength * t * t / opening;
  };
  const auto bears = [](const auto& tool, double taken) {
    return !tool.max_force || *tool.max_force >= taken;
  };
  const double wanted = options.opening ? *options.opening : t <= 2.5 ? 6 * t : 8 * t;
  std::map<double, bool> sizes;  // and whether a die bears its force
  for (const Die& die : tools.dies)
    if (die.opening > 0.0 && die.angle.degrees() <= most)
      sizes[die.opening] = sizes[die.opening] || bears(die, force(die.opening));
  double nearest = 0.0;
  for (const auto& [size, strong] : sizes)
    if ((strong || options.v == VChoice::any) &&
        (nearest == 0.0 || std::abs(size - wanted) < std::abs(nearest - wanted)))
      nearest = size;
  std::vector<ToolPair> found;
  for (int p = 0; p < std::ssize(tools.punches); ++p)
    for (int d = 0; d < std::ssize(tools.dies); ++d) {
      const Punch& one = tools.punches[p];
      const Die& die = tools.dies[d];
      const double v = die.opening;
      if (!sizes.contains(v) || die.angle.degrees() > most || one.angle.degrees() > most) continue;
      double tip = line.inside_radius, least = 100.0;
      for (const Punch& other : tools.punches)
        if (other.angle.degrees() <= most && bears(other, force(v)))
          least = std::min(least, other.tip_radius);
      if (least > tip) tip = least;
      if (options.v == VChoice::any) tip = std::max(tip, rho * v);
      const bool taken = v == nearest || (options.v == VChoice::any && v >= 4 * t && v <= 12 * t);
      const bool drawn = options.radius == RadiusWanted::drawn;
      const double made = std::max(one.tip_radius, rho * v);
      const bool radius = drawn ? made > line.drawn_radius * 2 / 3 - 1e-6 &&
                                      made < line.drawn_radius * 4 / 3 + 1e-6
                                : one.tip_radius <= tip;
      const bool v_taken = taken || (drawn && options.v == VChoice::any);
      // The shoulder's circle touches the top and the flank; about a tip that is rounder than drawn
      // the sheet has to touch it with its plane sides.
      const double q = die.shoulder_radius,
                   turn = line.angle.radians() + options.springback.radians();
      const double across = 0.5 * v + q / std::tan(std::numbers::pi / 4 + die.angle.radians() / 4);
      if (one.tip_radius > line.inside_radius &&
          (one.tip_radius + t + q) * std::sin(0.5 * turn) > across)
        continue;
      const double whole = force(v) * line.length() / 1000.0;
      if (!v_taken || !radius || !bears(one, force(v)) || !bears(die, force(v)) ||
          whole > tools.machine.force)
        continue;
      int away = 0;
      for (const auto& [size, strong] : sizes)
        away += size > std::min(v, nearest) && size <= std::max(v, nearest);
      found.push_back({p, d, options.v == VChoice::any ? away : 0});
    }
  return found;
}

TEST(Fits, TakesTheToolsThatBendALine) {
  std::mt19937 random(9);
  const auto one_of = [&](std::initializer_list<double> values) {
    return *(values.begin() + static_cast<int>(random() % values.size()));
  };
  std::array<int, 2> whole{}, partial{};
  for (int run = 0; run < 1'200; ++run) {
    BrakeTools tools = plain_tools();
    tools.machine.force = one_of({20, 60, 1000});
    tools.punches.clear();
    tools.dies.clear();
    for (int i = 0; i < 4; ++i) {
      PlainPunch upper;
      upper.angle = Angle::degrees(one_of({30, 60, 80, 88}));
      upper.tip_radius = one_of({0.5, 1.0, 2.0});
      tools.punches.push_back(punch(upper));
      if (random() % 3 == 0) tools.punches.back().max_force = one_of({50, 150, 300});
      PlainDie lower;
      lower.opening = one_of({6, 10, 12, 14, 16, 25});
      lower.angle = Angle::degrees(one_of({30, 60, 80, 88}));
      tools.dies.push_back(die(lower));
      if (random() % 3 == 0) tools.dies.back().max_force = one_of({50, 150, 300});
    }
    BrakeLine line;
    line.pieces = {{0.0, one_of({100, 300})}};
    line.bend.thickness = one_of({1.0, 2.0, 3.0});
    line.angle = Angle::degrees(one_of({45, 90, 100, 120}));
    line.inside_radius = line.drawn_radius = one_of({0.1, 0.6, 1.0, 3.0});
    PlanOptions options;
    options.springback = Angle::degrees(one_of({0, 2}));
    if (random() % 2) options.opening = one_of({8, 13, 15});
    options.v = random() % 2 ? VChoice::any : VChoice::wanted;
    options.radius = random() % 4 ? RadiusWanted::made : RadiusWanted::drawn;
    const FittingTools told = fitting_tools(line, tools, options);
    std::vector<ToolPair> wanted = by_hand(line, tools, options);
    std::ranges::stable_sort(wanted, {}, &ToolPair::v_away);
    EXPECT_EQ(told.pairs, wanted) << run;
    EXPECT_EQ(told.why.has_value(), wanted.empty());
    ++(wanted.empty() ? partial : whole)[options.v == VChoice::any];
  }
  for (const int mode : {0, 1}) {
    EXPECT_GT(whole[mode], 200);
    EXPECT_GT(partial[mode], 50);
  }
}

/// The press on both sides of its force: 100 mm of 2 mm over a V of 12 take 21.3 kN, and over one
/// of 24, the widest that may be taken, 10.65 kN.
TEST(Fits, TakeAWiderVWhereThePressIsWeak) {
  BrakeTools tools = plain_tools();
  tools.dies = {die({12.0, Angle::degrees(80)}), die({24.0, Angle::degrees(80)}),
                die({26.0, Angle::degrees(80)})};
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 2.0;
  const auto fit = [&](double force) {
    tools.machine.force = force;
    return fitting_tools(line, tools, {});
  };
  EXPECT_EQ(fit(21.31).pairs, (std::vector<ToolPair>{{0, 0, 0}, {0, 1, 1}}));
  EXPECT_EQ(fit(21.29).pairs, (std::vector<ToolPair>{{0, 1, 1}}));
  EXPECT_EQ(fit(10.66).pairs, (std::vector<ToolPair>{{0, 1, 1}}));
  const FittingTools unusual = fit(10.64);  // the V of 26 is wider than 12 T, 9.83 kN over it
  EXPECT_TRUE(unusual.pairs.empty());
  EXPECT_EQ(unusual.why->code, "weak_over_usual");
  EXPECT_EQ(unusual.wider, 26.0);
  tools.dies.pop_back();
  const FittingTools none = fit(10.64);
  EXPECT_EQ(none.wider, 0.0);
  EXPECT_TRUE(none.pairs.empty());
  ASSERT_TRUE(none.why);
  EXPECT_EQ(none.why->code, "weak_over_wide");
  ASSERT_EQ(none.why->told.numbers.size(), 4u);
  EXPECT_NEAR(none.why->told.numbers[0].quantity.value, 10.65, 1e-9);
  EXPECT_EQ(none.why->told.numbers[1].quantity.value, 10.64);
  EXPECT_EQ(none.why->told.numbers[2].quantity.value, 24.0);
  EXPECT_EQ(none.why->told.numbers[3].quantity.value, 25.0) << "24 × 10.65 / 10.64";
  EXPECT_EQ(fit(5.3).why->code, "weak_press") << "48.2 mm are more than 24 T: nobody has that";
}

/// Of a line of 700 the tools press 690: 5 mm may be missing at each end, 5 T are 10. Of two pieces
/// each has two ends.
TEST(Fits, TellByHowMuchTheSegmentsAreShort) {
  BrakeTools tools = plain_tools({.segments = {690}}, {.segments = {1000}});
  BrakeLine line;
  line.pieces = {{0.0, 700.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 2.0;
  FittingTools fitting = fitting_tools(line, tools, {});
  ASSERT_TRUE(fitting.why);
  EXPECT_EQ(fitting.why->code, "slightly_short_rows");
  EXPECT_NEAR(fitting.shortfall, 5.0, 1e-9);
  PlanOptions options;
  options.shortfall = fitting.shortfall;
  EXPECT_FALSE(fitting_tools(line, tools, options).pairs.empty());
  line.pieces = {{0.0, 300.0}, {350.0, 750.0}};
  EXPECT_NEAR(fitting_tools(line, tools, {}).shortfall, 2.5, 1e-9);
  tools.punches[0].segments = {650};
  fitting = fitting_tools(line, tools, {});
  EXPECT_EQ(fitting.shortfall, 0.0) << "12.5 at each end";
  EXPECT_EQ(fitting.why->code, "no_tool");
}

/// What tools have to press is the line less a shortfall at each end.
TEST(Fits, NeedAPressAsLongAsTheBend) {
  BrakeTools tools = plain_tools();
  BrakeLine line;
  line.pieces = {{0.0, 300.0}, {350.0, 700.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 2.0;
  PlanOptions options;
  options.shortfall = 5.0;
  tools.machine.length = 690.1;
  EXPECT_FALSE(fitting_tools(line, tools, options).pairs.empty());
  tools.machine.length = 689.9;
  const FittingTools none = fitting_tools(line, tools, options);
  EXPECT_TRUE(none.pairs.empty());
  ASSERT_TRUE(none.why);
  EXPECT_EQ(none.why->code, "short_press");
  EXPECT_NEAR(none.why->told.numbers.at(0).quantity.value, 690.0, 1e-9);
  // The segments press 290 and 340 mm, and need not fill the gap.
  tools.machine.length = 3'000.0;
  tools.punches[0].segments = {300.0, 330.1};
  EXPECT_FALSE(fitting_tools(line, tools, options).pairs.empty());
  tools.punches[0].segments = {300.0, 329.9};
  EXPECT_TRUE(fitting_tools(line, tools, options).pairs.empty());
}

/// A large radius takes any V that leaves it within a third, or a punch of that radius.
TEST(Fits, GivesALargeRadiusTheVThatLeavesIt) {
  BrakeTools tools = plain_tools();
  tools.dies.clear();
  for (const double opening : {12.0, 32.0, 34.0, 50.0, 66.0, 68.0})
    tools.dies.push_back(die({opening, Angle::degrees(80)}));
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.is_large = true;
  line.inside_radius = line.drawn_radius = 8.0;
  // 0.16 V from 5.33 to 10.67: V from 33.3 to 66.7; wanted is 50.
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs,
            (std::vector<ToolPair>{{0, 3, 0}, {0, 2, 1}, {0, 4, 1}}));
  tools.punches[0].tip_radius = 7.0;
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs.size(), 5u);
}

/// A radius below every tip: the smallest, and each that leaves what the V leaves anyway, 0.16 · 6.
TEST(Fits, TakesEachTipThatTheVHidesWhereNoneIsAsSharpAsDrawn) {
  BrakeTools tools = plain_tools();
  tools.dies = {die({6.0, Angle::degrees(80)})};
  const Punch plain = tools.punches.front();
  tools.punches.clear();
  for (const double tip : {0.2, 0.95, 0.97}) {
    tools.punches.push_back(plain);
    tools.punches.back().tip_radius = tip;
  }
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 1.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 0.05;
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs, (std::vector<ToolPair>{{0, 0, 0}, {1, 0, 0}}));
  tools.punches.erase(tools.punches.begin(), tools.punches.begin() + 2);
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs, (std::vector<ToolPair>{{0, 0, 0}}));
}

/// A tip above the drawn radius that is not told beside it, by a tenth or 0.2 T, is as good as one
/// of it; nobody insists on the wanted V's old rule.
TEST(Fits, TakeATipALittleRounderThanDrawn) {
  BrakeTools tools = plain_tools();
  tools.dies = {die({12.0, Angle::degrees(80)})};
  const Punch plain = tools.punches.front();
  tools.punches.clear();
  for (const double tip : {3.0, 5.0, 5.3, 5.31}) {
    tools.punches.push_back(plain);
    tools.punches.back().tip_radius = tip;
  }
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 4.9;
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs,
            (std::vector<ToolPair>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  PlanOptions wanted;
  wanted.v = VChoice::wanted;
  EXPECT_EQ(fitting_tools(line, tools, wanted).pairs, (std::vector<ToolPair>{{0, 0, 0}}));
  line.drawn_radius = line.inside_radius = 3.0;  // a tenth: to 3.3
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs, (std::vector<ToolPair>{{0, 0, 0}}));
}

/// Who insists on the drawn radius hears of it, not of a V that would leave another.
TEST(Fits, TellThatNoStrongToolsLeaveTheDrawnRadius) {
  BrakeTools tools = plain_tools();
  tools.punches[0].tip_radius = 0.6;
  tools.dies = {die({5.0, Angle::degrees(80)}), die({24.0, Angle::degrees(80)})};
  for (Die& one : tools.dies)
    one.max_force = 250.0;
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 3.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 0.6;
  PlanOptions drawn;
  drawn.radius = RadiusWanted::drawn;
  const auto fitting = fitting_tools(line, tools, drawn);
  EXPECT_TRUE(fitting.pairs.empty());
  ASSERT_TRUE(fitting.why);
  EXPECT_EQ(
      fitting.why->told.sentence,
      "no punch and die that leave an inside radius within a third of 0.6 mm and bear 1150 kN/m "
      "over their V of 5 mm: the strongest bear 250 kN/m");
}

/// Bumps: a V of at most four times their pitch, or the narrowest that the thickness takes.
TEST(Fits, GivesBumpsAVThatDoesNotReachTheNext) {
  BrakeTools tools = plain_tools();
  tools.dies.clear();
  for (const double opening : {6.0, 8.0, 10.0, 12.0})
    tools.dies.push_back(die({opening, Angle::degrees(80)}));
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(10);
  line.inside_radius = 2.0;
  line.press_line = 0;
  line.bump_pitch = 2.5;
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs, (std::vector<ToolPair>{{0, 1, 0}, {0, 2, 0}}));
  line.bump_pitch = 1.0;
  EXPECT_EQ(fitting_tools(line, tools, {}).pairs, (std::vector<ToolPair>{{0, 1, 0}}));
}

/// Only flat tools that bear four times the force of bending close a hem.
TEST(Fits, ClosesHemsWithFlatToolsThatBearIt) {
  BrakeTools tools = hemming_tools();
  BrakeLine closing;
  closing.closes = 0;
  closing.bend.thickness = 1.0;
  EXPECT_EQ(fitting_tools(closing, tools, {}).pairs, (std::vector<ToolPair>{{1, 1, 0}}));
  tools.punches[1].max_force = closing_force(450.0, 1.0) + 0.1;
  EXPECT_EQ(fitting_tools(closing, tools, {}).pairs.size(), 1u);
  tools.punches[1].max_force = closing_force(450.0, 1.0) - 0.1;
  EXPECT_TRUE(fitting_tools(closing, tools, {}).pairs.empty());
  const auto why = fitting_tools(closing, tools, {}).why;
  ASSERT_TRUE(why);
  ASSERT_EQ(why->told.numbers.size(), 2u);
  EXPECT_NEAR(why->told.numbers[0].quantity.value, 4.0 * 1.42 * 450.0 / 6.0, 1e-9);
  EXPECT_EQ(why->told.numbers[1].quantity.value, *tools.punches[1].max_force);
  // No wider V helps a hem.
  tools.punches[1].max_force.reset();
  closing.pieces = {{0.0, 100.0}};
  tools.machine.force = 1.0;
  EXPECT_EQ(fitting_tools(closing, tools, {}).why->code, "weak_press_for_hem");
}

/// The force that is needed and the most that any pair bears, by what it lacks: 106.5 kN/m over a V
/// of 24 and 213 over one of 12. Where they are enough over a V of at most 12 T, 24, it is named:
/// 12 * 213 / 120 is 21.3.
TEST(Fits, TellWhatToolsBear) {
  BrakeTools tools = plain_tools();
  tools.dies = {die({12.0, Angle::degrees(80)}), die({24.0, Angle::degrees(80)})};
  tools.dies[0].max_force = 150.0;
  tools.dies[1].max_force = 50.0;
  tools.punches[0].max_force = 120.0;
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 2.0;
  auto why = fitting_tools(line, tools, {}).why;
  ASSERT_TRUE(why);
  ASSERT_EQ(why->told.numbers.size(), 4u);
  EXPECT_NEAR(why->told.numbers[0].quantity.value, 1.42 * 450.0 * 4.0 / 12.0, 1e-9);
  EXPECT_EQ(why->told.numbers[1].quantity.value, 12.0);
  EXPECT_EQ(why->told.numbers[2].quantity.value, 120.0);
  EXPECT_EQ(why->told.numbers[3].quantity.value, 22.0);
  tools.punches[0].max_force = 100.0;  // 25.6
  why = fitting_tools(line, tools, {}).why;
  EXPECT_EQ(why->told.sentence.find("or more"), std::string::npos);
}

/// Over the wanted V alone the press is too weak where a wider one would do.
TEST(Fits, TellOfAWiderVWhereTheWantedOneIsInsistedOn) {
  BrakeTools tools = plain_tools();
  tools.dies = {die({12.0, Angle::degrees(80)}), die({24.0, Angle::degrees(80)})};
  BrakeLine line;
  line.pieces = {{0.0, 100.0}};
  line.bend.thickness = 2.0;
  line.angle = Angle::degrees(90);
  line.inside_radius = line.drawn_radius = 2.0;
  PlanOptions wanted;
  wanted.v = VChoice::wanted;
  tools.machine.force = 15.0;  // 21.3 kN over the V of 12, 10.65 over the V of 24
  EXPECT_EQ(fitting_tools(line, tools, wanted).why->code, "weak_over_wanted");
  tools.dies.pop_back();
  EXPECT_EQ(fitting_tools(line, tools, wanted).why->code, "weak_over_wide");
}

}  // namespace
}  // namespace planish::test
