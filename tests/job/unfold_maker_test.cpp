#include "job/job_requests.hpp"
#include "support/closed_mesh.hpp"

#include <planish/job/codes.hpp>
#include <planish/job/unfold.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

std::unique_ptr<Work> opened_bracket() {
  auto work = built_in().maker("unfold")->open(
      {"bracket.step", test::bytes_of_file(test::example("bracket.step")), {}}, {});
  EXPECT_TRUE(work);
  return std::move(*work);
}

Request quick_request() {
  Request request;
  request.input = "shop/bracket.step";
  request.effort = Effort::draft;
  return request;
}

TEST(UnfoldMaker, KeepsTheFileBetweenRequests) {
  const auto work = opened_bracket();
  const auto first = work->make(quick_request(), {});
  ASSERT_TRUE(first);
  const Report& report = (*first)->report();
  EXPECT_EQ(report.input, "shop/bracket.step");
  EXPECT_EQ(report.body, "bracket");
  int stages = 0;
  Progress progress;
  progress.report = [&](std::string_view stage, double) { stages += stage == "finding the sheet"; };
  Request other = quick_request();
  other.allowance = ConstantK{0.3, "x"};
  const auto second = work->make(other, progress);
  ASSERT_TRUE(second);
  EXPECT_EQ(stages, 0) << "the sheet was found before";
  EXPECT_NE((*second)->report().flat.area, report.flat.area);
  EXPECT_TRUE(work->free_spare());
  EXPECT_FALSE(work->free_spare()) << "once";
  EXPECT_TRUE(work->make(quick_request(), {}));
}

TEST(UnfoldMaker, ShowsTheBodyAsAMesh) {
  const auto made = opened_bracket()->make(quick_request(), {});
  ASSERT_TRUE(made);
  const auto mesh = (*made)->folded_mesh();
  ASSERT_TRUE(mesh);
  test::expect_closed(*mesh);
  EXPECT_TRUE((*made)->refused_solid());
  const auto alone = made_of(static_cast<const UnfoldReport&>((*made)->report()));
  EXPECT_FALSE(alone->folded_mesh()) << "a report alone has no body";
  EXPECT_FALSE(alone->refused_solid());
}

TEST(UnfoldMaker, SaysWhatTheFileHolds) {
  const json info = json::parse(opened_bracket()->info({}));
  EXPECT_EQ(info["input"], "bracket.step");
  EXPECT_EQ(info["bodies"].size(), 1u);
}

TEST(UnfoldMaker, RefusesBodiesAndFilesThatAreNotThere) {
  const auto work = opened_bracket();
  Request request = quick_request();
  request.body = "2";
  EXPECT_EQ(work->make(request, {}).error().code, code::no_such_body);
  EXPECT_EQ(work->edit({"a.step", "", {}}).error().code, code::bad_option) << "STEP is not edited";
  EXPECT_FALSE(built_in().maker("unfold")->open({"a.step", "x", {}}, {}));
}

}  // namespace
}  // namespace planish::job
