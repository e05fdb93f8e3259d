#include "sample_fits.hpp"

#include <planish/connect/codes.hpp>
#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

Plate tilted_plate() {
  const Vec3 o(10, 20, 30), a(80, 0, 60), b(0, 50, 0);
  Plate plate = rectangle_plate("A", o, a, b);
  plate.holes = {{o + 0.2 * a + 0.2 * b, o + 0.4 * a + 0.2 * b, o + 0.3 * a + 0.6 * b}};
  return plate;
}

ErrorCode refusal(const Plate& plate, const std::string& where) {
  const auto made = placed(plate, "/plates/7", 1e-3);
  EXPECT_FALSE(made);
  if (made) return code::internal;
  EXPECT_EQ(made.error().where, where) << made.error().message;
  return made.error().code;
}

TEST(Placed, KeepsEachCornerWhereItWas) {
  const Plate plate = tilted_plate();
  const PlacedPlate made = laid(plate);
  ASSERT_EQ(made.edge_count(), 4);
  for (int i = 0; i < 4; ++i)
    EXPECT_LT((made.corner(i) - plate.outline[i]).norm(), 1e-12);
  EXPECT_NEAR(made.area, 100 * 50, 1e-9);
  EXPECT_NEAR(made.extent, std::hypot(80, 60, 50), 1e-12);
}

TEST(Placed, RunsOutlinesOneWayAndHolesTheOther) {
  for (const bool turned : {false, true}) {
    Plate plate = tilted_plate();
    if (turned) {
      std::ranges::reverse(plate.outline);
      std::ranges::reverse(plate.holes[0]);
    }
    const PlacedPlate made = laid(plate);
    EXPECT_NEAR(ring_area(made.outline), 5000.0, 1e-9);
    EXPECT_NEAR(ring_area(made.holes[0]), -0.5 * 0.2 * 0.4 * 5000, 1e-9);
    // The normal is on the side from which the outline runs counter-clockwise.
    const Vec3 n = Vec3(-0.6, 0, 0.8) * (turned ? -1.0 : 1.0);
    EXPECT_LT((made.frame.z - n).norm(), 1e-12);
  }
}

TEST(Placed, RunsHolesAgainstTheOutlineHoweverTheyAreGivenAndHoweverSmall) {
  for (const double size : {1.0, 0.05})  // of 200 mm², and of half a square millimetre
    for (const bool turned : {false, true}) {
      Plate plate = tilted_plate();
      std::vector<Vec3>& hole = plate.holes[0];
      for (std::size_t i = 1; i < hole.size(); ++i)
        hole[i] = hole[0] + size * (hole[i] - hole[0]);
      if (turned) std::ranges::reverse(hole);
      const PlacedPlate made = laid(plate);
      EXPECT_NEAR(ring_area(made.holes[0]), -200 * size * size, 1e-9);
      EXPECT_EQ(made.turned, std::vector<bool>{!turned});
    }
}

TEST(Placed, TakesCornersThatLieOffThePlaneByLessThanIsAllowed) {
  Plate plate = tilted_plate();
  plate.holes.clear();
  plate.outline[2] += 2e-3 * Vec3(-0.6, 0, 0.8);  // a quarter of it off the middle plane
  EXPECT_TRUE(placed(plate, "/plates/7", 1e-3));
  EXPECT_EQ(placed(plate, "/plates/7", 1e-4).error().code, code::not_planar);
}

TEST(Placed, RefusesOutlinesThatAreNotPolygons) {
  Plate plate = tilted_plate();
  plate.outline.resize(2);
  EXPECT_EQ(refusal(plate, "/plates/7/outline"), code::too_few_corners);
  plate = tilted_plate();
  plate.outline[3] = plate.outline[2];
  EXPECT_EQ(refusal(plate, "/plates/7/outline/3"), code::repeated_corner);
  plate = tilted_plate();
  std::swap(plate.outline[1], plate.outline[2]);
  EXPECT_EQ(refusal(plate, "/plates/7/outline"), code::self_crossing);
}

TEST(Placed, RefusesAnEdgeThatRunsBackOverItself) {
  const Plate spike{
      "A", {{0, 0, 0}, {100, 0, 0}, {100, 50, 0}, {150, 50, 0}, {60, 50, 0}, {0, 50, 0}}, {}};
  EXPECT_EQ(refusal(spike, "/plates/7/outline"), code::self_crossing);
}

TEST(Placed, RefusesHolesOutsideOrAcrossEachOther) {
  Plate plate = tilted_plate();
  plate.holes[0][1] += Vec3(80, 0, 60);
  EXPECT_EQ(refusal(plate, "/plates/7/holes/0/1"), code::invalid_input);
  plate = tilted_plate();
  plate.holes.push_back(plate.holes[0]);
  EXPECT_EQ(refusal(plate, "/plates/7/holes/1"), code::self_crossing);
}

}  // namespace
}  // namespace planish::test
