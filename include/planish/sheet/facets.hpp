#pragma once

#include <planish/geometry/region.hpp>
#include <planish/sheet/layout.hpp>

#include <optional>
#include <vector>

namespace planish {

/// A plane region of the sheet, in the coordinates of the flat pattern: a face of a flange, or the
/// part of a bend between two rulings.
struct Facet {
  PartId part;
  std::optional<int> parent = {};  ///< the facet it is hinged to, earlier in the list; empty for
                                   ///< the root
  Segment hinge = {Vec2::Zero(), Vec2::Zero()};  ///< in the flat pattern; not used for the root
  Angle angle;  ///< of the folded sheet: turn about the hinge's direction by the right-hand rule,
                ///< +z up
  std::vector<Polygon> polygons;  ///< outer rings counter-clockwise, holes clockwise
};

/// A line, an arc or a spline of the sheet's outline, in the flat pattern, exactly.
struct FacetBorder {
  Curve2 curve;
  std::optional<FeatureId> feature = {};  ///< the feature that it outlines, where nothing is cut;
                                          ///< empty: an edge that is cut
};

/// A segment of what is cut (the sheet's contours, slits) or drawn (outlines of features), in the
/// flat pattern.
struct FacetEdge {
  int facet = 0;
  Segment line;
  int border = 0;  ///< that it is part of, a row of `Facets::borders`, on bends across all facets
};

/// A sheet as flat facets hinged to each other, to be shown between flat and folded: every stage,
/// with all angles at the same share, is isometric to the flat pattern. The neutral surface is
/// folded; flanges lie up to |½ − k|·t from the middle of the material.
struct Facets {
  std::vector<Facet> facets;  ///< parents before children; the root is a face of the largest flange
                              ///< or, in a sheet without flanges, a facet of a bend
  std::vector<FacetEdge> edges;
  std::vector<FacetBorder> borders;                        ///< `edges` are chords of these
  Eigen::Isometry3d root = Eigen::Isometry3d::Identity();  ///< from the flat pattern (z = 0) to the
                                                           ///< root facet in space, in the middle
                                                           ///< of the material
};

struct FacetOptions {
  double chord = 0.05;               ///< largest distance of facets and polygons from curved
                                     ///< borders and bends, mm
  Angle most = Angle::degrees(6.0);  ///< largest angle between two facets of a bend
  /// What is cut and what is drawn within forms, as in the pattern.
  ExtrudedHoles extruded = ExtrudedHoles::pilot;
};

/// Cuts the sheet as it was laid out along its joints and along rulings of its bends. The tree is
/// the layout's, rooted at the largest flange; a sharp bend has a facet at each joint where it
/// takes room. Facets cover what the pattern covers: they go on within the outlines of forms, which
/// lie in one face. Facets of a bend fold to its end within angle²/24 of its width. Requires the
/// layout of that sheet and options above 0.
Facets facets_of(const Sheet& sheet, const Layout& layout, const FacetOptions& options = {});

/// From the flat pattern (z = 0) to a face of a flange in space, in the middle of the material;
/// exact, whatever facets lie between it and the root. Requires the layout of that sheet.
Eigen::Isometry3d flange_in_space(const Sheet& sheet, const Layout& layout, FaceId face);

/// For each facet, the motion from the flat pattern into space with every angle at `share` of its
/// folded value: from 0 (flat, in the root's plane) to 1.
std::vector<Eigen::Isometry3d> folded(const Facets& facets, double share = 1.0);

}  // namespace planish
