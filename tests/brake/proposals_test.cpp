#include "brake/stroke_room.hpp"

#include <planish/brake/proposals.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using Kind = Proposal::Kind;

const double kSlope = std::numbers::sqrt2 / 2.0;  // of both sides at 90°

Turn bent_up(double radius = 2.0) { return {Angle::degrees(90), radius, BendDirection::up}; }

struct Tried {
  Plan plan;
  std::vector<Proposal> proposals;
  const Proposal* of(Kind kind) const {
    const auto found = std::ranges::find(proposals, kind, &Proposal::kind);
    return found == proposals.end() ? nullptr : &*found;
  }
};

Tried tried(const Sheet& sheet, const BrakeTools& tools, const PlanOptions& options = {},
            const BrakeTools* others = nullptr) {
  const auto flat = flat_sheet(sheet);
  EXPECT_TRUE(flat);
  auto plan = plan_bending(sheet, flat->layout, tools, options);
  EXPECT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->status, PlanStatus::infeasible);
  const ProposalOptions trying{.others = others, .checks = 1'000'000};
  return {*plan, proposals(sheet, flat->layout, tools, options, *plan, trying)};
}

/// Two legs of the same length on a web of 60.
Sheet channel_of(double leg) {
  return strip({Straight{leg}, bent_up(), Straight{60}, bent_up(), Straight{leg}}, 80, 1.5);
}

/// check_test.cpp: a punch 2 b wide closes a channel whose first leg is at most
/// web + r − (b − ε) / s long.
double longest_leg(double half_width) { return 60.0 + 2.0 - (half_width - 0.05) / kSlope; }

/// Only one leg is in the way of the last stroke, so only one has to be shorter, by what it is
/// beyond the limit.
TEST(Proposals, TellByHowMuchALegIsTooLong) {
  for (const double beyond : {0.35, 3.0, 17.85}) {
    const Tried all = tried(channel_of(longest_leg(10.0) + beyond), plain_tools());
    const Proposal* shorter = all.of(Kind::shorter_flange);
    ASSERT_NE(shorter, nullptr) << beyond;
    EXPECT_GT(shorter->by, beyond - 0.01);
    EXPECT_LT(shorter->by, beyond + 0.11);
    ASSERT_EQ(shorter->flanges.size(), 1u);
    EXPECT_NE(shorter->flanges[0], FlangeId(1));
    // Two angles can be bent.
    const Proposal* split = all.of(Kind::split);
    ASSERT_NE(split, nullptr);
    EXPECT_EQ(split->bends.size(), 1u);
    // One die, one punch that is as wide higher up, no order asked for.
    EXPECT_EQ(all.proposals.size(), 2u);
  }
}

/// A narrower punch of the other catalogue: 5 mm to each side instead of 10 take a leg that is
/// 5 / s longer.
TEST(Proposals, NameAPunchThatWouldDo) {
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

/// Between walls with a lip the shop's own punch needs ears.
TEST(Proposals, NameAPunchThatNeedsEars) {
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0}), others = tools;
  others.punches[0].id = "other";
  others.punches[0].ears = Ears{50.0, 50.0, 25.0, 20.0};
  PlanOptions options;
  options.begin_with = {BendId(2), BendId(1), BendId(0)};
  const Tried all = tried(lipped_base(15.0), tools, options, &others);
  const Proposal* eared = all.of(Kind::punch);
  ASSERT_NE(eared, nullptr);
  EXPECT_TRUE(eared->ears);
  EXPECT_EQ(eared->tools, std::vector<std::string>{"P"});
}

/// A flange of x takes a V of at most 2 (x − q) with shoulders of q, here of 1.5.
TEST(Proposals, NameTheWidestVForAShortFlange) {
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

/// Two flanges of a Z that end x from their lines, where a V of v with shoulders of q takes
/// v / 2 + q: both are to be longer by the difference, to 0.1 mm.
TEST(Proposals, TellByHowMuchFlangesAreTooShort) {
  BrakeTools tools = plain_tools();
  tools.dies = plain_dies({12.0});
  const double half_zone = 0.25 * std::numbers::pi * (1.0 + 0.44 * 2.0);
  const Turn up{Angle::degrees(90), 1.0, BendDirection::up},
      down{Angle::degrees(90), 1.0, BendDirection::down};
  for (const double lacks : {0.15, 2.0, 4.95}) {
    const double leg = 6.0 + 1.5 - lacks - half_zone;
    const Tried all = tried(strip({Straight{leg}, up, Straight{60}, down, Straight{leg}}, 50, 2.0),
                            tools);
    const Proposal* longer = all.of(Kind::longer_flanges);
    ASSERT_NE(longer, nullptr) << lacks;
    EXPECT_EQ(longer->flanges, (std::vector<FlangeId>{FlangeId(0), FlangeId(2)}));
    EXPECT_GT(longer->by, lacks - 0.01);
    EXPECT_LT(longer->by, lacks + 0.11);
  }
}

/// The web of a Z is to be wider by as much as a Z that can be bent is: found by bending such ones.
TEST(Proposals, TellByHowMuchTheWebOfAZIsTooNarrow) {
  const BrakeTools tools = plain_tools();
  const auto z = [](double web) {
    const Turn up{Angle::degrees(90), 1.0, BendDirection::up},
        down{Angle::degrees(90), 1.0, BendDirection::down};
    return strip({Straight{60}, up, Straight{web}, down, Straight{60}}, 50, 2.0);
  };
  const auto is_bent = [&](double web) {
    const Sheet sheet = z(web);
    const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, tools);
    return plan && plan->status == PlanStatus::optimal;
  };
  double narrow = 2.0, wide = 60.0;
  ASSERT_TRUE(!is_bent(narrow) && is_bent(wide));
  while (wide - narrow > 1e-3) {
    const double middle = 0.5 * (narrow + wide);
    (is_bent(middle) ? wide : narrow) = middle;
  }
  for (const double lacks : {0.15, 2.05, 5.95}) {
    const Tried all = tried(z(wide - lacks), tools);
    const Proposal* longer = all.of(Kind::longer_flanges);
    ASSERT_NE(longer, nullptr) << lacks;
    EXPECT_EQ(longer->flanges, std::vector<FlangeId>{FlangeId(1)});
    EXPECT_GT(longer->by, lacks - 0.01);
    EXPECT_LT(longer->by, lacks + 0.11);
  }
}

/// Both sides of a bend, of which the first to be told hides the other.
TEST(Proposals, TellOfShortSidesBehindShortSides) {
  BrakeTools tools = plain_tools();
  tools.dies = plain_dies({12.0});
  const double half_zone = 0.25 * std::numbers::pi * (1.0 + 0.44 * 2.0);
  const auto side = [&](double lacks) { return Straight{6.0 + 1.5 - lacks - half_zone}; };
  const Turn up{Angle::degrees(90), 1.0, BendDirection::up};
  const auto expect = [&](const Sheet& sheet, const std::vector<FlangeId>& flanges, double by) {
    const Tried all = tried(sheet, tools);
    const Proposal* longer = all.of(Kind::longer_flanges);
    ASSERT_NE(longer, nullptr);
    EXPECT_EQ(longer->flanges, flanges);
    EXPECT_GT(longer->by, by - 0.01);
    EXPECT_LT(longer->by, by + 0.11);
  };
  expect(strip({side(1.15), up, side(2.25)}, 50, 2.0), {FlangeId(0), FlangeId(1)}, 2.25);
  expect(strip({side(2.25), up, side(1.15)}, 50, 2.0), {FlangeId(0), FlangeId(1)}, 2.25);
}

/// check_test.cpp: a beam at Z above the tip takes legs up to
/// (Z + ε − r (1 − s)) / s − (web + r + T) − r; for legs 25 longer it has to be 25 s higher.
TEST(Proposals, TellHowMuchTallerPunchesAre) {
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

/// A leg loses at most half of its length: more is another part.
TEST(Proposals, ShortenAFlangeByHalfAtMost) {
  const double longest = longest_leg(10.0);
  for (const double share : {0.4, 0.6}) {
    const double leg = longest / (1.0 - share);
    const Tried all = tried(channel_of(leg), plain_tools());
    const Proposal* shorter = all.of(Kind::shorter_flange);
    EXPECT_EQ(shorter != nullptr, share < 0.5) << leg;
    if (shorter) {
      EXPECT_NEAR(shorter->by, leg - longest, 0.2);
    }
  }
}

/// A U whose first leg only closes if it is bent last.
TEST(Proposals, NameBendsToSwap) {
  const Sheet sheet = strip(
      {Straight{longest_leg(10.0) + 5.0}, bent_up(), Straight{60}, bent_up(), Straight{30}}, 80,
      1.5);
  PlanOptions options;
  options.begin_with = {BendId(0), BendId(1)};
  const Tried both = tried(sheet, plain_tools(), options);
  ASSERT_NE(both.of(Kind::swap), nullptr);
  EXPECT_EQ(both.of(Kind::swap)->bends, (std::vector<BendId>{BendId(0), BendId(1)}));
  EXPECT_EQ(both.of(Kind::any_order), nullptr);  // a swap says more
  options.begin_with = {BendId(0)};
  const Tried one = tried(sheet, plain_tools(), options);
  EXPECT_EQ(one.of(Kind::swap), nullptr);
  EXPECT_NE(one.of(Kind::any_order), nullptr);
}

TEST(Proposals, TakeNoTimeThatTheyAreNotGiven) {
  const Sheet sheet = channel_of(longest_leg(10.0) + 3.0);
  const auto flat = flat_sheet(sheet);
  const auto plan = plan_bending(sheet, flat->layout, plain_tools());
  ASSERT_TRUE(plan);
  EXPECT_TRUE(proposals(sheet, flat->layout, plain_tools(), {}, *plan, {.checks = 0}).empty());
}

}  // namespace
}  // namespace planish::test
