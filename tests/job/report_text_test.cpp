#include "job/sample_reports.hpp"

#include <planish/job/unfold.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace planish::job {
namespace {

using test::sample_report;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

TEST(ReportText, HasThicknessBlankBendsAndCertificate) {
  const std::string text = report_text(sample_report());
  EXPECT_THAT(text, HasSubstr("bracket.step: sheet 2 mm (spread 0.000), 2 flanges, 1 bend\n"));
  EXPECT_THAT(text, HasSubstr("blank 100.000 × 60.000 mm, area 5921.5 mm², "
                              "cutting length 320.000 mm outer + 31.416 mm in 1 opening\n"));
  EXPECT_THAT(text, HasSubstr("certificate: volume 1.000000 (K = ½), edge lengths within 2e-13 mm, "
                              "refold within 3e-09 mm\n"));
  EXPECT_THAT(text, Not(HasSubstr("findings")));
}

TEST(ReportText, SaysWhatIsASlitAndWhatIsOnlyOutlined) {
  UnfoldReport report = sample_report();
  report.flat.slits = {Segment{{60, 10}, {60, 20}}, Segment{{80, 10}, {80, 20}}};
  report.flat.features = {{"formed", FormSide::up, {}}, {"formed", FormSide::up, {}}};
  report.certificate.openings = {.solid = 2, .pattern = 2, .slits = 1, .missing = {}};
  std::string text = report_text(report);
  EXPECT_THAT(text, HasSubstr(" outer + 51.416 mm in 1 opening and 2 slits\n"
                              "outlined, not cut: 2 formed features up\n"));
  EXPECT_THAT(text, HasSubstr("openings 2 of 2 (1 is a slit)\n"));
  report.flat.openings.clear();
  EXPECT_THAT(report_text(report), HasSubstr(" outer + 20.000 mm in 2 slits\n"));
}

TEST(ReportText, SaysHowManyAreWantedOfMoreThanOne) {
  UnfoldReport report = sample_report();
  EXPECT_THAT(report_text(report), HasSubstr("bracket.step: "));
  report.quantity = 2;
  EXPECT_THAT(report_text(report), HasSubstr("bracket.step ×2: "));
}

TEST(ReportText, LinesTheBendTableUp) {
  const std::string text = report_text(sample_report());
  EXPECT_THAT(text,
              HasSubstr("bend  kind      angle  radius  direction      K  from     allowance  "
                        "deduction  length\n"
                        "B1    cylinder  90.0°   3.000  down       0.440  default      6.095  "
                        "    3.905  55.000\n"));
}

TEST(ReportText, SaysWhatWasNotMeasured) {
  UnfoldReport report = sample_report();
  report.certificate.volume_ratio = kUnmeasured;
  report.certificate.refold_deviation = kUnmeasured;
  EXPECT_THAT(report_text(report), HasSubstr("volume not measured, edge lengths within 2e-13 mm, "
                                             "refold not measured"));
}

TEST(ReportText, ShowsFindingsWithPlaceThenNotesThenFiles) {
  UnfoldReport report = sample_report();
  report.findings = {{"hole_to_bend", Severity::warning, "1 mm, less than 4 mm", {{70, 30}}}};
  report.notes = {"one spline surface is a plane"};
  report.files = {"bracket.dxf"};
  EXPECT_THAT(report_text(report),
              HasSubstr("findings:\n"
                        "  warning [hole_to_bend] at (70.000, 30.000): 1 mm, less than 4 mm\n"
                        "note: one spline surface is a plane\n"
                        "wrote bracket.dxf\n"));
}

TEST(ReportText, NamesBodyAndQuantityWhereTheFileHoldsMore) {
  UnfoldReport report = sample_report();
  report.number = 2;
  report.bodies_in_file = 3;
  report.body = "door";
  report.quantity = 4;
  EXPECT_THAT(report_text(report), HasSubstr("bracket.step, body 2 \"door\" ×4: sheet"));
}

TEST(ReportText, LetsNoNameCommandTheTerminal) {
  UnfoldReport report = sample_report();
  report.body = "red\033[31m";
  report.notes = {"two\nlines"};
  const std::string text = report_text(report);
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, Not(HasSubstr("two\nlines")));
}

TEST(ReportText, GivesTheMassWhenItIsKnown) {
  UnfoldReport report = sample_report();
  report.mass = 0.0929676;
  EXPECT_THAT(report_text(report), HasSubstr("1 bend, 0.093 kg\n"));
}

}  // namespace
}  // namespace planish::job
