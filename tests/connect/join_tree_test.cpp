#include "join_tree.hpp"

#include "sample_fits.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <set>

namespace planish::test {
namespace {

using namespace connect_detail;

std::vector<PlacedPlate> all_laid(const PlateStructure& s) {
  std::vector<PlacedPlate> plates;
  for (const Plate& plate : s.plates)
    plates.push_back(laid(plate));
  return plates;
}

Result<std::vector<BendFit>> tree(const PlateStructure& s, const Progress& progress = {}) {
  return fit_tree(s, all_laid(s), {}, {}, progress);
}
Result<std::vector<BendFit>> requested(const PlateStructure& s) {
  return fit_requested(s, all_laid(s), {}, {});
}

TEST(FitTree, HangsEachWallOnTheFloorByAnEdgeOfItsOwn) {
  const auto fits = tree(tray());
  ASSERT_TRUE(fits) << fits.error().message;
  ASSERT_EQ(fits->size(), 4u);
  std::set<int> walls, edges;
  for (const BendFit& fit : *fits) {
    EXPECT_EQ(fit.report.plates[0], 0);
    walls.insert(fit.report.plates[1]);
    edges.insert(fit.report.edges[0].begin(), fit.report.edges[0].end());
  }
  EXPECT_EQ(walls.size(), 4u);
  EXPECT_EQ(edges.size(), 4u);
}

TEST(FitTree, JoinsTheNearestFirst) {
  // Three plates in a row of right angles; the gap at the second is smaller.
  PlateStructure s = angle_pair(14.0);
  s.plates.push_back(rectangle_plate("C", {0, 124, 124}, {200, 0, 0}, {0, 100, 0}));
  const auto fits = tree(s);
  ASSERT_TRUE(fits) << fits.error().message;
  ASSERT_EQ(fits->size(), 2u);
  EXPECT_EQ((*fits)[0].report.plates, (std::vector{1, 2}));
  EXPECT_EQ((*fits)[1].report.plates, (std::vector{0, 1}));
}

TEST(FitTree, SaysWhichPlateStaysAloneAndWhy) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1] = rectangle_plate("C", {0, -300, 0}, {200, 0, 0}, {0, 100, 0});
  const auto alone = tree(s);
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().code, code::plates_coplanar);
  EXPECT_EQ(alone.error().where, "/plates/1");
  EXPECT_NE(alone.error().message.find("\"C\""), std::string::npos) << alone.error().message;
}

TEST(FitTree, StopsWhenItIsCancelled) {
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_EQ(tree(tray(), progress).error().code, code::cancelled);
}

TEST(FitRequested, KeepsTheOrderAndFitsGivenEdgesFirst) {
  // The first bend would take the edge that the second names.
  PlateStructure s = tray();
  s.bends = {{.between = {"floor", "front"}},
             {.between = {"floor", "back"}, .edges = {std::vector{2}, std::nullopt}},
             {.between = {"left", "floor"}},
             {.between = {"floor", "right"}}};
  const auto fits = requested(s);
  ASSERT_TRUE(fits) << fits.error().message;
  ASSERT_EQ(fits->size(), 4u);
  EXPECT_EQ((*fits)[1].report.edges[0], std::vector{2});
  EXPECT_EQ((*fits)[2].report.plates, (std::vector{3, 0}));
}

TEST(FitRequested, RefusesPlatesLeftAlone) {
  PlateStructure s = tray();
  s.bends = {{.between = {"floor", "front"}}};
  const auto alone = requested(s);
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().code, code::not_connected);
  EXPECT_NE(alone.error().message.find("\"back\""), std::string::npos) << alone.error().message;
}

}  // namespace
}  // namespace planish::test
