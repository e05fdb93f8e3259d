#include "loops.hpp"

#include "sample_parts.hpp"
#include "support/error_data.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

/// A floor with a wall on each of two neighbouring sides, and the walls joined as well where asked:
/// a corner of a box, which does not lie flat.
PlateStructure box_corner(bool closed) {
  PlateStructure s;
  s.thickness = 2;
  const double gap = 8;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {200, 0, 0}, {0, 150, 0}),
              rectangle_plate("front", {0, -gap, gap}, {200, 0, 0}, {0, 0, 80}),
              rectangle_plate("left", {-gap, 0, gap}, {0, 150, 0}, {0, 0, 80})};
  s.bends = {{.between = {"floor", "front"}}, {.between = {"floor", "left"}}};
  if (closed) s.bends.push_back({.between = {"front", "left"}});
  return s;
}

TEST(CheckLoops, LetsTreesPass) {
  const Parts parts = parts_of(box_corner(false));
  const auto made = assembled(parts);
  ASSERT_TRUE(made);
  EXPECT_TRUE(check_loops(parts, *made, 0.44));
}

TEST(CheckLoops, RefusesALoopThatDoesNotLieFlatAtItsClosingBend) {
  const Parts parts = parts_of(box_corner(true));
  const auto made = assembled(parts);
  ASSERT_TRUE(made) << made.error().message;
  const auto checked = check_loops(parts, *made, 0.44);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, code::bend_loop);
  EXPECT_EQ(pointers_in(checked.error()), std::vector<std::string>{"/bends/2"});
  EXPECT_EQ(ids_in(checked.error(), PlaceKind::plate),
            (std::vector<std::string>{"\"front\"", "\"left\""}));
  EXPECT_TRUE(is_told(checked.error()));
}

}  // namespace
}  // namespace planish::test
