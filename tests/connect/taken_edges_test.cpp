#include "taken_edges.hpp"

#include "sample_fits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;
using ::testing::ElementsAre;

struct LaidTray {
  PlateStructure structure = tray();
  std::vector<PlacedPlate> plates;
  LaidTray() {
    for (const Plate& plate : structure.plates)
      plates.push_back(laid(plate));
  }
};

TEST(TakenEdges, AreThoseOfBothPlatesOfABend) {
  const LaidTray tray;
  BendFit fit;
  fit.report.plates = {2, 0};
  fit.runs = {OutlineRun{.first = 1, .count = 1}, OutlineRun{.first = 3, .count = 2, .end = 0.5}};
  TakenEdges taken(tray.plates.size());
  take(fit, tray.plates, taken);
  EXPECT_THAT(taken[2].whole, ElementsAre(1));
  EXPECT_TRUE(taken[2].parts.empty());
  EXPECT_THAT(taken[0].whole, ElementsAre(3));
  ASSERT_EQ(taken[0].parts.size(), 1u);
  EXPECT_THAT(taken[0].parts.at(0), ElementsAre(std::pair{0.0, 0.5}));
  EXPECT_TRUE(taken[1].whole.empty() && taken[3].whole.empty() && taken[4].whole.empty());
}

TEST(TakenEdges, AreThoseOfABandWithWhatLiesBeyondRecesses) {
  const LaidTray tray;
  BendBand band;
  band.runs = {OutlineRun{.first = 0, .count = 1}, OutlineRun{.first = 2, .count = 1}};
  band.more[1] = {OutlineRun{.first = 3, .count = 1},
                  OutlineRun{.first = 1, .count = 1, .start = 0.75}};
  TakenEdges taken(tray.plates.size());
  take(band, {4, 1}, tray.plates, taken);
  EXPECT_THAT(taken[4].whole, ElementsAre(0));
  EXPECT_THAT(taken[1].whole, ElementsAre(2, 3));
  EXPECT_THAT(taken[1].parts.at(1), ElementsAre(std::pair{0.75, 1.0}));
}

TEST(FitTasks, KnowTheirPlatesAndWhatOthersHaveTaken) {
  const LaidTray tray;
  TakenEdges taken(tray.plates.size());
  taken[3].whole = {2};
  taken[0].parts[1] = {{0.0, 0.25}};
  BendRequest request;
  request.inside_radius = 4.5;
  const FitTask task = task_of(tray.structure, tray.plates, taken, {3, 0}, request);
  EXPECT_EQ(task.plates[0], &tray.plates[3]);
  EXPECT_EQ(task.plates[1], &tray.plates[0]);
  EXPECT_EQ(task.thickness, 3.0);
  EXPECT_EQ(task.request.inside_radius, 4.5);
  EXPECT_THAT(task.taken[0].whole, ElementsAre(2));
  EXPECT_TRUE(task.taken[1].whole.empty());
  EXPECT_THAT(task.taken[1].parts.at(1), ElementsAre(std::pair{0.0, 0.25}));
  const FitTask free = task_of(tray.structure, tray.plates, taken, {3}, request);
  EXPECT_EQ(free.plates[1], nullptr) << "a section with a free end";
}

TEST(PartsOf, HoldThePlatesAndRoomForTheirBends) {
  const LaidTray tray;
  const Parts parts = parts_of(tray.structure, tray.plates, 4);
  EXPECT_EQ(parts.thickness, 3.0);
  EXPECT_EQ(parts.plates.size(), 5u);
  EXPECT_EQ(parts.fits.size(), 4u);
  EXPECT_EQ(parts.root, 0);
  EXPECT_THAT(parts.ids, ElementsAre("floor", "front", "back", "left", "right"));
}

}  // namespace
}  // namespace planish::test
