#include <planish/brake/codes.hpp>
#include <planish/geometry/region.hpp>
#include <planish/shop/tools_json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <numeric>

namespace planish::shop {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The example of the format's description: its finger runs clockwise.
json example() {
  return json::parse(R"({ "format": "planish/tools", "version": 1, "units": "mm",
    "machine": { "name": "100 t, 3 m", "force": 1000, "length": 3060,
      "upper_beam": [[-60,120],[60,120],[60,400],[-60,400]],
      "lower_beam": [[-45,-300],[45,-300],[45,-100],[-45,-100]],
      "gauge": { "range": [5, 700], "finger_width": 40, "lift": [-40, 80],
                 "finger": [[0,0],[80,0],[80,-20],[0,-20]] } },
    "punches": [ { "id": "P88", "profile": [[0,0],[12,12.4],[12,120],[-12,120],[-12,12.4]],
      "tip_radius": 1.0, "angle": 88, "segments": [515,200,100,50], "max_force": 1000 } ],
    "dies": [ { "id": "V16", "opening": 16, "angle": 86, "shoulder_radius": 2,
      "profile": [[-8,0],[-30,0],[-30,-100],[30,-100],[30,0],[8,0],[0,-8.5]],
      "segments": [515,200,100,50], "max_force": 600 } ] })");
}

Error refusal_of(const std::function<void(json&)>& change) {
  json tools = example();
  change(tools);
  const auto read = parse_tools(tools.dump(), "t.json");
  EXPECT_FALSE(read.has_value()) << tools.dump();
  return read ? Error{} : read.error();
}

TEST(ToolsJson, ReadsTheExampleOfTheFormat) {
  const auto tools = parse_tools(example().dump(), "t.json");
  ASSERT_TRUE(tools.has_value()) << tools.error().message;
  EXPECT_EQ(tools->machine.name, "100 t, 3 m");
  EXPECT_EQ(tools->machine.force, 1000.0);
  EXPECT_EQ(tools->machine.length, 3060.0);
  EXPECT_EQ(tools->machine.upper_beam.size(), 4u);
  ASSERT_TRUE(tools->machine.gauge.has_value());
  EXPECT_EQ(tools->machine.gauge->from, 5.0);
  EXPECT_EQ(tools->machine.gauge->to, 700.0);
  EXPECT_EQ(tools->machine.gauge->finger_width, 40.0);
  EXPECT_EQ(tools->machine.gauge->lowest, -40.0);
  EXPECT_EQ(tools->machine.gauge->highest, 80.0);
  ASSERT_EQ(tools->punches.size(), 1u);
  EXPECT_EQ(tools->punches[0].id, "P88");
  EXPECT_EQ(tools->punches[0].profile[1], Vec2(12, 12.4));
  EXPECT_EQ(tools->punches[0].tip_radius, 1.0);
  EXPECT_NEAR(tools->punches[0].angle.degrees(), 88.0, 1e-12);
  EXPECT_THAT(tools->punches[0].segments, ElementsAre(515, 200, 100, 50));
  EXPECT_EQ(tools->punches[0].max_force, 1000.0);
  ASSERT_EQ(tools->dies.size(), 1u);
  EXPECT_EQ(tools->dies[0].opening, 16.0);
  EXPECT_EQ(tools->dies[0].shoulder_radius, 2.0);
}

TEST(ToolsJson, ReadsANose) {
  json nosed = example();
  EXPECT_FALSE(parse_tools(nosed.dump(), "t.json")->machine.gauge->nose);
  nosed["units"] = "inch";
  nosed["machine"]["gauge"]["nose"] = {{"width", 10}, {"profile", {{0, 0}, {6, 2}, {6, -3}}}};
  const auto tools = parse_tools(nosed.dump(), "t.json");
  ASSERT_TRUE(tools.has_value()) << tools.error().message;
  ASSERT_TRUE(tools->machine.gauge->nose);
  EXPECT_NEAR(tools->machine.gauge->nose->width, 254.0, 1e-9);
  EXPECT_GT(ring_area(tools->machine.gauge->nose->profile), 0.0) << "it runs clockwise in the file";
  const Error flat = refusal_of([](json& given) {
    given["machine"]["gauge"]["nose"] = {{"width", 10}, {"profile", {{0, 1}, {6, 1}, {6, -3}}}};
  });
  EXPECT_EQ(flat.code, code::bad_tools);
  EXPECT_THAT(flat.where, HasSubstr("/machine/gauge/nose/profile"));
}

/// The built-in nose fits openings from 10 by 7 on in sheet of the usual thicknesses.
TEST(ToolsJson, HasANoseAmongTheBuiltInTools) {
  const auto& nose = default_tools().machine.gauge->nose;
  ASSERT_TRUE(nose);
  EXPECT_EQ(nose->width, 10.0);
  for (const Vec2& corner : nose->profile) {
    EXPECT_GE(corner.x(), 0.0);
    EXPECT_TRUE(corner.x() <= 6.0 || corner.y() <= -8.0) << "below all sheets of 8 mm, which rise";
  }
}

TEST(ToolsJson, TurnsProfilesCounterClockwise) {
  json clockwise = example();
  for (const char* kind : {"/punches/0/profile", "/dies/0/profile", "/machine/upper_beam"}) {
    json& profile = clockwise[json::json_pointer(kind)];
    std::ranges::reverse(profile);
  }
  const auto tools = parse_tools(clockwise.dump(), "t.json");
  ASSERT_TRUE(tools.has_value()) << tools.error().message;
  for (const ToolProfile* profile :
       {&tools->punches[0].profile, &tools->dies[0].profile, &tools->machine.upper_beam,
        &tools->machine.lower_beam, &tools->machine.gauge->finger})
    EXPECT_GT(ring_area(*profile), 0.0);
}

TEST(ToolsJson, TakesLengthsInTheUnitOfTheFile) {
  json inches = example();
  inches["units"] = "inch";
  const auto mm = parse_tools(example().dump(), "t.json");
  const auto tools = parse_tools(inches.dump(), "t.json");
  ASSERT_TRUE(tools.has_value()) << tools.error().message;
  EXPECT_NEAR(tools->dies[0].opening, 16 * 25.4, 1e-9);
  EXPECT_NEAR(tools->dies[0].shoulder_radius, 2 * 25.4, 1e-9);
  EXPECT_NEAR(tools->punches[0].tip_radius, 25.4, 1e-9);
  EXPECT_NEAR(tools->punches[0].segments[3], 50 * 25.4, 1e-9);
  EXPECT_NEAR(tools->machine.length, 3060 * 25.4, 1e-9);
  EXPECT_NEAR(tools->machine.gauge->to, 700 * 25.4, 1e-9);
  EXPECT_NEAR(tools->punches[0].profile[1].y(), 12.4 * 25.4, 1e-9);
  EXPECT_EQ(tools->punches[0].angle, mm->punches[0].angle);
  EXPECT_EQ(tools->punches[0].max_force, mm->punches[0].max_force);
  EXPECT_EQ(tools->machine.force, mm->machine.force);
}

TEST(ToolsJson, TakesAnOpeningThatWasRoundedInInches) {
  json inches = example();
  const auto rounded = [](const json& mm) {
    return std::round(mm.get<double>() / 25.4 * 1e6) / 1e6;
  };
  inches["units"] = "inch";
  for (json& corner : inches["dies"][0]["profile"])
    corner = {rounded(corner[0]), rounded(corner[1])};
  inches["dies"][0]["opening"] = rounded(16);
  inches["dies"][0]["shoulder_radius"] = rounded(2);
  const auto tools = parse_tools(inches.dump(), "t.json");
  EXPECT_TRUE(tools.has_value()) << tools.error().message;
}

TEST(ToolsJson, DoesWithoutBeamsGaugeNameAndForceOfTools) {
  json bare = example();
  for (const char* key : {"name", "upper_beam", "lower_beam", "gauge"})
    bare["machine"].erase(key);
  bare["punches"][0].erase("max_force");
  bare["dies"][0].erase("max_force");
  const auto tools = parse_tools(bare.dump(), "t.json");
  ASSERT_TRUE(tools.has_value()) << tools.error().message;
  EXPECT_FALSE(tools->machine.gauge.has_value());
  EXPECT_TRUE(tools->machine.upper_beam.empty());
  EXPECT_FALSE(tools->punches[0].max_force.has_value());
}

TEST(ToolsJson, NamesWhatIsMissing) {
  for (const auto& [kind, keys] : std::map<std::string, std::vector<std::string>>{
           {"punches", {"id", "profile", "tip_radius", "angle", "segments"}},
           {"dies", {"id", "profile", "opening", "shoulder_radius", "angle", "segments"}}})
    for (const std::string& key : keys) {
      const Error error = refusal_of([&](json& t) { t[kind][0].erase(key); });
      EXPECT_EQ(error.code, code::invalid_input);
      EXPECT_THAT(error.where, HasSubstr("t.json/" + kind + "/0"));
      EXPECT_THAT(error.message, HasSubstr(key));
    }
  for (const char* key : {"force", "length"})
    EXPECT_THAT(refusal_of([&](json& t) { t["machine"].erase(key); }).message, HasSubstr(key));
}

TEST(ToolsJson, NamesWhatIsOutOfRange) {
  const auto expect_at = [](const std::string& pointer, const json& value) {
    const Error error = refusal_of([&](json& t) { t[json::json_pointer(pointer)] = value; });
    EXPECT_EQ(error.where, "t.json" + pointer) << value;
  };
  expect_at("/punches", json::array());
  expect_at("/dies", json::array());
  expect_at("/punches/0/segments", json::array());
  expect_at("/punches/0/segments/2", 0);
  expect_at("/punches/0/segments/2", "long");
  expect_at("/punches/0/angle", 181);
  expect_at("/punches/0/angle", 0);
  expect_at("/punches/0/tip_radius", -1);
  expect_at("/dies/0/opening", -16);
  expect_at("/dies/0/max_force", 0);
  expect_at("/machine/force", 0);
  expect_at("/machine/gauge/range", {700, 5});
  expect_at("/machine/gauge/range", {5});
  expect_at("/machine/gauge/lift", {80, -40});
  expect_at("/machine/gauge/lift", {5});
  expect_at("/machine/gauge/finger_width", 0);
  expect_at("/punches/0/profile", {{0, 0}, {1, 1}});
}

TEST(ToolsJson, NamesWhatCannotBeByItsPointer) {
  const Error tip = refusal_of([](json& t) {
    for (json& corner : t["punches"][0]["profile"])
      corner[1] = corner[1].get<double>() + 1.0;
  });
  EXPECT_EQ(tip.code, code::bad_tools);
  EXPECT_EQ(tip.where, "t.json/punches/0/profile");
  EXPECT_EQ(tip.message,
            "tools file: the profile of punch \"P88\" has no corner at (0, 0), where the tip is. "
            "Move it so that its tip is there.");
  const Error opening = refusal_of([](json& t) { t["dies"][0]["opening"] = 12; });
  EXPECT_EQ(opening.code, code::bad_tools);
  EXPECT_EQ(opening.where, "t.json/dies/0/opening");
  const Error twice = refusal_of([](json& t) { t["dies"].push_back(t["dies"][0]); });
  EXPECT_EQ(twice.where, "t.json/dies/1/id");
}

TEST(ToolsJson, CountsTheCornersOfTheFileInAProfileThatItTurns) {
  // Run clockwise from the tip: corner 3, at the right, is too low.
  const Error low = refusal_of([](json& t) {
    t["punches"][0]["profile"] = {{0, 0}, {-12, 12.4}, {-12, 120}, {12, 120}, {12, -1}};
  });
  EXPECT_EQ(low.where, "t.json/punches/0/profile/4");
}

TEST(ToolsJson, RefusesUnknownKeysAndOtherFormats) {
  EXPECT_EQ(refusal_of([](json& t) { t["punches"][0]["color"] = "red"; }).where,
            "t.json/punches/0/color");
  EXPECT_EQ(refusal_of([](json& t) { t["format"] = "planish/rules"; }).where, "t.json/format");
  EXPECT_EQ(parse_tools("{", "t.json").error().where, "t.json:1:1");
}

TEST(DefaultTools, AreSetsOfThePromecamKind) {
  const BrakeTools& tools = default_tools();
  ASSERT_TRUE(check(tools));
  for (const Punch& punch : tools.punches) {
    // One set of 835 mm in pieces; with the whole ones it fills the machine.
    std::vector<double> set;
    for (const double length : punch.segments)
      if (length < 415.0) set.push_back(length);
    if (punch.ears) set.insert(set.end(), {punch.ears->left, punch.ears->right});
    EXPECT_EQ(std::accumulate(set.begin(), set.end(), 0.0), 835.0);
    EXPECT_GE(std::accumulate(punch.segments.begin(), punch.segments.end(), 0.0),
              tools.machine.length);
  }
}

TEST(DefaultTools, HaveWhatCommonWorkTakes) {
  const BrakeTools& tools = default_tools();
  const auto punch = [&](double angle, double radius) {
    return std::ranges::any_of(tools.punches, [&](const Punch& one) {
      return std::abs(one.angle.degrees() - angle) < 1e-9 && one.tip_radius == radius;
    });
  };
  for (const double radius : {0.2, 0.6, 0.8, 1.0, 2.0, 3.0})
    EXPECT_TRUE(punch(88, radius) && punch(85, radius)) << radius;
  EXPECT_TRUE(punch(30, 0.8) && punch(26, 0.8) && punch(180, 0.0));
  const auto die = [&](double angle, double opening) {
    return std::ranges::any_of(tools.dies, [&](const Die& one) {
      return std::abs(one.angle.degrees() - angle) < 1e-9 && one.opening == opening;
    });
  };
  for (const double opening : {6, 8, 10, 12, 16, 20, 25, 32, 40, 50})
    EXPECT_TRUE(die(85, opening)) << opening;
  for (const double opening : {6, 8, 10, 12, 16, 20, 25})
    EXPECT_TRUE(die(88, opening) && die(30, opening)) << opening;
  EXPECT_TRUE(die(180, 0));
}

TEST(DefaultTools, HaveTheAnglesThatTheyAreDrawnWith) {
  const auto degrees = [](const Vec2& a, const Vec2& b) {
    return std::acos(a.normalized().dot(b.normalized())) * 180.0 / std::numbers::pi;
  };
  for (const Punch& punch : default_tools().punches) {
    if (flattens(punch.angle)) continue;
    EXPECT_EQ(punch.profile[0], Vec2(0, 0)) << punch.id;
    EXPECT_NEAR(degrees(punch.profile[1], punch.profile.back()), punch.angle.degrees(), 0.02)
        << punch.id;
  }
  for (const Die& die : default_tools().dies) {
    if (flattens(die.angle)) continue;
    const Vec2& bottom = die.profile.back();
    const Vec2 half(0.5 * die.opening, 0.0);
    EXPECT_NEAR(degrees(half - bottom, -half - bottom), die.angle.degrees(), 0.02) << die.id;
  }
}

}  // namespace
}  // namespace planish::shop
