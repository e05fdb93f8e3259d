#include "convex_boundary.hpp"

#include "plane_profile.hpp"
#include "profile_check.hpp"

#include <algorithm>
#include <tuple>

namespace planish::transition_detail {
namespace {

Element placed(const PlanePiece& piece, const Frame& frame, bool turned) {
  Element element;
  const auto to_space = [frame](const Vec2& v) -> Vec3 {
    return v.x() * frame.x + v.y() * frame.y;
  };
  element.curve = [curve = piece.curve, origin = frame.origin, to_space,
                   turned](double t) -> SpaceCurvePoint {
    const PlanePoint p = curve(turned ? -t : t);
    const Vec3 first = to_space(p.first);
    return {origin + to_space(p.point), turned ? Vec3(-first) : first, to_space(p.second)};
  };
  element.t0 = turned ? -piece.t1 : piece.t0;
  element.t1 = turned ? -piece.t0 : piece.t1;
  element.straight = piece.straight;
  element.source = piece.source;
  element.period = piece.period;
  element.knots = piece.knots;
  if (turned) {
    std::reverse(element.knots.begin(), element.knots.end());
    for (double& t : element.knots)
      t = -t;
  }
  if (piece.circle_radius > 0.0)
    element.circle = Circle{frame.point(piece.circle_centre), piece.circle_radius};
  return element;
}

Vec3 tangent(const Element& element, double t) { return element.curve(t).derivative.normalized(); }

}  // namespace

Result<Boundary> boundary_of(const PlacedProfile& profile, double outwards, const Vec3& towards,
                             const std::string& pointer) {
  auto pieces = pieces_of(profile.profile, outwards, pointer);
  if (!pieces) return tl::unexpected(pieces.error());
  Boundary boundary;
  const bool turned = profile.frame.z.dot(towards) < 0.0;
  boundary.turned = turned;
  boundary.axis = turned ? Vec3(-profile.frame.z) : profile.frame.z;
  const int n = static_cast<int>(pieces->size());
  for (int i = 0; i < n; ++i) {
    const auto& piece = (*pieces)[turned ? n - 1 - i : i];
    boundary.elements.push_back(placed(piece, profile.frame, turned));
    for (GivenEdge edge : piece.edges) {
      if (turned) std::tie(edge.from, edge.to) = std::pair{1.0 - edge.to, 1.0 - edge.from};
      edge.element = i;
      boundary.edges.push_back(edge);
    }
    for (GivenCorner corner : piece.corners) {
      // Turned round, a piece ends where it began.
      const bool at_end = turned && corner.at == 0.0;
      corner.element = at_end ? (i + 1) % n : i;
      corner.at = turned && !at_end ? 1.0 - corner.at : corner.at;
      boundary.corners.push_back(corner);
    }
  }
  for (int i = 0; i < n; ++i) {
    const Element &before = boundary.element(i - 1), &after = boundary.element(i);
    boundary.corner.push_back(tangent(before, before.t1).cross(tangent(after, after.t0)).norm() >
                              kNoCorner);
  }
  return boundary;
}

}  // namespace planish::transition_detail
