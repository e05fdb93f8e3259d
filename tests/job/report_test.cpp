#include "job/sample_reports.hpp"

#include <planish/job/unfold.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using test::sample_report;

TEST(UnfoldReport, HasAStatusByItsWorstFinding) {
  UnfoldReport report = sample_report();
  report.findings = {{"k_range", Severity::info, "noted", {}}};
  EXPECT_EQ(report.status(), Status::ok);
  report.findings.push_back({"flange_height", Severity::warning, "too low", {}});
  EXPECT_EQ(report.status(), Status::warning);
  report.refusal = Error{code::overlap, "covers itself", ""};
  EXPECT_EQ(report.status(), Status::refused);
}

}  // namespace
}  // namespace planish::job
