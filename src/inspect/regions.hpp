#pragma once

#include <planish/geometry/region.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace planish::inspect_detail {

/// By how much regions are shrunk before their overlap is measured. Overlaps shallower than twice
/// this cannot be distinguished from the errors of flattened curves, or of a closed cycle of
/// joints, half of which each side gets.
double contact_clearance(const FlatPattern& pattern);

/// Everything that takes area in the pattern, and the part of the sheet that it belongs to.
struct Regions {
  std::vector<Polygon> polygons;
  std::vector<PartId> parts;
  std::vector<std::optional<FaceId>> faces;  ///< empty for the band of a sharp bend
  /// Area that two faces may share: with the reference skin outside, a sharp bend takes less than
  /// its faces give, so they reach over each other.
  std::map<std::pair<std::optional<FaceId>, std::optional<FaceId>>, double> shared;
};
Regions regions_of(const Sheet& sheet, const Layout& layout, double chord);

/// An overlap of two regions beyond what they may share.
struct Shared {
  PartId first, second;
  double area = 0.0;  ///< with the rim that shrinking took off
  Overlap overlap;
};
std::vector<Shared> shared_areas(const Regions& regions, double clearance);

}  // namespace planish::inspect_detail
