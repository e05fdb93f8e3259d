#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <string>
#include <vector>

namespace planish {

enum class Severity { info, warning, error };

/// One observation about a flat pattern, with its place in the pattern.
struct Finding {
  std::string code;  ///< e.g. "overlap", "flange_height", "hole_to_bend"
  Severity severity = Severity::warning;
  std::string message;
  std::vector<Vec2> at;
};

/// Thresholds of SHOPFLOOR "Rules of manufacture". Lengths as factors of thickness T and inside
/// radius R where the names say so; all editable in a JSON file (see docs).
struct Rules {
  double flange_height_t = 1.5;  ///< smallest flange height = this·T + flange_height_r·R
  double flange_height_r = 1.0;
  double opening_to_bend_t = 2.0;    ///< opening to bend tangent line
  double opening_to_edge_t = 2.0;    ///< opening to outer contour
  double opening_to_opening_t = 5.0;
  double smallest_opening_t = 1.0;
  double inside_radius_t = 1.0;      ///< smallest inside radius = this·T
  double relief_width_t = 1.0;
  double relief_depth_r = 1.0;       ///< relief depth ≥ relief_depth_r·R + relief_depth_t·T
  double relief_depth_t = 1.0;
  double hem_diameter_t = 1.0;       ///< inside diameter of an open hem (angle ≥ 170°)
  double hem_return_t = 6.0;
  double k_low = 0.2;                ///< warn when a bend's K lies outside [k_low, k_high]
  double k_high = 0.5;
  bool enabled = true;
};

/// Where the pattern covers itself: findings with code "overlap", severity error, area in the
/// message and the overlap's outline as place. Pieces of faces that are joined may touch.
std::vector<Finding> find_overlaps(const Sheet& sheet, const FlatPattern& pattern);

/// Manufacturability warnings by the rules.
std::vector<Finding> check_rules(const Sheet& sheet, const FlatPattern& pattern, const Rules& rules);

}  // namespace planish
