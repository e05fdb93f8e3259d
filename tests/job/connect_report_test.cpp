#include "job/joined_sheet.hpp"
#include "made_report.hpp"
#include "support/sheets.hpp"

#include <planish/connect/codes.hpp>
#include <planish/job/connect.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// What `connect` of the job makes of plates already joined; how they are joined is not its affair.

namespace planish::job {
namespace {

using nlohmann::json;
using test::joined;
using test::report_of;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items())
    names.push_back(key);
  return names;
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
