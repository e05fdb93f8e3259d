#pragma once

#include "lateral.hpp"
#include "plate_plane.hpp"

#include <planish/base/result.hpp>
#include <planish/connect/connect.hpp>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace planish::connect_detail {

/// Consecutive edges of a ring of a plate: those that begin at its corners first, first + 1, …
/// (cyclically), `count` of them; of the first one the part from `start` on, of the last one that
/// up to `end`, as shares of their lengths.
struct OutlineRun {
  int first = 0;
  int count = 0;
  int ring = 0;
  double start = 0.0, end = 1.0;
};

/// The ends and corners of a run in the plate's own axes, in the order of its ring.
std::vector<Vec2> run_points(const PlacedPlate& plate, const OutlineRun& run);

/// A stretch of a bend from one lateral boundary to the other, and the edges that it joins.
struct BendBand {
  Boundaries boundaries;
  std::array<OutlineRun, 2> runs;
  std::array<std::vector<OutlineRun>, 2> more;  ///< beyond recesses of one plate, along the band
};

/// A fold of inside radius 0: it has no surface, the plates' inner skins meet in a line.
struct Fold {
  double reach = 0.0;            ///< of that line from the intersection line, mm
  double low = 0.0, high = 0.0;  ///< its ends along the intersection line
  /// By side: its low and high end are at corners of the plate.
  std::array<std::array<bool, 2>, 2> at_corner{};
  bool reference_inside = true;  ///< settled once all bends are known
};

/// A bend between two plates, or of one or none, ready for assembly.
struct BendFit {
  FittedBend report;
  BendSurface surface;
  Boundaries boundaries;
  std::array<OutlineRun, 2> runs;
  std::array<std::vector<OutlineRun>, 2> more;  ///< as of a band
  std::vector<BendBand> stretches;              ///< further stretches of an interrupted bend
  /// If this is only a further joint of another fit's band: the row of that fit, and the side.
  std::optional<std::pair<int, int>> joint_of = {};
  std::optional<int> stretch_of = {};  ///< row of the fit of which this is a further stretch
  std::optional<Fold> fold = {};
};

/// Parts of an edge, each from one share of its length to another.
using EdgeParts = std::vector<Spread>;

/// What bends use of a plate's edges, by their numbers.
struct UsedEdges {
  std::set<int> whole;
  std::map<int, EdgeParts> parts;
};

/// What a bend is fitted between, and how.
struct FitTask {
  std::array<const PlacedPlate*, 2> plates{};  ///< by side; null: the side ends free
  BendRequest request;
  double thickness = 0.0;
  std::string pointer;  ///< of the request in the file, "/bends/1"; empty if not requested
  std::array<UsedEdges, 2> taken;  ///< by other bends
  bool shares_edges = false;       ///< uses no more of an edge than lies opposite the other plate
  bool right_only = false;         ///< no general cone unless it is asked for
};

/// Extent of the larger plate of the task, mm.
double extent_of(const FitTask& task);

/// Facts of a refusal, with the plates of the task before them, named "plate".
Facts about(const FitTask& task, Facts facts);

/// An error about a task becomes one about its request: keys of the request, "/inside_radius",
/// become pointers into the file, and the plates and the request are among the places.
Error in_request(const FitTask& task, Error error);

/// Fits a bend between two plates (math.md#bend-fitting). Errors: those of `connect` for one bend.
Result<BendFit> fit_between(const FitTask& task, const ConnectOptions& options);

/// A curved section with a free end: at an edge of one plate, or by itself (math.md#free-sections).
Result<BendFit> fit_section(const FitTask& task, const ConnectOptions& options);

/// The distance between plates, for choosing which to join: of the best bend between them the span
/// of math.md#widest-bend without the shift of its ends, over the width that both edges have in
/// common (where they have none: span and width as they are). So a short wall is as near to a long
/// floor as to a short one. Empty if no bend fits.
struct Nearness {
  double span = 0.0, width = 0.0;
};
std::optional<Nearness> nearness(const FitTask& task, const ConnectOptions& options);

}  // namespace planish::connect_detail
