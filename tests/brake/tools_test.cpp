#include "support/error_data.hpp"

#include <planish/brake/codes.hpp>
#include <planish/brake/tools.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace planish {
namespace {

BrakeTools sound_tools() {
  BrakeTools tools;
  tools.machine = {.name = "100 t, 3 m",
                   .force = 1000.0,
                   .length = 3060.0,
                   .upper_beam = {{-60, 120}, {60, 120}, {60, 400}, {-60, 400}},
                   .lower_beam = {{-45, -300}, {45, -300}, {45, -100}, {-45, -100}},
                   .gauge = BackGauge{5.0, 700.0, 40.0, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}}};
  tools.punches = {{.id = "P88",
                    .profile = {{0, 0}, {12, 12.4}, {12, 120}, {-12, 120}, {-12, 12.4}},
                    .tip_radius = 1.0,
                    .angle = Angle::degrees(88),
                    .segments = {515, 200, 100},
                    .max_force = 1000.0}};
  tools.dies = {
      {.id = "V16",
       .opening = 16.0,
       .angle = Angle::degrees(86),
       .shoulder_radius = 2.0,
       .profile = {{-8, 0}, {-30, 0}, {-30, -100}, {30, -100}, {30, 0}, {8, 0}, {0, -8.5}},
       .segments = {515, 200, 100},
       .max_force = 600.0}};
  return tools;
}

BrakeTools with_flat_tools() {
  BrakeTools tools = sound_tools();
  tools.punches.push_back({.id = "flat",
                           .profile = {{-20, 0}, {20, 0}, {20, 120}, {-20, 120}},
                           .angle = Angle::degrees(180),
                           .segments = {835}});
  tools.dies.push_back({.id = "anvil",
                        .angle = Angle::degrees(180),
                        .profile = {{-30, 0}, {-30, -100}, {30, -100}, {30, 0}},
                        .segments = {835}});
  return tools;
}

/// What is said of sound tools once something in them has been changed.
Error said_of(const std::function<void(BrakeTools&)>& change) {
  BrakeTools tools = with_flat_tools();
  change(tools);
  const auto checked = check(tools);
  return checked ? Error{code::internal, "nothing is wrong", ""} : checked.error();
}

void expect_wrong(const std::string& where, const std::string& part,
                  const std::function<void(BrakeTools&)>& change) {
  const Error said = said_of(change);
  EXPECT_EQ(said.code, code::bad_tools);
  EXPECT_EQ(said.where, where) << said.message;
  EXPECT_NE(said.message.find(part), std::string::npos) << said.message;
  EXPECT_TRUE(test::is_told(said)) << said.message;
  EXPECT_EQ(test::pointers_in(said), std::vector<std::string>{where});
  EXPECT_EQ(said.remedies.size(), 1u) << said.message;
}

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(CheckTools, PassesSoundTools) {
  EXPECT_TRUE(check(sound_tools()));
  EXPECT_TRUE(check(with_flat_tools()));
  BrakeTools bare = sound_tools();
  bare.machine.upper_beam.clear();
  bare.machine.lower_beam.clear();
  bare.machine.gauge.reset();
  bare.punches[0].max_force.reset();
  EXPECT_TRUE(check(bare));
}

TEST(CheckTools, TakesACatalogueWithoutToolsForEmpty) {
  expect_wrong("/punches", "no punch", [](BrakeTools& t) { t.punches.clear(); });
  expect_wrong("/dies", "no die", [](BrakeTools& t) { t.dies.clear(); });
}

TEST(CheckTools, FindsWhatTheMachineCannotBe) {
  for (const double value : {0.0, -5.0, kNotANumber, kInfinite}) {
    expect_wrong("/machine/force", "force", [&](BrakeTools& t) { t.machine.force = value; });
    expect_wrong("/machine/length", "length", [&](BrakeTools& t) { t.machine.length = value; });
    expect_wrong("/machine/gauge/finger_width", "finger_width",
                 [&](BrakeTools& t) { t.machine.gauge->finger_width = value; });
  }
  expect_wrong("/machine/gauge/range", "before it begins",
               [](BrakeTools& t) { t.machine.gauge->to = 4.0; });
  expect_wrong("/machine/gauge/lift", "before it begins",
               [](BrakeTools& t) { t.machine.gauge->highest = -1.0; });
  expect_wrong("/machine/gauge/range/0", "0 or more",
               [](BrakeTools& t) { t.machine.gauge->from = -1.0; });
}

TEST(CheckTools, FindsBeamsOnTheWrongSideOfTheSheet) {
  expect_wrong("/machine/upper_beam/0", "lower than the tip",
               [](BrakeTools& t) { t.machine.upper_beam[0].y() = -1.0; });
  expect_wrong("/machine/lower_beam/2", "higher than its top",
               [](BrakeTools& t) { t.machine.lower_beam[2].y() = 1.0; });
}

TEST(CheckTools, FindsAFingerAwayFromWhereItTouches) {
  expect_wrong("/machine/gauge/finger", "(0, 0)", [](BrakeTools& t) {
    for (Vec2& corner : t.machine.gauge->finger)
      corner.x() += 3.0;
  });
}

TEST(CheckTools, FindsANoseThatCannotTouch) {
  const auto nose = [](double width, ToolProfile profile) {
    return [=](BrakeTools& t) { t.machine.gauge->nose = GaugeNose{width, profile}; };
  };
  const ToolProfile hook{{0, 0}, {0, -3}, {6, -3}, {6, 2}, {80, 2}, {80, 20}, {0, 20}};
  EXPECT_EQ(said_of(nose(10.0, hook)).message, "nothing is wrong");
  for (const double width : {0.0, -1.0, kNotANumber})
    expect_wrong("/machine/gauge/nose/width", "width of the nose", nose(width, hook));
  expect_wrong("/machine/gauge/nose/profile", "nose", nose(10.0, {{0, 0}, {6, 0}}));
  expect_wrong("/machine/gauge/nose/profile", "(0, 0)", nose(10.0, {{1, 0}, {1, -3}, {6, -3}}));
}

TEST(CheckTools, FindsProfilesThatCrossThemselves) {
  expect_wrong("/punches/0/profile/2", "crosses", [](BrakeTools& t) {
    t.punches[0].profile = {{0, 0}, {12, 100}, {-12, 100}, {12, 20}};
  });
  expect_wrong("/dies/0/profile/3", "crosses", [](BrakeTools& t) {
    t.dies[0].profile = {{-8, 0}, {-30, 0}, {30, -100}, {-30, -100}, {30, 0}, {8, 0}, {0, -8.5}};
  });
}

TEST(CheckTools, FindsProfilesThatTouchThemselves) {
  // A corner on another edge, and an edge that runs back.
  expect_wrong("/punches/0/profile/2", "touches", [](BrakeTools& t) {
    t.punches[0].profile = {{0, 0}, {12, 12}, {12, 120}, {6, 6}, {-12, 120}, {-12, 12}};
  });
  expect_wrong("/punches/0/profile/3", "touches", [](BrakeTools& t) {
    t.punches[0].profile = {{0, 0}, {12, 12}, {12, 120}, {0, 150}, {0, 120}, {-12, 120}, {-12, 12}};
    t.punches[0].profile[2] = {0, 120};
  });
}

TEST(CheckTools, FindsProfilesThatEncloseNothing) {
  expect_wrong("/punches/0/profile", "at least 3",
               [](BrakeTools& t) { t.punches[0].profile.resize(2); });
  expect_wrong("/dies/0/profile", "at least 3", [](BrakeTools& t) { t.dies[0].profile.clear(); });
  expect_wrong("/punches/0/profile/0", "touches", [](BrakeTools& t) {
    t.punches[0].profile = {{0, 0}, {0, 50}, {0, 100}};
  });
}

TEST(CheckTools, FindsCornersThatAreNoPlaces) {
  expect_wrong("/punches/0/profile/2", "not finite or lies beyond 10 km",
               [](BrakeTools& t) { t.punches[0].profile[2].x() = kNotANumber; });
  expect_wrong("/machine/upper_beam/1", "not finite or lies beyond 10 km",
               [](BrakeTools& t) { t.machine.upper_beam[1].y() = kInfinite; });
  expect_wrong("/dies/0/profile/4", "not finite or lies beyond 10 km",
               [](BrakeTools& t) { t.dies[0].profile[4].y() = 1e9; });
}

TEST(CheckTools, FindsRepeatedCorners) {
  expect_wrong("/punches/0/profile/2", "two corners in a row", [](BrakeTools& t) {
    t.punches[0].profile.insert(t.punches[0].profile.begin() + 2, {12, 12.4});
  });
  expect_wrong("/punches/0/profile/5", "two corners in a row",
               [](BrakeTools& t) { t.punches[0].profile.emplace_back(0, 0); });
}

TEST(CheckTools, FindsProfilesThatRunClockwise) {
  expect_wrong("/punches/0/profile", "clockwise",
               [](BrakeTools& t) { std::ranges::reverse(t.punches[0].profile); });
}

TEST(CheckTools, FindsATipAwayFromTheOrigin) {
  expect_wrong("/punches/0/profile", "(0, 0)", [](BrakeTools& t) {
    for (Vec2& corner : t.punches[0].profile)
      corner.x() += 0.01;
  });
  expect_wrong("/punches/0/profile/1", "lower than the tip",
               [](BrakeTools& t) { t.punches[0].profile[1].y() = -0.5; });
  expect_wrong("/punches/0/profile/1", "second corner",
               [](BrakeTools& t) { t.punches[0].profile[1].y() = 0.0; });
}

TEST(CheckTools, FindsAnOpeningThatTheProfileDoesNotHave) {
  expect_wrong("/dies/0/opening", "no corner at (6, 0)",
               [](BrakeTools& t) { t.dies[0].opening = 12.0; });
  expect_wrong("/dies/0/opening", "no corner at (8, 0)",
               [](BrakeTools& t) { t.dies[0].profile[5].x() = 9.0; });
  expect_wrong("/dies/0/opening", "not open", [](BrakeTools& t) { t.dies[0].profile.pop_back(); });
  expect_wrong("/dies/0/profile/1", "higher than its top",
               [](BrakeTools& t) { t.dies[0].profile[1].y() = 2.0; });
  for (const double value : {0.0, -16.0, kNotANumber})
    expect_wrong("/dies/0/opening", "above 0", [&](BrakeTools& t) { t.dies[0].opening = value; });
}

TEST(CheckTools, HoldsRadiiAgainstTheEdgesThatTheyRound) {
  // A wedge of 90° with edges of 10 mm takes a radius of up to 10 mm, an edge's length.
  const auto wedge = [](double radius) {
    return [radius](BrakeTools& t) {
      const double side = 10.0 / std::sqrt(2.0);
      t.punches[0].profile = {{0, 0}, {side, side}, {side, 120}, {-side, 120}, {-side, side}};
      t.punches[0].tip_radius = radius;
    };
  };
  EXPECT_EQ(said_of(wedge(9.99)).code, code::internal);
  expect_wrong("/punches/0/tip_radius", "10.01 mm", wedge(10.01));
  expect_wrong("/punches/0/tip_radius", "0 or more", wedge(-1.0));
  // The shoulder turns by 46.7°, tan of half of which is 0.432, and its flank is 11.67 mm long.
  EXPECT_EQ(said_of([](BrakeTools& t) { t.dies[0].shoulder_radius = 26.9; }).code, code::internal);
  expect_wrong("/dies/0/shoulder_radius", "27.1 mm",
               [](BrakeTools& t) { t.dies[0].shoulder_radius = 27.1; });
}

TEST(CheckTools, FindsAnglesOutOfRange) {
  for (const double degrees : {0.0, -88.0, 180.1, kNotANumber}) {
    expect_wrong("/punches/0/angle", "at most 180",
                 [&](BrakeTools& t) { t.punches[0].angle = Angle::degrees(degrees); });
    expect_wrong("/dies/0/angle", "at most 180",
                 [&](BrakeTools& t) { t.dies[0].angle = Angle::degrees(degrees); });
  }
}

TEST(CheckTools, FindsFlatToolsThatAreNotFlat) {
  expect_wrong("/punches/1/profile", "(0, 0)", [](BrakeTools& t) {
    for (Vec2& corner : t.punches[1].profile)
      corner.y() += 1.0;
  });
  expect_wrong("/dies/1/opening", "0", [](BrakeTools& t) { t.dies[1].opening = 6.0; });
}

TEST(CheckTools, FindsMissingSegments) {
  expect_wrong("/punches/0/segments", "no segments",
               [](BrakeTools& t) { t.punches[0].segments.clear(); });
  for (const double value : {0.0, -10.0, kNotANumber, kInfinite})
    expect_wrong("/dies/0/segments/1", "above 0",
                 [&](BrakeTools& t) { t.dies[0].segments[1] = value; });
}

TEST(CheckTools, FindsRepeatedAndMissingIds) {
  expect_wrong("/punches/1/id", "twice", [](BrakeTools& t) { t.punches[1].id = "P88"; });
  expect_wrong("/dies/1/id", "twice", [](BrakeTools& t) { t.dies[1].id = "V16"; });
  expect_wrong("/dies/0/id", "no id", [](BrakeTools& t) { t.dies[0].id = ""; });
  // A punch and a die are told apart by what they are.
  EXPECT_EQ(said_of([](BrakeTools& t) { t.dies[0].id = "P88"; }).code, code::internal);
}

TEST(CheckTools, SaysValuesWithTheirUnits) {
  Error said = said_of([](BrakeTools& t) { t.machine.force = -5.0; });
  EXPECT_EQ(test::number_in(said, "value"), -5.0);
  EXPECT_EQ(test::unit_in(said, "value"), "kN");
  said = said_of([](BrakeTools& t) { t.dies[0].opening = 12.0; });
  EXPECT_EQ(test::number_in(said, "opening"), 12.0);
  EXPECT_TRUE(said.message.starts_with("The opening of die \"V16\" is 12 mm")) << said.message;
}

TEST(CheckTools, FindsForcesThatAreNone) {
  for (const double value : {0.0, -1.0, kNotANumber})
    expect_wrong("/dies/0/max_force", "max_force",
                 [&](BrakeTools& t) { t.dies[0].max_force = value; });
}

}  // namespace
}  // namespace planish
