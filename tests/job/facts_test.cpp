#include "facts.hpp"

#include "job/sample_reports.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planish::job {
namespace {

TEST(Facts, SpellSeverityAndStatusAsTheFormatsPage) {
  EXPECT_EQ(severity_name(Severity::info), "info");
  EXPECT_EQ(severity_name(Severity::warning), "warning");
  EXPECT_EQ(severity_name(Severity::error), "error");
  EXPECT_EQ(status_name(Status::ok), "ok");
  EXPECT_EQ(status_name(Status::warning), "warning");
  EXPECT_EQ(status_name(Status::refused), "refused");
}

TEST(Facts, KnowHowFarAReportGot) {
  Report report;
  EXPECT_FALSE(sheet_known(report) || flat_known(report) || certificate_known(report));
  report.summary.thickness = 0.5;
  EXPECT_TRUE(sheet_known(report));
  EXPECT_FALSE(flat_known(report));
  report.flat = test::sample_pattern();
  EXPECT_TRUE(flat_known(report));
  EXPECT_FALSE(certificate_known(report));
  report.certificate.flat_area_half = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(certificate_known(report)) << "what could not be measured was looked at";
}

TEST(Facts, AreNoNumbersWhereNotKnown) {
  EXPECT_TRUE(std::isnan(or_nan(std::nullopt)));
  EXPECT_EQ(or_nan(0.0), 0.0);
}

}  // namespace
}  // namespace planish::job
