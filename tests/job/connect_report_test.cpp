#include "connect/sample_plates.hpp"
#include "connected.hpp"
#include "folded.hpp"
#include "made_report.hpp"
#include "support/sheets.hpp"

#include <planish/connect/codes.hpp>
#include <planish/job/connect.hpp>
#include <planish/job/outputs.hpp>
#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>

// What `connect` of the job makes of plates already joined; how they are joined is not its affair.

namespace planish::job {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

using std::numbers::pi;

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items())
    names.push_back(key);
  return names;
}

// 50 | 90° r 3 | 30, width 40, t 2, as if made of the plates "base" and "wall".
Connection joined() {
  Connection connection;
  connection.structure.thickness = 2.0;
  connection.structure.plates = {{"base", {}, {}}, {"wall", {}, {}}};
  connection.sheet = test::l_bracket();
  connection.sheet.volume.reset();  // the maker does not know it
  FittedBend bend;
  bend.request.between = {"base", "wall"};
  bend.plates = {0, 1};
  bend.edges = {{{1, 2}, {0}}};
  bend.edge_kind = EdgeKind::averted;
  bend.kind = BendKind::cone;
  bend.frame.origin = {25.4, 0, 0};
  bend.frame.beta = Angle::degrees(90);
  bend.line = {0.25, -5.08};
  bend.apex = -20.32;
  bend.angle = Angle::degrees(90);
  bend.inside_radius = 3.0;
  bend.inside_radii = {2.54, 5.08};
  bend.half_angle = Angle::degrees(12);
  bend.lateral = LateralBoundary::arc;
  bend.width = bend.joined = 50.8;
  bend.span = 25.4;
  bend.extension_area = 25.4 * 25.4;
  BendAlternative other;
  other.request = bend.request;
  other.request.edges = {std::vector<int>{3}, std::vector<int>{2}};
  other.width = 12.7;
  other.span = 2.54;
  bend.alternatives = {other};
  bend.bend = BendId{0};
  connection.bends = {bend};
  return connection;
}

ConnectReport report_of(Connection connection, const AllowanceRule& allowance = ConstantK{}) {
  ConnectReport report;
  report.input = "shop/plates.json";
  report.body = "plates";
  const auto error = finish(report, std::move(connection), allowance, {}, {});
  EXPECT_FALSE(error.has_value()) << (error ? error->message : "");
  return report;
}

json bend_of(const ConnectReport& report) {
  return json::parse(report_json(report))["flat"]["bends"][0];
}

TEST(ConnectReport, HasTheKeysOfEveryReportAndOfItsBends) {
  const json report = json::parse(report_json(report_of(joined())));
  EXPECT_EQ(report["command"], "connect");
  EXPECT_EQ(report["format"], "planish/report");
  EXPECT_EQ(report["input"], "shop/plates.json");
  EXPECT_THAT(keys_of(report), IsSupersetOf({"version", "units", "status", "reason", "sheet",
                                             "flat", "verification", "checks", "notes", "files"}));
  EXPECT_THAT(
      keys_of(report["flat"]["bends"][0]),
      IsSupersetOf({"id",         "kind",           "angle",     "inside_radius", "k_factor",
                    "allowance",  "deduction",      "direction", "length",        "line",
                    "between",    "edges",          "slope",     "apex",          "width",
                    "span",       "extension_area", "surface",   "facing",        "frame",
                    "half_angle", "inside_radii",   "lateral",   "alternatives",  "joined",
                    "stretches"}));
}

TEST(ConnectReport, SaysHowEachBendWasFitted) {
  const json bend = bend_of(report_of(joined()));
  EXPECT_EQ(bend["id"], "B1");
  EXPECT_EQ(bend["between"], (json{"base", "wall"}));
  EXPECT_EQ(bend["edges"], json::parse(R"({"base": [1, 2], "wall": [0]})"));
  EXPECT_EQ(bend["surface"], "cone");
  EXPECT_EQ(bend["facing"], "averted");
  EXPECT_EQ(bend["lateral"], "arc");
  EXPECT_EQ(bend["slope"], 0.25);
  EXPECT_EQ(bend["apex"], -20.32);
  EXPECT_DOUBLE_EQ(bend["half_angle"], 12.0);
  EXPECT_EQ(bend["inside_radii"], (json{2.54, 5.08}));
  EXPECT_DOUBLE_EQ(bend["frame"]["beta"], 90.0);
  EXPECT_EQ(bend["frame"]["d"], (json{1.0, 0.0, 0.0}));
  EXPECT_THAT(keys_of(bend["frame"]), IsSupersetOf({"origin", "d", "e1", "e2", "beta"}));
  const json other = bend["alternatives"][0];
  EXPECT_EQ(other["edges"], json::parse(R"({"base": [3], "wall": [2]})"));
  EXPECT_EQ(other["surface"], "cylinder");
  EXPECT_EQ(other["facing"], "facing");
}

TEST(ConnectReport, HasNoApexAndEvenRadiiForACylinder) {
  Connection connection = joined();
  connection.bends[0].kind = BendKind::cylinder;
  connection.bends[0].apex.reset();
  connection.bends[0].half_angle.reset();
  const json bend = bend_of(report_of(std::move(connection)));
  EXPECT_TRUE(bend["apex"].is_null());
  EXPECT_TRUE(bend["half_angle"].is_null());
  EXPECT_EQ(bend["inside_radii"], (json{3.0, 3.0}));
}

TEST(ConnectReport, ConvertsLengthsAndAreasOnly) {
  ConnectReport report = report_of(joined());
  report.units = LengthUnit::inch;
  const json bend = bend_of(report);
  EXPECT_DOUBLE_EQ(bend["apex"], -0.8);
  EXPECT_DOUBLE_EQ(bend["offset"], -0.2);
  EXPECT_DOUBLE_EQ(bend["width"], 2.0);
  EXPECT_DOUBLE_EQ(bend["span"], 1.0);
  EXPECT_DOUBLE_EQ(bend["extension_area"], 1.0);
  EXPECT_DOUBLE_EQ(bend["inside_radii"][1], 0.2);
  EXPECT_DOUBLE_EQ(bend["frame"]["origin"][0], 1.0);
  EXPECT_DOUBLE_EQ(bend["frame"]["d"][0], 1.0);
  EXPECT_DOUBLE_EQ(bend["alternatives"][0]["width"], 0.5);
  EXPECT_DOUBLE_EQ(bend["slope"], 0.25);
}

TEST(ConnectReport, MatchesBendsByTheirRowAndNotByTheirOrder) {
  Connection connection = joined();
  connection.sheet = test::u_channel();
  connection.structure.plates = {{"a", {}, {}}, {"b", {}, {}}, {"c", {}, {}}};
  connection.bends.push_back(connection.bends[0]);
  connection.bends[0].bend = BendId{1};
  connection.bends[0].plates = {1, 2};
  connection.bends[1].bend = BendId{0};
  const ConnectReport report = report_of(std::move(connection));
  const json bends = json::parse(report_json(report))["flat"]["bends"];
  ASSERT_EQ(bends.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const bool first = report.flat.bends[i].bend == BendId{0};
    EXPECT_EQ(bends[i]["between"][0], first ? "a" : "b");
  }
}

TEST(ConnectReport, VerifiesTheVolumeOnTheFoldedSolid) {
  const ConnectReport report = report_of(joined());
  const double area = 40.0 * (50.0 + pi / 2 * (3.0 + 0.5 * 2.0) + 30.0);
  EXPECT_NEAR(report.summary.volume, 2.0 * area, 1e-6 * area);
  EXPECT_NEAR(*report.certificate.volume_ratio, 1.0, 1e-6);
  EXPECT_NEAR(*report.certificate.explained_ratio, 1.0, 1e-6);
  EXPECT_LT(report.certificate.length_error, 1e-9);
  EXPECT_LT(report.certificate.refold_deviation, 1e-6);
  EXPECT_EQ(report.status(), Status::ok);
  ASSERT_TRUE(report.solid.has_value());
  const auto step = step_text(*report.solid);
  ASSERT_TRUE(step) << step.error().message;
  EXPECT_THAT(*step, HasSubstr("ISO-10303-21"));
  EXPECT_THAT(*step, HasSubstr("'plates'"));
  EXPECT_TRUE(dxf_text(report.flat).has_value());
}

TEST(ConnectReport, MeasuresFoldsThatEndInsideAnEdge) {
  // The mitre adds outside the middle surfaces what it takes inside: both plates as they are drawn.
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {test::rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 50, 0}),
              test::rectangle_plate("B", {20, 0, 0}, {50, 0, 0}, {0, 0, 40})};
  s.bends = {{.between = {"A", "B"}, .inside_radius = 0.0}};
  auto connection = connect(s);
  ASSERT_TRUE(connection) << connection.error().message;
  const ConnectReport report = report_of(std::move(*connection));
  ASSERT_TRUE(report.solid.has_value());
  EXPECT_NEAR(report.summary.volume, 2.0 * (100.0 * 50.0 + 50.0 * 40.0), 1e-6);
  EXPECT_NEAR(*report.certificate.explained_ratio, 1.0, 1e-9);
  for (const Finding& finding : report.findings)
    EXPECT_NE(finding.severity, Severity::error) << finding.message;
}

TEST(ConnectReport, LaysFlatByTheRuleAsked) {
  const ConnectReport report = report_of(joined(), ConstantK{0.3, "plates file"});
  EXPECT_EQ(report.summary.k_factor, 0.3);
  EXPECT_EQ(report.summary.k_source, "plates file");
  EXPECT_NEAR(report.flat.area, 40.0 * (80.0 + pi / 2 * 3.6), 1e-6);
}

TEST(ConnectReport, TakesKFromTheCommandThenTheFileThenTheDefault) {
  PlatesFile file;
  Request request;
  EXPECT_EQ(std::get<ConstantK>(allowance_of(file, request)).k, ConstantK{}.k);
  file.k_factor = 0.3;
  EXPECT_EQ(std::get<ConstantK>(allowance_of(file, request)).k, 0.3);
  EXPECT_EQ(std::get<ConstantK>(allowance_of(file, request)).source, "plates file");
  request.allowance = Din6935{};
  EXPECT_TRUE(std::holds_alternative<Din6935>(allowance_of(file, request)));
}

// Two walls beside each other on a base, so wide above that they share sheet when flat.
Sheet flaring_walls() {
  test::SheetBuilder builder(1.0);
  const FaceId base = builder.flange(Frame{}, {test::rectangle(40, 40)});
  for (const int border : {1, 2}) {
    const test::Rim rim = builder.bend(builder.rim(base, border),
                                       test::Turn{Angle::degrees(90), 2});
    builder.flange_behind(rim, {test::polygon({{0, 0}, {40, 0}, {110, 40}, {-70, 40}})});
  }
  return builder.finish();
}

TEST(ConnectReport, RefusesAPatternThatCoversItselfUnlessToldNotTo) {
  PatternChecks checks;
  Connection connection = joined();
  connection.sheet = flaring_walls();
  ConnectReport report;
  report.body = "flaring";
  const auto error = finish(report, connection, ConstantK{}, checks, {});
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, code::overlap);
  EXPECT_EQ(report.summary.flanges, 3);
  checks.write_overlapping = true;
  EXPECT_FALSE(finish(report, connection, ConstantK{}, checks, {}).has_value());
  EXPECT_TRUE(report.has_warnings());
}

TEST(ConnectReport, StopsWhenAsked) {
  Progress progress;
  progress.cancelled = [] { return true; };
  ConnectReport report;
  report.body = "stopped";
  const auto error = finish(report, joined(), ConstantK{}, {}, progress);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, code::cancelled);
}

TEST(ConnectReport, PutsTheFilesNameBeforeAPointer) {
  EXPECT_EQ(placed({code::not_planar, "m", "/plates/2/outline/3"}, "p.json").where,
            "p.json/plates/2/outline/3");
  EXPECT_EQ(placed({code::not_planar, "m", ""}, "p.json").where, "p.json");
  EXPECT_EQ(placed({code::overlap, "m", "flat pattern at (1, 2) mm"}, "p.json").where,
            "flat pattern at (1, 2) mm");
}

TEST(ConnectReport, IsTheReasonOfARequestThatFailed) {
  Request request;
  request.input = "p.json";
  request.units = LengthUnit::inch;
  const json report = json::parse(report_json(failed_report<ConnectReport>(
      request, {code::unknown_plate, "no plate C", "p.json/bends/0"})));
  EXPECT_EQ(report["command"], "connect");
  EXPECT_EQ(report["units"], "inch");
  EXPECT_EQ(report["status"], "refused");
  EXPECT_EQ(report["reason"]["code"], "unknown_plate");
  EXPECT_EQ(report["reason"]["where"], "p.json/bends/0");
  EXPECT_TRUE(report["flat"].is_null());
}

TEST(ConnectReport, HasATableOfTheBendsOnTheTerminal) {
  const std::string text = report_text(report_of(joined()));
  EXPECT_THAT(text, HasSubstr("plates.json: sheet 2 mm (spread 0.000), 2 flanges, 1 bend\n"));
  EXPECT_THAT(text,
              HasSubstr("bend  between      surface  radius  angle   width  extension area\n"
                        "B1    base – wall  cone      3.000  90.0°  50.800           645.2\n"));
  EXPECT_THAT(text, HasSubstr("certificate: volume 1.000000"));
}

}  // namespace
}  // namespace planish::job
