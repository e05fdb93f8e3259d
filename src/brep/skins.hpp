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
};

/// The two skins of a sheet in a solid.
struct Skins {
  double thickness = 0.0;
  double spread = 0.0;                      ///< of the depths met between the skins, mm
  std::vector<Side> side;                   ///< by face
  std::vector<std::vector<int>> partners;   ///< by face: faces opposite at the thickness
  std::vector<SharpEdge> sharp;             ///< on both skins
  double area_first = 0.0, area_second = 0.0;  ///< mm², coarse
};

/// Angle in space between the outward normals of the two faces of an edge, at its middle; negative
/// where the solid is concave there. Empty for seams, open edges and doubly curved neighbours.
std::optional<double> dihedral(const SolidModel& model, int edge);

/// Whether the faces of an edge continue each other: tangent, and parallel when both are planes.
bool smooth_edge(const SolidModel& model, int edge);

/// Infers the thickness from opposite faces (largest area agreeing) and grows both skins over smooth
/// and sharp-bent edges from the largest face. Errors: `not_a_sheet`, `thickness_not_constant`.
Result<Skins> find_skins(const SolidModel& model, const std::vector<Outline>& outlines, double thickness_tolerance);

}  // namespace planish::brep
