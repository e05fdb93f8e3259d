#include "station_report.hpp"

#include "job/planned_reports.hpp"

#include <planish/schema/units.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using schema::Json;

const std::vector<Station>& two_stations() {
  static const std::vector<Station> stations{
      {0, "P88", "V12", {{1270.0, {50.8, 25.4}, 0.0, 12.7}}, {{1270.0, {50.8}}}, {0, 2}},
      {1, "F180", "F180", {{254.0, {25.4}}, {508.0, {25.4}}}, {{254.0, {508.0}}}, {1}}};
  return stations;
}

TEST(StationReport, TellsStationsInTheReportsUnit) {
  Report report = test::planned_report();
  report.units = LengthUnit::inch;
  const Json told = stations_json(two_stations(), report);
  EXPECT_EQ(told[0], Json::parse(R"({"set_up": 1, "punch": "P88", "die": "V12", "from": 50.0,
      "segments": [2.0, 1.0], "ears": ["right"], "die_from": 50.0, "die_segments": [2.0],
      "strokes": [1, 3]})"));
  EXPECT_EQ(told[1]["set_up"], 2);
  EXPECT_EQ(
      told[1]["punch_rows"],
      Json::parse(R"([{"from": 10.0, "segments": [1.0]}, {"from": 20.0, "segments": [1.0]}])"));
  EXPECT_FALSE(told[1].contains("die_rows"));
  for (const Json& station : told)
    EXPECT_FALSE(schema::first_mistake(station_schema(), station)) << station;
}

TEST(StationReport, TellsThemInATable) {
  Plan plan;
  EXPECT_EQ(stations_text(plan, schema::Units(LengthUnit::mm)), "");
  plan.stations = two_stations();
  const std::string text = stations_text(plan, schema::Units(LengthUnit::mm));
  EXPECT_NE(text.find("50.8 + right ear 25.4"), std::string::npos) << text;
  EXPECT_NE(text.find("25.4, gap 228.600, 25.4"), std::string::npos) << text;
  EXPECT_NE(text.find("1 3"), std::string::npos) << text;
}

}  // namespace
}  // namespace planish::job
