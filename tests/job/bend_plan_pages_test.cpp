#include "job/job_requests.hpp"

#include <planish/job/bend_plan_pages.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

std::unique_ptr<Made> bent_channel(double leg) {
  Request request;
  request.bending.ask = Bending::Ask::plan;
  return test::made_from("channel.json", test::channel_plates(leg).dump(), request);
}

bool says(const Page& page, const std::string& text) {
  for (const Page::Text& one : page.texts())
    if (one.text.find(text) != std::string::npos) return true;
  return false;
}

TEST(BendPlanPages, DrawEachStrokeOfAPlan) {
  const auto made = bent_channel(30);
  ASSERT_TRUE(made && made->report().plan);
  const auto pages = bend_plan_pages(made->report(), {});
  ASSERT_EQ(pages.size(), 1u);
  for (const Stroke& stroke : made->report().plan->strokes)
    EXPECT_TRUE(says(pages[0], "punch " + stroke.punch));
  EXPECT_EQ(bend_plan_pages(*made, {}).size(), 1u) << "of its only piece";
}

TEST(BendPlanPages, SayWhyThereIsNone) {
  const auto made = bent_channel(250);
  ASSERT_TRUE(made && made->report().plan);
  const auto pages = bend_plan_pages(made->report(), {});
  ASSERT_EQ(pages.size(), 1u);
  EXPECT_TRUE(says(pages[0], "B1") || says(pages[0], "B2"));
}

TEST(BendPlanPages, ShowThePatternWithoutAPlan) {
  const auto made = test::made_from("channel.json", test::channel_plates(30).dump());
  ASSERT_TRUE(made);
  EXPECT_EQ(bend_plan_pages(made->report(), {}).size(), 1u);
}

TEST(BendPlanPages, AreThoseOfAllPieces) {
  Request request;
  request.effort = Effort::draft;
  auto net = nlohmann::json::parse(
      test::bytes_of_file(test::example("transition/a_square_to_round.json")));
  net["pieces"] = 2;
  const auto made = test::made_from("net.json", net.dump(), request);
  ASSERT_TRUE(made);
  EXPECT_EQ(bend_plan_pages(*made, {}).size(), 2u);
}

}  // namespace
}  // namespace planish::job
