#pragma once

#include "bend_fit.hpp"
#include "bend_frame.hpp"

#include <planish/connect/edge_search.hpp>

namespace planish::connect_detail {

/// The best edges for one bend between two plates, and their frame.
struct PairChoice {
  BendFrame frame;
  std::array<std::vector<Chain>, 2> chains;
  EdgeSearch search;

  /// Corners of a choice's runs by side, x growing; edge numbers likewise.
  std::array<std::vector<Vec2>, 2> corners(const EdgeChoice& choice) const;
  std::array<std::vector<int>, 2> edges(const EdgeChoice& choice) const;
};

/// The frame of a pair, and the chains of edges that are free there; not searched.
/// Error: `plates_offset`.
Result<PairChoice> chains_in(const FitTask& task, const BendFrame& frame,
                             std::optional<EdgeKind> kind);

/// What the request asks of the search for edges.
EdgeSearchOptions search_options(const FitTask& task, const BendFrame& frame);

/// The kind of edges that a given slope or apex applies to; empty: any.
std::optional<EdgeKind> natural_kind(const FitTask& task, const ConnectOptions& options);

/// Searches all frames of the pair and takes the one with the shortest reference bend. Whatever the
/// request gives of the tangent line is respected if it does not depend on the edges chosen;
/// `given` holds further requirements. Errors: `plates_coplanar`, `plates_offset`, `unknown_edge`,
/// `no_bend_fits`.
Result<PairChoice> search_pair(const FitTask& task, const ConnectOptions& options);

/// The chains of a side without what other bends use already.
std::vector<Chain> open_chains(const FitTask& task, const BendFrame& frame, int side);

/// Every choice of edges for a pair of plates, in each of its frames: the best for several
/// trade-offs with their alternatives, and each pair of edges or of two neighbours; in the order of
/// the objective (math.md#widest-bend).
std::vector<PairChoice> edge_choices(const FitTask& task, const ConnectOptions& options);

/// On how much of the line both runs of corners lie, x growing; negative if they lie beside each
/// other.
double common_width(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

/// Span and width of a choice, as `nearness` counts them.
Nearness nearness_of(const PairChoice& choice);

/// The bend on the edges of a choice. Errors: those of `connect` for one bend.
Result<BendFit> fit_choice(const FitTask& task, const PairChoice& choice,
                           const ConnectOptions& options);

/// The task, its inside radius reduced to what the edges allow where these are drawn at most
/// 0.001 mm short of it: plates of real parts carry the rounding of their file.
FitTask at_limit_of_edges(FitTask task, const ConnectOptions& options);

/// The tangent line that a request asks for in a frame.
GivenLine given_line(const BendRequest& request, const BendFrame& frame, double thickness);

/// Whether the request asks for a cone, by name or by its slope.
bool is_conical(const BendRequest& request);

/// Height of the tangent line over the intersection line at which the inside radius is that small.
double least_height(const FitTask& task, const BendFrame& frame);

/// Distance of the tangent line from the intersection line, where the mid-surface has this radius.
double tangent_distance(const BendFrame& frame, double mid_radius);

}  // namespace planish::connect_detail
