#include "segments.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Every sum of a few segments, by trying all subsets.
TEST(Segments, AddUpToEveryLengthThatASubsetHas) {
  const std::vector<double> segments = {200, 100, 100, 50, 40, 20, 15, 10};
  std::vector<double> all;
  for (unsigned subset = 1; subset < 1U << segments.size(); ++subset) {
    double sum = 0.0;
    for (size_t i = 0; i < segments.size(); ++i)
      if (subset >> i & 1U) sum += segments[i];
    all.push_back(sum);
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const SegmentSums sums(segments);
  ASSERT_EQ(sums.sums().size(), all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(sums.sums()[i].length, all[i], 1e-9);
    const std::vector<double> chosen = sums.chosen(sums.sums()[i].chosen);
    EXPECT_NEAR(std::accumulate(chosen.begin(), chosen.end(), 0.0), all[i], 1e-9);
  }
}

/// 64 of 10 mm, whose sums are 10, 20 … 640 mm; of the 2 mm there are too many.
TEST(Segments, BeyondTheLongestSixtyFourDoNotCount) {
  std::vector<double> segments(64, 10.0);
  segments.insert(segments.begin(), {2.0, 2.0});
  const SegmentSums sums(segments);
  EXPECT_EQ(sums.segments(), std::vector<double>(64, 10.0));
  ASSERT_EQ(sums.sums().size(), 64u);
  for (int n = 1; n <= 64; ++n) {
    const SegmentSums::Sum& sum = sums.sums()[n - 1];
    EXPECT_NEAR(sum.length, 10.0 * n, 1e-9);
    EXPECT_EQ(sums.chosen(sum.chosen), std::vector<double>(n, 10.0));
  }
  EXPECT_TRUE(tool_rows(sums, {{{0, 641}}, 0.0, {}, 1000}).empty());
}

TEST(Segments, AreAsShortAsTheLineLessItsShortfall) {
  const SegmentSums sums({100, 50, 20, 10});
  // 87 mm less 2 · 3.5 is 80: 50 + 20 + 10.
  auto rows = tool_rows(sums, {{{0, 87}}, 3.5, {}, 1000});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].length(), 80.0, 1e-9);
  EXPECT_NEAR(rows[0].from, 3.5, 1e-9);
  // A little more takes the 100, which stands out in the middle, to a whole millimetre.
  rows = tool_rows(sums, {{{0, 87.2}}, 3.5, {}, 1000});
  EXPECT_NEAR(rows[0].length(), 100.0, 1e-9);
  EXPECT_EQ(rows[0].from, -6.0);
  EXPECT_TRUE(tool_rows(sums, {{{0, 200}}, 3.5, {}, 1000}).empty());
  EXPECT_TRUE(tool_rows(sums, {{{0, 100}}, 3.5, {}, 90}).empty());
}

TEST(Segments, StandBetweenWallsAndBridgeGaps) {
  const SegmentSums sums({100, 60, 40, 30});
  // Walls close to both ends: 100 stands in 100 but for ε at each side, 99.8 does not take it.
  EXPECT_FALSE(tool_rows(sums, {{{2, 98}}, 1, {{-5, 0}, {100, 105}}, 1000}).empty());
  EXPECT_TRUE(tool_rows(sums, {{{2, 98}}, 1, {{-5, 0}, {99.8, 105}}, 1000}).empty());
  // Two pieces: bridged, or with a wall between two rows of what there is once.
  auto rows = tool_rows(sums, {{{0, 40}, {60, 100}}, 0, {}, 1000});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].length(), 100.0, 1e-9);
  rows = tool_rows(sums, {{{0, 40}, {60, 100}}, 0, {{45, 55}}, 1000});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[0].length(), 40.0, 1e-9);
  EXPECT_NEAR(rows[1].length(), 60.0, 1e-9);
  // 105 on both sides: 130 and then only 100.
  EXPECT_TRUE(tool_rows(sums, {{{0, 105}, {120, 225}}, 0, {{108, 115}}, 1000}).empty());
}

/// A row that may stand anywhere in a room is not pushed against its end: 5 mm are kept, or with
/// less room than that the middle.
TEST(Segments, KeepClearOfWallsWithRoom) {
  const SegmentSums sums({100});
  const auto from = [&](const Interval& left, const Interval& right) {
    return tool_rows(sums, {{{20, 80}}, 0, {left, right}, 1000})[0].from;
  };
  EXPECT_EQ(from({-500, -100}, {300, 400}), 0.0) << "in the middle";
  EXPECT_EQ(from({-500, -2}, {300, 400}), 3.0);
  EXPECT_EQ(from({-500, 5}, {300, 400}), 10.0);
  EXPECT_EQ(from({-500, -3}, {101.6, 400}), -1.0) << "2.3 to each side, to a whole millimetre";
}

/// Which row chooses first decides who gets the shorter one; either way nothing stands twice.
TEST(Segments, AreChosenFromEitherEnd) {
  const SegmentSums sums({50, 45, 45});
  RowRequest request{{{0, 40}, {60, 98}}, 0, {{45, 55}}, 1000};
  const auto first = tool_rows(sums, request);
  request.from_last = true;
  const auto last = tool_rows(sums, request);
  ASSERT_EQ(first.size(), 2u);
  ASSERT_EQ(last.size(), 2u);
  EXPECT_EQ(first[0].segments, last[0].segments);
  const SegmentSums few({60, 42, 38.5});
  request = {{{0, 38}, {60, 98}}, 0, {{45, 55}}, 1000};
  EXPECT_EQ(tool_rows(few, request)[0].segments, std::vector<double>{38.5});
  request.from_last = true;
  const auto turned = tool_rows(few, request);
  ASSERT_EQ(turned.size(), 2u);
  EXPECT_EQ(turned[0].segments, std::vector<double>{42});
  EXPECT_EQ(turned[1].segments, std::vector<double>{38.5});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE(turned[i].from, request.pieces[i].lo);
    EXPECT_GE(extent(turned[i]).hi, request.pieces[i].hi);
  }
}

/// What stands already is no more there, also for the rows behind a wall.
TEST(Segments, StandOnceInAllRows) {
  const std::vector<double> owned{40, 20, 10};
  const RowRequest request{{{0, 40}, {60, 78}}, 0, {{45, 55}}, 1000};
  EXPECT_EQ(tool_rows(SegmentSums(owned), request).size(), 2u);
  EXPECT_TRUE(tool_rows(SegmentSums(owned, 0b010), request).empty()) << "the 20 stands elsewhere";
  EXPECT_EQ(tool_rows(SegmentSums(owned, 0b100), request).size(), 2u) << "the 10 does";
}

/// The last wall of a box between two that stand: the row goes between them. The walls' inner faces
/// lie where their bends have turned, beside a base of length l: r inside each tangent line is
/// bent, so the faces are l + 2 r apart. A segment of that length fits, with ε at each end. (The
/// walls are so narrow that they stand beside the punch above its tip, clear of their bends.)
TEST(Segments, OfAPunchGoBetweenTheWallsOfABox) {
  BoxSize size;
  size.height = 40.0;
  size.length = 120.0;
  size.width = 90.0;
  size.relief = 30.0;
  const double between = size.length + 2.0 * size.inside_radius;
  for (const double step : {-0.1, 0.1}) {
    PlainPunch plain;
    plain.segments = {between + 2.0 * 0.05 + step};
    BrakeTools tools = plain_tools(plain,
                                   {12.0, Angle::degrees(80), 1.5, 14.0, 100.0, {120, 90, 80}});
    Room room(box(size), tools);
    // Bends 1 and 3 are the long ones, along x; 2 and 4 stand beside their ends.
    EXPECT_EQ(room.can_press(1, {2, 4}), step < 0.0) << step;
  }
}

}  // namespace
}  // namespace planish::test
