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

constexpr int kPressed = 5;

/// A corner of a transition that is to be pressed along five rulings.
Sheet pressed_corner(double near) {
  LoftedCorner corner;
  corner.near = near;
  Sheet sheet = lofted_corner(corner);
  Bend& bend = sheet.bends[BendId(0)];
  for (int i = 0; i < kPressed; ++i)
    bend.press_lines.push_back(
        {(i + 0.5) / kPressed, Angle::radians(bend.angle.radians() / kPressed)});
  return sheet;
}

/// The sheet ends so near the apex that the
/// lower ends of the surface's range of v lie beyond it for the shorter rulings, where what follows
/// a ruling is on its other side.
TEST(PressLines, DivideACornerUpToItsApex) {
  for (const double near : {0.4, 0.05, 0.02}) {
    const Sheet sheet = pressed_corner(near);
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

/// Towards the apex press lines run together. From where one is nearer to the next than a zone is
/// wide it need not be pressed; no farther.
TEST(PressLines, EndWhereTheyRunTogether) {
  Sheet sheet = pressed_corner(0.002);
  const auto flat = flat_sheet(sheet);
  ASSERT_TRUE(flat);
  // A radius as in the middle of the corner: near the apex zones are wider than lines are apart.
  sheet.bends[BendId(0)].inside_radius = 30.0;
  WorkpieceOptions options;
  options.air_radius = 4.0;
  const auto work = workpiece_of(sheet, flat->layout, options);
  ASSERT_TRUE(work);
  const std::vector<BrakeLine>& lines = work->lines;
  ASSERT_EQ(std::ssize(lines), kPressed);
  int ends = 0;
  for (const BrakeLine& line : lines)
    for (const bool upper : {false, true}) {
      const double over = line.overlapped[upper ? 1 : 0];
      const double at = upper ? line.to() - over : line.from() + over;
      double nearest = 1e9;
      for (const BrakeLine& other : lines)
        if (&other != &line)
          nearest = std::min(
              nearest, std::abs(cross(other.along, line.origin + at * line.along - other.origin)));
      EXPECT_GE(nearest, line.bend.allowance - 1e-9);
      if (over == 0.0) continue;
      ++ends;
      EXPECT_NEAR(nearest, line.bend.allowance, 1e-9) << "no more is left out";
    }
  EXPECT_EQ(ends, kPressed) << "each at the apex";
}

}  // namespace
}  // namespace planish::test
