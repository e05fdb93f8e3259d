#include "rule_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(SmallestOpening, IsTheDiameterOfACircle) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({30, 30}, 1.0));
  EXPECT_TRUE(findings_of(pattern).empty());
  open(pattern, circular_opening({60, 30}, 0.95));
  EXPECT_EQ(only(findings_of(pattern), "smallest_opening").message,
            "the opening Ø 1.9 mm at (60, 30) is 1.9 mm wide; at least 2 mm (T) is needed");
}

TEST(SmallestOpening, IsFoundHoweverNarrowASlotIs) {
  for (const double width : {0.5, 0.001, 2e-5}) {
    FlatPattern pattern = flat_plate(rectangle(100, 60));
    open(pattern, rectangular_opening({50, 30}, 20, width));
    EXPECT_NEAR(number_of(only(findings_of(pattern), "smallest_opening"), "measured"), width, 1e-9);
  }
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, rectangular_opening({50, 30}, 20, 0.0));
  EXPECT_TRUE(findings_of(pattern).empty()) << "a slit";
}

/// The width that the rule sees; 0 when it is satisfied.
double width_seen(const Loop& opening) {
  FlatPattern pattern = flat_plate(shifted(rectangle(400, 400), Vec2(-200, -200)));
  open(pattern, opening);
  Rules rules = strict_rules();
  rules.smallest_opening_t = 10.0;
  const auto found = of_code(findings_of(pattern, rules), "smallest_opening");
  if (found.empty()) return 0.0;
  return number_of(found[0], "measured");
}

TEST(SmallestOpening, IsTheLargestCircleThatFits) {
  const Isometry2 turn(Eigen::Rotation2Dd(0.4));
  EXPECT_NEAR(width_seen(transformed(rectangular_opening({3, 4}, 60, 7.5), turn)), 7.5, 6e-4);
  EXPECT_NEAR(width_seen(test::obround_opening({0, 0}, 30, 4, Angle::degrees(20))), 8.0, 6e-4);
  // A triangle 3-4-5 times 5 has an inscribed radius of 5.
  EXPECT_NEAR(width_seen(reversed(polygon({{0, 0}, {15, 0}, {0, 20}}))), 10.0, 6e-4);
  // A keyhole: the disc, not the slot.
  Loop keyhole{Arc{Vec2(0, 0), 9, 0.2, 2 * std::numbers::pi - 0.4}};
  const Vec2 upper = 9 * Vec2(std::cos(0.2), std::sin(0.2));
  const Vec2 lower(upper.x(), -upper.y());
  keyhole.push_back(Segment{lower, Vec2(40, lower.y())});
  keyhole.push_back(Segment{Vec2(40, lower.y()), Vec2(40, upper.y())});
  keyhole.push_back(Segment{Vec2(40, upper.y()), upper});
  EXPECT_NEAR(width_seen(reversed(keyhole)), 18.0, 6e-4);
  // An angle with arms 5 wide: the circle in its corner touches the outer sides and the inner
  // corner.
  const double corner = 2 * 5 * (2 - std::numbers::sqrt2);
  EXPECT_NEAR(width_seen(reversed(polygon({{0, 0}, {30, 0}, {30, 5}, {5, 5}, {5, 30}, {0, 30}}))),
              corner, 6e-4);
  EXPECT_EQ(width_seen(rectangular_opening({0, 0}, 20.0, 80)), 0.0);
  // Whichever way its contour runs, and however small it is.
  for (const double size : {1.0, 30.0}) {
    const Loop loop = polygon({{0, 0}, {size, 0}, {size, 0.5 * size}, {0, 0.5 * size}});
    EXPECT_NEAR(width_seen(loop), 0.5 * size, 6e-4);
    EXPECT_NEAR(width_seen(reversed(loop)), 0.5 * size, 6e-4);
  }
}

TEST(SmallestOpening, DoesNotMindLinesCut) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, polygon({{20, 20}, {20, 40}}));
  open(pattern, polygon({{50, 10}, {50, 30}, {70, 30}, {70, 10}, {70, 30}, {50, 30}}));
  EXPECT_TRUE(of_code(findings_of(pattern), "smallest_opening").empty())
      << text_of(findings_of(pattern));
}

}  // namespace
}  // namespace planish::test
