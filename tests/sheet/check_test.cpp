#include "support/damaged_sheets.hpp"

#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace planish::test {
namespace {

TEST(CheckSheet, FindsNothingWrongWithSoundSheets) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), u_channel(), box(), cone_joined(),
                             hem(), rolled(), plate_with_holes(), lofted_corner({})})
    EXPECT_TRUE(check(sheet)) << check(sheet).error().message;
}

/// "face 3, loop 0, border 2" as a path into the sheet: "/faces/3/loops/0/borders/2".
std::string path_of(const std::string& where) {
  if (where == "sheet") return "";
  std::string path = std::regex_replace(where, std::regex("([a-z]+) ([0-9]+)(, )?"), "/$1s/$2");
  return path;
}

TEST(CheckSheet, NamesTheRuleAndTheRow) {
  for (const Damage& damage : damages()) {
    Sheet sheet = u_channel();
    damage.inflict(sheet);
    const auto result = check(sheet);
    ASSERT_FALSE(result) << damage.rule;
    EXPECT_EQ(result.error().code, code::invalid_sheet);
    EXPECT_NE(result.error().message.find(damage.rule), std::string::npos)
        << result.error().message << " instead of: " << damage.rule;
    EXPECT_EQ(result.error().where, damage.where) << damage.rule;
    ASSERT_FALSE(result.error().places.empty()) << damage.rule;
    EXPECT_EQ(result.error().places.front(), place::pointer(path_of(damage.where)));
  }
}

TEST(CheckSheet, NamesTheFaceOfTheSolid) {
  Sheet sheet = u_channel();
  sheet.faces[FaceId{2}].source_face = 17;
  sheet.faces[FaceId{2}].sense = -1;
  const auto result = check(sheet);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().places, (std::vector{place::pointer("/faces/2"), place::face(17)}));
}

TEST(CheckSheet, WantsPressLinesWithinTheirBendOneBehindTheOther) {
  // Shares of a bend of 90°, 40 mm wide, at which it is pressed.
  const auto sound = [](const std::vector<double>& shares, double angle = 45.0) {
    Sheet sheet = strip(
        {Straight{50}, Turn{Angle::degrees(90), 20.0, BendDirection::up}, Straight{30}}, 40.0, 2.0);
    const Box2 box = parameter_box(sheet, sheet[BendId{0}]);
    for (const double share : shares)
      sheet.bends[BendId{0}].press_lines.push_back(
          {std::lerp(box.lo.x(), box.hi.x(), share), Angle::degrees(angle)});
    return check(sheet).has_value();
  };
  EXPECT_TRUE(sound({0.25, 0.75}));
  EXPECT_TRUE(sound({0.0, 1.0})) << "its ends are part of it";
  EXPECT_FALSE(sound({-0.001, 0.5}));
  EXPECT_FALSE(sound({0.5, 1.001}));
  EXPECT_FALSE(sound({0.5, 2.0}));
  EXPECT_FALSE(sound({0.75, 0.25}));
  EXPECT_FALSE(sound({0.5, 0.5})) << "the same line twice";
  EXPECT_FALSE(sound({0.5}, std::nan("")));
}

TEST(CheckSheet, StandsBeforeEveryLayout) {
  for (const Damage& damage : damages()) {
    Sheet sheet = u_channel();
    damage.inflict(sheet);
    for (const auto& error :
         {lay_out(sheet).error(), flat_sheet(sheet).error(), flatten(sheet).error()})
      EXPECT_EQ(error.code, code::invalid_sheet) << damage.rule;
  }
}

TEST(LayOut, RefusesARootThatTheSheetDoesNotHave) {
  for (const int face : {-1, 5, 1000}) {
    const auto result = flatten(u_channel(), {.root = FaceId{face}});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::no_such_face);
    ASSERT_EQ(result.error().numbers.size(), 2u);
    EXPECT_EQ(result.error().numbers[0].quantity, (Quantity{face + 1.0}));  // people count from 1
    EXPECT_EQ(result.error().numbers[1].quantity, (Quantity{5.0}));
  }
}

TEST(LayOut, RefusesOptionsThatMeanNothing) {
  const double nan = std::nan("");
  for (const FlattenOptions& options :
       {FlattenOptions{.bend_k = {{BendId{2}, 0.4}}}, FlattenOptions{.bend_k = {{BendId{-1}, 0.4}}},
        FlattenOptions{.curve_tolerance = 0.0}, FlattenOptions{.merge_tolerance = nan},
        FlattenOptions{.closure_tolerance = -1.0}}) {
    const auto result = flatten(u_channel(), options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::bad_option);
  }
}

TEST(LayOut, RefusesAKThatLeavesASharpInsideNoNeutralSurface) {
  // A bend without inside radius, rolled about its outer skin: at K = 0 it has nothing to unroll.
  const Sheet sheet = strip(
      {Straight{50}, Turn{Angle::degrees(90), 0.0, BendDirection::down}, Straight{30}}, 40.0, 2.0);
  for (const AllowanceRule& rule :
       {AllowanceRule(ConstantK{0.0, "test"}), AllowanceRule(Din6935{})}) {
    const auto result = flatten(sheet, {.allowance = rule});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::bad_option);
    EXPECT_EQ(result.error().where, "B1");
    ASSERT_EQ(result.error().places.size(), 1u);
    EXPECT_EQ(result.error().places[0].kind, PlaceKind::bend);
    EXPECT_EQ(result.error().places[0].at.size(), 3u);
  }
  EXPECT_TRUE(flatten(sheet, {.allowance = ConstantK{0.01, "test"}}));
}

TEST(CheckSheet, NamesTheFeatureWhoseCutsOrCountsAreNone) {
  const BorderLoop line{Border{Segment{{0, 0}, {1, 0}}}}, none{Border{CubicSpline{}}};
  const auto refused = [&](auto&& change) {
    Sheet sheet = u_channel();
    FormedFeature feature;
    feature.kind = "pocket";
    feature.face = FaceId{0};
    feature.outlines = {line, line};
    feature.openings.resize(2);
    for (FormedOpening& opening : feature.openings)
      opening.pilot = opening.through = line;
    feature.slits = {line, line};
    change(feature);
    sheet.features.push_back(feature);
    const auto sound = check(sheet);
    if (!sound) {
      EXPECT_EQ(sound.error().where, "feature 0");
    }
    return !sound;
  };
  EXPECT_FALSE(refused([](FormedFeature&) {}));
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_TRUE(refused([&](FormedFeature& f) { f.openings[i].pilot = none; })) << i;
    EXPECT_TRUE(refused([&](FormedFeature& f) { f.openings[i].through = {}; })) << i;
    EXPECT_TRUE(refused([&](FormedFeature& f) { f.slits[i] = none; })) << i;
    EXPECT_TRUE(refused([&](FormedFeature& f) { f.outlines[i] = none; })) << i;
  }
  EXPECT_TRUE(refused([](FormedFeature& f) { f.own_openings = -1; }));
  EXPECT_TRUE(refused([](FormedFeature& f) { f.lost_openings = -1; }));
}

TEST(CheckSheet, LooksAtEveryLabel) {
  Sheet sheet = u_channel();
  for (const char* text : {"A", "B", "C"})
    sheet.labels.push_back({FaceId{0}, {1, 2}, text});
  EXPECT_TRUE(check(sheet));
  for (const std::size_t i : {0u, 2u}) {
    Sheet broken = sheet;
    broken.labels[i].at.x() = std::nan("");
    ASSERT_FALSE(check(broken)) << i;
    EXPECT_EQ(check(broken).error().where, "label " + std::to_string(i));
  }
}

}  // namespace
}  // namespace planish::test
