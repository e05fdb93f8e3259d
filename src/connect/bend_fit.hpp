#pragma once

#include "lateral.hpp"
#include "plate_plane.hpp"

#include <planish/connect/connect.hpp>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace planish::connect_detail {

/// Consecutive edges of an outline: first, first + 1, … (cyclically), `count` of them.
struct OutlineRun {
  int first = 0;
  int count = 0;
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
  std::optional<Fold> fold = {};
};

/// What a bend is fitted between, and how.
struct FitTask {
  std::array<const PlacedPlate*, 2> plates{};  ///< by side; null: the side ends free
  BendRequest request;
  double thickness = 0.0;
  std::string pointer;  ///< of the request in the file, "/bends/1"; empty if not requested
  std::array<std::set<int>, 2> taken;  ///< edges that other bends use already
};

/// Fits a bend between two plates (math.md#bend-fitting). Errors: those of `connect` for one bend.
Result<BendFit> fit_between(const FitTask& task, const ConnectOptions& options);

/// A curved section with a free end: at an edge of one plate, or by itself (math.md#free-sections).
Result<BendFit> fit_section(const FitTask& task, const ConnectOptions& options);

/// The distance between plates in the sense of math.md#widest-bend, for choosing which to join:
/// span over width of the best bend between them; empty if no bend fits.
struct Nearness {
  double span = 0.0, width = 0.0;
};
std::optional<Nearness> nearness(const FitTask& task, const ConnectOptions& options);

}  // namespace planish::connect_detail
