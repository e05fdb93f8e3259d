#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <set>

namespace planish::test {
namespace {

/// Up and down in turns: it can be bent from the ends inwards, but 2^40 stages are too many to
/// prove that nothing is cheaper.
TEST(PlanBending, OrdersAStaircaseOfFortyBends) {
  std::vector<StripPart> sections{Straight{30}};
  for (int i = 0; i < 40; ++i) {
    const auto way = i % 2 == 0 ? BendDirection::up : BendDirection::down;
    sections.push_back(Turn{Angle::degrees(90), 2.0, way});
    sections.push_back(Straight{30});
  }
  const Sheet sheet = strip(sections, 80, 1.5);
  const auto flat = flat_sheet(sheet);
  ASSERT_TRUE(flat);
  PlanOptions options;
  options.limits.seconds = 4.0;
  const auto plan = plan_bending(sheet, flat->layout, plain_tools(), options);
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->status == PlanStatus::optimal || plan->status == PlanStatus::feasible);
  std::set<BendId> bent;
  for (const Stroke& stroke : plan->strokes)
    bent.insert(stroke.bends.begin(), stroke.bends.end());
  EXPECT_EQ(bent.size(), 40u);
}

}  // namespace
}  // namespace planish::test
