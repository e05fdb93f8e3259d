#include "fits.hpp"

#include "brake/hemming_tools.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace planish::test {
namespace {

using namespace brake_detail;

/// math.md#tool-fit.
TEST(Fits, WantsASixFoldVForThinSheetAndMoreForThick) {
  EXPECT_DOUBLE_EQ(wanted_opening(1.0), 6.0);
  EXPECT_DOUBLE_EQ(wanted_opening(2.5), 15.0);
  EXPECT_DOUBLE_EQ(wanted_opening(3.0), 24.0);
  EXPECT_DOUBLE_EQ(wanted_opening(8.0), 64.0);
  EXPECT_DOUBLE_EQ(wanted_opening(9.0), 90.0);
}

TEST(Fits, ReckonsForcesAsShopsDo) {
  EXPECT_DOUBLE_EQ(force_per_length(450.0, 2.0, 16.0), 1.42 * 450.0 * 4.0 / 16.0);
  EXPECT_DOUBLE_EQ(closing_force(450.0, 2.0), 4.0 * 1.42 * 450.0 * 4.0 / 12.0);
}

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

/// Any catalogue, without the words: which punches and dies bear a line by what math.md says.
struct Wanted {
  std::vector<int> punches, dies;
};

Wanted by_hand(const BrakeLine& line, const BrakeTools& tools, const PlanOptions& options) {
  const double t = line.bend.thickness;
  const double most = 180.0 - line.angle.degrees() - options.springback.degrees() + 1e-4;
  const auto force = [&](double opening) {
    return 1.42 * options.tensile_strength * t * t / opening;
  };
  const double wanted = options.opening ? *options.opening : t <= 2.5 ? 6 * t : 8 * t;
  Wanted found;
  double opening = 0.0;
  for (const Die& die : tools.dies) {
    if (die.opening == 0.0 || die.angle.degrees() > most) continue;
    if (die.max_force && *die.max_force < force(die.opening)) continue;
    const double away = std::abs(die.opening - wanted), now = std::abs(opening - wanted);
    if (opening == 0.0 || away < now || (away == now && die.opening < opening))
      opening = die.opening;
  }
  for (int i = 0; i < std::ssize(tools.dies); ++i) {
    const Die& die = tools.dies[i];
    if (opening > 0.0 && die.opening == opening && die.angle.degrees() <= most &&
        (!die.max_force || *die.max_force >= force(opening)))
      found.dies.push_back(i);
  }
  for (int i = 0; i < std::ssize(tools.punches); ++i) {
    const Punch& one = tools.punches[i];
    if (one.angle.degrees() <= most && one.tip_radius <= line.inside_radius &&
        (opening == 0.0 || !one.max_force || *one.max_force >= force(opening)))
      found.punches.push_back(i);
  }
  return found;
}

TEST(Fits, TakesTheToolsThatBearALine) {
  std::mt19937 random(9);
  const auto one_of = [&](std::initializer_list<double> values) {
    return *(values.begin() + static_cast<int>(random() % values.size()));
  };
  int whole = 0, partial = 0;
  for (int run = 0; run < 400; ++run) {
    BrakeTools tools = plain_tools();
    tools.punches.clear();
    tools.dies.clear();
    for (int i = 0; i < 4; ++i) {
      PlainPunch upper;
      upper.angle = Angle::degrees(one_of({30, 60, 80, 88}));
      upper.tip_radius = one_of({0.5, 1.0, 2.0});
      tools.punches.push_back(punch(upper));
      if (random() % 3 == 0) tools.punches.back().max_force = one_of({50, 150, 300});
      PlainDie lower;
      lower.opening = one_of({6, 10, 12, 14, 16});
      lower.angle = Angle::degrees(one_of({30, 60, 80, 88}));
      tools.dies.push_back(die(lower));
      if (random() % 3 == 0) tools.dies.back().max_force = one_of({50, 150, 300});
    }
    BrakeLine line;
    line.bend.thickness = one_of({1.0, 2.0, 3.0});
    line.angle = Angle::degrees(one_of({45, 90, 100, 120}));
    line.inside_radius = one_of({0.6, 1.0, 3.0});
    PlanOptions options;
    options.springback = Angle::degrees(one_of({0, 2}));
    if (random() % 2) options.opening = one_of({8, 13, 15});
    const FittingTools told = fitting_tools(line, tools, options);
    const Wanted wanted = by_hand(line, tools, options);
    EXPECT_EQ(told.punches, wanted.punches) << run;
    EXPECT_EQ(told.dies, wanted.dies) << run;
    const bool fits = !wanted.punches.empty() && !wanted.dies.empty();
    EXPECT_EQ(told.why.has_value(), !fits);
    ++(fits ? whole : partial);
  }
  EXPECT_GT(whole, 100);
  EXPECT_GT(partial, 50);
}

/// Only flat tools that bear four times the force of bending close a hem.
TEST(Fits, ClosesHemsWithFlatToolsThatBearIt) {
  BrakeTools tools = hemming_tools();
  BrakeLine closing;
  closing.closes = 0;
  closing.bend.thickness = 1.0;
  EXPECT_EQ(fitting_tools(closing, tools, {}).punches, std::vector<int>{1});
  EXPECT_EQ(fitting_tools(closing, tools, {}).dies, std::vector<int>{1});
  tools.punches[1].max_force = closing_force(450.0, 1.0) + 0.1;
  EXPECT_EQ(fitting_tools(closing, tools, {}).punches, std::vector<int>{1});
  tools.punches[1].max_force = closing_force(450.0, 1.0) - 0.1;
  EXPECT_TRUE(fitting_tools(closing, tools, {}).punches.empty());
  EXPECT_TRUE(fitting_tools(closing, tools, {}).why);
}

}  // namespace
}  // namespace planish::test
