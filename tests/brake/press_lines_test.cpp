#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <iterator>

namespace planish::test {
namespace {

using namespace brake_detail;

double area_of_pieces(const std::vector<Convex>& pieces) {
  double area = 0.0;
  for (const Convex& piece : pieces)
    area += ring_area(piece);
  return area;
}

Vec2 middle_of_corners(const Body& body) {
  Vec2 sum = Vec2::Zero();
  int corners = 0;
  for (const Convex& piece : body.pieces)
    for (const Vec2& p : piece) {
      sum += p;
      ++corners;
    }
  return sum / std::max(corners, 1);
}

/// A corner of a transition pressed along five rulings. The sheet ends so near the apex that the
/// lower ends of the surface's range of v lie beyond it for the shorter rulings, where what follows
/// a ruling is on its other side.
TEST(PressLines, DivideACornerUpToItsApex) {
  for (const double near : {0.4, 0.05, 0.02}) {
    LoftedCorner corner;
    corner.near = near;
    Sheet sheet = lofted_corner(corner);
    Bend& bend = sheet.bends[BendId(0)];
    constexpr int kPressed = 5;
    for (int i = 0; i < kPressed; ++i)
      bend.press_lines.push_back(
          {(i + 0.5) / kPressed, Angle::radians(bend.angle.radians() / kPressed)});
    const auto flat = flat_sheet(sheet);
    ASSERT_TRUE(flat) << flat.error().message;
    const auto work = workpiece_of(sheet, flat->layout, {});
    ASSERT_TRUE(work) << work.error().message;
    ASSERT_EQ(std::ssize(work->lines), kPressed);
    ASSERT_EQ(std::ssize(work->bodies), kPressed + 1);
    double most = 0.0, least = 1e9;
    for (int i = 0; i < kPressed; ++i) {
      const BrakeLine& line = work->lines[i];
      for (const int side : {0, 1}) {
        const Body& body = work->bodies[line.bodies[side]];
        EXPECT_GT(
            (side == 1 ? 1.0 : -1.0) * line.across().dot(middle_of_corners(body) - line.origin),
            0.0)
            << near << ", line " << i << ", side " << side;
      }
      if (i == 0) continue;  // between the first two lines and so on
      const double area = area_of_pieces(work->bodies[line.bodies[0]].pieces);
      most = std::max(most, area);
      least = std::min(least, area);
    }
    EXPECT_GT(least, 0.4 * most) << near;
  }
}

}  // namespace
}  // namespace planish::test
