#include "ruling_names.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace transition_detail;

using Names = std::array<std::string, 2>;

TEST(RulingNames, AreLettersInCornersAndNumbersElsewhere) {
  const Ring ring = square_to_circle();
  RulingNames names(*ring.hull, 1e-6);
  EXPECT_EQ(names.add({Vec3(-50, -50, 0), Vec3(0, -30, 80)}, "", 0), (Names{"A", "1'"}));
  EXPECT_EQ(names.add({Vec3(50, 50, 0), Vec3(30, 0, 80)}, "", 0), (Names{"C", "2'"}));
  EXPECT_EQ(names.add({Vec3(50, 0, 0), Vec3(30, 0, 80)}, "", 0), (Names{"1", "2'"}));
  const Ring squares = pyramid();
  RulingNames both(*squares.hull, 1e-6);
  EXPECT_EQ(both.add({Vec3(50, -50, 0), Vec3(30, -30, 80)}, "", 0), (Names{"B", "b"}));
}

TEST(RulingNames, GoOnAfterTheAlphabet) {
  const auto corners = regular_polygon(30, 50).corners;
  const Ring ring = ring_between(PolygonProfile{corners}, EllipseProfile{20, 20}, {0, 0, 80});
  RulingNames names(*ring.hull, 1e-6);
  const auto name = [&](int corner) {
    return names.add({Vec3(corners[corner].x(), corners[corner].y(), 0), Vec3(20, 0, 80)}, "",
                     0)[0];
  };
  EXPECT_EQ(name(25), "Z");
  EXPECT_EQ(name(26), "A1");
  EXPECT_EQ(name(27), "B1");
}

TEST(RulingNames, KeepEachRulingOnceWithItsLength) {
  const Ring ring = square_to_circle();
  RulingNames names(*ring.hull, 1e-6);
  const std::array<Vec3, 2> ruling{Vec3(-50, -50, 0), Vec3(0, -30, 80)};
  names.add(ruling, "B1", 0);
  const std::array<Vec3, 2> near{ruling[0] + Vec3(0, 5e-7, 0), ruling[1]};
  EXPECT_EQ(names.add(near, "", 1), (Names{"A", "1'"}));
  ASSERT_EQ(names.true_lengths().size(), 1u);
  const TrueLength& known = names.true_lengths()[0];
  EXPECT_NEAR(known.length, std::sqrt(50 * 50 + 20 * 20 + 80 * 80), 1e-12);
  EXPECT_EQ(known.piece, 0);
  EXPECT_EQ(known.press, "B1");
  names.add({ruling[0] + Vec3(0, 5e-6, 0), ruling[1]}, "", 1);
  ASSERT_EQ(names.true_lengths().size(), 2u);
  EXPECT_EQ(names.true_lengths()[1].piece, 1);
}

}  // namespace
}  // namespace planish::test
