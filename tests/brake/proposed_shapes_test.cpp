#include "proposed_shapes.hpp"

#include "brake/tried_proposals.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace planish::test {
namespace {

using namespace brake_detail;
using Kind = Proposal::Kind;

/// Only one leg is in the way of the last stroke, so only one has to be shorter, by what it is
/// beyond the limit.
TEST(ProposedShapes, TellByHowMuchALegIsTooLong) {
  for (const double beyond : {0.35, 3.0, 17.85}) {
    const Tried all = tried(channel_of(longest_leg(10.0) + beyond), plain_tools());
    const Proposal* shorter = all.of(Kind::shorter_flange);
    ASSERT_NE(shorter, nullptr) << beyond;
    EXPECT_GT(shorter->by, beyond - 0.01);
    EXPECT_LT(shorter->by, beyond + 0.11);
    ASSERT_EQ(shorter->flanges.size(), 1u);
    EXPECT_NE(shorter->flanges[0], FlangeId(1));
    // One die, one punch that is as wide higher up, no order asked for; nobody cuts it in two.
    EXPECT_EQ(all.proposals.size(), 1u);
  }
}

/// Two flanges of a Z that end x from their lines, where a V of v with shoulders of q takes
/// v / 2 + q: both are to be longer by the difference, to 0.1 mm.
TEST(ProposedShapes, TellByHowMuchFlangesAreTooShort) {
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
TEST(ProposedShapes, TellByHowMuchTheWebOfAZIsTooNarrow) {
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
TEST(ProposedShapes, TellOfShortSidesBehindShortSides) {
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

/// A leg loses at most half of its length: more is another part.
TEST(ProposedShapes, ShortenAFlangeByHalfAtMost) {
  const double longest = longest_leg(10.0);
  for (const double share : {0.4, 0.6}) {
    const double leg = longest / (1.0 - share);
    const Tried all = tried(channel_of(leg), plain_tools());
    const Proposal* shorter = all.of(Kind::shorter_flange);
    EXPECT_EQ(shorter != nullptr, share < 0.5) << leg;
    EXPECT_EQ(all.of(Kind::split) != nullptr, share > 0.5) << "two angles can be bent";
    if (shorter) {
      EXPECT_NEAR(shorter->by, leg - longest, 0.2);
    }
  }
}

}  // namespace
}  // namespace planish::test
