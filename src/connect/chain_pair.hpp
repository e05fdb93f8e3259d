#pragma once

#include "tangent_program.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/connect/edge_search.hpp>

#include <array>
#include <optional>

namespace planish::connect_detail {

/// Two chains of one kind, one per side, between which a bend is sought.
struct ChainPair {
  std::array<int, 2> chains{};
  std::array<const Chain*, 2> sides{};
  std::array<const RunEnvelope*, 2> envelopes{};
  /// Edges that must be used, as positions in the chain (first, last); empty: free.
  std::array<std::optional<std::pair<int, int>>, 2> fixed;
  EdgeKind kind = EdgeKind::facing;
  double factor = 0.0;  ///< Ψ̃
  double size = 0.0;    ///< extent of the corners
  GivenLine line;

  int edge_count(int side) const { return static_cast<int>(sides[side]->edges.size()); }
  double x(int side, int corner) const { return sides[side]->corners[corner].x(); }
  /// Corners of the edges first … last.
  CornerRange corners(int side, int first, int last) const {
    return {envelopes[side], first, last + 1};
  }
};

/// The bend of minimum average length of a pair of chains (math.md#shortest-bend): one edge per
/// side, or the fixed edges. Empty if no tangent line is possible, or none is shorter than `bound`.
struct ReferenceBend {
  EdgeChoice choice;  ///< with the width and the smallest span of its edges
  double length = 0.0;
};
std::optional<ReferenceBend> reference_bend(const ChainPair& pair, double bound);

/// The widest bend of a pair of chains with span − reference span ≤ γ · (width − reference width),
/// if it is better than `best` (which may be empty).
std::optional<EdgeChoice> widest_bend(const ChainPair& pair, const EdgeChoice& reference,
                                      double trade_off, const std::optional<EdgeChoice>& best);

/// The runs of a pair of chains with the smallest span, if it is smaller than that of `best` (which
/// may be empty).
std::optional<EdgeChoice> least_span(const ChainPair& pair, const std::optional<EdgeChoice>& best);

/// The smallest span of two runs (positions of their edges in the chains) over all tangent lines;
/// `start` is a slope to begin with.
std::optional<EdgeChoice> measured(const ChainPair& pair,
                                   const std::array<std::pair<int, int>, 2>& runs,
                                   double start = 0.0);

/// Widths that differ by less than this share of the extent are equal.
inline constexpr double kEqualWidths = tolerance::kComputed;

/// Order of math.md#widest-bend: the wider, then the smaller span, then the smaller edge numbers.
bool better(const ChainPair& pair, const EdgeChoice& a, const EdgeChoice& b);

}  // namespace planish::connect_detail
