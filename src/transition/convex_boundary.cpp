// A closed convex boundary in space as elements with their tangents: where it can be touched by a
// plane. A corner is a point that stands still while its tangent turns (math.md#lateral-hull), so
// polygons and curves are one case. Places continue past the end, round after round.

#include "convex_boundary.hpp"

#include "plane_profile.hpp"
#include "profile_check.hpp"

#include <algorithm>
#include <tuple>

// A profile as a closed convex curve in space, element by element, each turning by at most 90°. It
// runs so that its inside is on the left seen from its axis, which points to the other profile;
// where that reverses it, each element begins where it ended, and the given edges keep their
// numbers.

namespace planish::transition_detail {
namespace {

Element placed(const PlaneElement& plane_element, const Frame& frame, bool turned) {
  Element element;
  const auto to_space = [frame](const Vec2& v) -> Vec3 {
    return v.x() * frame.x + v.y() * frame.y;
  };
  element.curve = [curve = plane_element.curve, origin = frame.origin, to_space,
                   turned](double t) -> SpaceCurvePoint {
    const PlanePoint p = curve(turned ? -t : t);
    const Vec3 first = to_space(p.first);
    return {origin + to_space(p.point), turned ? Vec3(-first) : first, to_space(p.second)};
  };
  element.t0 = turned ? -plane_element.t1 : plane_element.t0;
  element.t1 = turned ? -plane_element.t0 : plane_element.t1;
  element.straight = plane_element.straight;
  element.source = plane_element.source;
  element.period = plane_element.period;
  element.knots = plane_element.knots;
  if (turned) {
    std::ranges::reverse(element.knots);
    for (double& t : element.knots)
      t = -t;
  }
  if (plane_element.circle_radius > 0.0)
    element.circle = Circle{frame.point(plane_element.circle_centre), plane_element.circle_radius};
  return element;
}

Vec3 tangent(const Element& element, double t) { return element.curve(t).derivative.normalized(); }

}  // namespace

Result<Boundary> boundary_of(const PlacedProfile& profile, double outwards, const Vec3& towards,
                             const std::string& pointer) {
  auto plane_elements = elements_of(profile.profile, outwards, pointer);
  if (!plane_elements) return pass_on(plane_elements);
  Boundary boundary;
  const bool turned = profile.frame.z.dot(towards) < 0.0;
  boundary.turned = turned;
  boundary.axis = turned ? Vec3(-profile.frame.z) : profile.frame.z;
  const int n = static_cast<int>(plane_elements->size());
  for (int i = 0; i < n; ++i) {
    const auto& plane_element = (*plane_elements)[turned ? n - 1 - i : i];
    boundary.elements.push_back(placed(plane_element, profile.frame, turned));
    for (GivenEdge edge : plane_element.edges) {
      if (turned) std::tie(edge.from, edge.to) = std::pair{1.0 - edge.to, 1.0 - edge.from};
      edge.element = i;
      boundary.edges.push_back(edge);
    }
    for (GivenCorner corner : plane_element.corners) {
      // Reversed, an element ends where it began.
      const bool at_end = turned && corner.at == 0.0;
      corner.element = at_end ? (i + 1) % n : i;
      corner.at = turned && !at_end ? 1.0 - corner.at : corner.at;
      boundary.corners.push_back(corner);
    }
  }
  for (int i = 0; i < n; ++i) {
    if (boundary.is_point()) {
      boundary.corner = {true};
      break;
    }
    const Element &before = boundary.element(i - 1), &after = boundary.element(i);
    const Vec3 in = tangent(before, before.t1), out = tangent(after, after.t0);
    boundary.corner.push_back(in.cross(out).norm() > kNoCorner || in.dot(out) < 0.0);
  }
  return boundary;
}

}  // namespace planish::transition_detail
