#include "feature_borders.hpp"

#include <algorithm>

namespace planish::sheet_detail {

Loop placed(const BorderLoop& borders, const Isometry2& placement) {
  return mapped(borders,
                [&](const Border& border) { return transformed(border.curve, placement); });
}

std::optional<FeatureId> outlined_form(const Face& face, int loop,
                                       const std::vector<bool>& joined) {
  if (loop == 0 || std::ranges::find(joined, true) != joined.end()) return {};
  for (const Border& border : face.loops[loop])
    if (border.feature) return border.feature;
  return {};
}

std::optional<FeatureId> feature_at(const Border& border, std::optional<FeatureId> of_loop) {
  return border.feature ? border.feature : of_loop;
}

FeatureBorders feature_borders(const Sheet& sheet, const Layout& layout, FaceId face,
                               ExtrudedHoles extruded) {
  const Isometry2& placement = layout.placement[face];
  const bool cut = extruded != ExtrudedHoles::outline;
  FeatureBorders made;
  const auto add = [&](const Loop& curves, std::optional<FeatureId> feature) {
    for (const Curve2& curve : curves)
      made.borders.push_back({curve, feature});
  };
  for (const FeatureId id : sheet.features.ids()) {
    const FormedFeature& feature = sheet[id];
    if (feature.face != face) continue;
    for (const BorderLoop& outline : feature.outlines)
      add(placed(outline, placement), id);
    for (const FormedOpening& opening : feature.openings) {
      const bool pilot = extruded == ExtrudedHoles::pilot;
      const Loop hole = placed(pilot ? opening.pilot : opening.through, placement);
      if (cut) made.holes.push_back(hole);
      add(hole, cut ? std::nullopt : std::optional(id));
    }
    for (const BorderLoop& slit : feature.slits)
      if (cut) add(placed(slit, placement), {});
  }
  return made;
}

}  // namespace planish::sheet_detail
