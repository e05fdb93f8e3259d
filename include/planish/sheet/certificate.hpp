#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <functional>
#include <optional>

namespace planish {

/// The openings of a pattern against those of the solid (math.md#openings-and-genus): a sheet with
/// h openings bounds, however it is folded, a solid of genus h.
struct OpeningCount {
  std::optional<int> solid;  ///< genus of the solid; none: there is no solid, or it is not known
  int pattern = 0;           ///< openings as written, and slits with both ends in the material
  int slits = 0;             ///< of these, slits
  int features = 0;  ///< within formed features, where the pattern lists but does not cut them
  int loops = 0;     ///< handles of the sheet itself: joints that close and lie flat
  /// Where openings were looked for and not found among what is written.
  std::vector<Vec2> missing;

  /// How many openings of the solid the pattern does not account for; below 0: it has more. None
  /// where the solid's are not known.
  std::optional<int> lost() const {
    if (!solid) return std::nullopt;
    return *solid - pattern - features - loops;
  }
};

/// The residuals that show a flat pattern right; empty where they could not be measured.
struct Certificate {
  double flat_area_half = 0.0;  ///< flat area at K = ½, mm²
  /// flat_area_half · thickness / volume of the solid (math.md#volume-identity).
  std::optional<double> volume_ratio = {};
  /// The same for the solid corrected for its formed features and mitred corners: 1 if nothing was
  /// missed.
  std::optional<double> explained_ratio = {};
  /// Largest |length of developed skin border − length of the solid's edge|, mm.
  double length_error = 0.0;
  Vec2 length_error_at = Vec2::Zero();
  /// Largest distance between the solid's edges and the contours, both ways: of a contour point,
  /// folded back, from its edge; of an edge, laid flat, from the contours; of a contour from every
  /// edge, mm.
  std::optional<double> refold_deviation = {};
  Vec2 refold_at = Vec2::Zero();
  OpeningCount openings;
  /// The opening that fits worst to what the solid lacks there: the difference of volumes as a mean
  /// distance all round its edge, or how far walls reach into it, mm (math.md#opening-balance).
  /// Empty where none was measured.
  std::optional<double> opening_error = {};
  Vec2 opening_error_at = Vec2::Zero();
  /// How far the solid reaches beyond the outline of a flange, seen along its normal, mm. Empty
  /// where nothing of the rim could.
  std::optional<double> outline_error = {};
  Vec2 outline_error_at = Vec2::Zero();
};

/// Distance from a point in space to an edge of the solid, by the edge's number. Makers supply it.
using EdgeDistance = std::function<double(int edge, const Vec3& point)>;

/// For a sheet that was made, not found in a solid: its edges are the sheet's own borders, mapped
/// into space at their `edge_depth`. The distance to an edge of several borders is that to the
/// nearest; to an edge without borders it is infinite. Exact on flanges; on bends to 1e-9 of the
/// border's length.
EdgeDistance border_distance(const Sheet& sheet);

/// Measures a pattern as written (its contours, and the K-factor and allowance of each bend)
/// against the sheet, and by `distance` against the solid it came from. It uses no placement, tree,
/// contour or origin of the code that made the pattern (math.md#certificate-independence): it
/// develops each face anew, lays the faces out over a tree of its own from where the pattern says
/// its root lies, and looks for every border among the contours and for every contour among the
/// borders. Anything lost or added is therefore a deviation, and so is a misplaced face. Certify
/// before cutting slits. `curve_tolerance`: fitting tolerance of developed curves, mm. Errors:
/// those of `check`, `bad_option` (a tolerance of 0 or less), `pattern_wrong` (the pattern leaves
/// out a bend of the sheet, has no outer contour or a root that is not a face of the sheet),
/// `not_a_sheet` (faces that no joint leads to).
Result<Certificate> certify(const Sheet& sheet, const FlatPattern& pattern,
                            const EdgeDistance& distance, double curve_tolerance = kImageTolerance);

}  // namespace planish
