#include "mould_clear.hpp"

#include "support/error_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace planish::test {
namespace {

using namespace slit_detail;

/// A level rib on a base at z = 0: a rectangle in x and y, its facet at a height.
MouldRib block(int strip, const Vec2& low, const Vec2& high, double height) {
  MouldRib rib;
  rib.strip = strip;
  const auto at = [&](double x, double y) { return Vec3(x, y, height); };
  rib.facets = {
      {at(low.x(), low.y()), at(high.x(), low.y()), at(high.x(), high.y()), at(low.x(), high.y())}};
  rib.footprint = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  return rib;
}

/// A level strip of one quad above it, normals down towards the mould.
std::vector<WholeStrip> level_strip(const Vec2& low, const Vec2& high, double height) {
  WholeStrip strip;
  strip.ridges = {{Vec3(low.x(), low.y(), height), Vec3(low.x(), high.y(), height)},
                  {Vec3(high.x(), low.y(), height), Vec3(high.x(), high.y(), height)}};
  strip.towards_mould = {-Vec3::UnitZ()};
  return {strip};
}

/// Places where ribs come up through strips 2 mm thick.
std::vector<RibThrough> through(const Mould& mould,
                                const std::vector<std::vector<WholeStrip>>& strips) {
  return ribs_through(mould, strips, 1.0);
}

TEST(Mitre, IsOneThicknessAwayFromBothFacets) {
  for (const double angle : {0.0, 0.5, 1.5, 2.5}) {
    const std::array<Vec3, 2> normals{Vec3::UnitZ(), Vec3(std::sin(angle), 0, std::cos(angle))};
    for (const Vec3& normal : normals)
      EXPECT_NEAR(mitre(normals, 1).dot(normal), 1.0, 1e-14);
  }
}

TEST(CheckClear, LetsRibsStandSideBySide) {
  Mould mould;
  mould.ribs = {block(0, {0, 0}, {100, 20}, 30), block(1, {0, 20}, {100, 40}, 50)};
  EXPECT_TRUE(check_apart(mould));
  EXPECT_TRUE(
      through(mould, {level_strip({0, 0}, {100, 20}, 31), level_strip({0, 20}, {100, 40}, 51)})
          .empty());
}

TEST(CheckClear, LetsRibsShareWhatRoundingMakes) {
  Mould mould;  // of ribs of 2,000 mm², a ten-millionth of 1 mm²
  mould.ribs = {block(0, {0, 0}, {100, 20}, 30), block(1, {0, 20 - 1e-9}, {100, 40}, 50)};
  EXPECT_TRUE(check_apart(mould));
}

TEST(CheckClear, LetsARibStandBesideALowerStripThatRoundingPutsBelowIt) {
  // A ten-millionth of 1 mm² again, of the strip of 2,000 mm² at 31.
  Mould mould;
  mould.ribs = {block(0, {0, 0}, {100, 20}, 50)};
  const auto own = level_strip({0, 0}, {100, 20}, 51);
  EXPECT_TRUE(through(mould, {own, level_strip({0, 20 - 1e-9}, {100, 40}, 31)}).empty());
  EXPECT_FALSE(through(mould, {own, level_strip({0, 19.9}, {100, 40}, 31)}).empty());
}

TEST(CheckClear, RefusesRibsThatOverlapByTheirArea) {
  Mould mould;
  mould.ribs = {block(0, {0, 0}, {100, 20}, 30), block(1, {0, 15}, {100, 40}, 50)};
  const auto clear = check_apart(mould);
  ASSERT_FALSE(clear);
  EXPECT_EQ(clear.error().code, code::unsupported_shape);
  EXPECT_NEAR(number_in(clear.error(), "area"), 500.0, 1e-6);
  EXPECT_EQ(unit_in(clear.error(), "area"), unit::mm2);
  EXPECT_EQ(ids_in(clear.error(), PlaceKind::strip), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(clear.error().where, "strip 0") << "as files count";
  const std::vector<double> at = at_in(clear.error(), PlaceKind::point);
  ASSERT_EQ(at.size(), 3u);
  EXPECT_TRUE(at[1] >= 15.0 && at[1] <= 20.0) << at[1];
  EXPECT_TRUE(is_told(clear.error())) << clear.error().message;
}

TEST(CheckClear, NamesAStripWhoseRibOverlapsThatOfItsMirrorImage) {
  Mould mould;
  mould.ribs = {block(2, {0, 0}, {100, 20}, 30), block(2, {0, 15}, {100, 40}, 50)};
  const auto clear = check_apart(mould);
  ASSERT_FALSE(clear);
  EXPECT_EQ(ids_in(clear.error(), PlaceKind::strip), std::vector<std::string>{"3"});
  EXPECT_NE(clear.error().message.find("symmetry plane"), std::string::npos);
  EXPECT_EQ(clear.error().where, "strip 2");
}

TEST(CheckClear, SeesASmallOverlapOfALargeRibWithASmallOne) {
  // A hundredth of a square millimetre of a rib of a square metre.
  for (const bool large_first : {true, false}) {
    Mould mould;
    mould.ribs = {block(0, {0, 0}, {1000, 1000}, 30), block(1, {999.99, 0}, {1010, 1}, 30)};
    if (!large_first) std::swap(mould.ribs[0], mould.ribs[1]);
    EXPECT_FALSE(check_apart(mould));
    mould.ribs = {block(0, {0, 0}, {1000, 1000}, 30), block(1, {1000, 0}, {1010, 1}, 30)};
    EXPECT_TRUE(check_apart(mould));
  }
}

TEST(CheckClear, RefusesAFootprintThatCrossesItself) {
  Mould mould;
  mould.ribs = {block(3, {0, 0}, {100, 20}, 30)};
  std::swap(mould.ribs[0].footprint[0], mould.ribs[0].footprint[1]);
  EXPECT_FALSE(check_apart(mould));
}

TEST(CheckClear, LetsARibStandBelowAnotherStripButNotThroughIt) {
  // The lower skin of the other strip, 2 mm thick, is 1 mm below its middle.
  Mould mould;
  mould.ribs = {block(0, {0, 0}, {100, 20}, 30)};
  const auto own = level_strip({0, 0}, {100, 20}, 31);
  EXPECT_TRUE(through(mould, {own, level_strip({0, 10}, {100, 40}, 31.001)}).empty());
  EXPECT_FALSE(through(mould, {own, level_strip({0, 10}, {100, 40}, 30.999)}).empty());
}

/// Corners of a ring, its least and its greatest.
Box2 box(const std::vector<Vec2>& ring) {
  Box2 all;
  for (const Vec2& p : ring)
    all.add(p);
  return all;
}

TEST(RibsThrough, SaysWhereAndByHowMuch) {
  Mould mould;
  mould.ribs = {block(0, {0, 0}, {100, 20}, 30)};
  const auto own = level_strip({0, 0}, {100, 20}, 31);
  const auto found = through(mould, {own, level_strip({10, 14}, {90, 40}, 26)});
  ASSERT_EQ(found.size(), 2u) << "both skins of the other strip, whose height is that of the lower";
  for (const RibThrough& one : found) {
    EXPECT_EQ(one.rib.strip, 0);
    EXPECT_EQ(one.strip.strip, 1);
    EXPECT_NEAR(one.height, 30 - 25, 1e-12);
    EXPECT_NEAR(one.at.z(), 25, 1e-12);
    EXPECT_NEAR((box(one.around).lo - Vec2(10, 14)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((box(one.around).hi - Vec2(90, 20)).norm(), 0.0, 1e-12);
  }
}

TEST(RibsThrough, IsOnlyWhereTheRibIsAbove) {
  // The other strip rises from 25 to 35 over the rib's length: its lower skin passes the rib's 30
  // in the middle, 1 mm · √(1 + 0.1²) below its own.
  Mould mould;
  mould.ribs = {block(0, {0, 0}, {100, 20}, 30)};
  auto rising = level_strip({0, 10}, {100, 40}, 0);
  for (std::size_t end = 0; end < 2; ++end)
    for (Vec3& p : rising.front().ridges[end])
      p.z() = end == 0 ? 25 : 35;
  const double steep = std::hypot(1.0, 0.1);
  rising.front().towards_mould = {Vec3(0.1, 0, -1) / steep};
  const auto found = through(mould, {level_strip({0, 0}, {100, 20}, 31), rising});
  ASSERT_FALSE(found.empty());
  double furthest = 0.0;
  for (const RibThrough& one : found)
    furthest = std::max(furthest, box(one.around).hi.x());
  EXPECT_NEAR(furthest, 50 + 10 * steep - 1e-5, 1e-9) << "heights equal to 1e-6 are no passage";
}

}  // namespace
}  // namespace planish::test
