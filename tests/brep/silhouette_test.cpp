#include "silhouette.hpp"

#include "guarded.hpp"
#include "recognised.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

const std::vector<Vec2> kOutline = rectangle_at({0, 0}, {100, 60});

/// Of the top of a plate of 2 mm.
std::optional<Silhouette> silhouette_in(const Recognised& seen) {
  return guarded([&] { return silhouette_of(seen.view(), kTop, kTop); }).value();
}

double area_of(const Silhouette& silhouette) {
  double area = 0.0;
  for (const BorderLoop& loop : silhouette.loops)
    for (const Border& border : loop)
      area += green_area(border.curve);
  return area;
}

TEST(Silhouette, OfAStepOnBothSidesIsTheWidest) {
  // Between the skins it is as wide as the blank.
  const std::vector<Vec2> above = rectangle_at({3, 1}, {99, 59});
  const std::vector<Vec2> below = rectangle_at({2, 2}, {98, 58});
  const Recognised seen = recognised(
      plate(2, {{{below, below, kOutline, kOutline, above, above}, {0, 0.6, 0.6, 1.2, 1.2, 2}}}), 2,
      kTop);
  const auto silhouette = silhouette_in(seen);
  ASSERT_TRUE(silhouette);
  EXPECT_FALSE(silhouette->outer_kept);
  EXPECT_NEAR(area_of(*silhouette), 6000.0, 1e-9);
}

TEST(Silhouette, IsNotAskedForByPlainWallsAndPlainCountersinks) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{6, 2}, {4, 1}, {4, 0}}}}), 2,
                                     kTop);
  EXPECT_FALSE(silhouette_in(seen)) << "its narrowest section is enough";
}

TEST(Silhouette, LeavesASlantedCutToTheSkins) {
  const Recognised seen = recognised(
      plate(2, {{{kOutline, rectangle_at({1, 1}, {99, 59})}, {0, 2}}}), 2, kTop);
  EXPECT_FALSE(silhouette_in(seen));
}

TEST(Ledges, AreWhatLooksTheSkinsWayBesideItsOutline) {
  const std::vector<Vec2> above = rectangle_at({3, 3}, {97, 57});
  const Recognised seen = recognised(
      plate(2, {{{kOutline, kOutline, above, above}, {0, 1.2, 1.2, 2}}}), 2, kTop);
  EXPECT_FALSE(ledges_of(seen.view(), kTop).empty());
  const Recognised plain = recognised(plate(2, {100, 60}), 2, kTop);
  EXPECT_TRUE(ledges_of(plain.view(), kTop).empty());
}

}  // namespace
}  // namespace planish::brep::test
