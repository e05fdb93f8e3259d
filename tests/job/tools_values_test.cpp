#include "job/changed_values.hpp"
#include "job/job_requests.hpp"

#include <planish/shop/schemas.hpp>

#include <gtest/gtest.h>

// Every value of a tools file changes some answer: none is read in vain.

namespace planish::job {
namespace {

using nlohmann::json;

json tools_of_shop() {
  return json::parse(R"({ "format": "planish/tools", "version": 1, "units": "mm",
    "machine": { "name": "small", "force": 300, "length": 1000,
      "upper_beam": [[-60,120],[60,120],[60,400],[-60,400]],
      "lower_beam": [[-45,-300],[45,-300],[45,-100],[-45,-100]],
      "gauge": { "range": [5, 700], "finger_width": 40, "lift": [-40, 80],
                 "finger": [[0,0],[0,-20],[80,-20],[80,0]],
                 "nose": { "width": 10,
                           "profile": [[0,0],[0,-3],[6,-3],[6,2],[80,2],[80,20],[0,20]] } } },
    "punches": [ { "id": "P", "profile": [[0,0],[6,6.2],[6,120],[-6,120],[-6,6.2]],
      "tip_radius": 1.0, "angle": 88, "segments": [100,50,40,20], "max_force": 1000,
      "ears": { "left": 30, "right": 30, "height": 20, "reach": 25 }, "raises_beam": 0 } ],
    "dies": [ { "id": "V", "opening": 12, "angle": 86, "shoulder_radius": 1,
      "profile": [[-6,0],[-10,0],[-10,-100],[10,-100],[10,0],[6,0],[0,-6.5]],
      "segments": [100,50,40,20], "max_force": 600 } ] })");
}

/// Valid values that matter to some part, by where they are.
const test::ValuesAt& changes() {
  static const test::ValuesAt all{
      {"/units", "inch"},
      {"/machine/force", 5},
      {"/machine/length", 90},
      {"/machine/upper_beam", {{-60, 20}, {60, 20}, {60, 400}, {-60, 400}}},
      {"/machine/lower_beam", {{-45, -300}, {45, -300}, {45, -6}, {-45, -6}}},
      {"/machine/gauge/range", {40, 700}},
      {"/machine/gauge/finger_width", 201},
      {"/machine/gauge/lift", {0, 0}},
      {"/machine/gauge/finger", {{0, 0}, {-30, -1}, {-30, -20}, {80, -20}, {80, 0}}},
      {"/machine/gauge/nose/width", 31},
      {"/machine/gauge/nose/profile", {{0, 0}, {0, -3}, {16, -3}, {16, 20}}},
      {"/punches/0/id", "Q"},
      {"/punches/0/profile",
       {{0, 0}, {6, 6.2}, {40, 20}, {40, 120}, {-40, 120}, {-40, 20}, {-6, 6.2}}},
      {"/punches/0/tip_radius", 2.5},
      {"/punches/0/angle", 100},
      {"/punches/0/segments", {20}},
      {"/punches/0/max_force", 50},
      {"/punches/0/ears/left", 0},
      {"/punches/0/ears/right", 0},
      {"/punches/0/ears/height", 60},
      {"/punches/0/ears/reach", 5},
      {"/punches/0/raises_beam", 40},
      {"/dies/0/id", "W"},
      {"/dies/0/opening", 10},
      {"/dies/0/angle", 100},
      {"/dies/0/shoulder_radius", 3},
      {"/dies/0/profile",
       {{-6, 0},
        {-10, 0},
        {-200, -10},
        {-200, -100},
        {200, -100},
        {200, -10},
        {10, 0},
        {6, 0},
        {0, -6.5}}},
      {"/dies/0/segments", {20}},
      {"/dies/0/max_force", 50}};
  return all;
}

/// For people alone, or the format itself.
const std::set<std::string> kTold{"/format", "/version", "/machine/name"};

/// The profile of the die has its opening.
const std::map<std::string, test::ValuesAt> kBeside{
    {"/dies/0/opening", {{"/dies/0/profile/0/0", -5}, {"/dies/0/profile/5/0", 5}}}};

/// A web of 60 whose only stop is an opening of 30 by 10 behind a bend, since its far edge and that
/// of the flange are slanted.
json opened() {
  json plates;
  plates["thickness"] = 2;
  plates["defaults"]["inside_radius"] = 2;
  plates["plates"] = {
      {{"id", "web"},
       {"outline", {{0, 5, 0}, {60, 5, 0}, {60, 90, 0}, {0, 99, 0}}},
       {"holes", {{{15, 50, 0}, {45, 50, 0}, {45, 60, 0}, {15, 60, 0}}}}},
      {{"id", "flange"}, {"outline", {{0, 0, 5}, {60, 0, 5}, {60, 0, 40}, {0, 0, 49}}}}};
  plates["bends"] = {{{"between", {"web", "flange"}}}};
  return plates;
}

json plate(const std::string& id, const json& outline) {
  return {{"id", id}, {"outline", outline}};
}

/// A flap in front of a base, bent between walls with lips 50 above it.
json lipped() {
  json plates;
  plates["thickness"] = 2;
  plates["defaults"]["inside_radius"] = 2;
  plates["plates"] = {
      plate("base", {{5, 5, 0}, {115, 5, 0}, {115, 80, 0}, {5, 80, 0}}),
      plate("flap", {{5, 0, 5}, {115, 0, 5}, {115, 0, 25}, {5, 0, 25}}),
      plate("left", {{0, 5, 5}, {0, 80, 5}, {0, 80, 45}, {0, 5, 45}}),
      plate("right", {{120, 5, 5}, {120, 80, 5}, {120, 80, 45}, {120, 5, 45}}),
      plate("left lip", {{5, 5, 50}, {20, 5, 50}, {20, 80, 50}, {5, 80, 50}}),
      plate("right lip", {{115, 5, 50}, {100, 5, 50}, {100, 80, 50}, {115, 80, 50}})};
  for (const auto& [one, other] : {std::pair("base", "flap"),
                                   {"base", "left"},
                                   {"base", "right"},
                                   {"left", "left lip"},
                                   {"right", "right lip"}})
    plates["bends"].push_back({{"between", {one, other}}});
  return plates;
}

/// Channels of legs that are short for the die, of any, and that nearly reach the beam, and a Z
/// whose second leg hangs beside the die; what is gauged in an opening, and what is bent between
/// lips.
std::vector<json> parts() {
  json high = test::channel_plates(110), low = test::channel_plates(30), z = low;
  for (json& corner : z["plates"][2]["outline"])
    corner[2] = -corner[2].get<double>();
  return {test::channel_plates(9.5), low, z, high, opened(), lipped()};
}

/// What the plans of the parts say, without the words.
std::string answers(const json& tools) {
  std::string all;
  for (const json& part : parts()) {
    json asked{{"maker", "bend"},
               {"input", {{"name", "part.json"}, {"content", part}}},
               {"options",
                {{"tools", {{"name", "t.json"}, {"content", tools.dump()}}},
                 {"v", "wanted"},
                 {"gauge_openings", true}}}};
    if (part == lipped()) asked["options"]["fix"] = "B4,B5,B2,B3,B1";
    const RunResult bent = test::done_by(asked);
    const json report = json::parse(bent.report);
    const bool planned = report.contains("plan") && report["plan"].is_object();
    const json& answer = planned ? report["plan"] : report["reason"];
    EXPECT_NE(answer.value("code", ""), "bad_tools") << answer;
    all += answer.dump();
  }
  return all;
}

TEST(ToolsValues, EachChangesSomeAnswer) {
  EXPECT_NE(answers(tools_of_shop()).find("\"optimal\""), std::string::npos);
  test::expect_each_changes_some_answer(
      {shop::tools_schema(), tools_of_shop(), changes(), kBeside, kTold, answers});
}

}  // namespace
}  // namespace planish::job
