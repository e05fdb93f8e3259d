#include "interrupted_bends.hpp"

#include "sample_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;
using ::testing::ElementsAre;

/// A bend between the first two walls of a tray, made by hand: 300 wide, and two further stretches.
Parts stretched_parts() {
  Parts parts;
  parts.thickness = 3;
  for (const Plate& plate : tray().plates) {
    parts.plates.push_back(laid(plate));
    parts.ids.push_back(plate.id);
  }
  BendFit& fit = parts.fits.emplace_back();
  fit.report.plates = {0, 1};
  fit.runs = {OutlineRun{.first = 0, .count = 1, .end = 0.2}, OutlineRun{.first = 3, .count = 2}};
  for (const double from : {100.0, 220.0}) {
    BendBand& band = fit.stretches.emplace_back();
    band.boundaries.low.v = {from, from};
    band.boundaries.high.v = {from + 50, from + 50};
    band.runs = {OutlineRun{.first = 0, .count = 1, .start = from / 300, .end = (from + 50) / 300},
                 OutlineRun{.first = 1, .count = 2}};
  }
  return parts;
}

TEST(AppendStretches, MakesThemFitsBehindAllOthers) {
  Parts parts = stretched_parts();
  parts.fits.emplace_back().report.plates = {2};
  append_stretches(parts);
  ASSERT_EQ(parts.fits.size(), 4u);
  EXPECT_EQ(parts.fits[1].report.plates, std::vector<int>{2}) << "other bends keep their rows";
  EXPECT_TRUE(parts.fits[0].stretches.empty());
  for (const int row : {2, 3}) {
    EXPECT_EQ(parts.fits[row].stretch_of, 0);
    EXPECT_EQ(parts.fits[row].report.plates, (std::vector<int>{0, 1}));
  }
  EXPECT_EQ(parts.fits[2].boundaries.low.v[0], 100.0);
  EXPECT_EQ(parts.fits[3].boundaries.high.v[1], 270.0);
  EXPECT_NEAR(parts.fits[3].runs[0].start, 220.0 / 300, 1e-12);
}

TEST(AppendStretches, ReportsEdgesAscendingAndWidths) {
  Parts parts = stretched_parts();
  append_stretches(parts);
  const FittedBend& report = parts.fits[0].report;
  EXPECT_THAT(report.edges[0], ElementsAre(0));
  EXPECT_THAT(report.edges[1], ElementsAre(0, 3)) << "3 and the next round the outline";
  ASSERT_EQ(report.stretches.size(), 2u);
  for (const BendStretch& stretch : report.stretches) {
    EXPECT_THAT(stretch.edges[0], ElementsAre(0));
    EXPECT_THAT(stretch.edges[1], ElementsAre(1, 2));
    EXPECT_NEAR(stretch.width, 50, 1e-12);
  }
}

TEST(AddStretches, MeasuresWhatEachBendJoinsAndLeaves) {
  const PlateStructure s = angle_pair(20, 200);
  std::vector<PlacedPlate> plates{laid(s.plates[0]), laid(s.plates[1])};
  Parts parts = parts_of(s);
  TakenEdges taken(2);
  take(parts.fits[0], plates, taken);
  add_stretches(s, plates, taken, parts.fits);
  EXPECT_TRUE(parts.fits[0].stretches.empty());
  EXPECT_NEAR(parts.fits[0].report.joined, 200, 1e-6);
  EXPECT_NEAR(parts.fits[0].report.unused[0], 0, 1e-6);
  EXPECT_NEAR(parts.fits[0].report.unused[1], 0, 1e-6);
  EXPECT_FALSE(parts.fits[0].report.beside) << "both joints have all of their width in common";
}

}  // namespace
}  // namespace planish::test
