#include "rule_checks.hpp"
#include "rule_findings.hpp"
#include "support/sheets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace planish::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(OpeningToBend, IsMeasuredFromTheTangentLine) {
  const double tangent = 0.5 * test::zone_width();
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, circular_opening({tangent + 4 + 3, 20}, 3));
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
  pattern.openings.clear();
  open(pattern, circular_opening({tangent + 4 + 3 - kJustShort, 20}, 3));
  const Finding found = only(findings_of(pattern), "opening_to_bend");
  EXPECT_THAT(
      found.message,
      HasSubstr("is 3.99 mm from the tangent line of bend B1; at least 4 mm (2 T) is needed"));
  EXPECT_THAT(found.message, HasSubstr("the opening Ø 6 mm at ("));
  EXPECT_NEAR(number_of(found, "measured"), 3.99, 1e-9);
  EXPECT_NEAR(number_of(found, "wanted"), 4.0, 1e-9);
  ASSERT_EQ(found.about.size(), 2u);  // the bend and the opening
  EXPECT_EQ(found.about[0].id, Place::Id("B1"));
  EXPECT_EQ(found.about[1].kind, PlaceKind::point);
  EXPECT_NEAR((found.at.at(0) - Vec2(tangent + 3.99, 20)).norm(), 0.0, 1e-6);
}

TEST(OpeningToBend, HoldsForEveryShape) {
  const double tangent = 0.5 * test::zone_width();
  const double s = std::sqrt(0.5);
  const std::vector<std::pair<Loop, double>> shapes = {
      {rectangular_opening({0, 0}, 8, 6), 4.0},
      {reversed(polygon({{-5, 0}, {0, -5}, {5, 0}, {0, 5}})), 5.0},
      {test::obround_opening({0, 0}, 10, 3, Angle::degrees(45)), 5 * s + 3}};
  for (const auto& [shape, reach] : shapes) {
    for (const double distance : {4.0, 3.5}) {
      FlatPattern pattern = flat_l(50, 50);
      open(pattern, shifted(shape, Vec2(tangent + distance + reach, 20)));
      const auto found = findings_of(pattern);
      if (distance < 4.0) {
        EXPECT_THAT(only(found, "opening_to_bend").message, HasSubstr("is 3.5 mm from"));
      } else {
        EXPECT_TRUE(found.empty()) << text_of(found);
      }
    }
  }
}

TEST(Openings, AreRankedByWhatTheyMissTheirLimitsBy) {
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, circular_opening({-25, 20}, 4));
  open(pattern, circular_opening({-16, 20}, 4));
  open(pattern, circular_opening({0.5 * test::zone_width() + 5, 20}, 2));
  open(pattern, circular_opening({30, 3}, 2));
  open(pattern, circular_opening({20, 30}, 0.5));
  const inspect_detail::Workpiece workpiece({}, pattern);
  std::set<std::string> codes;
  for (const auto observe :
       {inspect_detail::observe_openings_by_bends, inspect_detail::observe_openings_by_edges,
        inspect_detail::observe_openings_by_openings, inspect_detail::observe_opening_sizes})
    for (const inspect_detail::Observation& one : observe(workpiece, strict_rules())) {
      codes.insert(one.code);
      Finding told;
      told.numbers = one.place.numbers;
      EXPECT_NEAR(one.excess, number_of(told, "measured") - number_of(told, "wanted"), 1e-12)
          << one.place.message;
    }
  EXPECT_EQ(codes, (std::set<std::string>{"opening_to_bend", "opening_to_edge",
                                          "opening_to_opening", "smallest_opening"}));
}

TEST(OpeningToBend, DoesNotCountAcrossASlit) {
  // The opening is 2 mm from the tangent line, but a slit 0.5 wide runs between them.
  const double tangent = 0.5 * test::zone_width();
  const double x = tangent + 0.7;
  FlatPattern pattern = flat_plate(polygon(
      {{-50, 0}, {x, 0}, {x, 30}, {x + 0.5, 30}, {x + 0.5, 0}, {60, 0}, {60, 40}, {-50, 40}}));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  open(pattern, rectangular_opening({tangent + 5.5 + 5, 12}, 10, 4));
  Rules rules = strict_rules();
  rules.opening_to_bend_t = 3.0;
  rules.flange_height_t = 0.0;
  EXPECT_TRUE(of_code(findings_of(pattern, rules), "opening_to_bend").empty())
      << text_of(findings_of(pattern, rules));
  pattern.outer = flat_plate(shifted(rectangle(110, 40), Vec2(-50, 0))).outer;
  EXPECT_EQ(of_code(findings_of(pattern, rules), "opening_to_bend").size(), 1u);
}

/// A sheet of one bend face, so that openings can say what they were cut from.
Sheet sheet_with_bend_face() {
  Sheet sheet;
  sheet.faces.resize(1);
  sheet.faces.front().part_of = BendId{0};
  sheet.bends.resize(1);
  return sheet;
}

TEST(OpeningInBend, IsToldOnceForAHoleWithinTheZone) {
  FlatPattern pattern = flat_l(50, 40, {90, 8.0});
  open(pattern, circular_opening({0.5, 20}, 3));
  pattern.openings[0].origins[0] = {Origin{{FaceId{0}, 1, 0}, false, pattern.openings[0].loop[0]}};
  const double gap = std::sqrt(9 - 0.25);
  pattern.bends[0].lines = {{Vec2(0, 0), Vec2(0, 20 - gap)}, {Vec2(0, 20 + gap), Vec2(0, 40)}};
  const auto found = check_rules(sheet_with_bend_face(), pattern, {});
  EXPECT_EQ(only(found, "opening_in_bend").message,
            "the opening Ø 6 mm at (0.5, 20) reaches into bend B1, where it will be "
            "distorted; move it away or extend it through the whole bend");
}

TEST(OpeningInBend, IsToldForAHoleBesideTheBendLine) {
  // Within the zone, but without touching any line: only its origin tells.
  FlatPattern pattern = flat_l(50, 40, {90, 12.0});
  open(pattern, circular_opening({5, 20}, 2));
  EXPECT_TRUE(of_code(findings_of(pattern), "opening_in_bend").empty());
  pattern.openings[0].origins[0] = {Origin{{FaceId{0}, 1, 0}, false, pattern.openings[0].loop[0]}};
  only(check_rules(sheet_with_bend_face(), pattern, {}), "opening_in_bend");
}

TEST(OpeningInBend, IsToldForAHoleOverOneTangentLine) {
  const double tangent = 0.5 * test::zone_width();
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, rectangular_opening({tangent + 2, 20}, 6, 8));
  pattern.bends[0].tangent_lines = {{Vec2(-tangent, 0), Vec2(-tangent, 40)},
                                    {Vec2(tangent, 0), Vec2(tangent, 16)},
                                    {Vec2(tangent, 24), Vec2(tangent, 40)}};
  const Finding found = only(findings_of(pattern), "opening_in_bend");
  EXPECT_THAT(found.message, HasSubstr("the opening 8 × 6 mm at"));
}

TEST(OpeningInBend, IsAnInformationWhenCutThroughTheWholeBend) {
  const double tangent = 0.5 * test::zone_width();
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, rectangular_opening({0, 20}, 2 * tangent + 6, 8));
  FlatBend& bend = pattern.bends[0];
  bend.lines.clear();
  bend.tangent_lines.clear();
  for (const auto& [from, to] : {std::pair{0.0, 16.0}, std::pair{24.0, 40.0}}) {
    bend.lines.push_back({Vec2(0, from), Vec2(0, to)});
    bend.tangent_lines.push_back({Vec2(-tangent, from), Vec2(-tangent, to)});
    bend.tangent_lines.push_back({Vec2(tangent, from), Vec2(tangent, to)});
  }
  const auto found = findings_of(pattern);
  ASSERT_EQ(found.size(), 1u) << text_of(found);
  EXPECT_EQ(found[0].code, "opening_in_bend");
  EXPECT_EQ(found[0].severity, Severity::info);
  EXPECT_THAT(found[0].message, HasSubstr("is cut through bend B1"));
}

TEST(OpeningInBend, DoesNotMatterInRolledSheet) {
  FlatPattern pattern = flat_l(50, 40, {90, 60.0});
  open(pattern, circular_opening({0, 20}, 5));
  pattern.openings[0].origins[0] = {Origin{{FaceId{0}, 1, 0}, false, pattern.openings[0].loop[0]}};
  EXPECT_TRUE(check_rules(sheet_with_bend_face(), pattern, {}).empty());
}

TEST(OpeningInBend, AgreesWithFlattenedSheets) {
  for (const auto& [sheet, severity] : {std::pair{test::hole_in_bend(3.0, 0.44), Severity::warning},
                                        std::pair{test::slot_across_bend(), Severity::info},
                                        std::pair{test::slot_into_bend(), Severity::warning}}) {
    const auto pattern = flatten(sheet);
    ASSERT_TRUE(pattern.has_value());
    const auto found = check_rules(sheet, *pattern, {});
    ASSERT_EQ(found.size(), 1u) << text_of(found);
    EXPECT_EQ(found[0].code, "opening_in_bend") << found[0].message;
    EXPECT_EQ(found[0].severity, severity) << found[0].message;
  }
}

TEST(OpeningToEdge, IsAtLeastTwiceTheThickness) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({7, 30}, 3));
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
  pattern.openings.clear();
  open(pattern, circular_opening({7 - kJustShort, 30}, 3));
  const Finding found = only(findings_of(pattern), "opening_to_edge");
  EXPECT_EQ(found.message,
            "the opening Ø 6 mm at (6.99, 30) is 3.99 mm from the outer edge; at least 4 mm (2 T) "
            "is needed");
  EXPECT_NEAR((found.at.at(0) - Vec2(3.99, 30)).norm(), 0.0, 1e-6);
}

TEST(OpeningToEdge, HoldsTowardsCurvedEdges) {
  const Loop disc{Arc{Vec2(0, 0), 40, 0, 2 * std::numbers::pi}};
  const Loop half{Arc{Vec2(0, 0), 40, 0, std::numbers::pi}, Segment{Vec2(-40, 0), Vec2(40, 0)}};
  for (const Loop& outline : {disc, half}) {
    FlatPattern pattern = flat_plate(outline);
    // A corner of the square is nearest to the arc.
    const double corner = 40 - 3.5;
    const Vec2 out = Vec2(1, 1).normalized();
    open(pattern, rectangular_opening(corner * out - Vec2(4, 4), 8, 8));
    EXPECT_THAT(only(findings_of(pattern), "opening_to_edge").message,
                HasSubstr("is 3.5 mm from the outer edge"));
  }
}

TEST(OpeningToOpening, IsAtLeastFiveTimesTheThickness) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({30, 30}, 5));
  open(pattern, rectangular_opening({50, 30}, 10, 12));
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
  pattern.openings.pop_back();
  open(pattern, rectangular_opening({50 - kJustShort, 30}, 10, 12));
  const Finding found = only(findings_of(pattern), "opening_to_opening");
  EXPECT_EQ(found.message,
            "the opening Ø 10 mm at (30, 30) is 9.99 mm from the opening 12 × 10 mm at (49.99, "
            "30); at least 10 mm (5 T) "
            "is needed");
  ASSERT_EQ(found.at.size(), 2u);
  EXPECT_NEAR((found.at[0] - Vec2(35, 30)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((found.at[1] - Vec2(44.99, 30)).norm(), 0.0, 1e-6);
}

TEST(OpeningToOpening, IsToldForEachNearestNeighbourOnce) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  for (const double x : {20.0, 35.0, 48.0, 80.0})
    open(pattern, circular_opening({x, 30}, 4));
  // 35–48 are each other's nearest, 20 is nearest to 35, 80 is alone.
  EXPECT_THAT(messages(findings_of(pattern)),
              ElementsAre(HasSubstr("is 5 mm"), HasSubstr("is 7 mm")));
}

/// Circles of 1 to 3 mm in a plate of 120 × 90, none nearer to another than 0.5.
std::vector<std::pair<Vec2, double>> perforation(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> x(10, 110), y(10, 80), radius(1, 3);
  std::vector<std::pair<Vec2, double>> circles;
  while (std::ssize(circles) < count) {
    const std::pair<Vec2, double> next{Vec2(x(random), y(random)), radius(random)};
    const bool free = std::ranges::all_of(circles, [&](const auto& other) {
      return (other.first - next.first).norm() > other.second + next.second + 0.5;
    });
    if (free) circles.push_back(next);
  }
  return circles;
}

TEST(OpeningToOpening, IsThatOfTheNearestOfAllOthersEachPairOnce) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 12; ++trial) {
    const auto circles = perforation(random, 5 + 3 * trial);
    FlatPattern pattern = flat_plate(rectangle(120, 90));
    for (const auto& [center, radius] : circles)
      open(pattern, circular_opening(center, radius));
    Rules rules = strict_rules();
    rules.opening_to_opening_t = 4.0;  // 8 mm
    const auto gap = [&](std::size_t i, std::size_t k) {
      return (circles[i].first - circles[k].first).norm() - circles[i].second - circles[k].second;
    };
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      std::size_t nearest = i;
      for (std::size_t k = 0; k < circles.size(); ++k)
        if (k != i && (nearest == i || gap(i, k) < gap(i, nearest))) nearest = k;
      if (gap(i, nearest) < 8.0 - 1e-3) pairs.insert(std::minmax(i, nearest));
    }
    std::vector<double> wanted, measured;
    for (const auto& [i, k] : pairs)
      wanted.push_back(gap(i, k));
    for (const Finding& one : of_code(findings_of(pattern, rules), "opening_to_opening")) {
      measured.push_back(number_of(one, "measured"));
      ASSERT_EQ(one.at.size(), 2u);
      EXPECT_NEAR((one.at[0] - one.at[1]).norm(), measured.back(), 1e-9);
    }
    std::ranges::sort(wanted);
    ASSERT_EQ(measured.size(), wanted.size()) << trial;
    EXPECT_TRUE(std::ranges::is_sorted(measured)) << "the worst first";
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_NEAR(measured[i], wanted[i], 1e-9);
  }
}

TEST(OpeningToOpening, HasItsPlacesOnTheOpeningsThatItNames) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  for (const double x : {20.0, 35.0, 48.0})
    open(pattern, circular_opening({x, 30}, 4));
  for (const Finding& one : findings_of(pattern)) {
    ASSERT_EQ(one.about.size(), 2u);
    for (const int i : {0, 1}) {
      const Vec2 center(one.about[i].at.at(0), one.about[i].at.at(1));
      EXPECT_NEAR((one.at[i] - center).norm(), 4.0, 1e-9);
    }
  }
}

TEST(OpeningToOpening, DoesNotCountAcrossAnotherOpening) {
  // A slot between two holes: each is near to it, and not to the other.
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({46, 30}, 3));
  open(pattern, circular_opening({54, 30}, 3));
  EXPECT_NEAR(number_of(only(findings_of(pattern), "opening_to_opening"), "measured"), 2.0, 1e-9);
  open(pattern, rectangular_opening({50, 30}, 0.2, 20));
  const auto found = of_code(findings_of(pattern), "opening_to_opening");
  ASSERT_EQ(found.size(), 2u);
  for (const Finding& one : found)
    EXPECT_NEAR(number_of(one, "measured"), 0.9, 1e-9);
}

TEST(OpeningToEdge, IsThatOfTheNearestOfAllEdges) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> x(4.5, 27.5), y(4.5, 19.5), radius(1, 4);
  for (int i = 0; i < 60; ++i) {
    const Vec2 center(x(random), y(random));
    const double r = radius(random);
    FlatPattern pattern = flat_plate(rectangle(32, 24));
    open(pattern, circular_opening(center, r));
    const double distance = std::min({center.x(), 32 - center.x(), center.y(), 24 - center.y()}) -
                            r;
    const auto found = of_code(findings_of(pattern), "opening_to_edge");
    ASSERT_EQ(found.size(), distance < 4.0 - 1e-3 ? 1u : 0u) << center.transpose();
    if (!found.empty()) {
      EXPECT_NEAR(number_of(found[0], "measured"), distance, 1e-9);
    }
  }
}

TEST(OpeningToBend, IsThatOfTheNearestStretchOfEachBend) {
  // Two bends 40 mm apart, their limits interrupted at different places.
  const double half = 0.5 * test::zone_width();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> x(half + 3.2, 40 - half - 3.2), y(6, 54);
  for (int i = 0; i < 60; ++i) {
    FlatPattern pattern = flat_plate(shifted(rectangle(140, 60), Vec2(-50, 0)));
    for (const double at : {0.0, 40.0}) {
      FlatBend& bend = test::add_bend(pattern, {Vec2(at, 0), Vec2(at, 60)});
      bend.tangent_lines.clear();
      for (const double side : {-half, half})
        for (const auto& [from, to] : {std::pair{40.0, 60.0}, std::pair{0.0, 15.0 + 0.25 * at}})
          bend.tangent_lines.push_back({Vec2(at + side, from), Vec2(at + side, to)});
    }
    const Vec2 center(x(random), y(random));
    open(pattern, circular_opening(center, 3));
    Rules rules = strict_rules();
    rules.opening_to_bend_t = 7.5;  // 15 mm
    std::map<std::string, double> wanted;
    for (const FlatBend& bend : pattern.bends) {
      double least = 15.0 - 1e-3;
      for (const Segment& line : bend.tangent_lines)
        least = std::min(least, nearest(line, center).distance - 3.0);
      if (least < 15.0 - 1e-3) wanted[bend.id] = least;
    }
    std::map<std::string, double> measured;
    for (const Finding& one : of_code(findings_of(pattern, rules), "opening_to_bend"))
      measured[std::get<std::string>(one.about.at(0).id)] = number_of(one, "measured");
    ASSERT_EQ(measured.size(), wanted.size()) << center.transpose();
    for (const auto& [bend, distance] : wanted)
      EXPECT_NEAR(measured[bend], distance, 1e-9) << bend;
  }
}

TEST(OpeningToBend, NamesBendsInTheirOrder) {
  const double half = 0.5 * test::zone_width();
  FlatPattern pattern = flat_plate(shifted(rectangle(160, 60), Vec2(-50, 0)));
  test::add_bend(pattern, {Vec2(14, 0), Vec2(14, 60)});
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 60)});
  open(pattern, circular_opening({7, 30}, 7 - half - 1));
  const auto found = of_code(findings_of(pattern), "opening_to_bend");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].about.at(0).id, Place::Id("B1"));
  EXPECT_EQ(found[1].about.at(0).id, Place::Id("B2"));
}

}  // namespace
}  // namespace planish::test
