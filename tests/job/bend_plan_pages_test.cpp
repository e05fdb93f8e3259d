#include "job/job_requests.hpp"
#include "plan_report.hpp"

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
  ASSERT_EQ(pages.size(), 2u);
  for (const Stroke& stroke : made->report().plan->strokes)
    for (const Page& page : pages)  // a stroke on each
      EXPECT_TRUE(says(page, "punch " + stroke.punch));
  EXPECT_TRUE(says(pages[0], "Set-up 1 on the bed of 3060 mm"));
  EXPECT_EQ(bend_plan_pages(*made, {}).size(), 2u) << "of its only piece";
}

TEST(BendPlanPages, SayWhatToMeasureAndHowFlangesAreCalled) {
  // Legs of 30 to the middle of the web, 2 thick: 31 outside.
  const auto made = bent_channel(30);
  ASSERT_TRUE(made && made->report().plan);
  const Page page = bend_plan_pages(made->report(), {}).front();
  EXPECT_TRUE(says(page, ": 31.0 mm outside"));
  for (const char* name : {"F1", "F2", "F3"})
    EXPECT_TRUE(says(page, name));
  EXPECT_TRUE(says(page, "front side up"));
  made->report().plan->remarks = {{"rolled", tell("no stroke bends it", {})},
                                  {kFurthestStage, tell("it is in the way", {})}};
  const Page noted = bend_plan_pages(made->report(), {}).back();
  EXPECT_TRUE(says(noted, "No stroke bends it."));
  EXPECT_FALSE(says(noted, "in the way")) << "that is among the reasons";
}

TEST(BendPlanPages, SayWhyThereIsNone) {
  const auto made = bent_channel(250);
  ASSERT_TRUE(made && made->report().plan);
  const auto pages = bend_plan_pages(made->report(), {});
  ASSERT_EQ(pages.size(), 1u);
  for (const BlockedBend& blocked : made->report().plan->blocked)
    EXPECT_TRUE(says(pages[0], bend_id(made->report(), blocked.bend)));
}

TEST(BendPlanPages, ShowThePatternWithoutAPlan) {
  const auto made = test::made_from("channel.json", test::channel_plates(30).dump());
  ASSERT_TRUE(made);
  EXPECT_EQ(bend_plan_pages(made->report(), {}).size(), 1u);
}

TEST(BendPlanPages, SayWhichPartOfWhatMetal) {
  const auto made = test::made_from("shop/channel.json", test::channel_plates(30).dump());
  ASSERT_TRUE(made);
  Report& report = made->report();
  Bending bending;
  EXPECT_TRUE(says(bend_plan_pages(report, bending)[0], "steel 450 N/mm²"));
  EXPECT_FALSE(says(bend_plan_pages(report, bending)[0], "springback")) << "none is none";
  bending.plan.springback = Angle::degrees(1.0);
  EXPECT_TRUE(says(bend_plan_pages(report, bending)[0], "steel 450 N/mm², springback 1°"));
  bending.metal = "stainless";
  bending.plan.tensile_strength = 700;
  bending.plan.springback = Angle::degrees(2.5);
  EXPECT_TRUE(says(bend_plan_pages(report, bending)[0], "stainless 700 N/mm²"));
  EXPECT_TRUE(says(bend_plan_pages(report, bending)[0], "2.5°"));
  const auto title = [&] { return bend_plan_pages(report, bending)[0].texts()[0].text; };
  EXPECT_EQ(title(), "channel") << "the body is called as its file";
  report.body = "left wall";
  EXPECT_EQ(title(), "channel · left wall");
  for (const char* body : {"", "SOLID", "Solid1", "Channel"}) {
    report.body = body;
    EXPECT_EQ(title(), "channel") << body;
  }
}

TEST(BendPlanPages, AreThoseOfAllPieces) {
  const auto made = test::made_in_two_pieces();
  ASSERT_TRUE(made);
  EXPECT_EQ(bend_plan_pages(*made, {}).size(), 2u);
}

}  // namespace
}  // namespace planish::job
