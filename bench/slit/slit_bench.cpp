#include <planish/slit/session.hpp>

#include <benchmark/benchmark.h>

// What a designer waits for: one strip from nothing, one strip after its anchor moved, the same
// more finely divided, a whole chair after its weights changed, and how all of it grows with the
// number of strips.

namespace {

using namespace planish;

SlitDesign chair(int strips) {
  SlitDesign design;
  design.sheet.thickness = 4.0;
  design.sheet.panel_height = 420.0;
  design.sheet.half_length = 464.0;
  design.sheet.strips = equal_strips(strips, 60.0);
  const double width = 60.0 * strips;
  design.leg_curve = {{{360, 0}, {360, width}}};
  design.seat_curve = BezierCurve{{{330, 0}, {300, width / 3}, {310, width / 1.5}, {330, width}}};
  return design;
}

/// The chair of formats.md#slits, with a back.
SlitDesign six_strips() {
  SlitDesign design = chair(6);
  design.seat_curve = BezierCurve{{{330, 0}, {300, 120}, {310, 240}, {640, 360}}};
  return design;
}

void ColdStrip(benchmark::State& state) {
  const SlitDesign design = chair(1);
  for (auto _ : state) {
    auto session = SlitSession::start(design);
    if (!session || !session->solve()->converged) return state.SkipWithError("not solved");
  }
}
BENCHMARK(ColdStrip)->Unit(benchmark::kMillisecond);

/// An anchor of the second strip is dragged to and fro by 5 mm; `subdivisions` as the argument.
void WarmStrip(benchmark::State& state) {
  auto session = solved_slit_sheet(six_strips(), static_cast<int>(state.range(0)));
  if (!session) return state.SkipWithError("not solved");
  const int middle = session->design().ridges / 2;
  const Vec3 at = session->folded().strips[1].ridges[middle].folded[0];
  SlitDesign design = session->design();
  design.anchors = {{1, middle, StripEdge::left, at}};
  if (!session->set_design(design) || !session->solve()) return state.SkipWithError("no anchor");
  int step = 0, iterations = 0;
  for (auto _ : state) {
    const double lift = 5.0 * (++step % 2);
    design.anchors[0].at = at + Vec3(0, lift, 0);
    if (!session->set_design(design)) return state.SkipWithError("not moved");
    const auto report = session->solve();
    if (!report || !report->converged || report->strips_solved != 1)
      return state.SkipWithError("not solved");
    iterations += report->iterations;
  }
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(WarmStrip)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

void ColdChair(benchmark::State& state) {
  const SlitDesign design = six_strips();
  for (auto _ : state) {
    auto session = solved_slit_sheet(design, static_cast<int>(state.range(0)));
    if (!session) return state.SkipWithError("not solved");
  }
}
BENCHMARK(ColdChair)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);

/// The back of the seat curve is dragged by 5 mm: all strips are solved again.
void WarmChair(benchmark::State& state) {
  auto session = solved_slit_sheet(six_strips(), static_cast<int>(state.range(0)));
  if (!session) return state.SkipWithError("not solved");
  SlitDesign design = session->design();
  const double back = design.seat_curve->poles.back().x();
  int step = 0, iterations = 0;
  for (auto _ : state) {
    design.seat_curve->poles.back().x() = back + 5.0 * (++step % 2);
    if (!session->set_design(design)) return state.SkipWithError("not set");
    const auto report = session->solve();
    if (!report || !report->converged || report->strips_solved != 6)
      return state.SkipWithError("not solved");
    iterations += report->iterations;
  }
  state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(WarmChair)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

void StripsOfAWideSheet(benchmark::State& state) {
  const SlitDesign design = chair(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    auto session = SlitSession::start(design);
    if (!session || !session->solve()->converged) return state.SkipWithError("not solved");
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(StripsOfAWideSheet)
    ->Arg(1)
    ->Arg(10)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

/// Strips of 40 ridges, all of them one system.
void CoupledStrips(benchmark::State& state) {
  SlitDesign design = chair(static_cast<int>(state.range(0)));
  design.ridges = 40;
  design.coupling = SlitCoupling{};
  for (auto _ : state) {
    auto session = SlitSession::start(design);
    if (!session || !session->solve()->converged) return state.SkipWithError("not solved");
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(CoupledStrips)
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

}  // namespace
