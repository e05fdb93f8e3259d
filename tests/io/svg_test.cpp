#include "sample_patterns.hpp"
#include "svg_labels.hpp"
#include "svg_shapes.hpp"

#include <planish/geometry/region.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace planish {
namespace {

using namespace sample;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
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

TEST(Svg, HasTheTrueSizeOfThePartAndItsMargin) {
  const std::string svg = svg_text(bracket(), {.margin = 5.0, .labels = false, .legend = false});
  EXPECT_THAT(svg, HasSubstr("width=\"210mm\" height=\"110mm\" viewBox=\"-5 -105 210 110\""));
}

TEST(Svg, DrawsUpBlueAndDownRedAndSaysSo) {
  const std::string svg = svg_text(bracket());
  EXPECT_THAT(svg, HasSubstr("fill=\"#1d5fc4\" stroke-width"));
  EXPECT_THAT(svg, HasSubstr(">B1 UP 90° R2</text>"));
  EXPECT_THAT(svg, HasSubstr(">B2 DOWN 90° R2</text>"));
  EXPECT_THAT(svg, HasSubstr(">200 × 100 × 2 mm</text>"));
  EXPECT_THAT(svg, HasSubstr(">bend down</text>"));
  EXPECT_THAT(svg_text(bracket(), {.labels = false, .legend = false}), Not(HasSubstr("<text")));
}

TEST(Svg, EscapesWhatXmlWouldMisread) {
  FlatPattern pattern = bracket();
  pattern.bends[0].id = "<a & \"b\">\x01";
  pattern.features.push_back({"<em>boss", {hole({20, 50}, 11.0)}});
  const std::string svg = svg_text(pattern);
  EXPECT_THAT(svg, HasSubstr("&lt;a &amp; &quot;b&quot;&gt; UP"));
  EXPECT_THAT(svg, HasSubstr("<title>&lt;em&gt;boss</title>"));
  EXPECT_EQ(svg.find('\x01'), std::string::npos);
}

TEST(Svg, DrawsAnEmptyPatternAsAnEmptyPage) {
  const std::string svg = svg_text({});
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
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

TEST(Labels, RunAlongALongLineAndReadFromBelowOrTheRight) {
  for (const double degrees : {0.0, 30.0, 90.0, 150.0, 180.0, 210.0, 270.0, 359.0}) {
    const double a = Angle::degrees(degrees).radians();
    const Vec2 d(std::cos(a), std::sin(a));
    const auto placed = place_labels({{"B1 UP 90° R2", {-100 * d, 100 * d}}}, {}, 4.0);
    ASSERT_THAT(placed, SizeIs(1));
    EXPECT_GT(placed[0].angle, -kPi / 2);
    EXPECT_LE(placed[0].angle, kPi / 2 + 1e-5);
    EXPECT_NEAR(std::abs(std::cos(placed[0].angle) * d.y() - std::sin(placed[0].angle) * d.x()),
                0.0, 1e-9);
    EXPECT_NEAR(placed[0].center.norm(), 0.8 * 4.0, 1e-9) << "beside the middle of the line";
    EXPECT_FALSE(placed[0].leader);
  }
}

TEST(Labels, StandLevelBesideALineTooShortForThem) {
  const auto placed = place_labels({{"B1 UP 90° R2", {{0, 0}, {0, 3}}}}, {}, 4.0);
  ASSERT_THAT(placed, SizeIs(1));
  EXPECT_EQ(placed[0].angle, 0.0);
  EXPECT_TRUE(placed[0].leader);
}

TEST(Labels, KeepOffEachOtherAndOffLinesWhereThereIsRoom) {
  std::vector<LabelRequest> requests;
  std::vector<Segment> lines;
  for (int i = 0; i < 12; ++i) {
    lines.push_back({{0, 6.0 * i}, {100, 6.0 * i}});
    requests.push_back({"B UP 90° R2", lines.back()});
  }
  const auto placed = place_labels(requests, lines, 4.0);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto box = corners(placed[i]);
    for (const Segment& line : lines) {
      EXPECT_FALSE(box[0].y() < line.a.y() && line.a.y() < box[2].y()) << "label " << i;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const auto other = corners(placed[j]);
      EXPECT_FALSE(box[0].y() < other[2].y() && other[0].y() < box[2].y() &&
                   box[0].x() < other[2].x() && other[0].x() < box[2].x());
    }
  }
}

TEST(Labels, OfPointsStandOutsideInOneSizeAndMeetNothing) {
  const std::vector<Vec2> square{{0, 0}, {40, 0}, {40, 40}, {0, 40}};
  std::vector<Segment> lines;
  std::vector<PointRequest> requests;
  for (std::size_t i = 0; i < 4; ++i)
    lines.push_back({square[i], square[(i + 1) % 4]});
  for (int i = 0; i <= 10; ++i)
    requests.push_back({std::to_string(i), Vec2(4.0 * i, 40.0)});
  const auto placed = place_point_labels(requests, {square}, lines, 4.0);
  ASSERT_THAT(placed, SizeIs(11));
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_EQ(placed[i].font, placed[0].font);
    EXPECT_FALSE(inside({square}, placed[i].center)) << placed[i].text;
    EXPECT_LT((placed[i].center - requests[i].at).norm(), 8.0);
    const auto box = corners(placed[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const auto other = corners(placed[j]);
      EXPECT_FALSE(box[0].y() < other[2].y() && other[0].y() < box[2].y() &&
                   box[0].x() < other[2].x() && other[0].x() < box[2].x());
    }
  }
}

TEST(Labels, OfPointsThatHaveNoRoomAreLeftOut) {
  std::vector<PointRequest> requests(50, {"12345", {0, 0}});
  const auto placed = place_point_labels(requests, {}, {}, 4.0);
  EXPECT_GE(placed.size(), 2u);
  EXPECT_LT(placed.size(), 10u);
}

}  // namespace
}  // namespace planish
