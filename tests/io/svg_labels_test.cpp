#include "svg_labels.hpp"

#include "sample_patterns.hpp"
#include "svg_shapes.hpp"

#include <planish/geometry/region.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace planish {
namespace {

using namespace io_detail;
using namespace sample;
using testing::SizeIs;

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
