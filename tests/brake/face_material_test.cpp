#include "brake/stroke_room.hpp"

#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

bool covers(const std::vector<Convex>& pieces, const Vec2& p) {
  return std::ranges::any_of(pieces, [&](const Convex& piece) {
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (cross(piece[(i + 1) % piece.size()] - piece[i], p - piece[i]) < 0.0) return false;
    return true;
  });
}

/// A plate with a round opening and one with corners: area, and no material within them.
TEST(FaceMaterial, LeavesOpeningsOut) {
  SheetBuilder builder(1.0);
  Loop square = rectangle(10, 10);
  std::ranges::reverse(square);
  for (Curve2& side : square) {
    auto& segment = std::get<Segment>(side);
    segment = {segment.b + Vec2(70, 20), segment.a + Vec2(70, 20)};
  }
  builder.flange(Frame{}, {rectangle(100, 60),
                           Loop{Arc{{30, 30}, 15.0, 0.0, -2.0 * std::numbers::pi}}, square});
  const Sheet sheet = builder.finish();
  const auto flat = flat_sheet(sheet);
  ASSERT_TRUE(flat);
  const std::vector<Convex> pieces = face_material(sheet, flat->layout, FaceId(0));
  double area = 0.0;
  for (const Convex& piece : pieces)
    area += ring_area(piece);
  // The circle is told in chords of 0.01 mm at most: less than 0.1 % of its area.
  EXPECT_NEAR(area, 6000.0 - 100.0 - std::numbers::pi * 225.0, 1.0);
  const Isometry2& at = flat->layout.placement[FaceId(0)];
  for (double x = 0.5; x < 100; x += 2.3)
    for (double y = 0.5; y < 60; y += 2.3) {
      const double from_middle = (Vec2(x, y) - Vec2(30, 30)).norm();
      if (std::abs(from_middle - 15.0) < 0.1) continue;
      const bool in_square = x > 70 && x < 80 && y > 20 && y < 30;
      EXPECT_EQ(covers(pieces, at * Vec2(x, y)), from_middle > 15.0 && !in_square) << x << " " << y;
    }
}

}  // namespace
}  // namespace planish::test
