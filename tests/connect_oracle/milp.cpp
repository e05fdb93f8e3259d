#include "connect_oracle/milp.hpp"

#include "connect_oracle/line_bounds.hpp"
#include "connect_oracle/line_fit.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace planish::oracle {
namespace {

/// A corner of a chain in a program: what says that it is selected (1, else 0), and the line's
/// height.
struct SelectableCorner {
  Vec2 at;
  Linear selected, height;
  Bounds bounds;  ///< of the height, whether selected or not
};

/// a ≤ b where the corner is selected; `excess` is what a − b can be at most where it is not.
void at_most_if(LinearProgram& program, const SelectableCorner& corner, const Linear& a,
                const Linear& b, double excess) {
  program.at_most(a, b + std::max(0.0, excess) * (1.0 - corner.selected));
}

/// math.md#tangent-lines.
void require_feasible(LinearProgram& program, const SelectableCorner& corner, EdgeKind kind) {
  const double y = corner.at.y();
  at_most_if(program, corner, 0.0, corner.height, -corner.bounds.low);
  if (kind == EdgeKind::facing)
    at_most_if(program, corner, corner.height, y, corner.bounds.high - y);
  else
    at_most_if(program, corner, y, corner.height, y - corner.bounds.low);
}

struct Model {
  LinearProgram program;
  LineColumns line;
  EdgeKind kind;
  LineBounds bounds;

  SelectableCorner corner(const Vec2& at, Linear selected) const {
    return {at, std::move(selected), line.height(at.x()), bounds.height(at.x())};
  }
};

/// `cap` is what the height can be at most at a selected corner of averted edges.
std::optional<Model> model_of(const Corners& corners, EdgeKind kind, double cap) {
  std::array<std::vector<BoundedCorner>, 2> bounded;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Vec2& p : corners[i])
      bounded[i].push_back({p, kind == EdgeKind::facing ? Bounds{0.0, p.y()} : Bounds{p.y(), cap}});
  auto bounds = LineBounds::of(bounded);
  if (!bounds) return std::nullopt;
  // Bounds are rounded; their rounding must not cut a feasible line off.
  const double margin = 1e3 * kSolverTolerance;
  Model model{{}, {}, kind, std::move(*bounds)};
  const Bounds slope = model.bounds.slope(), at_zero = model.bounds.height(0.0);
  model.line = {model.program.continuous(slope.low - margin, slope.high + margin),
                model.program.continuous(-at_zero.high - margin, -at_zero.low + margin)};
  return model;
}

Linear absolute(LinearProgram& program, const Linear& difference) {
  const Linear value = Linear::of(program.continuous(0.0, std::numeric_limits<double>::max()));
  program.at_most(difference, value);
  program.at_most(-1.0 * difference, value);
  return value;
}

Linear sum_of(const std::vector<Column>& columns) {
  Linear sum;
  for (const Column column : columns)
    sum += Linear::of(column);
  return sum;
}

/// Σ weight(j) · column j.
template <typename Weight>
Linear weighted(const std::vector<Column>& columns, const Weight& weight) {
  Linear sum;
  for (std::size_t j = 0; j < columns.size(); ++j)
    sum += weight(j) * Linear::of(columns[j]);
  return sum;
}

std::vector<Column> binaries(LinearProgram& program, std::size_t count) {
  std::vector<Column> columns(count);
  for (Column& column : columns)
    column = program.binary();
  return columns;
}

int first_set(const Solution& solution, const std::vector<Column>& columns) {
  const auto set = [&](Column column) { return solution.value(Linear::of(column)) > 0.5; };
  return static_cast<int>(std::ranges::find_if(columns, set) - columns.begin());
}

/// [thesis 99]: left and right corner of the one edge of a side, each a vector of binaries with a
/// single one.
struct EdgeColumns {
  std::vector<Column> left, right;
};

EdgeColumns one_edge(LinearProgram& program, std::size_t corners) {
  EdgeColumns edge{binaries(program, corners), binaries(program, corners)};
  const auto number = [](std::size_t j) { return static_cast<double>(j); };
  program.equal(sum_of(edge.left), 1.0);
  program.equal(sum_of(edge.right), 1.0);
  program.equal(weighted(edge.right, number), weighted(edge.left, number) + 1.0);
  return edge;
}

/// The height at a corner where it is selected, else zero: B of [thesis 99].
Linear height_if_selected(Model& model, const SelectableCorner& corner, double cap) {
  const double top = model.kind == EdgeKind::facing ? corner.at.y() : cap;
  const Linear height = Linear::of(model.program.continuous(0.0, std::max(0.0, top)));
  model.program.at_most(height, std::max(0.0, top) * corner.selected);
  at_most_if(model.program, corner, height, corner.height, -corner.bounds.low);
  at_most_if(model.program, corner, corner.height, height, corner.bounds.high);
  return height;
}

/// ½Ψ̃ b̄ and the mean extension of a side.
Linear mean_length(Model& model, const std::vector<Vec2>& side, const EdgeColumns& edge, double psi,
                   double cap) {
  Linear length;
  for (std::size_t j = 0; j < side.size(); ++j) {
    const auto corner = model.corner(side[j], Linear::of(edge.left[j]) + Linear::of(edge.right[j]));
    require_feasible(model.program, corner, model.kind);
    const Linear height = height_if_selected(model, corner, cap);
    length += 0.5 * (0.5 * psi * height +
                     extension_sign(model.kind) * (side[j].y() * corner.selected - height));
  }
  return length;
}

/// Length of the shortest bend of averted edges with a level tangent line, at the highest of its
/// four corners: there is one, so the optimum is no longer.
double level_length(const Corners& corners, double psi) {
  double best = kNoBend;
  for (auto a = corners[0].begin(); a + 1 != corners[0].end(); ++a)
    for (auto b = corners[1].begin(); b + 1 != corners[1].end(); ++b) {
      const Corners edges{std::vector<Vec2>{a[0], a[1]}, std::vector<Vec2>{b[0], b[1]}};
      const double level = std::max(most(edges[0]), most(edges[1]));
      const double mean = 0.5 * (a[0].y() + a[1].y() + b[0].y() + b[1].y());
      best = std::min(best, shift_of(edges) + psi * level + 2.0 * level - mean);
    }
  return best;
}

/// Averted: (½Ψ̃ + 1)(b̄₁ + b̄₂) − ȳ₁ − ȳ₂ is at most the length of a bend there is.
double highest_of_shortest(const Corners& corners, double psi) {
  return 2.0 * (level_length(corners, psi) + most(corners[0]) + most(corners[1])) /
         (0.5 * psi + 1.0);
}

/// [thesis 114]: a run of corners of a side: `from` is 1 from the first corner on, `to` is 1 up to
/// the last.
struct RunColumns {
  std::vector<Column> from, to;
  Linear selected(std::size_t j) const { return Linear::of(from[j]) + Linear::of(to[j]) - 1.0; }
};

RunColumns one_run(LinearProgram& program, std::size_t corners) {
  RunColumns run{binaries(program, corners), binaries(program, corners)};
  for (std::size_t j = 0; j + 1 < corners; ++j) {
    program.at_most(Linear::of(run.from[j]), Linear::of(run.from[j + 1]));
    program.at_most(Linear::of(run.to[j + 1]), Linear::of(run.to[j]));
  }
  Linear count;
  for (std::size_t j = 0; j < corners; ++j) {
    program.at_most(0.0, run.selected(j));
    count += run.selected(j);
  }
  program.at_most(2.0, count);
  return run;
}

/// x of the run's first corner: the corner at which `from` steps up.
Linear left_end(const std::vector<Vec2>& side, const RunColumns& run) {
  return side.back().x() * Linear::of(run.from.back()) - weighted(run.from, [&](std::size_t j) {
           return j + 1 < side.size() ? side[j + 1].x() - side[j].x() : 0.0;
         });
}

Linear right_end(const std::vector<Vec2>& side, const RunColumns& run) {
  return side.front().x() * Linear::of(run.to.front()) + weighted(run.to, [&](std::size_t j) {
           return j > 0 ? side[j].x() - side[j - 1].x() : 0.0;
         });
}

/// ½Ψ̃ times the greatest height, and the greatest extension of a side.
Linear span_of(Model& model, const std::vector<Vec2>& side, const RunColumns& run, double psi) {
  const Linear tallest = Linear::of(
      model.program.continuous(0.0, std::numeric_limits<double>::max()));
  const Linear longest = Linear::of(
      model.program.continuous(0.0, std::numeric_limits<double>::max()));
  for (std::size_t j = 0; j < side.size(); ++j) {
    const auto corner = model.corner(side[j], run.selected(j));
    const double y = side[j].y();
    require_feasible(model.program, corner, model.kind);
    at_most_if(model.program, corner, corner.height, tallest, corner.bounds.high);
    at_most_if(model.program, corner, extension(model.line, model.kind, side[j]), longest,
               model.kind == EdgeKind::facing ? y - corner.bounds.low : corner.bounds.high - y);
  }
  return 0.5 * psi * tallest + longest;
}

/// Averted: ½Ψ̃ Σ H + Σ (H − y) is at most the span that the greatest width allows.
double highest_of_widest(const Corners& corners, double psi, const Wanted& wanted) {
  const double allowed = wanted.reference_span +
                         wanted.trade_off *
                             std::max(0.0, width_of(corners) - wanted.reference_width);
  return (allowed + most(corners[0]) + most(corners[1])) / (0.5 * psi + 1.0);
}

Wanted scaled(const Wanted& wanted, double scale) {
  return {scale * wanted.reference_span, scale * wanted.reference_width, wanted.trade_off};
}

}  // namespace

std::vector<Vec2> corners_of(const Chain& chain, int first, int last) {
  return {chain.corners.begin() + first, chain.corners.begin() + last + 2};
}

double width_of(const Corners& c) {
  return 0.5 * (c[0].back().x() - c[0].front().x() + c[1].back().x() - c[1].front().x());
}

MilpReference minimum_length_bend(const Chain& chain1, const Chain& chain2, double psi,
                                  double seconds) {
  const Normal normal({chain1.corners, chain2.corners});
  const Corners corners = normal.of({chain1.corners, chain2.corners});
  const double cap = highest_of_shortest(corners, psi);
  auto model = model_of(corners, chain1.kind, cap);
  if (!model) return {Outcome::infeasible, kNoBend, {}, {}};
  LinearProgram& program = model->program;
  const std::array<EdgeColumns, 2> edges{one_edge(program, corners[0].size()),
                                         one_edge(program, corners[1].size())};
  Linear length;
  for (std::size_t i = 0; i < 2; ++i)
    length += mean_length(*model, corners[i], edges[i], psi, cap);
  const auto x_at = [&](std::size_t i, const std::vector<Column>& columns) {
    return weighted(columns, [&](std::size_t j) { return corners[i][j].x(); });
  };
  length += absolute(program, x_at(0, edges[0].left) - x_at(1, edges[1].left));
  length += absolute(program, x_at(0, edges[0].right) - x_at(1, edges[1].right));
  program.minimise(length);
  const Solution solution = program.solve(seconds);
  MilpReference reference{solution.outcome, kNoBend, {}, {}};
  if (solution.values.empty()) return reference;
  reference.edges = {first_set(solution, edges[0].left), first_set(solution, edges[1].left)};
  const Fit exact = length_fit({corners_of(chain1, reference.edges[0], reference.edges[0]),
                                corners_of(chain2, reference.edges[1], reference.edges[1])},
                               chain1.kind, psi);
  reference.length = exact.cost;
  reference.line = exact.line;
  return reference;
}

MilpTopology widest_bend(const Chain& chain1, const Chain& chain2, double psi, const Wanted& given,
                         double seconds) {
  const Normal normal({chain1.corners, chain2.corners});
  const Corners corners = normal.of({chain1.corners, chain2.corners});
  Wanted wanted = scaled(given, normal.scale);
  wanted.reference_span += kSpanSlack * Normal::kSize;
  auto model = model_of(corners, chain1.kind, highest_of_widest(corners, psi, wanted));
  if (!model) return {Outcome::infeasible, 0.0, {}, kNoBend};
  LinearProgram& program = model->program;
  const std::array<RunColumns, 2> runs{one_run(program, corners[0].size()),
                                       one_run(program, corners[1].size())};
  std::array<Linear, 2> left, right;
  Linear width, span;
  for (std::size_t i = 0; i < 2; ++i) {
    left[i] = left_end(corners[i], runs[i]);
    right[i] = right_end(corners[i], runs[i]);
    width += 0.5 * (right[i] - left[i]);
    span += span_of(*model, corners[i], runs[i], psi);
  }
  span += absolute(program, left[0] - left[1]) + absolute(program, right[0] - right[1]);
  program.at_most(span - wanted.reference_span,
                  wanted.trade_off * (width - wanted.reference_width));
  program.minimise(-1.0 * width);
  const Solution solution = program.solve(seconds);
  MilpTopology topology{solution.outcome, 0.0, {}, kNoBend};
  if (solution.values.empty()) return topology;
  const std::array<const Chain*, 2> chains{&chain1, &chain2};
  Corners selected;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<Column> back(runs[i].to.rbegin(), runs[i].to.rend());
    const int last_corner = static_cast<int>(back.size()) - 1 - first_set(solution, back);
    topology.runs[i] = {0, first_set(solution, runs[i].from), last_corner - 1};
    selected[i] = corners_of(*chains[i], topology.runs[i].first, topology.runs[i].last);
  }
  topology.width = width_of(selected);
  topology.span = smallest_span(selected, chain1.kind, psi);
  return topology;
}

}  // namespace planish::oracle
