#include "cut_back.hpp"

#include "flat_area.hpp"
#include "sample_plates.hpp"

#include <planish/connect/connect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

TEST(CutBack, LeavesARecessForAWallOnPartOfAnEdge) {
  // A wall of 60 in the middle of an edge of 200; t 2, cut 3 deep, with reliefs of 2 × 4.
  PlateStructure s;
  s.thickness = 2;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
              rectangle_plate("wall", {70, 0, 0}, {60, 0, 0}, {0, 0, 50})};
  const auto made = connect(s);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->bends.size(), 1u);
  EXPECT_NEAR(made->bends[0].joined, 60.0, 1e-6);
  EXPECT_NEAR(area_when_flat(*made),
              200 * 100 - 60 * 3 - 2 * 2 * 4 + 60 * (50 - 3) + 60 * pi / 2 * 3, 1e-6);
}

TEST(CutBack, MovesEdgesInParallelAndCornersToWhereTheyMeet) {
  using namespace connect_detail;
  auto plate = placed(rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}), "/plates/0", 1e-3);
  ASSERT_TRUE(plate);
  PlateCuts cuts{std::vector<EdgeCut>(4)};
  cuts[0][0].strips = {{0, 200, 3}};
  cuts[0][1].strips = {{0, 100, 5}};
  cuts[0][3].corner = 10;
  EXPECT_EQ(cut_back(*plate, cuts, 2.0), 10.0);
  EXPECT_NEAR(plate->area, 195 * 97 - 0.5 * 10 * 10, 1e-9);
  EXPECT_EQ(plate->numbers.at(0), (std::vector{0, 1, 2, 4, 3}));
  EXPECT_EQ(plate->all_edges(), 5);
  for (int number = 0; number < 5; ++number)
    EXPECT_EQ(plate->edge_number(plate->place_of(number)), number);
}

TEST(CutBack, LeavesAPlateAloneThatWouldNotRemainWhole) {
  using namespace connect_detail;
  auto plate = placed(rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}), "/plates/0", 1e-3);
  ASSERT_TRUE(plate);
  PlateCuts cuts{std::vector<EdgeCut>(4)};
  cuts[0][0].strips = {{0, 200, 120}};
  EXPECT_FALSE(cut_back(*plate, cuts, 2.0));
  EXPECT_NEAR(plate->area, 200 * 100, 1e-9);
  EXPECT_FALSE(cut_back(*plate, PlateCuts{std::vector<EdgeCut>(4)}, 2.0));
}

}  // namespace
}  // namespace planish::test
