#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/general_cone.hpp>
#include <planish/transition/profile.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::transition_detail {

struct Circle {
  Vec3 centre;
  double radius = 0.0;
};

/// One element of a closed convex curve: a straight edge, or a part of a curve that turns by at
/// most 90°.
struct Element {
  SpaceCurve curve;  ///< of edges too: linear
  double t0 = 0.0, t1 = 1.0;
  bool straight = false;
  int source = 0;             ///< number of the edge, or of the curve that this is a part of
  double period = 0.0;        ///< of the curve in t; 0: not closed
  std::vector<double> knots;  ///< of the curve, where its third derivative jumps, t growing
  std::optional<Circle> circle;
};

/// An edge or a corner of a profile as given: its place on a boundary, as shares of an element's
/// length. Corners at which a polygon continues straight lie within elements.
struct GivenEdge {
  int number = 0, element = 0;
  double from = 0.0, to = 1.0;
};
struct GivenCorner {
  int number = 0, element = 0;
  double at = 0.0;
};

/// A closed convex curve in space, run so that its inside is on the left seen from the tip of
/// `axis`.
struct Boundary {
  Vec3 axis = Vec3::UnitZ();
  bool turned = false;  ///< runs clockwise about the frame's normal
  std::vector<Element> elements;
  std::vector<bool> corner;  ///< whether there is one at the start of each element
  std::vector<GivenEdge> edges;
  std::vector<GivenCorner> corners;

  int count() const { return static_cast<int>(elements.size()); }
  /// Whether it is a single point, an apex.
  bool is_point() const { return count() == 1; }
  const Element& element(int i) const { return elements[((i % count()) + count()) % count()]; }
  bool corner_at(int i) const { return corner[((i % count()) + count()) % count()]; }
};

/// The boundary of a profile offset `outwards` (mm, negative: inwards) in its plane, its axis on
/// the side that `towards` points to. Corners of polygons stay corners. `pointer` is the profile's
/// in the file. Errors: those of `make_transition` for one profile.
Result<Boundary> boundary_of(const PlacedProfile& profile, double outwards, const Vec3& towards,
                             const std::string& pointer);

}  // namespace planish::transition_detail
