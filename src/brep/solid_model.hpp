#pragma once

#include <planish/geometry/developable.hpp>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planish::brep {

// A model of a solid's boundary without the kernel, as input for recognition. All lengths in mm.

/// An edge's curve in space over [t0, t1].
struct SpaceCurve {
  enum class Kind { line, circle, other };
  Kind kind = Kind::other;
  double t0 = 0.0;
  double t1 = 1.0;
  Vec3 start = Vec3::Zero();
  Vec3 end = Vec3::Zero();
  Frame circle;         ///< circle: centre, axis z; the parameter is the angle from x
  double radius = 0.0;  ///< circle
  std::function<void(double t, Vec3& point, Vec3& derivative)> evaluate;  ///< for kind `other`

  Vec3 point(double t) const;
  Vec3 derivative(double t) const;
  Vec3 tangent(double t) const;  ///< unit
  /// Length: closed form for lines and circles, adaptive Gauss quadrature for others.
  double length() const;
  /// Distance of p from the curve.
  double distance(const Vec3& p) const;
};

struct SolidEdge {
  SpaceCurve curve;
  std::array<int, 2> faces{-1, -1};         ///< faces on both sides, equal for a seam
  std::array<int, 2> merged_faces{-1, -1};  ///< faces there that have become part of these
  std::array<bool, 2> forward{true, true};  ///< whether that face runs along the curve's sense
  std::array<int, 2> vertices{-1, -1};      ///< at the curve's start and end
  int uses = 0;                             ///< coedges; 2 on a closed solid
};

/// The face on a side of an edge, 0 or 1, as it was read, before faces became one.
int face_as_read(const SolidEdge& edge, int side);

/// The face on the other side of an edge of a face: the face itself at a seam, −1 at an open edge.
int face_across(const SolidEdge& edge, int face);

/// An edge as a face runs along it, the face on the left seen from outside.
struct CoEdge {
  int edge = 0;
  bool forward = true;
};

/// About the frame's z: a tube of radius `minor`, its middle on a circle of radius `major`.
struct Torus {
  Frame frame;
  double major = 0.0;
  double minor = 0.0;
};

/// A surface that is not known to be plane or developable.
struct DoublyCurved {
  std::string kind;  ///< "sphere", "torus", "spline", …
  std::optional<Torus> torus = {};
};
using SolidSurface = std::variant<Frame, Developable, DoublyCurved>;

struct SolidFace {
  SolidSurface surface;  ///< planes: z outward
  int sense = 1;         ///< outward normal = sense · surface normal; of a torus, from its tube
  std::vector<std::vector<CoEdge>> loops;
  std::vector<int> merged;   ///< other faces that are part of this one since healing
  double fitted = 0.0;       ///< deviation when the surface was recognised from another kind, mm
  double volume = 0.0;       ///< ⅓∫(x − c)·n dA with c the model's centre, mm³
  double curved_area = 0.0;  ///< of what is curved in two directions, mm², coarse
};

struct SolidModel {
  std::vector<SolidFace> faces;  ///< face i is number i+1 for users
  std::vector<SolidEdge> edges;
  double size = 0.0;           ///< diagonal of the bounding box, mm
  Vec3 centre = Vec3::Zero();  ///< of the bounding box: where volumes are measured from
  std::optional<int> genus;    ///< of the solid as it was read, before healing (genus.hpp)
};

/// Numbers of the edges of each face, ascending.
std::vector<std::vector<int>> edges_by_face(const SolidModel& model);

}  // namespace planish::brep
