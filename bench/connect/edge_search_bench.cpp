#include "connect_oracle/milp.hpp"

#include <planish/connect/edge_search.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <random>
#include <string>
#include <vector>

// What the exact edge search costs beside the thesis's mixed-integer programs, in the same run, on
// pairs of plates like those of its Fig. 34; and how it grows with the number of edges.

namespace {

using namespace planish;
using Sides = std::array<std::vector<Chain>, 2>;

/// Cbc is given this long for each program of a pair of chains.
constexpr double kPatience = 120.0;  // s

struct Case {
  std::string name;
  std::array<std::vector<Vec2>, 2> outlines;
  double beta = 90.0;  // °
  double trade_off = 1.0;
  Sides sides() const { return {viable_chains(outlines[0]), viable_chains(outlines[1])}; }
  Angle angle() const { return Angle::degrees(beta); }
};

/// (a) Rectangles at a right angle, near each other.
Case rectangles() {
  const std::vector<Vec2> plate{{0, 8}, {200, 8}, {200, 120}, {0, 120}};
  return {"a: rectangles", {plate, plate}};
}

/// (b) Two triangles of a lofted bend with their tips cut off, leaning alike.
Case truncated_triangles() {
  return {"b: truncated triangles",
          {{{{0, 20}, {90, 44}, {60, 150}, {40, 150}}, {{5, 18}, {100, 40}, {70, 140}, {55, 140}}}},
          140.0};
}

/// (c) A plate ripped before bending: one side notched.
Case ripped_plate() {
  return {"c: ripped plate with notch",
          {{{{0, 15}, {80, 15}, {82, 60}, {98, 60}, {100, 15}, {180, 15}, {180, 110}, {0, 110}},
            {{0, 15}, {180, 15}, {180, 90}, {0, 90}}}},
          120.0};
}

/// (d) Irregular plates of eight edges.
Case irregular_plates() {
  return {
      "d: irregular plates",
      {{{{0, 60}, {35, 32}, {80, 25}, {130, 30}, {170, 55}, {150, 120}, {80, 140}, {20, 115}},
        {{10, 50}, {40, 36}, {90, 22}, {140, 34}, {185, 70}, {160, 130}, {100, 150}, {30, 125}}}},
      100.0};
}

/// (e) Each further edge makes the bend wider and longer: the trade-off decides.
Case width_against_length() {
  return {"e: width against length",
          {{{{0, 20}, {60, 22}, {110, 40}, {150, 75}, {150, 160}, {0, 160}},
            {{0, 25}, {50, 24}, {115, 45}, {160, 90}, {160, 170}, {0, 170}}}},
          90.0,
          0.8};
}

/// Facing edges on a shallow arc, closed far away.
std::vector<Vec2> arc_plate(int edges, double y, double rise) {
  std::vector<Vec2> outline;
  for (int i = 0; i <= edges; ++i) {
    const double u = 2.0 * i / edges - 1.0;
    outline.emplace_back(200.0 * i / edges, y + rise * u * u);
  }
  outline.emplace_back(200.0, 200.0);
  outline.emplace_back(0.0, 200.0);
  return outline;
}

/// (f) Twenty facing edges a side. With γ = 1 all of them fit, which is easy to see for either;
/// with less the trade-off decides.
Case many_edges(double trade_off, const char* name) {
  return {name, {arc_plate(20, 60, 35), arc_plate(20, 55, 45)}, 110.0, trade_off};
}

std::vector<Case> cases() {
  return {rectangles(),
          truncated_triangles(),
          ripped_plate(),
          irregular_plates(),
          width_against_length(),
          many_edges(1.0, "f: twenty edges a side"),
          many_edges(0.3, "f, trade-off 0.3"),
          many_edges(0.1, "f, trade-off 0.1")};
}

/// Processor time: both use one thread, and a busy machine must not decide their ratio.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

EdgeSearchOptions options_of(const Case& part) {
  return {.trade_off = part.trade_off, .line = {}, .edges = {}, .alternatives = 0};
}

/// Both programs over all pairs of chains of one kind.
struct OracleRun {
  double shortest_s = 0.0, widest_s = 0.0;
  double length = std::numeric_limits<double>::infinity(), width = 0.0;
  bool proven = true;
};

OracleRun solve_programs(const Sides& sides, const Case& part, const EdgeSearch& found) {
  OracleRun run;
  const oracle::Wanted wanted{found.reference.span, found.reference.width, part.trade_off};
  for (const Chain& a : sides[0])
    for (const Chain& b : sides[1]) {
      if (a.kind != b.kind) continue;
      const double psi = arc_factor(part.angle(), a.kind, kLinearisedSlope);
      const double start = processor_seconds();
      const auto shortest = oracle::minimum_length_bend(a, b, psi, kPatience);
      const double middle = processor_seconds();
      run.shortest_s += middle - start;
      const auto widest = oracle::widest_bend(a, b, psi, wanted, kPatience);
      run.widest_s += processor_seconds() - middle;
      run.length = std::min(run.length, shortest.length);
      run.width = std::max(run.width, widest.width);
      run.proven &= shortest.outcome != oracle::Outcome::stopped &&
                    widest.outcome != oracle::Outcome::stopped;
    }
  return run;
}

bool agree(const OracleRun& run, const EdgeSearch& found) {
  constexpr double kClose = 1e-4;  // mm: enough to know that both solved the same problem
  return std::abs(run.length - found.reference_length) < kClose &&
         std::abs(run.width - found.best.width) < kClose;
}

void AgainstMixedIntegerPrograms(benchmark::State& state) {
  const Case part = cases()[state.range(0)];
  const Sides sides = part.sides();
  state.SetLabel(part.name);
  const auto once = search_edges(sides, part.angle(), options_of(part));
  if (!once) return state.SkipWithError(once.error().message.c_str());
  const double start = processor_seconds();
  for (auto _ : state)
    benchmark::DoNotOptimize(search_edges(sides, part.angle(), options_of(part)));
  const double ours = (processor_seconds() - start) / static_cast<double>(state.iterations());
  const OracleRun run = solve_programs(sides, part, *once);
  if (run.proven && !agree(run, *once))
    return state.SkipWithError("the programs have another optimum");
  state.counters["cbc_shortest_ms"] = 1e3 * run.shortest_s;
  state.counters["cbc_widest_ms"] = 1e3 * run.widest_s;
  state.counters["times_faster"] = (run.shortest_s + run.widest_s) / ours;
  state.counters["proven"] = run.proven;  // 0: Cbc ran out of time, so "at least"
}
// A fixed number of runs: Cbc solves once for each time that the function is entered.
BENCHMARK(AgainstMixedIntegerPrograms)
    ->DenseRange(0, 7)
    ->Iterations(200)
    ->Unit(benchmark::kMicrosecond);

/// A ragged row of edges a side, on an arc: most edges are candidates, no two alike.
std::vector<Vec2> ragged_plate(int edges, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> rough(0.0, 10.0);
  std::vector<Vec2> outline = arc_plate(edges, 50, 30);
  for (int i = 0; i <= edges; ++i)
    outline[i].y() += rough(random);
  return outline;
}

void search_of(benchmark::State& state, const Case& part) {
  const Sides sides = part.sides();
  for (auto _ : state)
    benchmark::DoNotOptimize(search_edges(sides, part.angle(), options_of(part)));
  state.SetComplexityN(state.range(0));
}

void ShallowArcs(benchmark::State& state) {
  const int edges = static_cast<int>(state.range(0));
  search_of(state, {"", {arc_plate(edges, 60, 35), arc_plate(edges, 55, 45)}, 110.0});
}
BENCHMARK(ShallowArcs)
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Arg(200)
    ->Arg(300)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity();

void RaggedEdges(benchmark::State& state) {
  const int edges = static_cast<int>(state.range(0));
  search_of(state, {"", {ragged_plate(edges, 1), ragged_plate(edges, 2)}, 110.0});
}
BENCHMARK(RaggedEdges)
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Arg(200)
    ->Arg(300)
    ->Arg(1000)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity();

}  // namespace
