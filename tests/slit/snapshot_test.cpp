#include "snapshot.hpp"

#include "sample_strips.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(Subdivided, KeepsEveryRidgeAndPutsOneBetween) {
  StripBase base = some_base(5);
  const StripParameters p = random_parameters(base, 8, 0.9);
  const FoldedStrip coarse = folded_strip(base, p);
  const StripParameters finer = subdivided(base, p);
  base.quads = 10;
  const FoldedStrip fine = folded_strip(base, finer);
  for (std::size_t ridge = 0; ridge < fine.ridges.size(); ++ridge)
    for (std::size_t side = 0; side < 2; ++side) {
      const Vec3 expected = 0.5 * (coarse.ridges[ridge / 2].folded[side] +
                                   coarse.ridges[(ridge + 1) / 2].folded[side]);
      EXPECT_NEAR((fine.ridges[ridge].folded[side] - expected).norm(), 0.0, 1e-12 * base.end[0]);
    }
  for (std::size_t ridge = 1; ridge < 10; ridge += 2)
    EXPECT_EQ(fine.ridges[ridge].fold.radians(), 0.0);
}

SlitDesign design_of(std::vector<double> widths) {
  SlitDesign design;
  for (const double width : widths)
    design.sheet.strips.push_back({.width = width});
  design.seat_curve = BezierCurve{{{0, 0}, {60, 80}}};  // 100 long
  return design;
}

/// Places along the seat curve, by their distance from its start.
std::vector<double> places(const SlitDesign& design) {
  Snapshot snapshot;
  take_seat_curve(snapshot, design);
  std::vector<double> distances;
  for (const Vec2& place : *snapshot.seat_places)
    distances.push_back(place.norm());
  return distances;
}

TEST(SeatPlaces, AreEvenlyApartFromEndToEnd) {
  const auto found = places(design_of({30, 20, 10}));
  const std::vector<double> expected{0, 30, 50, 70, 90, 100};
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-2) << i;
}

TEST(SeatPlaces, OfOneStripAreInTheMiddle) {
  const auto found = places(design_of({30}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 35.0, 1e-2);
  EXPECT_NEAR(found[1], 65.0, 1e-2);
}

TEST(ScanOf, NoPointsIsNull) {
  EXPECT_EQ(scan_of({}), nullptr);
  EXPECT_NE(scan_of({Vec3::Zero()}), nullptr);
}

}  // namespace
}  // namespace planish::test
