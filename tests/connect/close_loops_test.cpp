#include "close_loops.hpp"

#include "sample_plates.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

TEST(CloseLoops, JoinsWhatLiesFlat) {
  // Two floors beside each other, joined by a wall on either side.
  PlateStructure s;
  s.thickness = 2;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {90, 0, 0}, {0, 100, 0}),
              rectangle_plate("B", {110, 0, 0}, {90, 0, 0}, {0, 100, 0}),
              rectangle_plate("C", {0, 0, 0}, {200, 0, 0}, {0, 0, 50}),
              rectangle_plate("D", {0, 100, 0}, {200, 0, 0}, {0, 0, 50})};
  const auto made = connect(s);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->bends.size(), 4u);
  EXPECT_TRUE(made->left_open.empty());
  for (const FittedBend& bend : made->bends) {
    EXPECT_NEAR(bend.joined, 90.0, 1e-9);
    EXPECT_NEAR(std::min(bend.unused[0], bend.unused[1]), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace planish::test
