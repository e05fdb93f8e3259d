#include <planish/sheet/flat_pattern.hpp>
#include <planish/transition/transition.hpp>

#include <benchmark/benchmark.h>

// What a transition costs: its surface and its net against the number of press lines, and what
// somebody waits for who moves one size of a square-to-round and sees surface, net and mesh follow.

namespace {

using namespace planish;

TransitionSpec square_to_round(int lines, double height) {
  TransitionSpec spec;
  spec.thickness = 1.0;
  Frame above;
  above.origin = {0.0, 0.0, height};
  spec.from = {PolygonProfile{{{-150, -150}, {150, -150}, {150, 150}, {-150, 150}}}, {}};
  spec.to = {EllipseProfile{100.0, 100.0}, above};
  spec.seam = SeamEdge{0};
  if (lines > 0) spec.pressing = PressCount{lines};
  return spec;
}

/// What is seen on a screen: points within a tenth of a micrometre, outlines within one.
constexpr TransitionOptions kDrawn{.tolerance = 1e-7};
FlattenOptions drawn() {
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "bench"};
  options.curve_tolerance = 1e-3;
  return options;
}

void make(benchmark::State& state, const TransitionOptions& options, const FlattenOptions& flat) {
  int step = 0;
  for (auto _ : state) {
    const auto transition = make_transition(
        square_to_round(static_cast<int>(state.range(0)), 250.0 + 0.1 * (step++ % 100)), options);
    if (!transition) return state.SkipWithError(transition.error().message.c_str());
    const auto net = flatten(transition->pieces.front(), flat);
    if (!net) return state.SkipWithError(net.error().message.c_str());
    benchmark::DoNotOptimize(net);
  }
}

void SurfaceAndNet(benchmark::State& state) {
  FlattenOptions exact = drawn();
  exact.curve_tolerance = exact.merge_tolerance = 1e-7;
  make(state, {}, exact);
}
BENCHMARK(SurfaceAndNet)->Arg(0)->Arg(10)->Arg(25)->Arg(100)->Unit(benchmark::kMicrosecond);

/// 25 lines in each of four cones: 100.
void Editing(benchmark::State& state) {
  int step = 0;
  for (auto _ : state) {
    const TransitionSpec spec = square_to_round(static_cast<int>(state.range(0)),
                                                250.0 + 0.1 * (step++ % 100));
    const auto transition = make_transition(spec, kDrawn);
    if (!transition) return state.SkipWithError("no transition");
    const auto net = flatten(transition->pieces.front(), drawn());
    if (!net) return state.SkipWithError(net.error().message.c_str());
    benchmark::DoNotOptimize(net);
    benchmark::DoNotOptimize(transition->mesh);
  }
}
BENCHMARK(Editing)->Arg(25)->Unit(benchmark::kMicrosecond);

}  // namespace
