#pragma once

#include <planish/base/angle.hpp>
#include <planish/geometry/frame.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// Holes that are not polygons, in the plane of their plate, mm.
struct RoundHole {
  Vec3 at = Vec3::Zero();
  double radius = 0.0;
};
/// With round ends about two points.
struct SlotHole {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double width = 0.0;
};
/// Edge i runs from corner i to corner i + 1, straight or as the arc through a point between.
struct ArcHole {
  std::vector<Vec3> corners;
  std::vector<std::optional<Vec3>> through;  ///< by edge
};
using HoleShape = std::variant<RoundHole, SlotHole, ArcHole>;

/// A flat plate placed in space: closed polygons on its mid-surface, mm, the last corner not
/// repeated, either way round. Edge i runs from corner i to corner i + 1.
struct Plate {
  std::string id;
  std::vector<Vec3> outline;
  std::vector<std::vector<Vec3>> holes;
  /// By hole: those that are not polygons, which are empty in `holes`. They have no edges to carry
  /// a bend.
  std::map<std::size_t, HoleShape> shapes = {};
};

/// `general`: an oblique cone (math.md#general-cone), whose tangent lines lie along the edges of
/// both plates.
enum class SurfaceChoice { automatic, cylinder, cone, general };

/// math.md#lateral-boundaries. `automatic`: straight if the corners of both plates are near enough,
/// else corner.
enum class LateralBoundary { automatic, straight, arc, corner };

/// What is given of a bend; the rest is chosen. Lengths in mm.
struct BendRequest {
  /// Ids of the plates: two; one, for a curved section with a free end; or none, for a section by
  /// itself (a pipe).
  std::vector<std::string> between = {};
  /// Consecutive edges of each plate, in any order.
  std::array<std::optional<std::vector<int>>, 2> edges = {};
  SurfaceChoice surface = SurfaceChoice::automatic;
  std::optional<double> inside_radius = std::nullopt;  ///< of a cylinder; of a cone at mid-length
  std::optional<std::array<double, 2>> inside_radii = std::nullopt;  ///< of a cone at its lateral
                                                                     ///< boundaries
  std::optional<Angle> aperture = std::nullopt;  ///< of a cone: twice its half-angle
  std::optional<double> slope = std::nullopt;    ///< k of the tangent lines, math.md#tangent-lines
  std::optional<double> apex = std::nullopt;     ///< x₀ = q/k of the tangent lines,
                                                 ///< math.md#tangent-lines
  /// Of a general bend: where the tangents at both ends of its outer arc meet, on the planes'
  /// intersection line.
  std::optional<Vec3> tangent_point = std::nullopt;
  LateralBoundary lateral = LateralBoundary::automatic;
  double trade_off = 1.0;                       ///< γ of math.md#widest-bend, ≥ 0
  std::optional<Angle> angle = std::nullopt;    ///< of a section with a free end, ≤ 360°
  std::optional<double> length = std::nullopt;  ///< of a section without plates, along its rulings
};

/// What holds for the bends that the program finds.
struct BendDefaults {
  std::optional<double> inside_radius = std::nullopt;  ///< mm
  LateralBoundary lateral = LateralBoundary::automatic;
  double trade_off = 1.0;
};

/// Plates to be joined to one sheet, and what is given of the bends between them. If `bends` is
/// empty, the program finds which plates to join.
struct PlateStructure {
  double thickness = 0.0;  ///< mm
  std::vector<Plate> plates;
  std::vector<BendRequest> bends;
  BendDefaults defaults = {};
  /// The longest way from plate to plate, extensions included, that a bend may bridge, mm. Empty: a
  /// bend that the program finds, twice the diagonals of both plates together; a bend that is
  /// given, any.
  std::optional<double> largest_span = std::nullopt;
  /// Whether plates that touch are cut back so that bends fit between them (math.md#trimming).
  /// Empty: if all of them touch, or if then more are joined where they do.
  std::optional<bool> trim = std::nullopt;
  std::string root;  ///< id of the plate that stays where it is; empty: the largest
};

}  // namespace planish
