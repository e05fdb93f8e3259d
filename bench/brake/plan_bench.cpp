#include "support/sheets.hpp"

#include <planish/brake/plan.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <benchmark/benchmark.h>

// What a bend plan costs against the number of bends: profiles whose bends turn up and down in
// turns, and channels with lips, whose bends wait for one another.

namespace {

using namespace planish;
using namespace planish::test;

BrakeTools tools() {
  BrakeTools tools;
  tools.machine.force = 1000.0;
  tools.machine.length = 3000.0;
  Punch punch;
  punch.id = "P";
  punch.profile = {{0, 0}, {10, 10}, {10, 150}, {-10, 150}, {-10, 10}};
  punch.angle = Angle::degrees(88);
  punch.tip_radius = 1.0;
  punch.segments = {10, 15, 20, 40, 50, 100, 200};
  Die die;
  die.id = "V";
  die.opening = 9.0;
  die.angle = Angle::degrees(88);
  die.shoulder_radius = 1.0;
  die.profile = {{-4.5, 0}, {-8, 0}, {-8, -100}, {8, -100}, {8, 0}, {4.5, 0}, {0, -4.66}};
  die.segments = punch.segments;
  tools.punches = {punch};
  tools.dies = {die};
  return tools;
}

Sheet staircase(int bends) {
  std::vector<StripPart> sections{Straight{30}};
  for (int i = 0; i < bends; ++i) {
    sections.push_back(
        Turn{Angle::degrees(90), 2.0, i % 2 == 0 ? BendDirection::up : BendDirection::down});
    sections.push_back(Straight{30});
  }
  return strip(sections, 80, 1.5);
}

void FirstPlanOfAStaircase(benchmark::State& state) {
  const Sheet sheet = staircase(static_cast<int>(state.range(0)));
  const auto flat = flat_sheet(sheet);
  const BrakeTools shop = tools();
  PlanOptions options;
  options.limits.first = true;
  for (auto _ : state) {
    const auto plan = plan_bending(sheet, flat->layout, shop, options);
    if (!plan || plan->strokes.empty()) return state.SkipWithError("no plan");
    benchmark::DoNotOptimize(plan);
  }
}
BENCHMARK(FirstPlanOfAStaircase)->RangeMultiplier(2)->Range(5, 40)->Unit(benchmark::kMillisecond);

void CheapestPlanOfAStaircase(benchmark::State& state) {
  const Sheet sheet = staircase(static_cast<int>(state.range(0)));
  const auto flat = flat_sheet(sheet);
  const BrakeTools shop = tools();
  PlanOptions options;
  options.limits.seconds = 60.0;
  for (auto _ : state) {
    const auto plan = plan_bending(sheet, flat->layout, shop, options);
    if (!plan || plan->status != PlanStatus::optimal) return state.SkipWithError("not proven");
    benchmark::DoNotOptimize(plan);
  }
}
BENCHMARK(CheapestPlanOfAStaircase)->DenseRange(2, 10, 2)->Unit(benchmark::kMillisecond);

}  // namespace
