#include "on_bed.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

/// What stands on the bed after all bends of a box of 70 × 45, pressed in that order.
struct Laid {
  Laid(const PlainPunch& upper, const PlainDie& lower, const std::vector<int>& bends)
      : room(box({70.0, 45.0, 30.0}), plain_tools(upper, lower)) {
    for (const int bend : bends) {
      auto ways = room.ways(bend, formed);
      EXPECT_FALSE(ways.empty());
      ChosenStroke stroke{room.lines(formed), ways.front()};
      const int number = static_cast<int>(bed.strokes.size());
      auto with = with_stroke(room.cache(), bed,
                              std::make_shared<Wanted>(room.cache(), stroke, number));
      all = all && with;
      if (with) bed = std::move(*with);
      formed.push_back(bend);
    }
  }
  Room room;
  std::vector<int> formed;
  OnBed bed;
  bool all = true;
};

const std::vector<int> kLongFirst{1, 3, 2, 4};

/// One die of full length below, rows of segments above: both rows stand over that die, apart.
TEST(OnBed, RowsShareADie) {
  const Laid laid({.segments = {70, 45}}, {.segments = {500}}, kLongFirst);
  ASSERT_TRUE(laid.all);
  ASSERT_EQ(laid.bed.stations.size(), 1u);
  const StationTools& station = laid.bed.stations.front();
  EXPECT_EQ(station.rows[1].size(), 1u);
  ASSERT_EQ(station.rows[0].size(), 2u);
  EXPECT_GE(station.rows[0][1].from, extent(station.rows[0][0]).hi);
  for (const StationTools::Made& made : station.strokes)
    EXPECT_TRUE(station.stands(*made.demand, 1.5, made.at));
  // Punches and die begin whole millimetres from each other.
  for (const double from : {station.rows[0][1].from, station.rows[1][0].from}) {
    const double distance = from - station.rows[0][0].from;
    EXPECT_NEAR(distance, std::round(distance), 1e-9);
  }
}

/// A die that is too short for both rows is no place for them, and there is no other.
TEST(OnBed, RowsShareNoDieThatIsTooShort) {
  EXPECT_FALSE(Laid({.segments = {70, 45}}, {.segments = {80}}, kLongFirst).all);
}

/// Segments of 70 and 45 do for both lines of the box side by side, a second 45 is not needed.
TEST(OnBed, StandsSideBySide) {
  const std::vector<double> segments{70, 45};
  const Laid laid({.segments = segments}, {.segments = segments}, kLongFirst);
  ASSERT_TRUE(laid.all);
  ASSERT_EQ(laid.bed.stations.size(), 2u);
  const std::vector<double> starts = starts_of(laid.bed.stations);
  ASSERT_EQ(starts.size(), 3u);
  EXPECT_GT(starts[1], starts[0] + 70.0) << "the box reaches beyond its line";
  EXPECT_EQ(starts_of(laid.bed.stations, 3.0)[1], starts[1] + 3.0) << "with a clearance";
}

/// Lips at either end of a line, each in the way of one row: a row with both ears stands for both.
TEST(OnBed, RowsLookAheadToLaterWalls) {
  const std::vector<double> segments{50, 20};
  BrakeTools tools = plain_tools({.segments = segments}, {.segments = {100}});
  tools.punches[0].ears = Ears{20.0, 20.0, 25.0, 15.0};
  Room room(u_channel(), tools);
  auto way = room.ways(1, {});
  ASSERT_FALSE(way.empty());
  const auto demand = [&](int number, const Interval& wall) {
    auto made = std::make_shared<Demand>();
    made->stroke = number;
    made->choice = way.front();
    made->pieces = {{0.0, 90.0}};
    made->part = {0.0, 90.0};
    made->walls[0] = {wall};
    return std::make_shared<Wanted>(std::move(made));
  };
  const auto first = with_stroke(room.cache(), {}, demand(0, {-20.0, 8.0}));
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->stations[0].rows[0].front().ears.hi > 0.0) << "one ear does";
  const auto both = with_stroke(room.cache(), *first, demand(1, {82.0, 110.0}));
  ASSERT_TRUE(both);
  ASSERT_EQ(both->stations.size(), 1u);
  EXPECT_TRUE(both->stations[0].rows[0].front().ears.lo > 0.0);
  EXPECT_TRUE(both->stations[0].rows[0].front().ears.hi > 0.0);
}

/// Over a die of 200 in the middle of the first line nothing else has room where the second has a
/// wall beside it, so that one takes the die of 400; moved aside it serves both.
TEST(OnBed, IsLaidWithAsFewStationsAsThereCanBe) {
  Room room(u_channel(), plain_tools({.segments = {100, 100}}, {.segments = {200, 400}}));
  auto way = room.ways(1, {});
  ASSERT_FALSE(way.empty());
  OnBed bed;
  for (const bool wall : {false, true}) {
    auto made = std::make_shared<Demand>();
    made->stroke = wall ? 1 : 0;
    made->choice = way.front();
    made->pieces = {{0.0, 90.0}};
    made->part = {0.0, 90.0};
    if (wall) made->walls[1] = {{100.0, 150.0}};
    auto with = with_stroke(room.cache(), bed, std::make_shared<Wanted>(std::move(made)));
    ASSERT_TRUE(with);
    bed = std::move(*with);
  }
  EXPECT_EQ(bed.stations.size(), 2u);
  const OnBed least = with_least_to_lay(room.cache(), bed);
  ASSERT_EQ(least.stations.size(), 1u);
  EXPECT_EQ(least.stations[0].rows[1].front().segments, std::vector<double>{200});
  for (const StationTools::Made& made : least.stations[0].strokes)
    EXPECT_TRUE(least.stations[0].stands(*made.demand, 1.5, made.at));
}

}  // namespace
}  // namespace planish::test
