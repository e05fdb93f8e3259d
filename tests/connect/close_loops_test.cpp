#include "close_loops.hpp"

#include "sample_plates.hpp"

#include <gtest/gtest.h>

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
}

}  // namespace
}  // namespace planish::test
