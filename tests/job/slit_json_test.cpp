#include "job/job_requests.hpp"
#include "support/error_data.hpp"

#include <planish/job/slit_json.hpp>

#include <gtest/gtest.h>

#include <filesystem>

namespace planish::job {
namespace {

using nlohmann::json;

json two_strips() {
  return json::parse(R"({"units": "m", "thickness": 0.004, "symmetric": false,
    "sheet": {"strips": 2, "strip_width": 0.06, "panel_height": 0.42, "half_length": 0.464},
    "leg_curve": {"bezier": [[0.36, 0], [0.36, 0.12]]}})");
}

SlitFile slits_of(const json& document, std::optional<std::filesystem::path> folder = {}) {
  const auto file = parse_slits(document.dump(), "s.json", folder);
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? *file : SlitFile{};
}

json with(const char* pointer, const json& value) {
  json document = two_strips();
  document[json::json_pointer(pointer)] = value;
  return document;
}

TEST(SlitJson, ReadsLengthsInTheUnitOfTheFile) {
  const SlitFile file = slits_of(two_strips());
  EXPECT_EQ(file.units, LengthUnit::m);
  const SlitSheet& sheet = file.design.sheet;
  EXPECT_DOUBLE_EQ(sheet.thickness, 4.0);
  EXPECT_DOUBLE_EQ(sheet.panel_height, 420.0);
  EXPECT_DOUBLE_EQ(sheet.half_length, 464.0);
  ASSERT_EQ(sheet.strips.size(), 2u);
  EXPECT_DOUBLE_EQ(sheet.strips[1].width, 60.0);
  EXPECT_EQ(sheet.strips[1].gap, 0.0);
  ASSERT_EQ(file.design.leg_curve.poles.size(), 2u);
  EXPECT_LT((file.design.leg_curve.poles[1] - Vec2(360, 120)).norm(), 1e-12);
}

TEST(SlitJson, HasDefaultsForWhatIsLeftOut) {
  const SlitFile file = slits_of(two_strips());
  const SlitDesign usual;
  EXPECT_EQ(file.subdivisions, 0);
  EXPECT_FALSE(file.align_scans);
  EXPECT_EQ(file.kerf, 0.0);
  EXPECT_EQ(file.stop_hole, 0.0);
  EXPECT_FALSE(file.design.fit);
  EXPECT_EQ(file.design.lean.degrees(), 0.0);
  EXPECT_EQ(file.design.ridges, usual.ridges);
  EXPECT_EQ(file.design.end_angle, EndAngle::right_angle);
  EXPECT_EQ(file.design.weights.smooth, SlitWeights{}.smooth);
  EXPECT_EQ(file.design.weights.scan, SlitWeights{}.scan);
  EXPECT_FALSE(file.design.seat_curve || file.design.second_panel);
  EXPECT_TRUE(file.design.ends.empty() && file.design.anchors.empty());
  EXPECT_EQ(file.design.sheet.min_inside_radius, 0.0);
  EXPECT_EQ(file.design.sheet.margin, 0.0);
  EXPECT_EQ(file.mould.form, MouldForm::ribs);
  EXPECT_EQ(file.mould.side, MouldSide::ground);
  EXPECT_EQ(file.mould.base, MouldOptions{}.base);
  EXPECT_FALSE(file.mould.inset || file.mould.up);
  EXPECT_NEAR(file.mould.draft.degrees(), 5.0, 1e-12);
  json document = two_strips();
  document.erase("symmetric");
  EXPECT_TRUE(slits_of(document).design.sheet.symmetric);
  EXPECT_FALSE(slits_of(two_strips()).design.sheet.symmetric);
}

TEST(SlitJson, ReadsEachStrip) {
  const json strips = json::parse(R"([{"width": 0.04, "gap": 0.01},
      {"width": 0.03, "left_start": 0.2, "right_start": 0.23, "end": 0.56}])");
  json document = with("/sheet/strips", strips);
  document["sheet"].erase("strip_width");
  document["sheet"]["margin"] = 0.012;
  const SlitSheet sheet = slits_of(document).design.sheet;
  ASSERT_EQ(sheet.strips.size(), 2u);
  EXPECT_DOUBLE_EQ(sheet.strips[0].width, 40.0);
  EXPECT_DOUBLE_EQ(sheet.strips[0].gap, 10.0);
  EXPECT_FALSE(sheet.strips[0].left_start || sheet.strips[0].right_start || sheet.strips[0].end);
  EXPECT_DOUBLE_EQ(*sheet.strips[1].left_start, 200.0);
  EXPECT_DOUBLE_EQ(*sheet.strips[1].right_start, 230.0);
  EXPECT_DOUBLE_EQ(*sheet.strips[1].end, 560.0);
  EXPECT_DOUBLE_EQ(sheet.margin, 12.0);
}

TEST(SlitJson, ReadsCurvesPanelsAndWeights) {
  json document = with("/leg_curve/fit", true);
  document["leg_curve"]["lean"] = 30;
  document["seat_curve"] = {{"bezier", {{0.33, 0}, {0.3, 0.12}}}};
  document["second_panel"] = json::parse(R"({"height": 0.2, "leg_curve":
      {"bezier": [[0, 0], [0, 0.12]], "lean": -15, "fit": true}})");
  document["weights"] = {{"smooth", 7}, {"seat", 0}};
  document["min_inside_radius"] = 0.005;
  document["ridges"] = 12;
  document["end_angle"] = "free";
  const SlitDesign design = slits_of(document).design;
  EXPECT_TRUE(design.fit);
  EXPECT_NEAR(design.lean.degrees(), 30.0, 1e-12);
  EXPECT_LT((design.seat_curve->poles[0] - Vec2(330, 0)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(design.second_panel->height, 200.0);
  EXPECT_NEAR(design.second_panel->lean.degrees(), -15.0, 1e-12);
  EXPECT_TRUE(design.second_panel->fit);
  EXPECT_LT((design.second_panel->leg_curve.poles[1] - Vec2(0, 120)).norm(), 1e-12);
  EXPECT_EQ(design.weights.smooth, 7.0);
  EXPECT_EQ(design.weights.seat, 0.0);
  EXPECT_EQ(design.weights.spacing, SlitWeights{}.spacing);
  EXPECT_DOUBLE_EQ(design.sheet.min_inside_radius, 5.0);
  EXPECT_EQ(design.ridges, 12);
  EXPECT_EQ(design.end_angle, EndAngle::free);
  EXPECT_EQ(slits_of(with("/end_angle", "level")).design.end_angle, EndAngle::level);
}

TEST(SlitJson, TakesTheObjectiveThatAWeightIsOf) {
  EXPECT_EQ(slits_of(two_strips()).design.objective, SlitObjective::energy);
  json document = with("/objective", "smooth");
  EXPECT_EQ(slits_of(document).design.objective, SlitObjective::smooth);
  document.erase("objective");
  document["weights"] = {{"smooth", 7}};
  EXPECT_EQ(slits_of(document).design.objective, SlitObjective::smooth) << "as files before had it";
  document["objective"] = "energy";
  EXPECT_FALSE(parse_slits(document.dump(), "s.json", {}));
}

TEST(SlitJson, ReadsAnchorsAndEnds) {
  json document = two_strips();
  document["anchors"] = json::parse(R"([{"strip": 1, "ridge": 3, "at": [0.1, 0.2, 0.3]},
      {"strip": 0, "ridge": 2, "at": [0, 0, 0], "side": "right"}])");
  document["ends"] = json::parse(R"([{"strip": 1, "position": [0.1, 0, 0], "direction": [0, 2, 0]},
      {"strip": 0, "across": [0, 0, -3]}])");
  const SlitDesign design = slits_of(document).design;
  ASSERT_EQ(design.anchors.size(), 2u);
  EXPECT_EQ(design.anchors[0].strip, 1);
  EXPECT_EQ(design.anchors[0].ridge, 3);
  EXPECT_EQ(design.anchors[0].side, StripEdge::left);
  EXPECT_LT((design.anchors[0].at - Vec3(100, 200, 300)).norm(), 1e-9);
  EXPECT_EQ(design.anchors[1].side, StripEdge::right);
  ASSERT_EQ(design.ends.size(), 2u);
  EXPECT_LT((*design.ends[1].position - Vec3(100, 0, 0)).norm(), 1e-9);
  EXPECT_EQ(*design.ends[1].direction, Vec3::UnitY());
  EXPECT_FALSE(design.ends[1].across || design.ends[0].position || design.ends[0].direction);
  EXPECT_EQ(*design.ends[0].across, -Vec3::UnitZ());
  document["ends"] = json::parse(R"([{"strip": 0}])");
  EXPECT_EQ(slits_of(document).design.ends.size(), 1u) << "as far as they are given";
}

TEST(SlitJson, ReadsCutsAndTheMould) {
  json document = with("/mould", json::parse(R"({"form": "body", "side": "front",
      "up": [0, 0, 2], "base": 0.05, "inset": 0.003, "draft": 10})"));
  document["kerf"] = 0.0002;
  document["stop_hole"] = 0.003;
  document["subdivisions"] = 2;
  document["align_scan"] = true;
  const SlitFile file = slits_of(document);
  EXPECT_DOUBLE_EQ(file.kerf, 0.2);
  EXPECT_DOUBLE_EQ(file.stop_hole, 3.0);
  EXPECT_EQ(file.subdivisions, 2);
  EXPECT_TRUE(file.align_scans);
  EXPECT_EQ(file.mould.form, MouldForm::body);
  EXPECT_EQ(file.mould.side, MouldSide::front);
  EXPECT_EQ(*file.mould.up, Vec3::UnitZ());
  EXPECT_DOUBLE_EQ(file.mould.base, 50.0);
  EXPECT_DOUBLE_EQ(*file.mould.inset, 3.0);
  EXPECT_NEAR(file.mould.draft.degrees(), 10.0, 1e-12);
  EXPECT_EQ(slits_of(with("/mould/side", "back")).mould.side, MouldSide::back);
}

TEST(SlitJson, ReadsScansInPlaceAndFromFiles) {
  json document = two_strips();
  document["scan"] = json::parse(R"([{"strip": 1, "points": [[0.1, 0.2, 0.3], [0, 0, 1]]},
                                     {"strip": 0, "points": "planish_slit_json.xyz"}])");
  const SlitFile without = slits_of(document);
  ASSERT_EQ(without.design.scans.size(), 2u);
  EXPECT_EQ(without.design.scans[0].strip, 1);
  ASSERT_EQ(without.design.scans[0].points.size(), 2u);
  EXPECT_LT((without.design.scans[0].points[0] - Vec3(100, 200, 300)).norm(), 1e-9);
  EXPECT_TRUE(without.design.scans[1].points.empty()) << "not read without a folder";
  const std::filesystem::path folder = ::testing::TempDir();
  std::ofstream(folder / "planish_slit_json.xyz") << "1 2 3\n";
  const SlitFile read = slits_of(document, folder);
  ASSERT_EQ(read.design.scans[1].points.size(), 1u);
  EXPECT_EQ(read.design.scans[1].strip, 0);
  EXPECT_LT((read.design.scans[1].points[0] - Vec3(1000, 2000, 3000)).norm(), 1e-9);
  std::ofstream(folder / "planish_slit_json.xyz") << "1 2\n";
  EXPECT_EQ(parse_slits(document.dump(), "s.json", folder).error().where,
            (folder / "planish_slit_json.xyz").string() + ":1");
  std::filesystem::remove(folder / "planish_slit_json.xyz");
  EXPECT_EQ(parse_slits(document.dump(), "s.json", folder).error().code, code::cannot_read);
}

TEST(SlitJson, KnowsTheFilesThatItNamesWhateverElseIsWrong) {
  const auto files = slit_files_of(R"({"thickness": "x", "scan": [{"points": [[1, 2, 3]]},
      {"strip": 0, "points": "a.xyz"}, 7, {"points": "b.xyz"}]})");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].file, "a.xyz");
  EXPECT_EQ(files[0].pointer, "/scan/1/points");
  EXPECT_EQ(files[1].pointer, "/scan/3/points");
  for (const char* none : {"", "[]", "{", "{}", R"({"scan": 3})"})
    EXPECT_TRUE(slit_files_of(none).empty()) << none;
}

TEST(SlitJson, NamesThePlaceOfAMistake) {
  const auto place_of_mistake = [](const json& document) -> std::string {
    const auto file = parse_slits(document.dump(), "s.json", std::nullopt);
    return file ? "read" : file.error().where;
  };
  for (const auto& [pointer, value] : std::vector<std::pair<const char*, json>>{
           {"/thickness", 0},
           {"/thickness", 1e5},
           {"/sheet/strips", 0},
           {"/sheet/strips", 10001},
           {"/sheet/panel_height", 0},
           {"/sheet/half_length", 0},
           {"/sheet/margin", -1},
           {"/ridges", 2},
           {"/ridges", 1001},
           {"/subdivisions", 7},
           {"/kerf", -1},
           {"/stop_hole", -1},
           {"/leg_curve/bezier", json::array({json::array({1, 2})})},
           {"/leg_curve/lean", 91},
           {"/leg_curve/lean", -91},
           {"/mould", {{"draft", 0}}},
           {"/mould", {{"draft", 86}}},
           {"/weights", {{"seat", 10001}}},
           {"/weights", {{"seat", -1}}},
           {"/min_inside_radius", -1},
           {"/ends", {{{"strip", 2}}}},
           {"/ends", {{{"strip", 1}}, {{"strip", 1}}}},
           {"/ends", {{{"strip", 1}, {"direction", {0, 0, 0}}}}}})
    EXPECT_EQ(place_of_mistake(with(pointer, value)).rfind(std::string("s.json") + pointer, 0), 0u)
        << pointer << " " << value << " " << place_of_mistake(with(pointer, value));
  for (const auto& [pointer, value] :
       std::vector<std::pair<const char*, json>>{{"/ridges", 3},
                                                 {"/ridges", 1000},
                                                 {"/subdivisions", 6},
                                                 {"/leg_curve/lean", 90},
                                                 {"/mould", {{"draft", 85}}},
                                                 {"/weights", {{"seat", 10000}}},
                                                 {"/ends", {{{"strip", 1}}, {{"strip", 0}}}},
                                                 {"/sheet/strips", 1}})
    EXPECT_EQ(place_of_mistake(with(pointer, value)), "read") << pointer << " " << value;
  EXPECT_EQ(place_of_mistake(with("/ends", {{{"strip", 0}}, {{"strip", 2}}})),
            "s.json/ends/1/strip");
  const Error beyond = parse_slits(with("/ends", {{{"strip", 2}}}).dump(), "s.json", {}).error();
  EXPECT_EQ(test::number_in(beyond, "strip"), 2.0);
  EXPECT_EQ(test::number_in(beyond, "last"), 1.0);
}

TEST(SlitJson, RefusesEndsAndPanelsThatContradictOneAnother) {
  const json panel = json::parse(
      R"({"height": 0.2, "leg_curve": {"bezier": [[0, 0], [0, 0.12]]}})");
  const auto place_of_mistake = [](const json& document) -> std::string {
    const auto file = parse_slits(document.dump(), "s.json", std::nullopt);
    return file ? "read" : file.error().where;
  };
  json document = with("/second_panel", panel);
  EXPECT_EQ(place_of_mistake(document), "read");
  document["ends"] = json::array();
  EXPECT_EQ(place_of_mistake(document), "s.json/ends");
  document.erase("ends");
  document["symmetric"] = true;
  EXPECT_EQ(place_of_mistake(document), "s.json/second_panel");
  document.erase("second_panel");
  EXPECT_EQ(place_of_mistake(document), "read");
  document["ends"] = json::array();
  EXPECT_EQ(place_of_mistake(document), "s.json/ends");
}

TEST(SlitJson, ReadsWhatStripsHaveToDoWithEachOther) {
  EXPECT_FALSE(slits_of(two_strips()).design.coupling);
  const SlitCoupling usual = *slits_of(with("/coupling", json::object())).design.coupling;
  EXPECT_EQ(usual, SlitCoupling{});
  const json given = json::parse(R"({"smooth": 0.5, "gap": [0.002, 0.01]})");
  const SlitCoupling coupling = *slits_of(with("/coupling", given)).design.coupling;
  EXPECT_EQ(coupling.smooth, 0.5);
  ASSERT_TRUE(coupling.gap);
  EXPECT_DOUBLE_EQ((*coupling.gap)[0], 2.0);
  EXPECT_DOUBLE_EQ((*coupling.gap)[1], 10.0);
  for (const char* wrong : {R"({"gap": [0.002]})", R"({"gap": [-1, 2]})", R"({"smooth": -1})"})
    EXPECT_FALSE(parse_slits(with("/coupling", json::parse(wrong)).dump(), "s.json", {})) << wrong;
}

}  // namespace
}  // namespace planish::job
