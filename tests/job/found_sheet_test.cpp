#include "lay_flat.hpp"
#include "support/folded_box.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

TEST(FoundSheet, IsTheOneThatWasFolded) {
  const auto body = folded_body(test::u_channel(), "channel");
  ASSERT_TRUE(body);
  const auto found = found_sheet(*body);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->sheet.thickness, 1.5, 1e-9);
  EXPECT_EQ(found->sheet.flanges.size(), 3u);
  EXPECT_EQ(found->sheet.bends.size(), 2u);
}

TEST(FoundSheet, IsCutOpenAlongTheEdgesThatItsRefusalNames) {
  const auto body = folded_body(test::folded_box({.length = 80, .width = 50, .height = 25}).sheet,
                                "box");
  ASSERT_TRUE(body);
  const auto closed = found_sheet(*body);
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().code, code::closed_loop);
  std::vector<int> rips;
  for (const Place& place : closed.error().places)
    if (place.kind == PlaceKind::edge) rips.push_back(std::get<int>(place.id));
  ASSERT_FALSE(rips.empty());
  EXPECT_TRUE(found_sheet(*body, {.rip_edges = rips})) << "they do open it";
}

TEST(FoundSheet, LooksForNoRipsOnceItIsCancelled) {
  const auto body = folded_body(test::folded_box({.length = 80, .width = 50, .height = 25}).sheet,
                                "box");
  ASSERT_TRUE(body);
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_FALSE(found_sheet(*body, {}, progress));
}

}  // namespace
}  // namespace planish::job
