#pragma once

#include <planish/sheet/facets.hpp>

#include <optional>
#include <vector>

namespace planish::sheet_detail {

/// Borders of a plane face as they lie in the pattern.
Loop placed(const BorderLoop& borders, const Isometry2& placement);

/// The feature that a loop of a face outlines, within which the material goes on; empty for a cut.
/// `joined` marks its borders that are not edges of the sheet.
std::optional<FeatureId> outlined_form(const Face& face, int loop, const std::vector<bool>& joined);

/// The feature that a free border outlines: its own, or that of the loop it belongs to.
std::optional<FeatureId> feature_at(const Border& border, std::optional<FeatureId> of_loop);

/// What the flat pattern has of the features on a face beside the face's own borders, in the
/// pattern.
struct FeatureBorders {
  std::vector<FacetBorder> borders;  ///< outlines, which are drawn; openings and slits, which are
                                     ///< cut
  std::vector<Loop> holes;           ///< openings among them
};
FeatureBorders feature_borders(const Sheet& sheet, const Layout& layout, FaceId face,
                               ExtrudedHoles extruded);

}  // namespace planish::sheet_detail
