#include "job/job_requests.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/codes.hpp>
#include <planish/job/info.hpp>
#include <planish/job/unfold.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::job {
namespace {

/// An L of 2 mm, 50 | 90° r 3 | 30, and a box.
StepFile two_sheets() {
  StepFile file;
  file.schema = "AP214";
  file.unit = "mm";
  file.surface_bodies = 3;
  file.bodies = {*folded_body(test::l_bracket(), "bracket"), *folded_body(test::box(), "box")};
  return file;
}

InfoReport told(const InfoRequest& request) {
  const auto report = info_of(two_sheets(), request);
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  return report ? *report : InfoReport{};
}

TEST(Info, MeasuresEachBody) {
  const InfoReport report = told({.input = "two.step", .body = {}, .units = LengthUnit::inch});
  EXPECT_EQ(report.input, "two.step");
  EXPECT_EQ(report.schema, "AP214");
  EXPECT_EQ(report.file_unit, "mm");
  EXPECT_EQ(report.surface_bodies, 3);
  EXPECT_EQ(report.units, LengthUnit::inch);
  ASSERT_EQ(report.bodies.size(), 2u);
  const BodyInfo& bracket = report.bodies[0];
  EXPECT_EQ(bracket.number, 1);
  EXPECT_EQ(bracket.name, "bracket");
  EXPECT_EQ(bracket.quantity, 1);
  EXPECT_NEAR(bracket.volume, 80.0 * (80.0 + std::numbers::pi / 2 * 4.0), 1e-3);
  // 50 and the bend's outside beyond it; as high as the bend and 30.
  EXPECT_NEAR(bracket.size.x(), 55.0, 1e-6);
  EXPECT_NEAR(bracket.size.y(), 40.0, 1e-6);
  EXPECT_NEAR(bracket.size.z(), 35.0, 1e-6);
  EXPECT_EQ(bracket.faces, 14) << "two skins and two sides of three each, two ends";
  EXPECT_FALSE(bracket.sheet) << "unless asked";
  EXPECT_EQ(report.bodies[1].number, 2);
}

TEST(Info, FindsTheSheetAndTheFacesThatCanBeItsRoot) {
  const InfoReport report = told({.input = "two.step", .body = {}, .recognize = true});
  ASSERT_TRUE(*report.bodies[0].sheet);
  const SheetInfo& bracket = **report.bodies[0].sheet;
  EXPECT_NEAR(bracket.thickness, 2.0, 1e-9);
  EXPECT_EQ(bracket.flanges, 2);
  EXPECT_EQ(bracket.bends, 1);
  ASSERT_EQ(bracket.faces.size(), 2u) << "no bend";
  EXPECT_NEAR(bracket.faces[0].area, 50.0 * 40.0, 1e-6) << "the largest first";
  EXPECT_NEAR(bracket.faces[1].area, 30.0 * 40.0, 1e-6);
  EXPECT_EQ((*report.bodies[1].sheet)->bends, 4);
}

TEST(Info, TellsOfOneBodyWhereOneIsNamed) {
  const InfoReport report = told({.input = "two.step", .body = "box"});
  ASSERT_EQ(report.bodies.size(), 1u);
  EXPECT_EQ(report.bodies[0].number, 2);
  EXPECT_EQ(info_of(two_sheets(), {.input = "x", .body = "lid"}).error().code, code::no_such_body);
}

TEST(Info, SaysHowFarItIsAndStopsWhenAsked) {
  std::vector<double> shares;
  Progress progress;
  progress.report = [&](std::string_view, double share) { shares.push_back(share); };
  ASSERT_TRUE(info_of(two_sheets(), {.input = "x", .body = {}}, progress));
  EXPECT_EQ(shares, (std::vector<double>{0.0, 0.5}));
  progress.cancelled = [] { return true; };
  EXPECT_EQ(info_of(two_sheets(), {.input = "x", .body = {}}, progress).error().code,
            code::cancelled);
}

TEST(Info, SaysWhatTheFileSaysOfTheMaterial) {
  std::string text = test::bytes_of_file(test::example("bracket.step"));
  text.insert(text.rfind("ENDSEC;"), R"(
#9001=DESCRIPTIVE_REPRESENTATION_ITEM('AlMg3','AlMg3');
#9002=PROPERTY_DEFINITION('material property','material name',#5);
#9003=REPRESENTATION('material name',(#9001),#1443);
#9004=PROPERTY_DEFINITION_REPRESENTATION(#9002,#9003);
#9005=(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.));
#9006=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));
#9007=DERIVED_UNIT_ELEMENT(#9005,1.);
#9008=DERIVED_UNIT_ELEMENT(#9006,-3.);
#9009=DERIVED_UNIT((#9007,#9008));
#9010=MEASURE_REPRESENTATION_ITEM('density measure',POSITIVE_RATIO_MEASURE(2680.),#9009);
#9011=PROPERTY_DEFINITION('material property','density',#5);
#9012=REPRESENTATION('density',(#9010),#1443);
#9013=PROPERTY_DEFINITION_REPRESENTATION(#9011,#9012);
)");
  const auto file = read_step_text(text, "bracket.step");
  ASSERT_TRUE(file) << file.error().message;
  const auto report = info_of(*file, {.input = "bracket.step", .body = {}});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->bodies[0].material, "AlMg3");
  EXPECT_NEAR(report->bodies[0].density.value_or(0.0), 2.68, 1e-9);
  Request request;
  request.effort = Effort::draft;
  const auto unfolded = unfold_body(file->bodies[0], request);
  ASSERT_TRUE(unfolded);
  EXPECT_EQ(unfolded->material, "AlMg3");
  EXPECT_NEAR(*unfolded->mass, 2.68e-6 * unfolded->flat.area * unfolded->summary.thickness, 1e-2)
      << "by the density of the file";
}

TEST(Info, ReadsItsFile) {
  const auto report = info({.input = test::example("bracket.step"), .body = {}});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->bodies.size(), 1u);
  EXPECT_EQ(info({.input = "/no/such.step", .body = {}}).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::job
