#include "widest.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>

// Where the blank must be cut if a wall widens below the skin: at the edge where the widening ends,
// so that it reaches as far as the material. Strips of the wall are followed from the skin as long
// as they lean outwards and are no steps; a wall that slants from skin to skin is a slanted cut and
// stays with the skin's own border. How a strip that is curved in two directions leans (a fillet
// round a corner), the chord between its edges tells.

namespace planish::brep {
namespace {

/// Sine of the slope from which a wall is not a straight cut: 3°, more than draft and tolerances
/// cause.
constexpr double kSlope = 0.05;
/// Cosine of the flattest chamfer; anything flatter is a step or a neighbouring flange's rim.
constexpr double kFlattest = 0.99;
/// Smallest share of the thickness that a chamfer removes, and that it leaves.
constexpr double kShallowest = 1e-3;
/// Of the length of an edge: nearer to each other, its ends are one.
constexpr double kClosed = 1e-3;

Vec3 middle(const SpaceCurve& curve) { return curve.point((curve.t0 + curve.t1) / 2); }

/// Twice the area that a closed curve encloses, as a vector.
Vec3 swept(const SpaceCurve& curve) {
  constexpr int kPieces = 16;
  Vec3 sum = Vec3::Zero();
  Vec3 from = curve.start - curve.start;
  for (int i = 1; i <= kPieces; ++i) {
    const Vec3 to = curve.point(std::lerp(curve.t0, curve.t1, static_cast<double>(i) / kPieces)) -
                    curve.start;
    sum += from.cross(to);
    from = to;
  }
  return sum;
}

/// Whether two edges along a strip run the same way.
bool same_way(const SpaceCurve& a, const SpaceCurve& b) {
  if (a.kind == SpaceCurve::Kind::circle && b.kind == SpaceCurve::Kind::circle)
    return a.circle.z.dot(b.circle.z) > 0;
  const Vec3 along = a.end - a.start;
  if (along.norm() < kClosed * a.length()) return swept(a).dot(swept(b)) > 0;
  return along.dot(b.end - b.start) > 0;
}

/// How a strip goes on from its edge along a skin to its other edge.
struct Lean {
  double slope = 0.0;  ///< sine of its outward normal towards the skin's outside
  double depth = 0.0;  ///< of the other edge below this one, mm
};
Lean lean_of(const SolidModel& model, const Vec3& outwards, const CoEdge& use, int wall, int far) {
  const SpaceCurve& near = model.edges[use.edge].curve;
  const Vec3 from = middle(near), to = middle(model.edges[far].curve);
  Lean lean{0.0, (from - to).dot(outwards)};
  if (!std::holds_alternative<DoublyCurved>(model.faces[wall].surface)) {
    lean.slope = outward_normal_at(model.faces[wall], (from + to) / 2).dot(outwards);
    return lean;
  }
  const Vec3 tangent = near.tangent((near.t0 + near.t1) / 2);
  const Vec3 away = (use.forward ? tangent : Vec3(-tangent)).cross(outwards);
  const double chord = std::hypot((to - from).dot(away), lean.depth);
  if (chord > 0.0) lean.slope = (to - from).dot(away) / chord;
  return lean;
}

/// A loop without the slivers that roundings leave at corners, if four sides remain.
std::vector<CoEdge> four_sides(const SolidModel& model, const std::vector<CoEdge>& loop) {
  constexpr size_t kSides = 4;
  constexpr double kSliver = 0.05;  // of the shortest side
  if (loop.size() <= kSides) return loop;
  std::vector<double> lengths = mapped(
      loop, [&](const CoEdge& use) { return model.edges[use.edge].curve.length(); });
  std::ranges::sort(lengths, std::ranges::greater());
  const double shortest = lengths[kSides - 1];
  if (lengths[kSides] > kSliver * shortest) return {};
  std::vector<CoEdge> sides;
  for (const CoEdge& use : loop)
    if (model.edges[use.edge].curve.length() >= shortest) sides.push_back(use);
  return sides;
}

}  // namespace

std::optional<int> opposite_edge(const SolidModel& model, int wall, int edge) {
  const SolidFace& strip = model.faces[wall];
  if (strip.loops.size() == 2 && strip.loops[0].size() == 1 && strip.loops[1].size() == 1)
    return strip.loops[strip.loops[0].front().edge == edge ? 1 : 0].front().edge;
  if (strip.loops.size() != 1) return {};
  const auto loop = four_sides(model, strip.loops.front());
  if (loop.size() != 4) return {};
  for (size_t i = 0; i < 4; ++i)
    if (loop[i].edge == edge) return loop[(i + 2) % 4].edge;
  return {};
}

bool leans_back(const SolidModel& model, int skin_face, const CoEdge& border) {
  const int wall = face_across(model.edges[border.edge], skin_face);
  if (wall < 0) return false;
  const auto far = opposite_edge(model, wall, border.edge);
  if (!far) return false;
  const SpaceCurve& curve = model.edges[border.edge].curve;
  const Vec3 outwards = outward_normal_at(model.faces[skin_face], middle(curve));
  return lean_of(model, outwards, border, wall, *far).slope > kSlope;
}

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
    const auto next = opposite_edge(model, wall, at.edge);
    if (!next) break;
    // A slanted wall from skin to skin is a slanted cut: the skin's own border represents it.
    if (const int beyond = face_across(model.edges[*next], wall);
        beyond < 0 || rim.part_of[beyond] < 0)
      break;
    const SpaceCurve& far = model.edges[*next].curve;
    const Vec3 outwards = outward_normal_at(model.faces[skin_face], middle(edge.curve));
    const auto [slope, depth] = lean_of(model, outwards, at, wall, *next);
    if (slope < kSlope || slope > kFlattest) break;
    if (depth <= kShallowest * thickness || reached + depth >= (1.0 - kShallowest) * thickness)
      break;
    reached += depth;
    at = {*next, same_way(edge.curve, far) == at.forward};
    from = wall;
  }
  return at;
}

}  // namespace planish::brep
