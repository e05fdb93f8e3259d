#include "flat_plates.hpp"

#include <planish/inspect/double_cover.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

/// Flat faces that lie where they are given, each a flange of its own.
struct LaidFaces {
  Sheet sheet;
  Layout layout;
  FlatPattern pattern;

  explicit LaidFaces(const std::vector<Loop>& outlines) {
    pattern.thickness = sheet.thickness = 1.0;
    for (const Loop& outline : outlines) {
      Face face;
      face.surface = Frame{};
      face.part_of = FlangeId{static_cast<int>(sheet.faces.size())};
      sheet.faces.push_back(face);
      layout.images.push_back({outline});
    }
  }
  std::vector<DoubleCover> covers() const { return double_covers(sheet, layout, pattern); }
  SheetArea area() const { return {sheet, layout, pattern}; }
};

Loop plate_at(double x, double y, double width, double height) {
  return shifted(rectangle(width, height), Vec2(x, y));
}

std::vector<Place> kinds_of(const DoubleCover& cover) {
  std::vector<Place> parts = cover.parts;
  for (Place& part : parts)
    part.at.clear();
  return parts;
}

/// Each region is shrunk by the clearance, a thousandth of the thickness, before it is measured.
constexpr double kShrunk = 0.002;

TEST(DoubleCover, IsMeasuredByItsSmallestRectangle) {
  for (const double turned : {0.0, 0.5, 1.2, -0.9}) {
    const Isometry2 turn(Eigen::Rotation2Dd{turned});
    // 14 × 6 covered twice, about (23, 10).
    const LaidFaces laid(
        {transformed(plate_at(0, 0, 30, 20), turn), transformed(plate_at(16, 7, 40, 6), turn)});
    const auto covers = laid.covers();
    ASSERT_EQ(covers.size(), 1u);
    const DoubleCover& cover = covers[0];
    EXPECT_EQ(kinds_of(cover), (std::vector{place::flange(1), place::flange(2)}));
    EXPECT_EQ(cover.who, "flange 1 and flange 2");
    EXPECT_NEAR(cover.area, 84.0, 20 * 2 * kShrunk);
    EXPECT_LT((cover.middle - turn * Vec2(23, 10)).norm(), kShrunk) << turned;
    EXPECT_LT((cover.size - Vec2(14, 6)).norm(), 2 * kShrunk);
    EXPECT_NEAR(std::abs(cover.along.dot(turn * Vec2(1, 0))), 1.0, 1e-6);
    for (const Place& part : cover.parts)
      EXPECT_EQ(part, place::at(place::flange(part == cover.parts[0] ? 1 : 2), cover.middle));
  }
}

TEST(DoubleCover, HasItsMiddleInThatOfItsRectangleNotOfItsCorners) {
  // A triangle with two corners near each other: 20 × 10, along x.
  const LaidFaces laid({plate_at(0, 0, 60, 40), polygon({{10, 10}, {30, 10}, {10, 20}})});
  const auto covers = laid.covers();
  ASSERT_EQ(covers.size(), 1u);
  EXPECT_NEAR(covers[0].area, 100.0, 0.2);
  // The smallest rectangle of a right triangle lies along a leg, or along the hypotenuse: equal
  // areas.
  EXPECT_NEAR(covers[0].size.x() * covers[0].size.y(), 200.0, 0.3);
  const Vec2 across(-covers[0].along.y(), covers[0].along.x());
  for (const Vec2& corner : {Vec2(10, 10), Vec2(30, 10), Vec2(10, 20)}) {
    EXPECT_LT(std::abs((corner - covers[0].middle).dot(covers[0].along)),
              covers[0].size.x() / 2 + 4 * kShrunk);
    EXPECT_LT(std::abs((corner - covers[0].middle).dot(across)),
              covers[0].size.y() / 2 + 4 * kShrunk);
  }
}

TEST(DoubleCover, JoinsWhatMeetsAndNoMore) {
  // A bar over two plates that touch: one place of three parts.
  const LaidFaces touching(
      {plate_at(0, 0, 20, 20), plate_at(20, 0, 20, 20), plate_at(10, 5, 20, 4)});
  const auto one = touching.covers();
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(one[0].area, 80.0, 0.3);
  EXPECT_NEAR(one[0].size.x(), 20.0, 3 * kShrunk);
  EXPECT_EQ(kinds_of(one[0]), (std::vector{place::flange(1), place::flange(3), place::flange(2)}));
  // Over two plates 0.1 apart: a place on each.
  const LaidFaces apart(
      {plate_at(0, 0, 20, 20), plate_at(20.1, 0, 20, 20), plate_at(10, 5, 20, 4)});
  const auto two = apart.covers();
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0].area + two[1].area, 80.0 - 0.4, 0.3);
  // The same one above the other.
  EXPECT_EQ(LaidFaces({plate_at(0, 0, 20, 20), plate_at(0, 20, 20, 20), plate_at(5, 10, 4, 20)})
                .covers()
                .size(),
            1u);
  EXPECT_EQ(LaidFaces({plate_at(0, 0, 20, 20), plate_at(0, 20.1, 20, 20), plate_at(5, 10, 4, 20)})
                .covers()
                .size(),
            2u);
}

TEST(DoubleCover, JoinsAChainInWhateverOrderItIsMet) {
  // Places 1, 3 and 2 along a bar: the middle one joins the others.
  const LaidFaces laid({plate_at(0, 0, 10, 20), plate_at(20, 0, 10, 20), plate_at(10, 0, 10, 20),
                        plate_at(2, 5, 26, 4)});
  const auto covers = laid.covers();
  ASSERT_EQ(covers.size(), 1u);
  EXPECT_EQ(covers[0].parts.size(), 4u);
  EXPECT_NEAR(covers[0].area, 26.0 * 4, 0.4);
  EXPECT_LT((covers[0].middle - Vec2(15, 7)).norm(), 2 * kShrunk);
}

TEST(DoubleCover, OfWhatMerelyTouchesIsNone) {
  EXPECT_TRUE(LaidFaces({plate_at(0, 0, 20, 20), plate_at(20, 0, 20, 20)}).covers().empty());
}

TEST(SheetAreaWithin, CountsWhatIsCoveredTwiceTwice) {
  const LaidFaces laid({plate_at(0, 0, 20, 20), plate_at(10, 0, 20, 20), plate_at(60, 0, 5, 5)});
  const SheetArea area = laid.area();
  EXPECT_NEAR(area.within(plate_at(-5, -5, 100, 100)), 2 * 400 + 25, 1e-6);
  EXPECT_NEAR(area.within(plate_at(0, 0, 10, 20)), 200, 1e-6);
  EXPECT_NEAR(area.within(plate_at(5, 3, 10, 2)), 2 * 10 + 2 * 5, 1e-6);
  EXPECT_NEAR(area.within(plate_at(40, 0, 10, 10)), 0.0, 1e-9);
  EXPECT_NEAR(area.within(plate_at(29.9, 7, 10, 0.3)), 0.03, 1e-9) << "however little";
}

TEST(SheetAreaWithin, OfACircleIsThatOfItsDisc) {
  const LaidFaces laid({plate_at(0, 0, 40, 40)});
  const Loop disc{Arc{Vec2(20, 20), 10, 0, 2 * pi}};
  EXPECT_NEAR(laid.area().within(disc), 100 * pi, 0.02);
  const Loop half_off{Arc{Vec2(40, 20), 10, 0, 2 * pi}};
  EXPECT_NEAR(laid.area().within(half_off), 50 * pi, 0.02);
}

TEST(SheetAreaWithin, LeavesOutOtherLoops) {
  const LaidFaces laid({plate_at(0, 0, 40, 40), plate_at(30, 0, 40, 40)});
  const SheetArea area = laid.area();
  const Loop whole = plate_at(-1, -1, 80, 50);
  EXPECT_NEAR(area.within(whole, {plate_at(5, 5, 10, 10)}), 3200 - 100, 1e-6);
  EXPECT_NEAR(area.within(whole, {plate_at(32, 5, 6, 10)}), 3200 - 2 * 60, 1e-6);
  EXPECT_NEAR(area.within(whole, {plate_at(5, 5, 10, 10), plate_at(10, 5, 10, 10)}), 3200 - 150,
              1e-6);
  EXPECT_NEAR(area.within(whole, {plate_at(200, 5, 10, 10)}), 3200, 1e-6);
  EXPECT_NEAR(area.within(plate_at(0, 0, 20, 20), {plate_at(10, -5, 50, 50)}), 200, 1e-6);
}

}  // namespace
}  // namespace planish::test
