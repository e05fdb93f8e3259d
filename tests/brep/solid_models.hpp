#pragma once

#include "outline.hpp"

#include <planish/geometry/curve.hpp>

#include <vector>

// Solids as recognition sees them, made by hand and without a kernel: each step is tested on a
// small one whose sizes are known.

namespace planish::brep::test {

SpaceCurve line(const Vec3& from, const Vec3& to);
/// About the frame's z from one angle to another; clockwise when the second is smaller.
SpaceCurve arc(const Frame& frame, double radius, double from, double to);

/// A closed path of curves, each from its start to its end, the face on its left seen from outside.
using Path = std::vector<SpaceCurve>;
Path polygon_path(const std::vector<Vec3>& corners);

/// Makes a model face by face. Curves of two faces that cover each other become one edge, ends that
/// coincide one vertex.
class SolidMaker {
 public:
  /// A plane through the first point of the first path. All return the face's index.
  int plane(const Vec3& outward, const std::vector<Path>& loops);
  int curved(const Developable& surface, int sense, const std::vector<Path>& loops);
  int doubly_curved(const std::string& kind, const std::vector<Path>& loops);

  /// The model with its size, its centre and the volumes of its faces. Every edge must have two
  /// faces.
  SolidModel build() &&;
  /// The same of a part of a boundary: edges may have one face.
  SolidModel build_open() &&;

 private:
  int add(SolidFace face, const std::vector<Path>& loops);
  CoEdge use_of(const SpaceCurve& curve);
  int vertex_at(const Vec3& point);

  SolidModel model_;
  std::vector<Vec3> vertices_;
};

/// A prism over loops in the frame's xy plane, outer ones counter-clockwise, from z = 0 to the
/// height. Faces: the one at z = 0, the one at the height, then the walls in the order of the
/// curves. Full circles give one wall with a seam.
SolidModel prism(const std::vector<Loop>& profile, double height, const Frame& frame = {});

/// A straight piece of a strip and the bend behind it, to the left when the turn is positive.
struct Leg {
  double length = 0.0;
  double turn = 0.0;           ///< radians
  double inside_radius = 0.0;  ///< 0: the inside is sharp, the outside rounded about it
};
/// Cross-section of a strip that starts at the origin along x and has its thickness to the left:
/// its right side leg by leg, its end, its left side back, its start.
Loop strip_profile(double thickness, const std::vector<Leg>& legs);

/// Polygons with as many corners, from the bottom to the top of a plate: its contour when they run
/// counter-clockwise, an opening when clockwise. Walls between them are plane.
struct Lofted {
  std::vector<std::vector<Vec2>> sections;
  std::vector<double> heights;
};
std::vector<Vec2> rectangle_at(const Vec2& low, const Vec2& high);
std::vector<Vec2> clockwise(std::vector<Vec2> polygon);

/// Surfaces turned about a vertical axis, by points (radius, height): from the top, or from the
/// axis, to the bottom, or to the axis. The material is outside a path that goes down.
struct Turned {
  Vec2 centre;
  std::vector<Vec2> profile;
};

/// A plate from z = 0 to its thickness. Faces: bottom, top, the walls of its contours section by
/// section, the turned ones. Loops of bottom and top: contours, then turned ones.
SolidModel plate(double thickness, const std::vector<Lofted>& contours,
                 const std::vector<Turned>& turned = {});
/// The same with one rectangular contour from the origin.
SolidModel plate(double thickness, const Vec2& size, const std::vector<Turned>& turned = {});

/// Bottom and top of a plate.
inline constexpr int kBottom = 0, kTop = 1;

/// The edge where two faces meet; a failure of the test if they do not.
int edge_between(const SolidModel& model, int a, int b);

}  // namespace planish::brep::test
