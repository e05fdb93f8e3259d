#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish {

// The plane problem of math.md#bend-frame. On side i of a bend a corner is (x, y): x along the
// intersection line of the plates' planes, y the distance from it, positive on the side where the
// plate lies.

/// Facing: the outward normals point to the intersection line; averted: away from it.
enum class EdgeKind { facing, averted };

/// A maximal run of consecutive edges of one kind that can carry a bend, x growing: edges[j] joins
/// corners[j] and corners[j + 1]. Edges that cross the intersection line (y changes sign) or are
/// parallel to the y axis cannot carry a bend.
struct Chain {
  EdgeKind kind = EdgeKind::facing;
  std::vector<Vec2> corners;
  std::vector<int> edges;  ///< numbers of the edges in the plate's outline
};

/// Viable chains of an outline (either way round) with y ≥ 0, in the order of their first edge
/// number. Edges of one kind never close a loop. Edges whose |Δx| is below 1e-9 of
/// the outline's extent or 0.001 of |Δy| count as parallel to the y axis, corners with |y| below
/// 1e-9 of the extent as y = 0.
std::vector<Chain> viable_chains(const std::vector<Vec2>& outline);

/// Ψ(φ) of math.md#arc-factor for the slope k = tan φ: arc length of the circular directrix over
/// the height of its ends above the intersection line; `beta` is the angle between the plates'
/// sides e₁ and e₂, in (0, π). For averted edges with the averted azimuth.
double arc_factor(Angle beta, EdgeKind kind, double slope);

/// The slope at which the thesis linearises Ψ [thesis 94].
inline constexpr double kLinearisedSlope = 0.3;

/// The tangent lines y = k x − q, the same on both sides.
struct TangentLine {
  double slope = 0.0;   ///< k
  double offset = 0.0;  ///< q
  double at(double x) const { return slope * x - offset; }
};

/// What is given of the tangent line: at most two members; `offset` is q.
struct GivenLine {
  std::optional<double> slope = std::nullopt;
  std::optional<double> offset = std::nullopt;
  std::optional<double> apex = std::nullopt;  ///< x₀: q = k·x₀
};

/// Consecutive edges of one chain: chain.edges[first … last].
struct Run {
  int chain = 0;  ///< index into the side's chains
  int first = 0, last = 0;
  friend bool operator==(const Run&, const Run&) = default;
};

/// Edges for a bend and how good they are (math.md#widest-bend).
struct EdgeChoice {
  EdgeKind kind = EdgeKind::facing;
  std::array<Run, 2> runs;
  double width = 0.0;
  double span = 0.0;  ///< smallest over the tangent lines allowed
  TangentLine line;   ///< for which the span is smallest
};

struct EdgeSearchOptions {
  double trade_off = 1.0;  ///< γ ≥ 0
  GivenLine line;
  /// Edges that the bend must use, per side, by outline number: all of them and no others.
  std::array<std::optional<std::vector<int>>, 2> edges;
  int alternatives = 3;  ///< largest number of next best choices to return
};

struct EdgeSearch {
  EdgeChoice reference;  ///< the bend of minimum average length (math.md#shortest-bend); its span
                         ///< is S_ref
  double reference_length = 0.0;  ///< the objective of math.md#shortest-bend
  EdgeChoice best;
  /// Next best choices: the best of each other pair of chains or of the other kind, widest first.
  std::vector<EdgeChoice> alternatives;
};

/// Exact optimum of math.md#widest-bend over all runs of both sides and both kinds: the widest bend
/// whose span exceeds the reference's by at most γ times the gain in width. Ties (widths within
/// 1e-9 of the extent): the smaller span, then the smaller edge numbers. Exact to rounding: span
/// and width agree with the mixed-integer programs [thesis 99, 114] to 1e-9 of the extent. Errors:
/// `no_bend_fits` when no pair of edges admits a tangent line (facing needs 0 ≤ k x − q ≤ y at
/// every corner, averted k x − q ≥ y), also if only because of what is given; `unknown_edge` when
/// given edges are not consecutive edges of one viable chain. Cost: a best-first branch and bound
/// over the ends of the runs; near-linear in practice, see docs/connect.md for measurements.
Result<EdgeSearch> search_edges(const std::array<std::vector<Chain>, 2>& sides, Angle beta,
                                const EdgeSearchOptions& options = {});

/// All choices of edges that are *efficient* (math.md#efficient-bends): no other is as wide and
/// shorter, or as short and wider. The widest first, each next one shorter by its span and
/// narrower; of more than `most`, the widest and the shortest; of `most` = 1 the shortest. Width,
/// span and edges as `search_edges` has them; the trade-off has no part in it. Empty where
/// `search_edges` fails. Cost: one search for each.
std::vector<EdgeChoice> efficient_edges(const std::array<std::vector<Chain>, 2>& sides, Angle beta,
                                        const EdgeSearchOptions& options = {}, int most = 250);

/// Tangent line of least plate extension for given runs (math.md#least-extension): minimises the
/// sum over both sides of the area between the run and the tangent line, lateral edges along y.
/// Exact: a linear program in (k, q), solved at its vertices. If the optimum is not unique, the one
/// with the smallest |k|.
struct SmallestExtension {
  TangentLine line;
  double area = 0.0;  ///< mm², ≥ 0
};
/// Corners of the selected runs by side, x growing. Error: `no_bend_fits` as above.
Result<SmallestExtension> smallest_extension(const std::array<std::vector<Vec2>, 2>& corners,
                                             EdgeKind kind, const GivenLine& given = {});

/// Area between runs and a tangent line as in math.md#least-extension; negative where the line cuts
/// a plate.
double extension_area(const std::array<std::vector<Vec2>, 2>& corners, EdgeKind kind,
                      const TangentLine& line);

/// Smallest and largest feasible values of a tangent line, for messages; empty if no value is
/// feasible.
struct Range {
  double low = 0.0, high = 0.0;  ///< may be infinite
};
std::optional<Range> feasible_slopes(const std::array<std::vector<Vec2>, 2>& corners,
                                     EdgeKind kind);
/// Offsets q for a given slope.
std::optional<Range> feasible_offsets(const std::array<std::vector<Vec2>, 2>& corners,
                                      EdgeKind kind, double slope);

}  // namespace planish
