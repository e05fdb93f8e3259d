#pragma once

#include "connect_oracle/linear_program.hpp"

#include <planish/connect/edge_search.hpp>

#include <array>
#include <limits>
#include <vector>

// The mixed-integer programs of the bent-plate thesis (bibliography.md#thesis), [thesis 99] with
// [thesis 101–102] (section 4.6.7) and [thesis 114] (section 4.6.8), for one pair of chains of one
// kind: what search_edges must agree with and is measured against. Nothing here is shared with the
// search; Ψ̃ is given.
//
// Where they differ from the thesis, which math.md#shortest-bend and math.md#widest-bend put right:
// - Reference [thesis 103, 114]. The thesis subtracts the average length of the shortest bend from
//   a span. A span is never less, so the shortest bend itself could be refused. Here its span is
//   subtracted.
// - Ψ̃ [thesis 94, 99, 100]. The Ψ of the thesis, half of ours, has −1 beside it in [thesis 99] and
//   +1 in [thesis 102]: the curved section counts ½Ψ̃ b̄ a side, the extension ȳ − b̄ (facing) or
//   b̄ − ȳ (averted). Here it is written out term by term, with the constant at slope 0.3.
// - Shift [thesis 98, 99, 112]. |x₁ − x₂| of the left and of the right corners. [thesis 99] as
//   printed bounds its variables by unreadable terms; here by two rows each, ±(x₁ − x₂).
// - Adjacency [thesis 99]. −1 ≤ difference of the indices ≤ 1, with a further row against 0, leaves
//   both orders of an edge's corners: twice the solutions, and left may meet right. Here the index
//   of the second corner is that of the first plus one.
// - Runs [thesis 107, 114]. Here, too, two vectors of binaries a side, "from the first corner on"
//   and "up to the last", whose sum less one says what is selected; at least two corners. The ends'
//   x follow by telescoping sums, without the big M that [thesis 114] takes for the least and
//   greatest selected x.
// - The objective of [thesis 114] adds the distance of the ends over M to settle ties. That shifts
//   the optimum a little; it is left out.
// - Signs [thesis 110–114]. Heights are k x − q ≥ 0, and the extension is y − (k x − q). The thesis
//   writes both ways round; the text at hand has lost its minus signs.
// - Averted [thesis 101–102] is given for the shortest bend only. In the widest bend: y ≤ k x − q,
//   extension (k x − q) − y, Ψ̃ of the averted azimuth.
// - Big M is one large number in the thesis. Here every row has its own, from the coordinates: a
//   bend uses at least one edge on each side, which bounds the tangent line at that edge, and so
//   its slope and its height at every other corner. Averted edges bound it from below only; the
//   length or span that an optimum can have at most bounds it from above.
namespace planish::oracle {

/// No time limit.
inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

using Corners = std::array<std::vector<Vec2>, 2>;  ///< selected, by side, x growing

struct MilpReference {
  Outcome outcome = Outcome::stopped;
  double length = 0.0;  ///< objective of math.md#shortest-bend, of a linear program for the edges
                        ///< found
  std::array<int, 2> edges{};  ///< positions in the chains
  TangentLine line;
};

/// The bend of minimum average length (math.md#shortest-bend) between two chains of one kind.
MilpReference minimum_length_bend(const Chain& chain1, const Chain& chain2, double psi,
                                  double seconds = kUnlimited);

struct Wanted {
  double reference_span = 0.0;   ///< S_ref
  double reference_width = 0.0;  ///< w_ref
  double trade_off = 0.0;        ///< γ
};

struct MilpTopology {
  Outcome outcome = Outcome::stopped;
  double width = 0.0;
  std::array<Run, 2> runs;  ///< `chain` is 0
  double span = 0.0;        ///< least for the runs found
};

/// The widest bend (math.md#widest-bend) between two chains of one kind; a span may exceed what is
/// allowed by kSpanSlack of the extent, without which the reference itself would hang on rounding
/// where γ = 0.
MilpTopology widest_bend(const Chain& chain1, const Chain& chain2, double psi, const Wanted& wanted,
                         double seconds = kUnlimited);
inline constexpr double kSpanSlack = 1e-8;

/// Objective of math.md#shortest-bend and span of math.md#widest-bend of selected corners, the
/// least over all tangent lines, by linear programs; infinite where no tangent line is feasible.
double smallest_length(const Corners& corners, EdgeKind kind, double psi);
double smallest_span(const Corners& corners, EdgeKind kind, double psi);

/// Corners of edges `first` to `last` of a chain.
std::vector<Vec2> corners_of(const Chain& chain, int first, int last);

/// ½ Σ (x_right − x_left).
double width_of(const Corners& corners);

}  // namespace planish::oracle
