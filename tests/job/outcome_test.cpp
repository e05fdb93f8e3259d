#include "job/job_requests.hpp"
#include "job/sample_reports.hpp"

#include <planish/brake/codes.hpp>
#include <planish/job/report.hpp>

#include <gtest/gtest.h>

#include <type_traits>

namespace planish::job {
namespace {

using test::refused_report;
using test::sample_report;

// Otherwise a report could come in without its refusal being looked at.
static_assert(!std::is_constructible_v<Outcome<UnfoldReport>, tl::expected<UnfoldReport, Error>>);
static_assert(!std::is_constructible_v<Outcome<UnfoldReport>, tl::in_place_t, UnfoldReport>);

TEST(Outcome, HoldsAReportWithAPattern) {
  const Outcome<UnfoldReport> outcome = sample_report();
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->body, "bracket");
  EXPECT_EQ(shown(outcome)->body, "bracket");
}

TEST(Outcome, IsAnErrorThatShowsARefusedReport) {
  Outcome<UnfoldReport> outcome = refused_report();
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, code::not_a_sheet);
  EXPECT_EQ(outcome.error().where, "body 2");
  ASSERT_TRUE(outcome.error().shown);
  EXPECT_EQ(outcome.error().shown->body, "block");
  const auto written = shown(outcome);
  ASSERT_TRUE(written) << "there is a report to write";
  EXPECT_EQ(written->status(), Status::refused);
  outcome = sample_report();
  EXPECT_TRUE(outcome);
  outcome = refused_report();
  EXPECT_FALSE(outcome) << "also if it held another before";
}

TEST(Outcome, ShowsNothingOfARequestThatFailed) {
  const Outcome<UnfoldReport> outcome = fail(code::cannot_read, "gone", "a.step");
  ASSERT_FALSE(outcome);
  EXPECT_FALSE(outcome.error().shown);
  const auto written = shown(outcome);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, code::cannot_read);
  EXPECT_EQ(written.error().message, "gone");
  EXPECT_EQ(written.error().where, "a.step");
}

TEST(Outcome, LooksIntoWhatWasMade) {
  EXPECT_TRUE(Outcome<std::unique_ptr<Made>>(made_of(sample_report())));
  const Outcome<std::unique_ptr<Made>> outcome = made_of(refused_report());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, code::not_a_sheet);
  ASSERT_TRUE(outcome.error().shown);
  EXPECT_EQ((*outcome.error().shown)->report().body, "block");
}

TEST(Outcome, OfARequestKeepsWhatExplainsTheRefusal) {
  // Its legs are too high for the beam: bending_test.cpp.
  const nlohmann::json request{
      {"maker", "bend"},
      {"input", {{"name", "channel.json"}, {"content", test::channel_plates(250)}}}};
  const auto outcome = make(request.dump());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, code::cannot_bend);
  ASSERT_TRUE(outcome.error().shown);
  EXPECT_TRUE(outcome.error().shown->made->report().plan);
}

}  // namespace
}  // namespace planish::job
