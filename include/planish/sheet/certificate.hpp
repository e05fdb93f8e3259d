#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <functional>
#include <limits>

namespace planish {

/// The residuals that show a flat pattern right. NaN where nothing could be measured.
struct Certificate {
  double flat_area_half = 0.0;  ///< flat area at K = ½, mm²
  double volume_ratio = 0.0;    ///< flat_area_half · thickness / volume of the solid (MATH 1)
  /// The same for the solid without what its formed features and mitred corners add or take: 1 when
  /// nothing was missed. NaN where one of them could not be measured.
  double explained_ratio = std::numeric_limits<double>::quiet_NaN();
  double length_error = 0.0;  ///< largest |length of developed skin border − length of the solid's
                              ///< edge|, mm
  Vec2 length_error_at = Vec2::Zero();
  double refold_deviation = 0.0;  ///< largest distance of a refolded contour point from the solid's
                                  ///< edge, mm
  Vec2 refold_at = Vec2::Zero();
};

/// Distance from a point in space to an edge of the solid, by the edge's number. Makers supply it.
using EdgeDistance = std::function<double(int edge, const Vec3& point)>;

/// For a sheet that was made and not found in a solid: its edges are the sheet's own borders,
/// mapped into space at their `edge_depth`. An edge of several borders is where the nearest of them
/// is, one of none infinitely far. Exact on flanges; on bends to 1e-9 of the border's length.
EdgeDistance border_distance(const Sheet& sheet);

/// Measures a pattern against the sheet and the solid it came from, independently of how it was
/// made: the volume identity at K = ½ whatever K the pattern used, edge lengths on the reference
/// skin, and contour points of the finished pattern folded back onto the solid's edges.
Result<Certificate> certify(const Sheet& sheet, const FlatPattern& pattern,
                            const EdgeDistance& distance, const FlattenOptions& options = {});

}  // namespace planish
