#pragma once

#include "outline.hpp"

#include <planish/base/result.hpp>

namespace planish::brep {

/// Which skin of the sheet a face belongs to.
enum class Side { none, first, second };

/// An edge where two faces of a skin meet at an angle: a bend without radius on this skin.
struct SharpEdge {
  int edge = 0;
  bool concave = false;  ///< the inside of the bend; the other skin is mitred or rounded there
  bool rounded = false;  ///< rounded, not mitred
};

/// The two skins of a sheet in a solid.
struct Skins {
  double thickness = 0.0;
  double spread = 0.0;                         ///< of the depths met between the skins, mm
  std::vector<Side> side;                      ///< by face
  std::vector<std::vector<int>> partners;      ///< by face: faces opposite at the thickness
  std::vector<SharpEdge> sharp;                ///< on both skins
  double area_first = 0.0, area_second = 0.0;  ///< mm², coarse
  int islands_first = 0, islands_second = 0;   ///< faces of a skin that are not connected to it
};

/// Angle in space between the outward normals of the two faces of an edge, at its middle; negative
/// where the solid is concave there. Empty for seams, open edges and doubly curved neighbours.
std::optional<double> dihedral(const SolidModel& model, int edge);

/// Whether the faces of an edge continue each other: tangent, and parallel when both are planes.
bool smooth_edge(const SolidModel& model, int edge);

/// Depths that much area of opposite faces agrees on (within `tolerance`, a share), likeliest
/// first.
std::vector<double> likely_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance);

/// Grows both skins of a sheet of that thickness over smooth and sharp-bent edges from the largest
/// face. Errors: `not_a_sheet`, `unsupported_shape`.
Result<Skins> find_skins(const SolidModel& model, const std::vector<Outline>& outlines,
                         double thickness, double tolerance);

}  // namespace planish::brep
