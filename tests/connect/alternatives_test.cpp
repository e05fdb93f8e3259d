#include "alternatives.hpp"

#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

// What is said of bends that are not the widest: the shortest on request, and all that are worth
// choosing among.

namespace planish::test {
namespace {

using std::numbers::pi;

/// An irregular polygon in the plane of `e` and x, some way from the x axis.
Plate random_plate(std::mt19937& random, const std::string& id, const Vec3& e) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<double> angles(4 + static_cast<std::size_t>(2 * unit(random)));
  for (double& angle : angles)
    angle = 2.0 * pi * unit(random);
  std::ranges::sort(angles);
  const Vec2 middle(80 * unit(random) - 40, 130 + 50 * unit(random));
  Plate plate{id, {}, {}};
  for (const double angle : angles) {
    const double radius = 60 + 40 * unit(random);
    const Vec2 p = middle + radius * Vec2(std::cos(angle), std::sin(angle));
    plate.outline.push_back(p.x() * Vec3::UnitX() + p.y() * e);
  }
  return plate;
}

PlateStructure random_pair(unsigned seed) {
  std::mt19937 random(seed);
  const double beta = std::uniform_real_distribution<double>(0.9, 2.4)(random);
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {random_plate(random, "A", Vec3::UnitY()),
              random_plate(random, "B", {0, std::cos(beta), std::sin(beta)})};
  s.bends = {{.between = {"A", "B"}, .trade_off = 0.0}};
  return s;
}

TEST(ShortestBend, IsReturnedWhereWidthCountsForNothingOrItIsSaidWhyNot) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    PlateStructure pair = random_pair(seed);
    const auto chosen = connect(pair);
    if (!chosen) continue;  // an outline that crosses itself
    for (int i = 0; i < std::ssize(pair.plates[0].outline); ++i)
      for (int j = 0; j < std::ssize(pair.plates[1].outline); ++j) {
        pair.bends[0].edges = {std::vector{i}, std::vector{j}};
        const auto asked = connect(pair);
        if (!asked) continue;
        ++compared;
        EXPECT_TRUE(chosen->bends[0].span <= asked->bends[0].span + 1e-6 ||
                    chosen->bends[0].passed_over)
            << "seed " << seed << ": " << chosen->bends[0].span << " where edges " << i << " and "
            << j << " have " << asked->bends[0].span;
      }
  }
  EXPECT_GT(compared, 10);
}

TEST(Alternatives, AreThoseOfWhichNoneIsBothWiderAndShorter) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const auto made = connect(random_pair(seed));
    if (!made) continue;
    const auto& others = made->bends[0].alternatives;
    for (std::size_t i = 1; i < others.size(); ++i) {
      EXPECT_LT(others[i].width, others[i - 1].width + 1e-9);
      EXPECT_LT(others[i].span, others[i - 1].span);
    }
    for (const BendAlternative& other : others)
      EXPECT_FALSE(other.request.edges[0] == made->bends[0].edges[0] &&
                   other.request.edges[1] == made->bends[0].edges[1]);
  }
}

TEST(Alternatives, AskedForGiveTheBendThatTheyTell) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    PlateStructure pair = random_pair(seed);
    const auto made = connect(pair);
    if (!made) continue;
    for (const BendAlternative& other : made->bends[0].alternatives) {
      ASSERT_TRUE(other.request.edges[0] && other.request.edges[1]);
      pair.bends = {other.request};
      const auto asked = connect(pair);
      if (!asked) continue;  // what else it runs into is not known yet
      ++compared;
      const FittedBend& bend = asked->bends[0];
      EXPECT_EQ(bend.edges[0], *other.request.edges[0]) << seed;
      EXPECT_EQ(bend.edges[1], *other.request.edges[1]) << seed;
      EXPECT_EQ(bend.edge_kind, other.edge_kind) << seed;
      EXPECT_NEAR(bend.width, other.width, 1e-6) << seed;
      EXPECT_NEAR(bend.span, other.span, 1e-6) << seed;
    }
  }
  EXPECT_GT(compared, 3);
}

/// A plate of 200 × 100, and one 20 mm beside it that is turned about a line.
PlateStructure nearly_one_plane(const Vec3& through, const Vec3& along, double degrees) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
              rectangle_plate("B", {220, 0, 0}, {180, 0, 0}, {0, 100, 0})};
  const Eigen::AngleAxisd turn(degrees * pi / 180, along.normalized());
  for (Vec3& p : s.plates[1].outline)
    p = through + turn * (p - through);
  return s;
}

TEST(NearlyCoplanarPlates, AreCalledSoAndNotSaidToRunIntoEachOther) {
  for (const auto& [through, along] :
       {std::pair{Vec3(300, 50, 0), Vec3(1, 0, 0)}, std::pair{Vec3(300, 50, 0), Vec3(1, 1, 0)},
        std::pair{Vec3(300, 0, 0), Vec3(1, 0, 0)}, std::pair{Vec3(300, 50, 0), Vec3(0, 1, 0)},
        std::pair{Vec3(100, 0, 0), Vec3(0, 1, 0)}}) {
    const auto refused = connect(nearly_one_plane(through, along, 0.05));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, code::plates_coplanar) << refused.error().message;
  }
  // About a line between them a bend fits.
  EXPECT_TRUE(connect(nearly_one_plane({210, 0, 0}, {0, 1, 0}, 0.05)));
}

}  // namespace
}  // namespace planish::test
