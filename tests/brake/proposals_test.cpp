#include "brake/tried_proposals.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using Kind = Proposal::Kind;

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
