#pragma once

#include <planish/geometry/region.hpp>
#include <planish/sheet/layout.hpp>

#include <optional>
#include <vector>

namespace planish {

/// A flat piece of the sheet, in the coordinates of the flat pattern: a face of a flange, or what
/// lies between two rulings of a bend.
struct Facet {
  PartId part;
  std::optional<int> parent = {};  ///< the facet it is hinged to, earlier in the list; root: none
  Segment hinge = {Vec2::Zero(), Vec2::Zero()};  ///< in the flat pattern; of the root none
  Angle angle;  ///< of the folded sheet: turn about the hinge's direction by the right hand, +z up
  std::vector<Polygon> polygons;  ///< outer rings counter-clockwise, holes clockwise
};

/// A piece of the sheet's outline (cut edges, of openings too), in the flat pattern.
struct FacetEdge {
  int facet = 0;
  Segment line;
  int border = 0;  ///< which border of a face it is a piece of: a line, an arc or a spline, of
                   ///< bends across their strips; from 0, without gaps
};

/// A sheet as flat facets hinged to each other, to be shown between flat and folded: with every
/// angle at the same share it is isometric at every stage. What is folded is the neutral surface;
/// flanges lie up to |½ − k|·t from the middle of the material.
struct Facets {
  std::vector<Facet> facets;  ///< parents before children; the root is a face of the largest
                              ///< flange, of sheets without flanges a strip of a bend
  std::vector<FacetEdge> edges;
  Eigen::Isometry3d root = Eigen::Isometry3d::Identity();  ///< from the flat pattern (z = 0) to the
                                                           ///< root facet in space, in the middle
                                                           ///< of the material
};

struct FacetOptions {
  double chord = 0.05;               ///< mm, by which facets and polygons may leave what is curved
  Angle most = Angle::degrees(6.0);  ///< between two facets of a bend
};

/// Cuts the sheet as it was laid out along its joints and along rulings of its bends. The tree is
/// the layout's, hung up at the largest flange. Facets of cylinders and cones fold to where the
/// bend ends within angle²/24 of its width, those of general bends likewise. Requires the layout of
/// that sheet and options above 0.
Facets facets_of(const Sheet& sheet, const Layout& layout, const FacetOptions& options = {});

/// By facet, from the flat pattern into space: every angle `share` times as large as folded, 0
/// (flat, in the root's plane) to 1.
std::vector<Eigen::Isometry3d> folded(const Facets& facets, double share = 1.0);

}  // namespace planish
