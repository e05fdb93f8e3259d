#include "bend_reasons.hpp"

#include "job/planned_reports.hpp"
#include "proposal_report.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using test::infeasible_report;
using test::planned_report;

TEST(BendReasons, AreWhatBlocksAPlanThatIsNotPossible) {
  EXPECT_TRUE(obstacles_of(planned_report()).empty());
  Report report = infeasible_report();
  report.plan->in_the_way = {BlockedBend{.bend = BendId{0}}};
  ASSERT_EQ(obstacles_of(report).size(), 1u);
  EXPECT_EQ(obstacles_of(report)[0].bend, BendId{1});
  report.plan->blocked.clear();
  ASSERT_EQ(obstacles_of(report).size(), 1u);
  EXPECT_EQ(obstacles_of(report)[0].bend, BendId{0}) << "else what is in the way at last";
  report.plan->status = PlanStatus::gave_up;
  EXPECT_TRUE(obstacles_of(report).empty());
  report.plan.reset();
  EXPECT_TRUE(obstacles_of(report).empty());
}

TEST(BendReasons, StandBelowOneAnotherWithWhatWouldHelp) {
  const Report report = infeasible_report();
  Page page(210, 297);
  write_reasons(page, report, {12, 150}, 285);
  const auto& texts = page.texts();
  ASSERT_EQ(texts.size(), 3u);
  EXPECT_EQ(texts[0].text, blocked_sentence(report.plan->blocked[0], report));
  EXPECT_EQ(texts[0].at, Vec2(12, 150));
  EXPECT_TRUE(texts[2].text.ends_with(proposal_sentence(report.plan->proposals[0], report)));
  for (std::size_t i = 1; i < texts.size(); ++i) {
    EXPECT_EQ(texts[i].at.x(), 12.0);
    EXPECT_GE(texts[i].at.y() - texts[i - 1].at.y(), texts[i].style.size) << "no two overlap";
  }
  Report helpless = report;
  helpless.plan->proposals.clear();
  Page without(210, 297);
  write_reasons(without, helpless, {12, 150}, 285);
  EXPECT_EQ(without.texts().size(), 1u);
}

TEST(BendReasons, EndWhereThePageDoesAndAreWrapped) {
  Report report = infeasible_report();
  report.plan->blocked.assign(40, report.plan->blocked[0]);
  Page page(210, 297);
  write_reasons(page, report, {12, 150}, 200);
  EXPECT_GT(page.texts().size(), 5u);
  for (const Page::Text& text : page.texts())
    EXPECT_LE(text.at.y(), 200.0);
  report.plan->blocked.resize(1);
  report.plan->blocked[0].why = std::string(50, 'a') + " " + std::string(60, 'b');
  Page wrapped(210, 297);
  write_reasons(wrapped, report, {12, 150}, 285);
  EXPECT_EQ(wrapped.texts().size(), 4u) << "one of them on two lines";
}

}  // namespace
}  // namespace planish::job
