// The certificate's own layout (math.md#certificate-independence): the same geometry as
// placement.cpp, found in another way so that a mistake in either shows. Joints are taken longest
// first into a tree (Kruskal) that is walked from the root; each development is at the K that the
// pattern states; corners are not set back but laid over each other, 2 setbacks less one allowance
// apart.

#include "relaid.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/base/union_find.hpp>
#include <planish/sheet/places.hpp>

#include <algorithm>
#include <cmath>

// The sheet laid out anew for its certificate (math.md#certificate-independence): a tree by Kruskal
// instead of a search, allowances as the pattern states them, sharp bends not set back. It uses
// nothing of the layout, so a mistake in one shows against the other (docs/decisions/0004).

namespace planish::sheet_detail {
namespace {

using Stated = IdVector<BendId, BendAllowance>;

/// The neutral surface of a bend's face, developed.
Development neutral_development(const Sheet& sheet, const Face& face, double k) {
  const Bend& bend = sheet[std::get<BendId>(face.part_of)];
  const double from_inside = k * sheet.thickness;
  const double depth = bend.reference_inside ? from_inside : sheet.thickness - from_inside;
  return {std::get<Developable>(face.surface), face.sense * (sheet.reference_depth - depth),
          middle_u(face)};
}

/// A point of a face as seen from its outside, not yet placed.
Vec2 seen(const Relaid& laid, const Sheet& sheet, FaceId face, const Vec2& uv) {
  const Vec2 flat = laid.development[face] ? laid.development[face]->develop(uv) : uv;
  return sheet[face].sense > 0 ? flat : Vec2(flat.x(), -flat.y());
}

Vec3 ends_apart(const Sheet& sheet, const BorderRef& ref) {
  const Face& face = sheet[ref.face];
  return skin_point(face, end_of(sheet[ref].curve)) - skin_point(face, start_of(sheet[ref].curve));
}

/// Joints between different flanges and bends that connect all of them, longest first.
std::vector<int> spanning_joints(const Sheet& sheet, const Topology& topology) {
  std::vector<std::pair<double, int>> joints;
  for (int j = 0; j < std::ssize(sheet.joints); ++j)
    joints.emplace_back(-ends_apart(sheet, sheet.joints[j].a).norm(), j);
  std::ranges::sort(joints);
  UnionFind parts(topology.node_count());
  std::vector<int> spanning;
  for (const auto& [length, j] : joints)
    if (parts.unite(topology.node_of(sheet.joints[j].a.face),
                    topology.node_of(sheet.joints[j].b.face)))
      spanning.push_back(j);
  return spanning;
}

/// Unit direction of a joint in space, along its border a: that of the ruling there, or of the line
/// in which the planes meet. Rounding is too large on short borders.
Vec3 joint_direction(const Sheet& sheet, const Joint& joint) {
  const Vec3 chord = ends_apart(sheet, joint.a);
  Vec3 direction = chord;
  for (const BorderRef& ref : {joint.b, joint.a})
    if (const auto* surface = std::get_if<Developable>(&sheet[ref.face].surface))
      direction = ruling_on(*surface, start_of(sheet[ref].curve).x());
  const auto* a = std::get_if<Frame>(&sheet[joint.a.face].surface);
  const auto* b = std::get_if<Frame>(&sheet[joint.b.face].surface);
  constexpr double kParallelPlanes = 1e-3;  // sine
  if (a && b && a->z.cross(b->z).norm() > kParallelPlanes) direction = a->z.cross(b->z);
  return direction.normalized() * (direction.dot(chord) < 0.0 ? -1.0 : 1.0);
}

/// Unit direction of a border in its face's plane, not yet placed; `in_space` runs along it.
Vec2 seen_direction(const Relaid& laid, const Sheet& sheet, const BorderRef& ref,
                    const Vec3& in_space) {
  const Face& face = sheet[ref.face];
  if (const auto* frame = std::get_if<Frame>(&face.surface))
    return Vec2(frame->x.dot(in_space), frame->y.dot(in_space)).normalized();
  const Curve2& curve = sheet[ref].curve;
  const Vec2 uv = 0.5 * (start_of(curve) + end_of(curve));
  const double way = end_of(curve).y() < start_of(curve).y() ? -1.0 : 1.0;
  const Vec2 ruling = way * laid.development[ref.face]->jacobian(uv).col(1).normalized();
  return face.sense > 0 ? ruling : Vec2(ruling.x(), -ruling.y());
}

Vec2 middle_of(const Relaid& laid, const Sheet& sheet, const BorderRef& ref) {
  const Curve2& curve = sheet[ref].curve;
  return 0.5 * (seen(laid, sheet, ref.face, start_of(curve)) +
                seen(laid, sheet, ref.face, end_of(curve)));
}

Vec3 middle_in_space(const Sheet& sheet, const BorderRef& ref) {
  const Face& face = sheet[ref.face];
  const Curve2& curve = sheet[ref].curve;
  return 0.5 * (skin_point(face, start_of(curve)) + skin_point(face, end_of(curve)));
}

/// Places what lies beyond a joint, from the motion of what lies on its side a.
Isometry2 beyond(const Relaid& laid, const Sheet& sheet, const Joint& joint, const Isometry2& here,
                 double apart) {
  const Vec3 direction = joint_direction(sheet, joint);
  const Vec2 along = here.linear() * seen_direction(laid, sheet, joint.a, direction);
  const Vec2 theirs = seen_direction(laid, sheet, joint.b, -direction);
  const Eigen::Rotation2Dd turn(std::atan2(-along.y(), -along.x()) -
                                std::atan2(theirs.y(), theirs.x()));
  Vec2 target = here * middle_of(laid, sheet, joint.a) + apart * Vec2(along.y(), -along.x());
  if (joint.sharp)
    target += (middle_in_space(sheet, joint.b) - middle_in_space(sheet, joint.a)).dot(direction) *
              along;
  Isometry2 motion = Isometry2::Identity();
  motion.linear() = turn.toRotationMatrix();
  motion.translation() = target - motion.linear() * middle_of(laid, sheet, joint.b);
  return motion;
}

/// Distance between the borders of a joint in the pattern.
double distance_apart(const Sheet& sheet, const Joint& joint, const Stated& stated) {
  return joint.sharp ? stated[*joint.sharp].allowance - 2.0 * setback_at(sheet, joint) : 0.0;
}

/// Motions of the nodes, the root's the identity.
std::vector<std::optional<Isometry2>> walked(const Relaid& laid, const Sheet& sheet,
                                             const Topology& topology, FaceId root,
                                             const Stated& stated) {
  std::vector<std::vector<int>> joints_of(topology.node_count());
  for (const int j : spanning_joints(sheet, topology)) {
    joints_of[topology.node_of(sheet.joints[j].a.face)].push_back(j);
    joints_of[topology.node_of(sheet.joints[j].b.face)].push_back(j);
  }
  std::vector<std::optional<Isometry2>> motions(topology.node_count());
  std::vector<int> open{topology.node_of(root)};
  motions[open.front()] = Isometry2::Identity();
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    for (const int j : joints_of[node]) {
      Joint joint = sheet.joints[j];
      if (topology.node_of(joint.a.face) != node) std::swap(joint.a, joint.b);
      const int next = topology.node_of(joint.b.face);
      if (motions[next]) continue;
      motions[next] = beyond(laid, sheet, joint, *motions[node],
                             distance_apart(sheet, joint, stated));
      open.push_back(next);
    }
  }
  return motions;
}

Isometry2 seen_from_outside(const Face& face) {
  Isometry2 motion = Isometry2::Identity();
  if (face.sense < 0) motion.linear()(1, 1) = -1.0;
  return motion;
}

}  // namespace

Vec2 Relaid::image(FaceId face, const Vec2& uv) const {
  return placement[face] * (development[face] ? development[face]->develop(uv) : uv);
}

Vec2 Relaid::fold(FaceId face, const Vec2& p) const {
  const Vec2 local = placement[face].inverse() * p;
  return development[face] ? development[face]->fold(local) : local;
}

Result<Stated> stated_allowances(const Sheet& sheet, const FlatPattern& pattern) {
  IdVector<BendId, std::optional<BendAllowance>> found(sheet.bends.size());
  for (const FlatBend& bend : pattern.bends)
    if (sheet.bends.has(bend.bend)) found[bend.bend] = bend.allowance;
  Stated stated;
  for (const BendId id : sheet.bends.ids()) {
    if (!found[id]) return fail(refuse::pattern_lacks_bend, {{"bend", place_of(sheet, id)}});
    stated.push_back(*found[id]);
  }
  return stated;
}

Stated at_half(const Sheet& sheet, Stated allowances) {
  for (const BendId id : sheet.bends.ids()) {
    BendAllowance& allowance = allowances[id];
    const double wider = allowance.k_factor - 0.5;
    allowance.k_factor = 0.5;
    allowance.allowance -= sheet[id].angle.radians() * sheet.thickness * wider;
  }
  return allowances;
}

double setback_at(const Sheet& sheet, const Joint& joint) {
  if (!joint.sharp || sheet.reference_depth > 0.0) return 0.0;
  const Bend& bend = sheet[*joint.sharp];
  if (bend.reference_inside) return 0.0;
  return sheet.thickness * std::tan(0.5 * bend.angle.radians());
}

Result<Relaid> relaid(const Sheet& sheet, const FlatPattern& pattern, const Stated& stated) {
  Relaid laid;
  for (const Face& face : sheet.faces) {
    auto& development = laid.development.emplace_back();
    if (const auto* bend = std::get_if<BendId>(&face.part_of))
      development.emplace(neutral_development(sheet, face, stated[*bend].k_factor));
  }
  const Topology topology(sheet);
  const auto motions = walked(laid, sheet, topology, pattern.root, stated);
  const Isometry2 whole = pattern.root_placement * seen_from_outside(sheet[pattern.root]).inverse();
  for (const FaceId id : sheet.faces.ids()) {
    const auto& motion = motions[topology.node_of(id)];
    if (!motion) return fail(refuse::unconnected, {{"face", place_of(sheet, id)}});
    laid.placement.push_back(whole * *motion * seen_from_outside(sheet[id]));
  }
  return laid;
}

HingeBand hinge_band(const Sheet& sheet, const Relaid& laid, const Joint& joint, double allowance) {
  const auto ends = [&](const BorderRef& ref) {
    const Curve2& curve = sheet[ref].curve;
    return Segment{laid.image(ref.face, start_of(curve)), laid.image(ref.face, end_of(curve))};
  };
  const Segment a = ends(joint.a), b = ends(joint.b);
  HingeBand band;
  band.along = (a.b - a.a).normalized();
  // Away from face a: the side of face b, unless they overlap.
  const bool reflected = laid.placement[joint.a.face].linear().determinant() *
                             sheet[joint.a.face].sense <
                         0.0;
  band.outwards = (reflected ? -1.0 : 1.0) * Vec2(band.along.y(), -band.along.x());
  double low = 0.0, high = 0.0;
  for (const Vec2& p : {a.a, a.b, b.a, b.b}) {
    low = std::min(low, (p - a.a).dot(band.along));
    high = std::max(high, (p - a.a).dot(band.along));
  }
  band.origin = a.a + low * band.along - setback_at(sheet, joint) * band.outwards;
  band.length = high - low;
  band.width = allowance;
  return band;
}

bool HingeBand::holds(const Vec2& p, double tolerance) const {
  const double x = (p - origin).dot(along), y = (p - origin).dot(outwards);
  return x >= -tolerance && x <= length + tolerance && y >= -tolerance && y <= width + tolerance;
}

}  // namespace planish::sheet_detail
