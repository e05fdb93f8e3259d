#include "proposed_tools.hpp"

#include "brake/tried_proposals.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace planish::test {
namespace {

using namespace brake_detail;
using Kind = Proposal::Kind;

constexpr double kUnderLip = 30.0;  // of `lipped_base`, above the base's upper skin

/// A narrower punch of the other catalogue: 5 mm to each side instead of 10 take a leg that is
/// 5 / s longer.
TEST(ProposedTools, NameAPunchThatWouldDo) {
  BrakeTools others = plain_tools();
  for (const double half_width : {9.0, 5.0, 4.0}) {
    PlainPunch plain;
    plain.half_width = half_width;
    others.punches.push_back(punch(plain));
    others.punches.back().id = std::to_string(static_cast<int>(half_width));
  }
  const double leg = longest_leg(10.0) + 5.0;
  const Tried all = tried(channel_of(leg), plain_tools(), {}, &others);
  ASSERT_NE(all.of(Kind::punch), nullptr);
  EXPECT_EQ(all.of(Kind::punch)->tools, std::vector<std::string>{"5"});
  EXPECT_EQ(tried(channel_of(longest_leg(3.0)), plain_tools(), {}, &others).of(Kind::punch),
            nullptr);
}

/// Between walls with lips the shop's own punch needs ears.
TEST(ProposedTools, NameAPunchThatNeedsEars) {
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0}), others = tools;
  others.punches[0].id = "other";
  others.punches[0].ears = Ears{50.0, 50.0, 25.0, 20.0};
  // One with another tip would do as well.
  others.punches.insert(others.punches.begin(), others.punches[0]);
  others.punches[0].tip_radius += 0.1;
  const Tried all = tried(lipped_tray(18.0), tools, {}, &others);
  const Proposal* eared = all.of(Kind::punch);
  ASSERT_NE(eared, nullptr);
  EXPECT_TRUE(eared->ears);
  EXPECT_EQ(eared->tools, std::vector<std::string>{"P"});
}

/// A flange that is too short for the shop's V takes a narrower one of the catalogue.
TEST(ProposedTools, NameADieThatWouldDo) {
  BrakeTools tools = plain_tools(), others = tools;
  tools.dies = plain_dies({16.0}, "V");
  others.dies = plain_dies({20.0, 12.0, 10.0}, "V");
  const double half_zone = 0.25 * std::numbers::pi * (1.0 + 0.44 * 2.0);
  const Sheet sheet = strip({Straight{60}, bent_up(1.0), Straight{7.7 - half_zone}}, 50, 2.0);
  const Tried all = tried(sheet, tools, {}, &others);
  ASSERT_NE(all.of(Kind::die), nullptr);
  EXPECT_EQ(all.of(Kind::die)->tools, std::vector<std::string>{"V12"});
}

/// A flange of x takes a V of at most 2 (x − q) with shoulders of q, here of 1.5.
TEST(ProposedTools, NameTheWidestVForAShortFlange) {
  BrakeTools tools = plain_tools();
  tools.dies = plain_dies({16.0, 12.0, 10.0, 8.0, 6.0}, "V");
  const double half_zone = 0.25 * std::numbers::pi * (1.0 + 0.44 * 2.0);
  const auto proposed = [&](double flange, VChoice v) {
    PlanOptions options;
    options.v = v;
    const Sheet sheet = strip({Straight{60}, bent_up(1.0), Straight{flange - half_zone}}, 50, 2.0);
    const Tried all = tried(sheet, tools, options);
    const Proposal* smaller = all.of(Kind::smaller_v);
    EXPECT_NE(smaller, nullptr);
    return smaller ? std::pair(smaller->opening, smaller->tools)
                   : std::pair<double, std::vector<std::string>>();
  };
  using Named = std::pair<double, std::vector<std::string>>;
  EXPECT_EQ(proposed(7.0, VChoice::wanted), Named(10.0, {"V10"}));
  // From 4 T on the plan itself takes it.
  EXPECT_EQ(proposed(4.7, VChoice::any), Named(6.0, {"V6"}));
}

/// check_test.cpp: a beam at Z above the tip takes legs up to
/// (Z + ε − r (1 − s)) / s − (web + r + T) − r; for legs 25 longer it has to be 25 s higher.
TEST(ProposedTools, TellHowMuchTallerPunchesAre) {
  PlainPunch plain;
  plain.height = 100.0;
  BrakeTools tools = plain_tools(plain);
  tools.machine.upper_beam = {{-200, 100}, {200, 100}, {200, 300}, {-200, 300}};
  const double tip = plain.tip_radius / std::sin(0.5 * plain.angle.radians()) - plain.tip_radius;
  const double web = 90.0, r = 2.0, t = 1.5;
  const double longest = (100.0 - tip + 0.05 - r * (1.0 - kSlope)) / kSlope - (web + r + t) - r;
  const double leg = longest + 25.0;  // 17.7 mm too high
  const Tried all = tried(
      strip({Straight{leg}, bent_up(r), Straight{web}, bent_up(r), Straight{leg}}, 80, t), tools);
  ASSERT_NE(all.of(Kind::taller_punches), nullptr);
  EXPECT_EQ(all.of(Kind::taller_punches)->by, 20.0);
}

/// The foot of an ear goes below a lip, as high as ears_test.cpp tells: told in steps of 5.
TEST(ProposedTools, NameTheHighestFootThatGoesBelowALip) {
  PlanOptions options;
  options.begin_with = {BendId(2), BendId(1), BendId(0)};
  for (const double above : {4.8, 9.8}) {
    BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0});
    tools.punches[0].ears = Ears{50.0, 50.0, kUnderLip + above, 20.0};
    const Tried all = tried(lipped_base(15.0), tools, options);
    ASSERT_NE(all.of(Kind::lower_ears), nullptr) << above;
    EXPECT_EQ(all.of(Kind::lower_ears)->by, kUnderLip);
  }
  EXPECT_EQ(tried(lipped_base(15.0), plain_tools({.half_width = 4.0}, {.half_width = 9.0}), options)
                .of(Kind::lower_ears),
            nullptr);
}

/// A lip of l covers so much of the line's end: so much the punch has to be short of it, to a
/// millimetre, and at most by a sixth of the shortest line, 80.
TEST(ProposedTools, TellByHowMuchThePunchMayBeShort) {
  PlanOptions options;
  options.begin_with = {BendId(2), BendId(1), BendId(0)};
  for (const auto& [lip, by] :
       std::vector<std::pair<double, double>>{{6.5, 7.0}, {6.9, 7.0}, {9.5, 10.0}}) {
    const Tried all = tried(lipped_base(lip), plain_tools({.half_width = 4.0}, {.half_width = 9.0}),
                            options);
    ASSERT_NE(all.of(Kind::short_punch), nullptr) << lip;
    EXPECT_EQ(all.of(Kind::short_punch)->by, by);
  }
  EXPECT_EQ(tried(lipped_base(14.0), plain_tools({.half_width = 4.0}, {.half_width = 9.0}), options)
                .of(Kind::short_punch),
            nullptr);
}

/// A bend does not end well where the punch is short of it by ten thicknesses: that is one way
/// among others, as ears.
TEST(ProposedTools, TellOtherWaysBesideAPunchThatIsFarTooShort) {
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0}), others = tools;
  others.punches[0].ears = Ears{50.0, 50.0, 25.0, 20.0};
  const Tried all = tried(lipped_tray(10.0), tools, {}, &others);
  EXPECT_NE(all.of(Kind::short_punch), nullptr);
  EXPECT_NE(all.of(Kind::punch), nullptr);
}

/// Between the walls of a box a punch in one piece does not stand.
TEST(ProposedTools, NameWhatHasToHaveSegments) {
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0});
  tools.punches[0].segments = {400.0};
  const Tried all = tried(box({70.0, 45.0, 30.0}), tools);
  ASSERT_NE(all.of(Kind::segments), nullptr);
  EXPECT_EQ(all.of(Kind::segments)->tools, std::vector<std::string>{tools.punches[0].id});
  tools.punches = {3, tools.punches[0]};
  for (int i = 0; i < 3; ++i)
    tools.punches[i].id = "P" + std::to_string(i);
  const Tried of_three = tried(box({70.0, 45.0, 30.0}), tools);
  ASSERT_NE(of_three.of(Kind::segments), nullptr);
  EXPECT_EQ(of_three.of(Kind::segments)->tools.size(), 1u) << "nobody buys more than he needs";
}

}  // namespace
}  // namespace planish::test
