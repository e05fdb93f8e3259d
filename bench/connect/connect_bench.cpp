#include <planish/connect/connect.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// What joining plates costs, and what joining the same ones again costs after one has moved: folded
// stairs of irregular plates, each bend's edges, tangent line and boundaries chosen by the program.
// A frame at 60 Hz is 16 ms.

namespace {

using namespace planish;

/// Treads and risers in turn, 12 mm short of the lines where their planes meet, and no two edges
/// that face each other parallel.
PlateStructure stairs(int count) {
  PlateStructure s;
  s.thickness = 4.0;
  constexpr double kGap = 12.0, kDepth = 150.0;
  Vec3 corner = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const Vec3 along = i % 2 == 0 ? Vec3::UnitY() : Vec3::UnitZ();
    const double slant = 3.0 + i % 3;
    const Vec3 near = corner + kGap * along, far = corner + (kDepth - kGap) * along;
    const auto at = [](const Vec3& p, double x) { return Vec3(x, p.y(), p.z()); };
    s.plates.push_back(
        {"P" + std::to_string(i),
         {at(near, 0), at(near + slant * along, 120), at(near + 2 * slant * along, 240),
          at(far, 245), at(far + slant * along, 110), at(far, -5)},
         {}});
    corner += kDepth * along;
  }
  return s;
}

Plate nudged(Plate plate, int step) {
  const double by = 0.1 * (1 + step % 20);
  for (Vec3& p : plate.outline)
    p.x() += by;
  return plate;
}

void Connect(benchmark::State& state) {
  const PlateStructure s = stairs(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const auto connection = connect(s);
    if (!connection) return state.SkipWithError(connection.error().message.c_str());
    benchmark::DoNotOptimize(connection);
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(Connect)->Arg(2)->Arg(10)->Arg(30)->Arg(100)->Unit(benchmark::kMicrosecond)->Complexity();

/// One plate in the middle moves a little each time, the bends that were found are asked for again;
/// with the flat pattern, as one who drags a plate wants to see it.
void Rejoin(benchmark::State& state) {
  PlateStructure s = stairs(static_cast<int>(state.range(0)));
  const auto first = connect(s);
  if (!first) return state.SkipWithError(first.error().message.c_str());
  for (const FittedBend& bend : first->bends)
    s.bends.push_back(bend.request);
  const bool flat_too = state.range(1) != 0;
  Plate& moving = s.plates[s.plates.size() / 2];
  const Plate plate = moving;
  int step = 0;
  for (auto _ : state) {
    moving = nudged(plate, step++);
    const auto connection = connect(s);
    if (!connection) return state.SkipWithError(connection.error().message.c_str());
    if (!flat_too) continue;
    const auto pattern = flatten(connection->sheet, {});
    if (!pattern) return state.SkipWithError(pattern.error().message.c_str());
    benchmark::DoNotOptimize(pattern);
  }
  state.SetLabel(flat_too ? "and flat pattern" : "");
}
BENCHMARK(Rejoin)->ArgsProduct({{2, 10, 30, 100}, {0, 1}})->Unit(benchmark::kMicrosecond);

}  // namespace
