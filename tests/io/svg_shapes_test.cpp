#include "svg_shapes.hpp"

#include "sample_patterns.hpp"
#include "svg_labels.hpp"

#include <planish/geometry/region.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace planish {
namespace {

using namespace io_detail;
using namespace sample;
using testing::SizeIs;

/// Area to the left of SVG path data (M, L, A, C, Z), by the specification's rules for arcs.
class PathArea {
 public:
  explicit PathArea(const std::string& data)
      : in_(std::regex_replace(data, std::regex("([MLACZ])"), " $1 ")) {
    for (char command = 0; in_ >> command;) {
      if (command == 'M') start_ = at_ = point();
      if (command == 'L') line_to(point());
      if (command == 'A') arc_to();
      if (command == 'C') curve_to();
      if (command == 'Z') line_to(start_);
    }
  }
  /// y points down on the page: positive is clockwise as seen, so the sign is turned.
  double value() const { return -area_; }

 private:
  Vec2 point() {
    Vec2 p;
    in_ >> p.x() >> p.y();
    return p;
  }
  static double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
  void line_to(const Vec2& to) {
    area_ += 0.5 * cross(at_, to);
    at_ = to;
  }
  void arc_to() {
    double rx = 0, ry = 0, turn = 0;
    int large = 0, positive = 0;
    in_ >> rx >> ry >> turn >> large >> positive;
    const Vec2 to = point();
    const double half = std::asin(std::min(1.0, (to - at_).norm() / (2 * rx)));
    const double sweep = (positive ? 1.0 : -1.0) * (large ? 2 * kPi - 2 * half : 2 * half);
    area_ += 0.5 * rx * rx * (sweep - std::sin(sweep));
    line_to(to);
  }
  void curve_to() {
    const Vec2 p0 = at_, p1 = point(), p2 = point(), p3 = point();
    area_ += 3.0 / 20.0 *
                 (2 * cross(p0, p1) + cross(p0, p2) + cross(p1, p2) + cross(p1, p3) +
                  2 * cross(p2, p3)) +
             cross(p0, p3) / 20.0;
    at_ = p3;
  }

  std::istringstream in_;
  Vec2 start_ = Vec2::Zero(), at_ = Vec2::Zero();
  double area_ = 0.0;
};

TEST(SvgPath, EnclosesTheAreaOfTheLoop) {
  // A disc with a flat, both ways round: most of a turn.
  const Loop disc{Arc{{3, 4}, 10.0, kPi / 3, 4.0 * kPi / 3},
                  Segment{{8, 4 - std::sqrt(75.0)}, {8, 4 + std::sqrt(75.0)}}};
  const Loop slot = obround({100, 30}, 12.0, 5.0);
  const Loop round = hole({20, 50}, 8.0);
  const Loop leaf = petal({175, 20}, {-30, 60}, {40, 60});
  for (const Loop& loop : {disc, slot, round, leaf, rectangle({-1, -2}, {3, 4})}) {
    EXPECT_NEAR(PathArea(svg_path(loop)).value(), signed_area(loop), 1e-3);
    EXPECT_NEAR(PathArea(svg_path(reversed(loop))).value(), -signed_area(loop), 1e-3);
  }
  EXPECT_NEAR(PathArea(svg_path(round)).value(), -64.0 * kPi, 1e-3);
  EXPECT_NEAR(PathArea(svg_path(reversed(leaf))).value(), kPetalArea, 1e-3);
}

TEST(SvgPath, DrawsACircleAsTwoArcsAndASplineAsCubics) {
  EXPECT_EQ(svg_path({Arc{{20, 50}, 8.0, 0.0, 2 * kPi}}),
            "M28 -50A8 8 0 0 0 12 -50A8 8 0 0 0 28 -50Z");
  EXPECT_EQ(svg_path(petal({0, 0}, {-30, 60}, {40, 60})), "M0 0C-30 -60 40 -60 0 0Z");
}

TEST(SvgNumber, IsShort) {
  EXPECT_EQ(svg_number(12.5), "12.5");
  EXPECT_EQ(svg_number(100.0), "100");
  EXPECT_EQ(svg_number(-1e-9), "0");
  EXPECT_EQ(svg_number(1.0 / 3.0, 2), "0.33");
}

TEST(BendZones, LieBetweenTheTangentLines) {
  const auto zones = bend_zones(bracket().bends[0]);
  ASSERT_THAT(zones, SizeIs(1));
  EXPECT_NEAR(std::abs(signed_area(polygon({zones[0].begin(), zones[0].end()}))), 400.0, 1e-9);
}

TEST(BendZones, DoNotReachAcrossAGapThatBothSidesHave) {
  FlatBend two = bend("B1", BendDirection::up, {{0, 0}, {100, 0}}, 4.0);
  two.lines = {{{0, 0}, {30, 0}}, {{70, 0}, {100, 0}}};
  two.tangent_lines = {
      {{0, 2}, {30, 2}}, {{70, 2}, {100, 2}}, {{30, -2}, {0, -2}}, {{100, -2}, {70, -2}}};
  double area = 0.0;
  for (const auto& zone : bend_zones(two))
    area += std::abs(signed_area(polygon({zone.begin(), zone.end()})));
  EXPECT_NEAR(area, 2 * 30.0 * 4.0, 1e-9);
  // One side uncut: still only what has both sides.
  two.tangent_lines = {{{0, 2}, {100, 2}}, {{0, -2}, {30, -2}}, {{70, -2}, {100, -2}}};
  area = 0.0;
  for (const auto& zone : bend_zones(two))
    area += std::abs(signed_area(polygon({zone.begin(), zone.end()})));
  EXPECT_NEAR(area, 2 * 30.0 * 4.0, 1e-9);
}

}  // namespace
}  // namespace planish
