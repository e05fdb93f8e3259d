#include "thickness.hpp"

#include "solid_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

using std::numbers::pi;

std::vector<double> thicknesses(const SolidModel& model) {
  return likely_thicknesses(model, outlines_of(model), 0.02);
}

/// Two thicknesses over a flat bottom, 60 mm and 40 mm wide.
SolidModel stepped(double left, double right) {
  return prism({{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, right}},
                 Segment{{100, right}, {60, right}}, Segment{{60, right}, {60, left}},
                 Segment{{60, left}, {0, left}}, Segment{{0, left}, {0, 0}}}},
               200);
}

TEST(LikelyThicknesses, OfAPlateIsItsOwn) {
  EXPECT_THAT(thicknesses(plate(2, {100, 60})), ElementsAre(DoubleNear(2.0, 1e-9)));
}

TEST(LikelyThicknesses, OfABentStripIsThatOfFlangesAndBends) {
  const SolidModel bent = prism({strip_profile(1.5, {{50, pi / 2, 3}, {30, -1.0, 2}, {20}})}, 400);
  EXPECT_THAT(thicknesses(bent), ElementsAre(DoubleNear(1.5, 1e-9)));
}

TEST(LikelyThicknesses, OfAChannelAreMeasuredToTheNearestFace) {
  // Each leg's outside lies 2 mm over its inside and 24 mm over the other leg's outside.
  const SolidModel channel = prism({strip_profile(2, {{40, pi / 2, 3}, {14, pi / 2, 3}, {40}})},
                                   300);
  EXPECT_THAT(thicknesses(channel), ElementsAre(DoubleNear(2.0, 1e-9)));
}

TEST(LikelyThicknesses, AreNotMeasuredToTheLedgesOfCounterbores) {
  // From below, and within the sheet: ledges that face down lie nearer to the top than the bottom.
  const SolidModel bored = plate(
      2, {100, 60},
      {{{30, 30}, {{4, 2}, {4, 1.2}, {8, 1.2}, {8, 0}}},
       {{70, 30}, {{4, 2}, {4, 1.5}, {8, 1.5}, {8, 0.5}, {4, 0.5}, {4, 0}}}});
  EXPECT_THAT(thicknesses(bored), ElementsAre(DoubleNear(2.0, 1e-9)));
  EXPECT_NEAR(plate_thickness(bored, outlines_of(bored)).value(), 2.0, 1e-9);
}

TEST(MilledThicknesses, AreBeyondTheLikeliest) {
  // The rim on the left is 3 mm wide, the floor 97 mm.
  const SolidModel milled = prism(
      {{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 2}}, Segment{{100, 2}, {3, 2}},
        Segment{{3, 2}, {3, 5}}, Segment{{3, 5}, {0, 5}}, Segment{{0, 5}, {0, 0}}}},
      200);
  EXPECT_THAT(thicknesses(milled), ElementsAre(DoubleNear(2, 1e-9)));
  EXPECT_THAT(milled_thicknesses(milled, outlines_of(milled), 0.02),
              ElementsAre(DoubleNear(3, 1e-9), DoubleNear(5, 1e-9), DoubleNear(100, 1e-9)))
      << "across the rim, at the rim, from wall to wall";
  const SolidModel whole = plate(2, {100, 60});
  for (const double deeper : milled_thicknesses(whole, outlines_of(whole), 0.02))
    EXPECT_GT(deeper, 50.0) << "from wall to wall";
}

TEST(LikelyThicknesses, AreOrderedByTheAreaThatAgrees) {
  // Bottom and tops vote for 2 mm with 60 × 200 mm² each, for 5 mm with 40 × 200.
  EXPECT_THAT(thicknesses(stepped(2, 5)), ElementsAre(DoubleNear(2, 1e-9), DoubleNear(5, 1e-9)));
}

TEST(LikelyThicknesses, ThatNearlyAgreeAreOneMean) {
  const double mean = (2.0 * 60 + 2.02 * 40) / 100;
  EXPECT_THAT(thicknesses(stepped(2, 2.02)), ElementsAre(DoubleNear(mean, 1e-9)));
}

TEST(LikelyThicknesses, AreThoseOfTheSheetAroundShallowRecesses) {
  // A groove of 30 mm hides as much of the bottom from the top, and no more.
  const SolidModel grooved = prism(
      {{Segment{{0, 0}, {40, 0}}, Segment{{40, 0}, {40, 0.3}}, Segment{{40, 0.3}, {70, 0.3}},
        Segment{{70, 0.3}, {70, 0}}, Segment{{70, 0}, {100, 0}}, Segment{{100, 0}, {100, 2}},
        Segment{{100, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      200);
  EXPECT_THAT(thicknesses(grooved), ElementsAre(DoubleNear(2, 1e-9), DoubleNear(1.7, 1e-9)));
}

TEST(LikelyThicknesses, AreUnknownWhereNoFacesAreOpposite) {
  SolidMaker tetrahedron;
  const Vec3 o(0, 0, 0), x(10, 0, 0), y(0, 10, 0), z(0, 0, 10);
  tetrahedron.plane(-Vec3::UnitZ(), {polygon_path({o, y, x})});
  tetrahedron.plane(-Vec3::UnitY(), {polygon_path({o, x, z})});
  tetrahedron.plane(-Vec3::UnitX(), {polygon_path({o, z, y})});
  tetrahedron.plane(Vec3(1, 1, 1).normalized(), {polygon_path({x, y, z})});
  EXPECT_THAT(thicknesses(std::move(tetrahedron).build()), IsEmpty());
}

}  // namespace
}  // namespace planish::brep::test
