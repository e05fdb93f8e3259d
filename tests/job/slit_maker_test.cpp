#include "job/job_requests.hpp"
#include "support/closed_mesh.hpp"

#include <planish/slit/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

json small_chair_file() {
  return json::parse(R"({"thickness": 4,
    "sheet": {"strips": 2, "strip_width": 60, "panel_height": 420, "half_length": 464},
    "leg_curve": {"bezier": [[360, 0], [360, 120]]},
    "seat_curve": {"bezier": [[300, 0], [300, 150]]}})");
}

Request draft_request() {
  Request request;
  request.input = "chair.json";
  request.effort = Effort::draft;
  return request;
}

std::unique_ptr<Made> draft_chair(const json& file = small_chair_file()) {
  return test::made_from("chair.json", file.dump(), draft_request());
}

TEST(SlitMaker, GivesThePageItsCurvesAndRidges) {
  const auto made = draft_chair();
  ASSERT_TRUE(made);
  const json handles = json::parse(made->handles());
  const json& leg = handles["leg_curve"];
  ASSERT_EQ(leg.size(), 65u);
  EXPECT_EQ(leg.front(), json({360.0, 0.0, 0.0})) << "on the ground";
  EXPECT_EQ(leg.back(), json({360.0, 0.0, 120.0}));
  EXPECT_EQ(leg[32], json({360.0, 0.0, 60.0})) << "evenly";
  EXPECT_EQ(handles["seat_curve"].front(), json({0.0, 300.0, 0.0})) << "in the symmetry plane";
  EXPECT_EQ(handles["seat_curve"].back(), json({0.0, 300.0, 150.0}));
  EXPECT_FALSE(handles.contains("second_leg_curve"));
  ASSERT_EQ(handles["ridges"].size(), 2u);
  const auto& strips = static_cast<const Report&>(made->report());
  EXPECT_FALSE(strips.refusal);
  for (const json& strip : handles["ridges"])
    for (const json& ridge : strip) {
      ASSERT_EQ(ridge.size(), 2u);
      double width = 0.0;
      for (int i = 0; i < 3; ++i)
        width += std::pow(ridge[0][i].get<double>() - ridge[1][i].get<double>(), 2);
      EXPECT_GT(width, 59.9 * 59.9) << "at least as long as the strip is wide";
    }
  EXPECT_TRUE(handles["scan"].empty());
}

TEST(SlitMaker, PicksPointsOfScansEvenly) {
  json file = small_chair_file();
  json points = json::array();
  for (int i = 0; i < 10'001; ++i)
    points.push_back({300.0 - 0.01 * i, 420.0, 30.0});
  file["scan"] = {{{"strip", 0}, {"points", points}}};
  const auto made = draft_chair(file);
  ASSERT_TRUE(made);
  const json scan = json::parse(made->handles())["scan"];
  EXPECT_LE(scan.size(), 5000u);
  EXPECT_GT(scan.size(), 2500u);
  EXPECT_EQ(scan[0], json({300.0, 420.0, 30.0}));
  const double step = scan[0][0].get<double>() - scan[1][0].get<double>();
  for (std::size_t i = 2; i < scan.size(); ++i)
    ASSERT_NEAR(scan[i - 1][0].get<double>() - scan[i][0].get<double>(), step, 1e-9);
}

TEST(SlitMaker, LeavesRidgesOutOfTheReportOfADraft) {
  const json draft = json::parse(draft_chair()->json());
  EXPECT_TRUE(draft["slit"]["strips"][0]["ridges"].empty());
  EXPECT_TRUE(draft["flat"]["bends"].empty());
  Request whole;
  const auto made = test::made_from("chair.json", small_chair_file().dump(), whole);
  ASSERT_TRUE(made);
  EXPECT_FALSE(json::parse(made->json())["slit"]["strips"][0]["ridges"].empty());
}

TEST(SlitMaker, MakesTheSheetAndItsMould) {
  const auto made = draft_chair();
  ASSERT_TRUE(made);
  const auto mesh = made->folded_mesh();
  ASSERT_TRUE(mesh);
  EXPECT_FALSE(mesh->triangles.empty());
  const auto mould = made->mould_mesh();
  ASSERT_TRUE(mould) << mould.error().message;
  test::expect_closed(*mould);
  EXPECT_FALSE(made->svg().labels) << "there are too many ridges";
}

TEST(SlitMaker, StartsEachDraftFromTheLast) {
  const auto work = built_in().maker("slit")->open({"chair.json", small_chair_file().dump(), {}},
                                                   {});
  ASSERT_TRUE(work);
  ASSERT_TRUE((*work)->make(draft_request(), {}));
  json moved = small_chair_file();
  moved["seat_curve"]["bezier"] = {{305, 0}, {305, 150}};
  ASSERT_TRUE((*work)->edit({"chair.json", moved.dump(), {}}));
  const auto again = (*work)->make(draft_request(), {});
  ASSERT_TRUE(again);
  EXPECT_EQ(json::parse((*again)->handles())["seat_curve"].front(), json({0.0, 305.0, 0.0}));
  EXPECT_FALSE((*work)->edit({"chair.json", "{", {}}));
}

TEST(SlitMaker, RefusesADraftThatHasNoForm) {
  json file = small_chair_file();
  file["leg_curve"]["bezier"] = {{360, 0}, {360, 50}};
  const auto made = draft_chair(file);
  ASSERT_TRUE(made);
  ASSERT_TRUE(made->report().refusal);
  EXPECT_EQ(made->report().refusal->code, code::curve_too_short);
  EXPECT_EQ(made->report().refusal->where.rfind("chair.json/leg_curve", 0), 0u);
  file = small_chair_file();
  file["anchors"] = {{{"strip", 9}, {"ridge", 1}, {"at", {0, 0, 0}}}};
  const auto work = built_in().maker("slit")->open({"chair.json", file.dump(), {}}, {});
  ASSERT_TRUE(work);
  const auto wrong = (*work)->make(draft_request(), {});
  ASSERT_FALSE(wrong) << "an input that is wrong";
  EXPECT_EQ(wrong.error().where.rfind("chair.json/anchors/0", 0), 0u);
}

}  // namespace
}  // namespace planish::job
