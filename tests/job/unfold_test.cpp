#include "job/job_requests.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/codes.hpp>
#include <planish/job/unfold.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

Request of_bracket() {
  Request request;
  request.input = test::example("bracket.step");
  request.effort = Effort::draft;
  return request;
}

TEST(Unfold, ReadsAndUnfoldsTheOnlyBody) {
  Request request = of_bracket();
  request.units = LengthUnit::inch;
  const auto report = unfold(request);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->input, request.input.string());
  EXPECT_EQ(report->number, 1);
  EXPECT_EQ(report->bodies_in_file, 1);
  EXPECT_EQ(report->units, LengthUnit::inch);
  EXPECT_GT(report->read_seconds, 0.0);
  EXPECT_EQ(report->flat.bends.size(), 2u);
}

TEST(Unfold, HandsOnWhatIsWrongWithTheRequest) {
  Request request = of_bracket();
  request.body = "7";
  EXPECT_EQ(unfold(request).error().code, code::no_such_body);
  request = of_bracket();
  request.root = "99";
  EXPECT_EQ(unfold(request).error().code, code::no_such_face);
  request.input = "/no/such.step";
  EXPECT_EQ(unfold(request).error().code, code::cannot_read);
  EXPECT_EQ(unfold_all(request).error().code, code::cannot_read);
}

TEST(UnfoldAll, ReportsEachBodyAndGoesOn) {
  Request request = of_bracket();
  std::vector<int> begun;
  std::vector<double> shares;
  AllBodies all;
  all.begins = [&](int body) { begun.push_back(body); };
  Progress progress;
  progress.report = [&](std::string_view, double share) { shares.push_back(share); };
  auto bodies = unfold_all(request, progress, all);
  ASSERT_TRUE(bodies);
  ASSERT_EQ(bodies->size(), 1u);
  EXPECT_EQ(begun, std::vector<int>{0});
  ASSERT_TRUE((*bodies)[0]);
  EXPECT_EQ((*bodies)[0]->number, 1);
  EXPECT_EQ((*bodies)[0]->input, request.input.string());
  for (std::size_t i = 1; i < shares.size(); ++i)
    EXPECT_GE(shares[i], shares[i - 1]) << "progress only grows";
  EXPECT_LE(shares.back(), 1.0);
  all.given_up = {{0, {code::out_of_time, "too long", ""}}};
  bodies = unfold_all(request, {}, all);
  ASSERT_TRUE(bodies);
  ASSERT_FALSE((*bodies)[0]);
  EXPECT_EQ((*bodies)[0].error().code, code::out_of_time);
  ASSERT_TRUE((*bodies)[0].error().shown);
  EXPECT_EQ((*bodies)[0].error().shown->body, "bracket");
  all.wanted = [](int) { return false; };
  EXPECT_TRUE(unfold_all(request, {}, all)->empty());
}

TEST(UnfoldAll, StopsWhenAsked) {
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_EQ(unfold_all(of_bracket(), progress).error().code, code::cancelled);
}

TEST(FailedUnfold, RepeatsTheRequest) {
  Request request = of_bracket();
  request.body = "door";
  UnfoldReport report = failed_unfold(request, {code::cannot_read, "m", "w"});
  EXPECT_EQ(report.input, request.input.string());
  EXPECT_EQ(report.body, "door");
  EXPECT_EQ(report.units, LengthUnit::mm);
  EXPECT_EQ(report.refusal->where, "w");
  request.units = LengthUnit::m;
  EXPECT_EQ(failed_unfold(request, {}).units, LengthUnit::m);
}

}  // namespace
}  // namespace planish::job
