#include "brake/stroke_room.hpp"
#include "brake/stroke_tables.hpp"
#include "support/sheet_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace planish::test {
namespace {

constexpr int kSheets = 60;
constexpr std::array kBends{2, 3, 4, 5, 3, 4, 5, 6, 4, 7};

/// A base with flanges on its sides, one of them not square, and lips on some of these: `bends`
/// bends in four directions.
Sheet random_tray(std::mt19937& random, int bends) {
  const auto between = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  constexpr double kNotch = 4.0;
  const double length = between(30, 90), width = between(30, 90), slant = between(0, 12);
  SheetBuilder builder(1.0);
  const std::array<Vec2, 12> corners{Vec2(kNotch, 0),
                                     {length - kNotch, 0},
                                     {length - kNotch, kNotch},
                                     {length, kNotch},
                                     {length - slant, width},
                                     {length - slant - kNotch, width},
                                     {length - slant - kNotch, width + kNotch},
                                     {kNotch, width + kNotch},
                                     {kNotch, width},
                                     {0, width},
                                     {0, kNotch},
                                     {kNotch, kNotch}};
  Loop base;
  for (std::size_t i = 0; i < corners.size(); ++i)
    base.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  const FaceId floor = builder.flange({}, {base});
  std::vector<Rim> rims{builder.rim(floor, 0), builder.rim(floor, 3), builder.rim(floor, 6),
                        builder.rim(floor, 9)};
  std::ranges::shuffle(rims, random);
  for (int bend = 0; bend < bends; ++bend) {
    const Rim rim = rims.front();
    rims.erase(rims.begin());
    const auto way = between(0, 1) < 0.7 ? BendDirection::up : BendDirection::down;
    const double angle = between(0, 1) < 0.7 ? 90.0 : between(30, 100);
    const double reach = between(5.5, 30.0);
    const Rim far = builder.bend(rim, Turn{Angle::degrees(angle), 1.0, way});
    const Vec2 b(far.length, 0), c(far.length, reach), d(0, reach);
    const FaceId flange = builder.flange_behind(
        far, {{Segment{Vec2::Zero(), b}, Segment{b, c}, Segment{c, d}, Segment{d, Vec2::Zero()}}});
    rims.push_back(builder.rim(flange, 2));
  }
  return builder.finish();
}

/// A straight punch, a goose neck, two dies of one opening, beams, and a gauge.
BrakeTools shop() {
  PlainPunch straight;
  straight.half_width = 8.0;
  straight.tip_radius = 0.8;
  PlainDie narrow;
  narrow.opening = 6.0;
  narrow.shoulder_radius = 0.8;
  narrow.half_width = 8.0;
  BrakeTools tools = plain_tools(straight, narrow);
  Punch neck = tools.punches.front();
  neck.id = "G";
  neck.profile = {{0, 0},    {5, 5.96},  {5, 25},   {-12, 45}, {-12, 80}, {14, 100},
                  {14, 150}, {-26, 150}, {-26, 40}, {-8, 18},  {-8, 9.53}};
  tools.punches.push_back(neck);
  Die wide = tools.dies.front();
  wide.id = "W";
  narrow.half_width = 22.0;
  wide.profile = die(narrow).profile;
  tools.dies.push_back(wide);
  tools.machine.upper_beam = {{-30, 150}, {30, 150}, {30, 400}, {-30, 400}};
  tools.machine.gauge = BackGauge{.from = 5.0,
                                  .to = 300.0,
                                  .finger_width = 10.0,
                                  .finger = {{0, 0}, {0, -20}, {60, -20}, {60, 0}}};
  return tools;
}

/// Every stroke that can be made in every stage, asked for one by one from the last stage back.
StrokeTable table_of(brake_detail::StageCache& cache) {
  StrokeTable table;
  table.lines = cache.inputs().lines();
  table.by_stage.resize(std::size_t{1} << table.lines);
  for (std::size_t stage = table.stages(); stage-- > 0;)
    for (const StrokeChoice& choice : brake_detail::choices(cache, LineSet{stage}))
      if (brake_detail::check(cache, LineSet{stage}, choice).feasible)
        table.by_stage[stage].push_back(choice);
  return table;
}

/// What brute force over every stage says of random sheets.
void compare(const BrakeTools& tools, const PlanOptions& options, unsigned seed) {
  std::mt19937 random(seed);
  int possible = 0, impossible = 0, other_v = 0;
  for (int run = 0; run < kSheets; ++run) {
    const Sheet sheet = random_tray(random, kBends[run % kBends.size()]);
    Room room(sheet, tools, options);
    const StrokeTable table = table_of(room.cache());
    const auto cheapest = cheapest_by_table(table, {});
    if (table.lines <= 4) {
      EXPECT_EQ(cheapest_by_orders(table, {}), cheapest);
    }
    const auto plan = plan_bending(sheet, room.layout(), tools, options);
    ASSERT_TRUE(plan) << plan.error().message;
    SCOPED_TRACE(run);
    EXPECT_EQ(plan->status, cheapest ? PlanStatus::optimal : PlanStatus::infeasible);
    if (cheapest) {
      EXPECT_NEAR(plan->cost, *cheapest, 1e-9);
    }
    ++(cheapest ? possible : impossible);
    other_v += std::ranges::any_of(plan->strokes, [](const Stroke& s) { return s.v_away > 0; });
  }
  EXPECT_GT(possible, kSheets / 5);
  EXPECT_GT(impossible, options.v == VChoice::any ? 0 : kSheets / 10);
  EXPECT_EQ(other_v > 0, options.v == VChoice::any);
}

TEST(EveryOrder, OfRandomSheetsHasThePlansVerdictAndNoLessCost) {
  PlanOptions wanted;
  wanted.v = VChoice::wanted;
  compare(shop(), wanted, 20261122);
}

/// With a wider V and a narrower one besides.
TEST(EveryOrder, AndEveryVHasThePlansVerdictAndNoLessCost) {
  BrakeTools tools = shop();
  for (const double opening : {4.0, 10.0}) {
    PlainDie plain;
    plain.opening = opening;
    plain.shoulder_radius = 0.1 * opening;
    plain.half_width = 0.5 * opening + 5.0;
    tools.dies.push_back(die(plain));
    tools.dies.back().id = "V" + std::to_string(static_cast<int>(opening));
  }
  compare(tools, {}, 20261126);
}

}  // namespace
}  // namespace planish::test
