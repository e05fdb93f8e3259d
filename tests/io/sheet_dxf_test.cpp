// Sheets with parts on them, read back by ezdxf.
#include "dxf_reading.hpp"
#include "sample_patterns.hpp"

#include <planish/io/flat_writers.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planish {
namespace {

using namespace sample;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

nlohmann::json listed(const std::string& text) {
  const Directory directory("list-dxf");
  const std::string file = (directory.path() / "sheet.dxf").string();
  const std::string report = (directory.path() / "report.json").string();
  std::ofstream(file) << text;
  const std::string command = PLANISH_PYTHON " " PLANISH_SOURCE_DIR "/tests/io/list_dxf.py " +
                              file + " > " + report;
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(report);
  return nlohmann::json::parse(in);
}

Isometry2 placed(double x, double y, double degrees) {
  Isometry2 motion = Isometry2::Identity();
  motion.translate(Vec2(x, y)).rotate(degrees * kPi / 180.0);
  return motion;
}

/// Three brackets, 200 × 100: as drawn, upright, and turned round.
SheetDrawing three_brackets(const FlatPattern& flat) {
  return {1000.0,
          500.0,
          {{&flat, placed(10, 10, 0), "bracket"},
           {&flat, placed(320, 10, 90), "Gehäuse 2\nßÄ€"},
           {&flat, placed(530, 110, 180), "third"}}};
}

class SheetDxfByEzdxf : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_ezdxf()) GTEST_SKIP() << PLANISH_PYTHON " has no ezdxf (Debian: python3-ezdxf)";
  }
};

void expect_near(const nlohmann::json& numbers, const std::vector<double>& expected) {
  ASSERT_EQ(numbers.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(numbers[i].get<double>(), expected[i], 1e-9) << numbers.dump();
}

TEST_F(SheetDxfByEzdxf, HoldsEveryContourAndBendLineWhereItsPartLies) {
  const FlatPattern flat = bracket();
  const SheetDrawing sheet = three_brackets(flat);
  for (const DxfVersion version : {DxfVersion::r2000, DxfVersion::r12}) {
    const auto report = listed(sheet_dxf_text(sheet, {.version = version}).value());
    EXPECT_TRUE(report["audit"].empty()) << report["audit"].dump();
    EXPECT_EQ(report["version"], version == DxfVersion::r12 ? "AC1009" : "AC1015");
    EXPECT_EQ(report["units"], 4);
    const auto& outer = report["layers"]["OUTER_PROFILE"]["polylines"];
    const auto& openings = report["layers"]["INTERIOR_PROFILES"];
    ASSERT_EQ(outer.size(), 3u);
    ASSERT_EQ(openings["polylines"].size(), 3u);
    ASSERT_EQ(openings["circles"].size(), 3u);
    for (const auto& contour : outer) {
      EXPECT_TRUE(contour["closed"]);
      EXPECT_NEAR(contour["area"].get<double>(), 20000.0, 1e-8);
    }
    for (const auto& slot : openings["polylines"]) {
      EXPECT_TRUE(slot["closed"]);
      EXPECT_NEAR(std::abs(slot["area"].get<double>()), 240.0 + 25.0 * kPi, 1e-8);
    }
    // (20, 50), up at x = 60 from y = 0 to 100, down at x = 150, moved by hand.
    expect_near(openings["circles"][0], {30, 60, 8});
    expect_near(openings["circles"][1], {270, 30, 8});
    expect_near(openings["circles"][2], {510, 60, 8});
    const auto& up = report["layers"]["BEND_UP"]["lines"];
    const auto& down = report["layers"]["BEND_DOWN"]["lines"];
    ASSERT_EQ(up.size(), 3u);
    ASSERT_EQ(down.size(), 3u);
    expect_near(up[0], {70, 10, 70, 110});
    expect_near(up[1], {320, 70, 220, 70});
    expect_near(up[2], {470, 110, 470, 10});
    expect_near(down[1], {220, 160, 320, 160});
  }
}

TEST_F(SheetDxfByEzdxf, KeepsEdgeAndNamesOnLayersThatAreNotCut) {
  const FlatPattern flat = bracket();
  const auto report = listed(sheet_dxf_text(three_brackets(flat)).value());
  const auto& edge = report["layers"]["SHEET"]["polylines"];
  ASSERT_EQ(edge.size(), 1u);
  expect_near(edge[0]["box"], {0, 0, 1000, 500});
  EXPECT_THAT(report["off"], ElementsAre("PART_NAMES"));
  const auto& names = report["layers"]["PART_NAMES"]["texts"];
  ASSERT_EQ(names.size(), 3u);
  EXPECT_EQ(names[0][0], "bracket");
  EXPECT_EQ(names[1][0], "Gehäuse 2 ßÄ€");
  for (std::size_t i = 0; i < 3; ++i) {
    // Each within its own part, its height with it.
    const auto& box = report["layers"]["OUTER_PROFILE"]["polylines"][i]["box"];
    const double x = names[i][1], y = names[i][2], half = 0.5 * names[i][3].get<double>();
    EXPECT_GT(half, 0.5);
    EXPECT_GE(x - half, box[0].get<double>());
    EXPECT_GE(y - half, box[1].get<double>());
    EXPECT_LE(x + half, box[2].get<double>());
    EXPECT_LE(y + half, box[3].get<double>());
  }
}

TEST_F(SheetDxfByEzdxf, FollowsProfileAndUnits) {
  const FlatPattern flat = bracket();
  const auto report = listed(
      sheet_dxf_text(three_brackets(flat),
                     {.profile = LayerProfile::inventor, .units = LengthUnit::inch})
          .value());
  EXPECT_EQ(report["units"], 1);
  EXPECT_EQ(report["layers"]["IV_OUTER_PROFILE"]["polylines"].size(), 3u);
  EXPECT_THAT(report["dashed"], UnorderedElementsAre("IV_BEND", "IV_BEND_DOWN"));
  expect_near(report["layers"]["SHEET"]["polylines"][0]["box"], {0, 0, 1000 / 25.4, 500 / 25.4});
  expect_near(report["layers"]["IV_INTERIOR_PROFILES"]["circles"][0],
              {30 / 25.4, 60 / 25.4, 8 / 25.4});
}

TEST(SheetDxf, ShowsNamesInNarrowAndHollowPartsToo) {
  FlatPattern ring;
  ring.outer.loop = {Arc{{0, 0}, 100.0, 0.0, 2.0 * kPi}};
  ring.openings.push_back({hole({0, 0}, 95.0), {}});
  const std::string text = sheet_dxf_text({300, 300, {{&ring, placed(150, 150, 0), "a"}}}).value();
  for (const Groups& entity : entities(text)) {
    if (entity.front().second != "TEXT") continue;
    const Vec2 at(std::stod(value_of(entity, 11)), std::stod(value_of(entity, 21)));
    const double from_middle = (at - Vec2(150, 150)).norm();
    EXPECT_GT(from_middle, 95.0);
    EXPECT_LT(from_middle, 100.0);
    return;
  }
  FAIL() << "no name";
}

TEST(SheetDxf, RefusesWhatIsNoSheet) {
  const FlatPattern flat = bracket(), empty;
  EXPECT_THAT(sheet_dxf_text({0.0, 10.0, {}}).error().message, HasSubstr("0 mm × 10 mm"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(sheet_dxf_text({10.0, nan, {}}));
  EXPECT_FALSE(sheet_dxf_text({100.0, 100.0, {{&empty, Isometry2::Identity(), "none"}}}));
}

}  // namespace
}  // namespace planish
