#pragma once

#include <planish/base/id_vector.hpp>
#include <planish/base/result.hpp>
#include <planish/sheet/topology.hpp>

#include <vector>

namespace planish::brep {

/// The corners of a sheet: starts of borders, united by the joints. Requires a sheet whose joints
/// name borders that exist, each at most once.
class SheetCorners {
 public:
  explicit SheetCorners(const Sheet& sheet);

  const Topology& topology() const { return topology_; }
  int count() const { return static_cast<int>(sharp_.size()); }
  /// Where a border starts, and where it ends.
  int at_start(BorderId border) const { return corner_[border]; }
  int at_end(BorderId border) const { return corner_[topology_.next(border)]; }
  /// Whether a sharp joint ends there.
  bool is_sharp(int corner) const { return sharp_[corner]; }
  /// The border of a joint that gives the common edge its curve; for a free border, itself.
  BorderId leader(BorderId border) const { return leader_[border]; }
  bool leads(BorderId border) const { return leader_[border] == border; }

 private:
  Topology topology_;
  IdVector<BorderId, int> corner_;
  IdVector<BorderId, BorderId> leader_;
  std::vector<bool> sharp_;  // by corner
};

/// Positions of a corner: on the reference skin (or, for a reference surface between the skins, on
/// the skin it was measured from), and on the other skin, equally far from every plane that meets
/// there (a sharp joint mitres).
struct CornerPoints {
  Vec3 reference = Vec3::Zero();
  Vec3 other = Vec3::Zero();
};

/// Errors: `unsupported_shape` if a sharp joint turns so far that its mitre becomes too long.
Result<std::vector<CornerPoints>> corner_points(const Sheet& sheet, const SheetCorners& corners);

}  // namespace planish::brep
