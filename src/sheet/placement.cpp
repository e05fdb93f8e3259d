// Places the faces of a sheet side by side in the plane: a child's border trihedron goes onto its
// parent's, turned round (math.md#border-trihedron), with the allowance of a sharp bend between
// them and a shift along the fold line where trimmed borders differ in length. Grown by Prim's
// algorithm over the joints of highest rank, so that placements rest on long borders; directions
// come from surfaces, not from short borders.

#include "placement.hpp"

#include "refusals.hpp"

#include <planish/base/search.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/sheet/places.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

// Places faces by border trihedrons (math.md#border-trihedron) over a tree of joints, highest rank
// first: T = TC · R · TR with the child's border laid onto the parent's, reversed, as both keep
// their face on the left. A border's direction comes from the surfaces, not from its end points,
// whose rounding a short border would magnify. A sharp bend lies between its two borders with its
// allowance.

namespace planish::sheet_detail {
namespace {

/// The border's trihedron in the developed plane of its face: a point and the direction X
/// (math.md#border-trihedron; Y points into the face, Z out of the plane). The direction comes from
/// the surfaces, not from the end points, whose rounding a short border would magnify.
struct BorderFrame {
  Vec2 middle;
  Vec2 direction;
};

Vec3 chord_on(const Sheet& sheet, const BorderRef& ref) {
  const Face& face = sheet[ref.face];
  const Curve2& curve = sheet[ref].curve;
  return skin_point(face, end_of(curve)) - skin_point(face, start_of(curve));
}

/// Direction in space of the fold line that two joined faces share.
Vec3 fold_line(const Sheet& sheet, const Joint& joint) {
  const Face& a = sheet[joint.a.face];
  const Face& b = sheet[joint.b.face];
  const Vec3 chord = chord_on(sheet, joint.a);
  Vec3 line = chord;
  const auto ruling = [&](const Face& face, const BorderRef& ref) {
    return ruling_on(std::get<Developable>(face.surface), start_of(sheet[ref].curve).x());
  };
  if (std::holds_alternative<Developable>(a.surface)) {
    line = ruling(a, joint.a);
  } else if (std::holds_alternative<Developable>(b.surface)) {
    line = ruling(b, joint.b);
  } else {
    constexpr double kNearlyParallel = 1e-3;  // sine below which the planes' normals determine no
                                              // line
    const Vec3 cross = std::get<Frame>(a.surface).z.cross(std::get<Frame>(b.surface).z);
    if (cross.norm() > kNearlyParallel) line = cross;
  }
  line.normalize();
  return line.dot(chord) < 0 ? Vec3(-line) : line;
}

/// A skin is developed as seen from its outside: mirrored if the surface's normal points inwards.
Isometry2 mirror_of(const Face& face) {
  Isometry2 mirror = Isometry2::Identity();
  if (face.sense < 0) mirror.linear()(1, 1) = -1.0;
  return mirror;
}

BorderFrame border_frame(const Sheet& sheet, const Layout& layout, const BorderRef& ref,
                         const Vec3& line) {
  const Face& face = sheet[ref.face];
  const Curve2& curve = sheet[ref].curve;
  if (const auto* frame = std::get_if<Frame>(&face.surface)) {
    const Vec2 direction(line.dot(frame->x), line.dot(frame->y));
    return {(start_of(curve) + end_of(curve)) / 2, direction.normalized()};
  }
  const Development& development = *layout.development[std::get<BendId>(face.part_of)];
  const Isometry2 mirror = mirror_of(face);
  const Vec2 start = mirror * development.develop(start_of(curve));
  const Vec2 end = mirror * development.develop(end_of(curve));
  const Eigen::Matrix2d jacobian = development.jacobian((start_of(curve) + end_of(curve)) / 2);
  Vec2 direction = mirror.linear() * jacobian.col(1);
  if (direction.dot(end - start) < 0) direction = -direction;
  return {(start + end) / 2, direction.normalized()};
}

/// Trimmed borders of a sharp bend need not be equally long: how far their middles lie apart.
double shift_along(const Sheet& sheet, const Joint& joint, const Vec3& line) {
  const auto middle = [&](const BorderRef& ref) -> Vec3 {
    const Face& face = sheet[ref.face];
    const Curve2& curve = sheet[ref].curve;
    return (skin_point(face, start_of(curve)) + skin_point(face, end_of(curve))) / 2;
  };
  return (middle(joint.b) - middle(joint.a)).dot(line);
}

/// Placement of joint.b's node where joint.a's is placed at `base`: b's border trihedron goes onto
/// a's, reversed because both borders keep their face on the left (math.md#border-trihedron), with
/// the allowance of a sharp bend between them.
Isometry2 child_placement(const Sheet& sheet, const Layout& layout, const Joint& joint,
                          const Isometry2& base) {
  const Vec3 line = fold_line(sheet, joint);
  const BorderFrame parent = border_frame(sheet, layout, joint.a, line);
  const BorderFrame child = border_frame(sheet, layout, joint.b, -line);
  const Vec2 x = base.linear() * parent.direction;
  const Vec2 target = -x;
  Isometry2 placement = Isometry2::Identity();
  const double c = child.direction.dot(target);
  const double s = cross(child.direction, target);
  placement.linear() << c, -s, s, c;
  const double gap = joint.sharp ? layout.allowance[*joint.sharp].allowance : 0.0;
  const Vec2 outwards(x.y(), -x.x());
  const double shift = joint.sharp ? shift_along(sheet, joint, line) : 0.0;
  placement.translation() = base * parent.middle + gap * outwards + shift * x -
                            placement.linear() * child.middle;
  return placement;
}

/// The two borders of a sharp bend are parallel, one allowance apart; their ends may differ.
double sharp_mismatch(const Sheet& sheet, const Layout& layout, const Joint& joint) {
  const double gap = layout.allowance[*joint.sharp].allowance;
  const Curve2& a = sheet[joint.a].curve;
  const Curve2& b = sheet[joint.b].curve;
  const Vec2 a0 = layout.develop(sheet, joint.a.face, start_of(a));
  const Vec2 a1 = layout.develop(sheet, joint.a.face, end_of(a));
  const Vec2 x = (a1 - a0).normalized();
  const Vec2 outwards(x.y(), -x.x());
  const Vec2 b0 = layout.develop(sheet, joint.b.face, end_of(b));
  const Vec2 b1 = layout.develop(sheet, joint.b.face, start_of(b));
  const bool apart = std::abs(((b0 + b1) / 2 - (a0 + a1) / 2).dot(x)) >
                     (a1 - a0).norm() + (b1 - b0).norm();
  return std::max({std::abs((b0 - a0).dot(outwards) - gap), std::abs((b1 - a0).dot(outwards) - gap),
                   apart ? (b0 - a0).norm() : 0.0});
}

}  // namespace

double joint_length(const Sheet& sheet, const Joint& joint) {
  return chord_on(sheet, joint.a).norm();
}

std::vector<JointRank> longest_first(const Sheet& sheet) {
  return mapped(sheet.joints, [&](const Joint& joint) {
    return JointRank{{joint_length(sheet, joint), 0.0, 0.0}};
  });
}

Result<Placed> placed_over(const std::vector<JointRank>& ranks, const Sheet& sheet,
                           const Topology& topology, const Layout& layout) {
  Placed placed;
  std::vector<std::optional<Isometry2>> nodes(topology.node_count());
  Frontier<std::pair<JointRank, int>, std::less<>> front;  // Prim's algorithm
  const auto enter = [&](int node, const Isometry2& placement) {
    nodes[node] = placement;
    for (const int joint : topology.joints_of(node))
      if (ranks[joint]) front.add({ranks[joint], joint});
  };
  enter(topology.node_of(layout.root), Isometry2::Identity());
  while (!front.empty()) {
    const int number = front.take().second;
    Joint joint = sheet.joints[number];
    if (!nodes[topology.node_of(joint.a.face)]) std::swap(joint.a, joint.b);
    const int parent = topology.node_of(joint.a.face), child = topology.node_of(joint.b.face);
    if (nodes[child]) continue;
    placed.tree.push_back(number);
    enter(child, child_placement(sheet, layout, joint, *nodes[parent]));
  }
  for (const FaceId id : sheet.faces.ids()) {
    const auto& node = nodes[topology.node_of(id)];
    if (!node) return fail(refuse::unconnected, {{"face", place_of(sheet, id)}});
    placed.placement.push_back(*node * mirror_of(sheet[id]));
  }
  return placed;
}

double mismatch(const Sheet& sheet, const Layout& layout, const Joint& joint) {
  if (joint.sharp) return sharp_mismatch(sheet, layout, joint);
  const Curve2& a = sheet[joint.a].curve;
  const Curve2& b = sheet[joint.b].curve;
  const auto image = [&](FaceId face, const Vec2& uv) { return layout.develop(sheet, face, uv); };
  return std::max((image(joint.a.face, start_of(a)) - image(joint.b.face, end_of(b))).norm(),
                  (image(joint.a.face, end_of(a)) - image(joint.b.face, start_of(b))).norm());
}

double own_mismatch(const Sheet& sheet, Layout& layout, const Joint& joint) {
  layout.placement[joint.a.face] = mirror_of(sheet[joint.a.face]);
  layout.placement[joint.b.face] = child_placement(sheet, layout, joint, Isometry2::Identity()) *
                                   mirror_of(sheet[joint.b.face]);
  return mismatch(sheet, layout, joint);
}

}  // namespace planish::sheet_detail
