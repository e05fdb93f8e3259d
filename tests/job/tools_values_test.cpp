#include "job/job_requests.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

// Every value of a tools file changes some answer: none is read in vain. A value that is added to
// the format fails here until a change of it is known that matters.

namespace planish::job {
namespace {

using nlohmann::json;

json tools_of_shop() {
  return json::parse(R"({ "format": "planish/tools", "version": 1, "units": "mm",
    "machine": { "name": "small", "force": 300, "length": 1000,
      "upper_beam": [[-60,120],[60,120],[60,400],[-60,400]],
      "lower_beam": [[-45,-300],[45,-300],[45,-100],[-45,-100]],
      "gauge": { "range": [5, 700], "finger_width": 40, "lift": [-40, 80],
                 "finger": [[0,0],[0,-20],[80,-20],[80,0]] } },
    "punches": [ { "id": "P", "profile": [[0,0],[6,6.2],[6,120],[-6,120],[-6,6.2]],
      "tip_radius": 1.0, "angle": 88, "segments": [100,50,40,20], "max_force": 1000,
      "raises_beam": 0 } ],
    "dies": [ { "id": "V", "opening": 12, "angle": 86, "shoulder_radius": 1,
      "profile": [[-6,0],[-10,0],[-10,-100],[10,-100],[10,0],[6,0],[0,-6.5]],
      "segments": [100,50,40,20], "max_force": 600 } ] })");
}

/// Valid values that matter to some part, by where they are.
const std::map<std::string, json>& changes() {
  static const std::map<std::string, json> all{
      {"/units", "inch"},
      {"/machine/force", 5},
      {"/machine/length", 90},
      {"/machine/upper_beam", {{-60, 20}, {60, 20}, {60, 400}, {-60, 400}}},
      {"/machine/lower_beam", {{-45, -300}, {45, -300}, {45, -6}, {-45, -6}}},
      {"/machine/gauge/range", {40, 700}},
      {"/machine/gauge/finger_width", 201},
      {"/machine/gauge/lift", {0, 0}},
      {"/machine/gauge/finger", {{0, 0}, {-30, -1}, {-30, -20}, {80, -20}, {80, 0}}},
      {"/punches/0/id", "Q"},
      {"/punches/0/profile",
       {{0, 0}, {6, 6.2}, {40, 20}, {40, 120}, {-40, 120}, {-40, 20}, {-6, 6.2}}},
      {"/punches/0/tip_radius", 2.5},
      {"/punches/0/angle", 100},
      {"/punches/0/segments", {20}},
      {"/punches/0/max_force", 50},
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

/// The pointers of values, a list of numbers or of corners being one.
void collect(const json& value, const std::string& at, std::set<std::string>& found) {
  const bool is_list_of_objects = value.is_array() && !value.empty() && value[0].is_object();
  if (!value.is_object() && !is_list_of_objects) {
    found.insert(at);
    return;
  }
  for (const auto& [key, item] : value.items())
    collect(item, at + "/" + key, found);
}

/// Channels of legs that are short for the die, of any, and that nearly reach the beam, and a Z
/// whose second leg hangs beside the die.
std::vector<json> parts() {
  json high = test::channel_plates(110), low = test::channel_plates(30), z = low;
  for (json& corner : z["plates"][2]["outline"])
    corner[2] = -corner[2].get<double>();
  return {test::channel_plates(9.5), low, z, high};
}

/// What the plans of the parts say, without the words.
std::string answers(const json& tools) {
  std::string all;
  for (const json& part : parts()) {
    json asked{
        {"maker", "bend"},
        {"input", {{"name", "part.json"}, {"content", part}}},
        {"options", {{"tools", {{"name", "t.json"}, {"content", tools.dump()}}}, {"v", "wanted"}}}};
    const RunResult bent = test::done_by(asked);
    const json report = json::parse(bent.report);
    all += report.contains("plan") && report["plan"].is_object()
               ? report["plan"].dump()
               : report.value("reason", json()).dump();
  }
  return all;
}

TEST(ToolsValues, EachChangesSomeAnswer) {
  std::set<std::string> values;
  collect(tools_of_shop(), "", values);
  const std::string plain = answers(tools_of_shop());
  EXPECT_NE(plain.find("\"optimal\""), std::string::npos) << plain;
  for (const std::string& value : values) {
    if (kTold.contains(value)) continue;
    const auto change = changes().find(value);
    if (change == changes().end()) {
      ADD_FAILURE() << "say how " << value << " matters";
      continue;
    }
    json tools = tools_of_shop();
    tools[json::json_pointer(value)] = change->second;
    if (value == "/dies/0/opening") {  // its profile has that opening
      tools["dies"][0]["profile"][0][0] = -5;
      tools["dies"][0]["profile"][5][0] = 5;
    }
    const std::string changed = answers(tools);
    EXPECT_EQ(changed.find("bad_tools"), std::string::npos) << value << ": " << changed;
    EXPECT_NE(changed, plain) << value << " changes nothing";
  }
}

}  // namespace
}  // namespace planish::job
