#include "widest.hpp"

// Where the blank must be cut if a wall widens below the skin: at the edge where the widening ends,
// so that it reaches as far as the material. Strips of the wall are followed from the skin as long
// as their middles face outwards and they are no steps; a wall that slants from skin to skin is a
// slanted cut and stays with the skin's own border.

namespace planish::brep {
namespace {

/// Sine of the slope from which a wall is not a straight cut: 3°, more than draft and tolerances
/// cause.
constexpr double kSlope = 0.05;
/// Cosine of the flattest chamfer; anything flatter is a step or a neighbouring flange's rim.
constexpr double kFlattest = 0.99;
/// Smallest share of the thickness that a chamfer removes, and that it leaves.
constexpr double kShallowest = 1e-3;

/// Outward normal of a wall near a point of its border; empty where it is not known.
std::optional<Vec3> wall_normal(const SolidModel& model, int wall, const Vec3& point) {
  const SolidFace& face = model.faces[wall];
  if (std::holds_alternative<DoublyCurved>(face.surface)) return {};
  return outward_normal_at(face, point);
}

/// The edge across a strip: the other loop of a ring, the opposite side of a four-sided face.
std::optional<int> opposite_edge(const SolidFace& strip, int edge) {
  if (strip.loops.size() == 2 && strip.loops[0].size() == 1 && strip.loops[1].size() == 1)
    return strip.loops[strip.loops[0].front().edge == edge ? 1 : 0].front().edge;
  if (strip.loops.size() != 1 || strip.loops.front().size() != 4) return {};
  const auto& loop = strip.loops.front();
  for (size_t i = 0; i < 4; ++i)
    if (loop[i].edge == edge) return loop[(i + 2) % 4].edge;
  return {};
}

Vec3 middle(const SpaceCurve& curve) { return curve.point((curve.t0 + curve.t1) / 2); }

/// Whether two edges along a strip run the same way.
bool same_way(const SpaceCurve& a, const SpaceCurve& b) {
  if (a.kind == SpaceCurve::Kind::circle && b.kind == SpaceCurve::Kind::circle)
    return a.circle.z.dot(b.circle.z) > 0;
  return (a.end - a.start).dot(b.end - b.start) > 0;
}

}  // namespace

CoEdge widest_edge(const SolidModel& model, const Rim& rim, double thickness, int skin_face,
                   const CoEdge& border) {
  CoEdge at = border;
  double reached = 0.0;
  int from = skin_face;
  constexpr int kMostStrips = 4;  // chamfer and fillet faces between a skin and the middle of a
                                  // wall
  for (int i = 0; i < kMostStrips; ++i) {
    const SolidEdge& edge = model.edges[at.edge];
    const int wall = face_across(edge, from);
    if (edge.uses != 2 || wall < 0 || rim.part_of[wall] < 0) break;
    if (!rim.parts[rim.part_of[wall]].within) break;
    const auto next = opposite_edge(model.faces[wall], at.edge);
    if (!next) break;
    // A slanted wall from skin to skin is a slanted cut: the skin's own border represents it.
    if (const int beyond = face_across(model.edges[*next], wall);
        beyond < 0 || rim.part_of[beyond] < 0)
      break;
    // A wall widens where its middle faces towards the skin's outside.
    const SpaceCurve& far = model.edges[*next].curve;
    const Vec3 half_way = (middle(edge.curve) + middle(far)) / 2;
    const auto normal = wall_normal(model, wall, half_way);
    const Vec3 outwards = outward_normal_at(model.faces[skin_face], middle(edge.curve));
    const double slope = normal ? normal->dot(outwards) : 0.0;
    if (slope < kSlope || slope > kFlattest) break;
    const double depth = (middle(edge.curve) - middle(far)).dot(outwards);
    if (depth <= kShallowest * thickness || reached + depth >= (1.0 - kShallowest) * thickness)
      break;
    reached += depth;
    at = {*next, same_way(edge.curve, far) == at.forward};
    from = wall;
  }
  return at;
}

}  // namespace planish::brep
