#include "connect_oracle/line_fit.hpp"

namespace planish::oracle {
namespace {

LineColumns free_line(LinearProgram& program) {
  constexpr double kFree = std::numeric_limits<double>::max();
  return {program.continuous(-kFree, kFree), program.continuous(-kFree, kFree)};
}

void require_feasible(LinearProgram& program, const LineColumns& line, const Corners& corners,
                      EdgeKind kind) {
  for (const auto& side : corners)
    for (const Vec2& p : side) {
      program.at_most(0.0, line.height(p.x()));
      program.at_most(0.0, extension(line, kind, p));
    }
}

template <typename MakeCost>
Fit fit(const Corners& given, EdgeKind kind, const MakeCost& make_cost) {
  const Normal normal(given);
  const Corners corners = normal.of(given);
  LinearProgram program;
  const LineColumns line = free_line(program);
  require_feasible(program, line, corners, kind);
  const Linear cost = make_cost(program, line, corners);
  program.minimise(cost);
  const Solution solution = program.solve(kUnlimited);
  if (solution.values.empty()) return {};
  return {
      solution.value(cost) / normal.scale,
      normal.back(solution.value(Linear::of(line.slope)), solution.value(Linear::of(line.offset)))};
}

}  // namespace

Fit length_fit(const Corners& given, EdgeKind kind, double psi) {
  return fit(given, kind, [&](LinearProgram&, const LineColumns& line, const Corners& corners) {
    Linear length = shift_of(corners);
    for (const auto& side : corners)
      for (const Vec2& p : side)
        length += 1.0 / static_cast<double>(side.size()) *
                  (0.5 * psi * line.height(p.x()) + extension(line, kind, p));
    return length;
  });
}

Fit span_fit(const Corners& given, EdgeKind kind, double psi) {
  return fit(given, kind,
             [&](LinearProgram& program, const LineColumns& line, const Corners& corners) {
               Linear span = shift_of(corners);
               for (const auto& side : corners) {
                 const Linear tallest = Linear::of(
                     program.continuous(0.0, std::numeric_limits<double>::max()));
                 const Linear longest = Linear::of(
                     program.continuous(0.0, std::numeric_limits<double>::max()));
                 for (const Vec2& p : side) {
                   program.at_most(line.height(p.x()), tallest);
                   program.at_most(extension(line, kind, p), longest);
                 }
                 span += 0.5 * psi * tallest + longest;
               }
               return span;
             });
}

double smallest_length(const Corners& corners, EdgeKind kind, double psi) {
  return length_fit(corners, kind, psi).cost;
}

double smallest_span(const Corners& corners, EdgeKind kind, double psi) {
  return span_fit(corners, kind, psi).cost;
}

}  // namespace planish::oracle
