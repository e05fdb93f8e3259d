#include "job/job_requests.hpp"

#include <planish/job/slit_json.hpp>

#include <gtest/gtest.h>

// Slits that are curves, and outlines, as files give them.

namespace planish::job {
namespace {

using nlohmann::json;

json slits_along_the_sheet() {
  return json::parse(R"({"units": "m", "thickness": 0.004, "symmetric": false,
    "sheet": {"strips": 2, "strip_width": 0.06, "panel_height": 0.42, "half_length": 0.464},
    "leg_curve": {"bezier": [[0.36, 0], [0.36, 0.12]]}})");
}

SlitSheet sheet_of_file(const json& document) {
  const auto file = parse_slits(document.dump(), "s.json", {});
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? file->design.sheet : SlitSheet{};
}

json two_slits() {
  json document = slits_along_the_sheet();
  document["sheet"] = json::parse(R"({"width": 0.15, "panel_height": 0.42, "half_length": 0.464})");
  document["slits"] = json::parse(R"([{"points": [[0.5, 0.1], [0.7, 0.09], [0.884, 0.1]]},
    {"bezier": [[0.42, 0.05], [0.6, 0.05], [0.7, 0.06], [0.884, 0.06]]}])");
  return document;
}

TEST(SlitSheetJson, ReadsSlitsThatAreCurves) {
  const SlitSheet sheet = sheet_of_file(two_slits());
  ASSERT_EQ(sheet.strips.size(), 3u);
  EXPECT_NEAR(sheet.strips[0].width, 50.0, 1e-9);
  EXPECT_NEAR(sheet.width_at_end(1), 40.0, 1e-9);
  EXPECT_NEAR(sheet.width(), 150.0, 1e-9);
  EXPECT_TRUE(sheet.strips[0].edges[0].empty());
  EXPECT_GT(sheet.strips[0].edges[1].size(), 10u) << "a Bézier curve as lines";
  EXPECT_EQ(sheet.strips[0].edges[1], sheet.strips[1].edges[0]);
  EXPECT_EQ(sheet.strips[2].edges[0].size(), 3u);
  ASSERT_TRUE(sheet.strips[2].left_start);
  EXPECT_NEAR(*sheet.strips[2].left_start, 500.0, 1e-9);
}

TEST(SlitSheetJson, ReadsSlitsThatEndInTheMiddle) {
  json document = two_slits();
  document["slits"] = json::parse(R"([{"points": [[0.42, 0.05], [0.8, 0.05]]},
    {"points": [[0.42, 0.1], [0.7, 0.1]]}])");
  const SlitSheet sheet = sheet_of_file(document);
  EXPECT_NEAR(*sheet.strips[0].right_end, 800.0, 1e-9);
  EXPECT_NEAR(*sheet.strips[1].left_end, 800.0, 1e-9);
  EXPECT_NEAR(*sheet.strips[1].right_end, 700.0, 1e-9);
  json list = slits_along_the_sheet();
  list["sheet"].erase("strip_width");
  list["sheet"]["strips"] = {{{"width", 0.05}, {"right_end", 0.8}},
                             {{"width", 0.1}, {"left_end", 0.8}}};
  const SlitSheet other = sheet_of_file(list);
  EXPECT_EQ(other.strips[0].right_end, sheet.strips[0].right_end);
  EXPECT_TRUE(other.joins_next(0));
}

TEST(SlitSheetJson, ReadsAnOutlineInPlaceOfTheWidth) {
  json document = two_slits();
  document["sheet"].erase("width");
  document["outline"] = json::parse(R"([{"points": [[0, 0], [0.42, 0]]},
    {"bezier": [[0.42, 0], [0.6, 0], [0.7, 0.02], [0.884, 0.02]]},
    {"points": [[0.884, 0.13], [0.42, 0.15], [0, 0.15]]}])");
  const SlitSheet sheet = sheet_of_file(document);
  ASSERT_EQ(sheet.strips.size(), 3u);
  EXPECT_NEAR(sheet.width(), 150.0, 1e-9);
  EXPECT_NEAR(sheet.breadth(), 110.0, 1e-9);
}

TEST(SlitSheetJson, RefusesSlitsThatMakeNoStrips) {
  const auto refused = [](auto change) {
    json document = two_slits();
    change(document);
    const auto file = parse_slits(document.dump(), "s.json", {});
    return file ? std::string("read") : file.error().where;
  };
  // The other one would go on beside the uncut sheet, and is curved there.
  EXPECT_EQ(refused([](json& d) { d["slits"][1]["bezier"][3][0] = 0.8; }), "s.json/slits/0");
  EXPECT_EQ(refused([](json& d) { d["slits"][0]["points"][1][1] = 0.02; }), "s.json/slits/0");
  EXPECT_EQ(refused([](json& d) { d["sheet"].erase("width"); }), "s.json/sheet");
  EXPECT_EQ(refused([](json& d) { d.erase("slits"); }), "s.json/sheet");
  EXPECT_EQ(refused([](json& d) {
              d["sheet"].erase("width");
              d["outline"] = {{{"points", {{0, 0}, {0.884, 0}, {0.884, 0.15}, {0.1, 0.2}}}}};
            }),
            "s.json/outline");
  json both = slits_along_the_sheet();
  both["slits"] = two_slits()["slits"];
  EXPECT_EQ(parse_slits(both.dump(), "s.json", {}).error().where, "s.json/sheet");
  both = slits_along_the_sheet();
  both["outline"] = {{{"points", {{0, 0}, {1, 0}}}}};
  EXPECT_EQ(parse_slits(both.dump(), "s.json", {}).error().where, "s.json/outline");
}

}  // namespace
}  // namespace planish::job
