#include "job/changed_values.hpp"
#include "job/job_requests.hpp"
#include "job/sample_reports.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/options.hpp>
#include <planish/shop/schemas.hpp>

#include <gtest/gtest.h>

// Every value of a shop profile changes some answer: none is read in vain.

namespace planish::job {
namespace {

using nlohmann::json;

/// Gauges give K as K, from a deduction and from an allowance. The layer of outer contours has the
/// name that the set of layers gives it.
json whole_shop() {
  return json::parse(R"({ "format": "planish/shop", "version": 1, "name": "S", "units": "mm",
    "thickness_tolerance": 0.05,
    "materials": [ { "name": "steel", "density": 7.85, "tensile_strength": 450, "gauges": [
      { "thickness": 1, "inside_radius": 1, "k": 0.4 },
      { "thickness": 1.5, "inside_radius": 1.5, "deduction": 2.518, "angle": 95,
        "deduction_to": "tangent_plane", "smallest_flange": 5, "smallest_opening": 1 },
      { "thickness": 2.02, "inside_radius": 2, "allowance": 4.4, "angle": 90 } ] } ],
    "dxf": { "profile": "default", "bend_lines": "dashed", "release": "r2000",
      "layers": { "outer": "OUTER_PROFILE", "openings": "B", "bend_up": "C", "bend_down": "D",
                  "bend_zone": "E", "features": "F", "slits": "G" } },
    "rules": { "strict": true, "flange_height_t": 1, "flange_height_r": 1, "opening_to_bend_t": 0.5,
      "opening_to_edge_t": 0.5, "opening_to_opening_t": 0.5, "opening_to_opening_mm": 0.5,
      "smallest_opening_t": 0.1, "inside_radius_t": 2, "relief_width_t": 0.1,
      "relief_depth_r": 0.1, "relief_depth_t": 0.1, "hem_diameter_t": 0.1, "hem_return_t": 1,
      "k_low": 0.1, "k_high": 0.9 },
    "limits": { "sheet": [3000, 1500], "smallest_part": [5, 5], "longest_bend": 2500,
                "most_bends": 20 },
    "tools": { "punches": ["P88-R1", "P88-R2"], "dies": ["V12-88", "V16-88"] } })");
}

/// Valid values that matter to some part, by where they are.
test::ValuesAt shop_changes() {
  test::ValuesAt all{{"/name", "T"},
                     {"/units", "inch"},
                     {"/thickness_tolerance", 0.01},
                     {"/materials/0/name", "iron"},
                     {"/materials/0/density", 7.7},
                     {"/materials/0/tensile_strength", 500},
                     {"/materials/0/gauges/0/thickness", 1.1},
                     {"/materials/0/gauges/0/inside_radius", 1.3},
                     {"/materials/0/gauges/0/k", 0.41},
                     {"/materials/0/gauges/1/thickness", 1.4},
                     {"/materials/0/gauges/1/inside_radius", 1.6},
                     {"/materials/0/gauges/1/deduction", 2.4},
                     {"/materials/0/gauges/1/angle", 94},
                     {"/materials/0/gauges/1/deduction_to", "mould_line"},
                     {"/materials/0/gauges/1/smallest_flange", 50},
                     {"/materials/0/gauges/1/smallest_opening", 20},
                     {"/materials/0/gauges/2/thickness", 2.03},
                     {"/materials/0/gauges/2/inside_radius", 2.1},
                     {"/materials/0/gauges/2/allowance", 4.5},
                     {"/materials/0/gauges/2/angle", 91},
                     {"/dxf/profile", "inventor"},
                     {"/dxf/bend_lines", "continuous"},
                     {"/dxf/release", "r12"},
                     {"/rules/strict", false},
                     {"/rules/k_low", 0.7},
                     {"/rules/k_high", 0.2},
                     {"/limits/sheet", {90, 40}},
                     {"/limits/smallest_part", {500, 500}},
                     {"/limits/longest_bend", 10},
                     {"/limits/most_bends", 1},
                     {"/tools/punches", {"P88-R1"}},
                     {"/tools/dies", {"V16-88"}}};
  const json plain = whole_shop();
  for (const auto& [rule, value] : plain["rules"].items())
    if (const std::string at = "/rules/" + rule; !all.contains(at)) all[at] = 30;
  for (const auto& [layer, name] : plain["dxf"]["layers"].items())
    all["/dxf/layers/" + layer] = "X";
  return all;
}

/// The set of layers names the one that is left out here, as the profile does until then.
const std::map<std::string, test::ValuesAt> kBesideInShop{{"/dxf/profile",
                                                           {{"/dxf/layers",
                                                             {{"openings", "B"},
                                                              {"bend_up", "C"},
                                                              {"bend_down", "D"},
                                                              {"bend_zone", "E"},
                                                              {"features", "F"},
                                                              {"slits", "G"}}}}}};

/// A plate of 2 mm with a flange that is narrower, slots of 1 by 1.5 at its ends, and two holes
/// that are near to all.
Sheet notched_plate() {
  test::SheetBuilder builder(2.0);
  const FaceId plate = builder.flange(
      Frame{}, {test::polygon({{0, 0},
                               {20, 0},
                               {20, 1.5},
                               {21, 1.5},
                               {21, 0},
                               {59, 0},
                               {59, 1.5},
                               {60, 1.5},
                               {60, 0},
                               {80, 0},
                               {80, 60},
                               {0, 60}}),
                test::circular_opening({40, 8}, 2.0), test::circular_opening({47, 8}, 2.0)});
  builder.flange_behind(builder.bend(builder.rim(plate, 4), {Angle::degrees(90), 2.5}),
                        {test::rectangle(38, 25)});
  return builder.finish();
}

/// Parts of each gauge, with all that there are rules for.
std::vector<std::pair<std::string, std::string>> parts_for_shop() {
  test::Opened opened;
  opened.thickness = 1.5;
  opened.turn = {Angle::degrees(90), 2.0, BendDirection::up};
  std::vector<std::pair<std::string, std::string>> all;
  for (const Sheet& sheet :
       {test::hem(), test::two_flaps(), test::slot_across_bend(12.0, opened), notched_plate()})
    all.emplace_back("unfold", folded_solid_step(sheet, "part").value());
  json plates = test::channel_plates(30);
  plates.erase("defaults");  // then the gauge has the radius
  all.emplace_back("connect", plates.dump());
  all.emplace_back("bend", plates.dump());
  return all;
}

/// The drawing of one of each thing that has a layer.
std::string layered_drawing(const std::string& shop) {
  OptionValues values;
  values.set(option("shop"), OptionFile{"shop.json", shop});
  Request request;
  EXPECT_TRUE(values.enter(request));
  FlatPattern pattern = test::sample_pattern();
  pattern.bends.push_back(pattern.bends[0]);
  pattern.bends[1].direction = BendDirection::up;
  pattern.bends[1].tangent_lines = {Segment{{45, 0}, {45, 60}}};
  pattern.features = {{"formed", FormSide::up, {pattern.openings[0].loop}}};
  pattern.slits = {Segment{{10, 10}, {20, 10}}};
  request.dxf.tangent_lines = true;
  return dxf_text(pattern, request.dxf).value();
}

/// Without the texts that tell where a K comes from, which repeat what the profile says.
json without_sources(json report) {
  for (const char* key : {"k_source", "source"})
    if (report.is_object()) report.erase(key);
  if (report.is_structured())
    for (json& item : report)
      item = without_sources(std::move(item));
  return report;
}

/// Reports of all parts, and the drawing.
std::string answers_of_shop(const json& shop) {
  static const auto made = parts_for_shop();
  std::string all = layered_drawing(shop.dump());
  for (const auto& [maker, content] : made) {
    const std::string name = maker == "unfold" ? "part.step" : "part.json";
    const RunResult done = test::done_by(
        {{"maker", maker},
         {"input", {{"name", name}, {"content", content}}},
         {"options", {{"shop", {{"name", "s.json"}, {"content", shop}}}}}});
    const json report = json::parse(done.report);
    EXPECT_TRUE(report["reason"].is_null() || report["reason"]["code"] == "cannot_bend") << report;
    all += without_sources(report).dump();
  }
  return all;
}

TEST(ShopValues, EachChangesSomeAnswer) {
  test::expect_each_changes_some_answer({shop::shop_schema(),
                                         whole_shop(),
                                         shop_changes(),
                                         kBesideInShop,
                                         {"/format", "/version"},
                                         answers_of_shop});
}

}  // namespace
}  // namespace planish::job
