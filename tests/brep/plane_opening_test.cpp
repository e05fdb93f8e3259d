#include "plane_opening.hpp"

#include "form_volume.hpp"
#include "recognised.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

/// What is cut of the round opening of a plate of 2 mm; its outline on top where nothing is less.
double cut_area(const std::vector<Vec2>& path) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, path}}), 2, kTop);
  const Recognition of = seen.view();
  for (const RimPart& part : of.rim.parts) {
    const LoopRef here = loops_here(of, part).front(), there = loops_there(of, part).front();
    if (!goes_round(of, part, here)) continue;
    const auto& plane = std::get<Frame>(of.model.faces[kTop].surface);
    const PlaneOpening opening = opening_between(of, part, here, there, plane);
    return loop_area(narrower_cut(of, opening, plane).value_or(opening.mine));
  }
  return 0.0;
}

TEST(NarrowerCut, IsTheLeastOfBothOutlinesAndWhatLiesBetween) {
  EXPECT_NEAR(cut_area({{4, 2}, {4, 0}}), 16 * pi, 1e-9);
  EXPECT_NEAR(cut_area({{4, 2}, {6, 0}}), 16 * pi, 1e-9);
  EXPECT_NEAR(cut_area({{6, 2}, {4, 0}}), 16 * pi, 1e-9);
  EXPECT_NEAR(cut_area({{6, 2}, {4, 1}, {5, 0}}), 16 * pi, 1e-9);
}

TEST(GoesRound, HoldsOnlyForOpenings) {
  const Recognised seen = recognised(plate(2, {100, 60}), 2, kTop);
  const Recognition of = seen.view();
  ASSERT_EQ(of.rim.parts.size(), 1u);
  EXPECT_FALSE(goes_round(of, of.rim.parts.front(), loops_here(of, of.rim.parts.front()).front()));
}

}  // namespace
}  // namespace planish::brep::test
