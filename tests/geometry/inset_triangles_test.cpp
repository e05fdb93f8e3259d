#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using Triangles = std::vector<std::array<Vec2, 3>>;

double area_of(const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& t : triangles)
    sum += std::abs(ring_area({t[0], t[1], t[2]}));
  return sum;
}

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Vec2> polygon_around(const Vec2& centre, double radius, int corners, double turned) {
  std::vector<Vec2> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = turned + 2 * std::numbers::pi * i / corners;
    ring.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Whether two triangles share area: some side of neither parts them.
bool share_area(const std::array<Vec2, 3>& a, const std::array<Vec2, 3>& b) {
  for (const auto* t : {&a, &b})
    for (int i = 0; i < 3; ++i) {
      const Vec2 side = (*t)[(i + 1) % 3] - (*t)[i];
      const Vec2 across = Vec2(-side.y(), side.x()).normalized();
      double low_a = HUGE_VAL, high_a = -HUGE_VAL, low_b = HUGE_VAL, high_b = -HUGE_VAL;
      for (int k = 0; k < 3; ++k) {
        low_a = std::min(low_a, across.dot(a[k])), high_a = std::max(high_a, across.dot(a[k]));
        low_b = std::min(low_b, across.dot(b[k])), high_b = std::max(high_b, across.dot(b[k]));
      }
      if (std::min(high_a, high_b) - std::max(low_a, low_b) < 1e-6) return false;
    }
  return true;
}

TEST(InsetTriangles, CoverARectangleSetIn) {
  const Polygon plate{rectangle(0, 0, 60, 40), {}};
  EXPECT_NEAR(area_of(inset_triangles(plate, 0.0)), 60 * 40, 1e-4);
  EXPECT_NEAR(area_of(inset_triangles(plate, 1.5)), 57 * 37, 1e-4);
  EXPECT_TRUE(inset_triangles(plate, 20.5).empty());
  EXPECT_TRUE(inset_triangles({}, 1.0).empty());
}

TEST(InsetTriangles, LeaveOutHolesAndWhatIsTakenAway) {
  const Polygon plate{rectangle(0, 0, 60, 40), {rectangle(20, 10, 40, 30)}};
  EXPECT_NEAR(area_of(inset_triangles(plate, 0.0)), 60 * 40 - 20 * 20, 1e-4);
  // Set in by 1, the hole grows by 1 and gets round corners, drawn with chords.
  const double hole = 20 * 20 + 4 * 20 + std::numbers::pi;
  EXPECT_NEAR(area_of(inset_triangles(plate, 1.0)), 58 * 38 - hole, 0.05);
  // Two strips, from hole to edge, leave two pieces.
  const std::vector<Polygon> strips{{rectangle(-1, 18, 21, 22), {}},
                                    {rectangle(39, 18, 61, 22), {}}};
  EXPECT_NEAR(area_of(inset_triangles(plate, 0.0, strips)), 60 * 40 - 20 * 20 - 2 * 20 * 4, 1e-4);
}

// Openings with corners in line, which GEOS fails to triangulate.
TEST(InsetTriangles, CoverAPlateWithOpeningsInLine) {
  constexpr std::array kOpenings{std::pair{6, 0.2}, std::pair{3, 0.1}, std::pair{3, 0.1},
                                 std::pair{4, 0.2}, std::pair{3, 0.1}, std::pair{3, 0.1},
                                 std::pair{6, 0.4}, std::pair{3, 0.1}, std::pair{3, 0.1}};
  Polygon plate{rectangle(-30, -30, 30, 30), {}};
  double area = 3600.0;
  for (int i = 0; i < 9; ++i) {
    const auto [corners, radius] = kOpenings[i];
    plate.holes.push_back(
        polygon_around({20.0 * (i % 3 - 1), 20.0 * (i / 3 - 1)}, radius, corners, 0.0));
    area -= std::abs(ring_area(plate.holes.back()));
  }
  EXPECT_NEAR(area_of(inset_triangles(plate, 0.0)), area, 1e-4);
}

RC_GTEST_PROP(InsetTriangles, CoverPerforatedPlatesOnce, ()) {
  // 3 × 3 cells of 20, in each a polygon that touches no other, all turned: the corners are numbers
  // without pattern, many nearly in line.
  const double turned = *rc::gen::inRange(0, 6283) / 1000.0;
  const Eigen::Rotation2Dd turn(turned);
  Polygon plate;
  for (const Vec2& p : rectangle(-30, -30, 30, 30))
    plate.outer.push_back(turn * p);
  double holes = 0.0;
  for (int i = 0; i < 9; ++i) {
    const int corners = *rc::gen::inRange(3, 40);
    const double radius = *rc::gen::inRange(1, 95) / 10.0;
    const Vec2 centre(20.0 * (i % 3 - 1), 20.0 * (i / 3 - 1));
    plate.holes.push_back(polygon_around(turn * centre, radius, corners, turned));
    holes += std::abs(ring_area(plate.holes.back()));
  }
  const Triangles triangles = inset_triangles(plate, 0.0);
  RC_ASSERT(std::abs(area_of(triangles) - (3600.0 - holes)) < 1e-4);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      RC_ASSERT(!share_area(triangles[i], triangles[j]));
}

}  // namespace
}  // namespace planish::test
