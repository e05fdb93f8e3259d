#include "unfolding_tree.hpp"

#include <planish/base/assert.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <queue>

namespace planish {
namespace {

/// Flanges and bends are the nodes of the tree; faces follow the node they belong to.
struct Nodes {
  explicit Nodes(const Sheet& sheet)
      : flanges(static_cast<int>(sheet.flanges.size())),
        count(flanges + static_cast<int>(sheet.bends.size())) {}
  int of(const Face& face) const {
    if (const auto* flange = std::get_if<FlangeId>(&face.part_of)) return index_of(*flange);
    return flanges + index_of(std::get<BendId>(face.part_of));
  }
  int flanges;
  int count;
};

const Face& face_at(const Sheet& sheet, FaceId id) { return sheet.faces[index_of(id)]; }

/// The border's trihedron in the developed plane of its face: a point and the direction X
/// (MATH 4.2; Y points into the face, Z out of the plane). The direction comes from the surfaces,
/// not from the end points, whose rounding a short border would magnify.
struct BorderFrame {
  Vec2 middle;
  Vec2 direction;
};

Vec3 chord_on(const Face& face, const Border& border) {
  return skin_point(face, end_of(border.curve)) - skin_point(face, start_of(border.curve));
}

/// Direction in space of the fold line that two joined faces share.
Vec3 fold_line(const Sheet& sheet, const Joint& joint) {
  const Face& a = face_at(sheet, joint.a.face);
  const Face& b = face_at(sheet, joint.b.face);
  const Vec3 chord = chord_on(a, border_at(sheet, joint.a));
  Vec3 line = chord;
  const auto ruling = [&](const Face& face, const BorderRef& ref) {
    return ruling_on(std::get<Developable>(face.surface),
                     start_of(border_at(sheet, ref).curve).x());
  };
  if (std::holds_alternative<Developable>(a.surface)) {
    line = ruling(a, joint.a);
  } else if (std::holds_alternative<Developable>(b.surface)) {
    line = ruling(b, joint.b);
  } else {
    constexpr double kNearlyParallel = 1e-3;  // sine below which the planes' normals fix no line
    const Vec3 cross = std::get<Frame>(a.surface).z.cross(std::get<Frame>(b.surface).z);
    if (cross.norm() > kNearlyParallel) line = cross;
  }
  line.normalize();
  return line.dot(chord) < 0 ? Vec3(-line) : line;
}

class Grower {
 public:
  Grower(const Sheet& sheet, const FlattenOptions& options)
      : sheet_(sheet),
        options_(options),
        nodes_(sheet),
        joints_of_(static_cast<size_t>(nodes_.count)),
        node_placement_(static_cast<size_t>(nodes_.count)) {}

  Result<UnfoldingTree> run() {
    if (auto done = settle_allowances(); !done) return tl::unexpected(done.error());
    list_joints();
    grow();
    if (auto done = check_reached(); !done) return tl::unexpected(done.error());
    for (const Face& face : sheet_.faces) {
      tree_.placement.push_back(*node_placement_[nodes_.of(face)] * mirror_of(face));
    }
    if (auto done = check_closure(); !done) return tl::unexpected(done.error());
    for (size_t f = 0; f < sheet_.faces.size(); ++f)
      tree_.images.push_back(images_of(sheet_.faces[f], tree_.placement[f]));
    return std::move(tree_);
  }

 private:
  Result<void> settle_allowances() {
    for (size_t i = 0; i < sheet_.bends.size(); ++i) {
      const Bend& bend = sheet_.bends[i];
      auto allowance = allowance_of(BendId{static_cast<int>(i)}, bend);
      if (!allowance) return tl::unexpected(allowance.error());
      tree_.allowance.push_back(*allowance);
      if (bend.faces.empty() && sheet_.reference_depth > 0.0)
        settle_hinge(bend, tree_.allowance.back());
      tree_.development.push_back(development_of(bend, allowance->k_factor));
    }
    for (const Face& face : sheet_.faces) {
      const auto* bend = std::get_if<BendId>(&face.part_of);
      tree_.neutral_offset.push_back(bend ? offset_of(*bend, face) : 0.0);
    }
    return {};
  }

  Result<BendAllowance> allowance_of(BendId id, const Bend& bend) const {
    const auto by = [&](const AllowanceRule& rule) {
      return bend_allowance(rule, sheet_.thickness, bend.inside_radius, bend.angle);
    };
    for (const auto& [single, k] : options_.bend_k)
      if (single == id) return by(ConstantK{k, "this bend"});
    return by(options_.allowance);
  }

  /// How far the neutral surface of a bend lies below the reference surface.
  double neutral_depth(const Bend& bend, double k) const {
    return (bend.reference_inside ? k : 1.0 - k) * sheet_.thickness - sheet_.reference_depth;
  }

  /// Between skins a sharp bend turns about the reference surface; outside the faces meet beyond
  /// it.
  void settle_hinge(const Bend& bend, BendAllowance& allowance) const {
    const double outwards = bend.reference_inside ? 1.0 : -1.0;
    allowance.allowance = bend.angle.radians() * outwards * neutral_depth(bend, allowance.k_factor);
    const double outside = bend.reference_inside ? sheet_.thickness - sheet_.reference_depth
                                                 : sheet_.reference_depth;
    allowance.deduction = 2.0 * outside_setback(0.0, outside, bend.angle) - allowance.allowance;
  }

  double offset_of(BendId id, const Face& face) const {
    const Bend& bend = sheet_.bends[index_of(id)];
    const double k = tree_.allowance[index_of(id)].k_factor;
    return -face.sense * neutral_depth(bend, k);
  }

  /// What a sharp bend takes between its two borders.
  double gap_of(BendId id) const { return tree_.allowance[index_of(id)].allowance; }

  Development development_of(const Bend& bend, double k) const {
    if (bend.faces.empty()) return Development(Cylinder{{}, 1.0}, 0.0);
    const Face& face = face_at(sheet_, bend.faces.front());
    return Development(std::get<Developable>(face.surface), -face.sense * neutral_depth(bend, k));
  }

  static Isometry2 mirror_of(const Face& face) {
    Isometry2 mirror = Isometry2::Identity();
    if (face.sense < 0) mirror.linear()(1, 1) = -1.0;
    return mirror;
  }

  void list_joints() {
    for (size_t i = 0; i < sheet_.joints.size(); ++i) {
      const int a = nodes_.of(face_at(sheet_, sheet_.joints[i].a.face));
      const int b = nodes_.of(face_at(sheet_, sheet_.joints[i].b.face));
      if (a == b) continue;
      joints_of_[a].push_back(static_cast<int>(i));
      joints_of_[b].push_back(static_cast<int>(i));
    }
  }

  FaceId root() const {
    if (options_.root) return *options_.root;
    int best = 0;
    double best_area = -1.0;
    for (size_t i = 0; i < sheet_.faces.size(); ++i) {
      if (!std::holds_alternative<FlangeId>(sheet_.faces[i].part_of)) continue;
      double area = 0.0;
      for (const BorderLoop& loop : sheet_.faces[i].loops)
        for (const Border& border : loop)
          area += green_area(border.curve);
      if (area > best_area) {
        best_area = area;
        best = static_cast<int>(i);
      }
    }
    return FaceId{best};
  }

  double joint_length(int joint) const {
    const BorderRef& ref = sheet_.joints[joint].a;
    return chord_on(face_at(sheet_, ref.face), border_at(sheet_, ref)).norm();
  }

  /// Prim's algorithm: the longest joint fixes a placement best.
  void grow() {
    std::priority_queue<std::pair<double, int>> front;
    const auto enter = [&](int node, const Isometry2& placement) {
      node_placement_[node] = placement;
      for (const int joint : joints_of_[node])
        front.emplace(joint_length(joint), joint);
    };
    enter(nodes_.of(face_at(sheet_, root())), Isometry2::Identity());
    while (!front.empty()) {
      Joint joint = sheet_.joints[front.top().second];
      front.pop();
      const int a = nodes_.of(face_at(sheet_, joint.a.face));
      const int b = nodes_.of(face_at(sheet_, joint.b.face));
      const bool has_a = node_placement_[a].has_value();
      const bool has_b = node_placement_[b].has_value();
      if (has_a && has_b) continue;
      if (!has_a) std::swap(joint.a, joint.b);
      enter(has_a ? b : a, child_placement(joint));
    }
  }

  Vec2 local(FaceId id, const Vec2& uv) const {
    const Face& face = face_at(sheet_, id);
    const auto* bend = std::get_if<BendId>(&face.part_of);
    if (!bend) return uv;
    return mirror_of(face) * tree_.development[index_of(*bend)].develop(uv);
  }

  BorderFrame border_frame(const BorderRef& ref, const Vec3& line) const {
    const Face& face = face_at(sheet_, ref.face);
    const Curve2& curve = border_at(sheet_, ref).curve;
    const Vec2 start = local(ref.face, start_of(curve));
    const Vec2 end = local(ref.face, end_of(curve));
    Vec2 direction;
    if (const auto* frame = std::get_if<Frame>(&face.surface)) {
      direction = {line.dot(frame->x), line.dot(frame->y)};
    } else {
      const BendId bend = std::get<BendId>(face.part_of);
      const Eigen::Matrix2d jacobian = tree_.development[index_of(bend)].jacobian(
          (start_of(curve) + end_of(curve)) / 2);
      direction = mirror_of(face).linear() * jacobian.col(1);
      if (direction.dot(end - start) < 0) direction = -direction;
    }
    return {(start + end) / 2, direction.normalized()};
  }

  /// Placement of joint.b's node given that of joint.a's: b's border trihedron goes onto a's,
  /// turned round because both borders keep their face on the left (MATH 4.2), with the allowance
  /// of a sharp bend between them.
  Isometry2 child_placement(const Joint& joint) const {
    const Vec3 line = fold_line(sheet_, joint);
    const BorderFrame parent = border_frame(joint.a, line);
    const BorderFrame child = border_frame(joint.b, -line);
    const Isometry2& base = *node_placement_[nodes_.of(face_at(sheet_, joint.a.face))];
    const Vec2 x = base.linear() * parent.direction;
    const Vec2 target = -x;
    Isometry2 placement = Isometry2::Identity();
    const double c = child.direction.dot(target);
    const double s = child.direction.x() * target.y() - child.direction.y() * target.x();
    placement.linear() << c, -s, s, c;
    const double gap = joint.sharp ? gap_of(*joint.sharp) : 0.0;
    const Vec2 outwards(x.y(), -x.x());
    const double shift = joint.sharp ? shift_along(joint, line) : 0.0;
    placement.translation() = base * parent.middle + gap * outwards + shift * x -
                              placement.linear() * child.middle;
    return placement;
  }

  /// Trimmed borders of a sharp bend need not be equally long: how far their middles lie apart.
  double shift_along(const Joint& joint, const Vec3& line) const {
    const auto middle = [&](const BorderRef& ref) -> Vec3 {
      const Face& face = face_at(sheet_, ref.face);
      const Curve2& curve = border_at(sheet_, ref).curve;
      return (skin_point(face, start_of(curve)) + skin_point(face, end_of(curve))) / 2;
    };
    return (middle(joint.b) - middle(joint.a)).dot(line);
  }

  std::vector<Loop> images_of(const Face& face, const Isometry2& place) const {
    const auto* bend = std::get_if<BendId>(&face.part_of);
    const auto laid = [&](const Curve2& curve) {
      if (!bend) return transformed(curve, place);
      const Development& development = tree_.development[index_of(*bend)];
      const Curve2 image = transformed(development.develop(curve, options_.curve_tolerance), place);
      // A border that becomes a point, as at a cone's apex, is one, not the rounding about it.
      const bool point = bounds(image).size().norm() <= options_.merge_tolerance;
      return point ? Curve2(Segment{start_of(image), end_of(image)}) : image;
    };
    std::vector<Loop> images;
    for (const BorderLoop& loop : face.loops) {
      Loop& image = images.emplace_back();
      for (const Border& border : loop)
        image.push_back(laid(border.curve));
    }
    return images;
  }

  Result<void> check_reached() const {
    for (size_t node = 0; node < node_placement_.size(); ++node) {
      const bool sharp = static_cast<int>(node) >= nodes_.flanges &&
                         sheet_.bends[node - static_cast<size_t>(nodes_.flanges)].faces.empty();
      if (!node_placement_[node] && !sharp)
        return fail(ErrorCode::not_a_sheet,
                    "The flanges of the sheet are not all connected by bends.");
    }
    return {};
  }

  Result<void> check_closure() {
    const Joint* worst = nullptr;
    for (const Joint& joint : sheet_.joints) {
      const double mismatch = joint_mismatch(joint);
      if (mismatch <= tree_.closure) continue;
      tree_.closure = mismatch;
      worst = &joint;
    }
    if (tree_.closure <= options_.closure_tolerance) return {};
    const int a = face_at(sheet_, worst->a.face).source_face;
    const int b = face_at(sheet_, worst->b.face).source_face;
    return fail(
        ErrorCode::closed_loop,
        fmt::format("The flanges and bends form a closed loop that does not lie flat (it misses by "
                    "{:.3g} mm); a rip along the edge between face {} and face {} would open it.",
                    tree_.closure, a, b),
        fmt::format("edge {} between face {} and face {}", border_at(sheet_, worst->a).edge, a, b));
  }

  double joint_mismatch(const Joint& joint) const {
    if (joint.sharp) return sharp_mismatch(joint);
    const Curve2& a = border_at(sheet_, joint.a).curve;
    const Curve2& b = border_at(sheet_, joint.b).curve;
    return std::max((tree_.image(sheet_, joint.a.face, start_of(a)) -
                     tree_.image(sheet_, joint.b.face, end_of(b)))
                        .norm(),
                    (tree_.image(sheet_, joint.a.face, end_of(a)) -
                     tree_.image(sheet_, joint.b.face, start_of(b)))
                        .norm());
  }

  /// The two borders of a sharp bend are parallel, one allowance apart; their ends may differ.
  double sharp_mismatch(const Joint& joint) const {
    const double gap = gap_of(*joint.sharp);
    const Curve2& a = border_at(sheet_, joint.a).curve;
    const Curve2& b = border_at(sheet_, joint.b).curve;
    const Vec2 a0 = tree_.image(sheet_, joint.a.face, start_of(a));
    const Vec2 a1 = tree_.image(sheet_, joint.a.face, end_of(a));
    const Vec2 x = (a1 - a0).normalized();
    const Vec2 outwards(x.y(), -x.x());
    const Vec2 b0 = tree_.image(sheet_, joint.b.face, end_of(b));
    const Vec2 b1 = tree_.image(sheet_, joint.b.face, start_of(b));
    const double along = std::abs(((b0 + b1) / 2 - (a0 + a1) / 2).dot(x)) >
                                 (a1 - a0).norm() + (b1 - b0).norm()
                             ? (b0 - a0).norm()
                             : 0.0;
    return std::max(
        {std::abs((b0 - a0).dot(outwards) - gap), std::abs((b1 - a0).dot(outwards) - gap), along});
  }

  const Sheet& sheet_;
  const FlattenOptions& options_;
  Nodes nodes_;
  std::vector<std::vector<int>> joints_of_;
  std::vector<std::optional<Isometry2>> node_placement_;
  UnfoldingTree tree_;
};

}  // namespace

const Border& border_at(const Sheet& sheet, const BorderRef& ref) {
  return face_at(sheet, ref.face).loops[ref.loop][ref.border];
}

Vec2 UnfoldingTree::image(const Sheet& sheet, FaceId id, const Vec2& uv) const {
  const auto* bend = std::get_if<BendId>(&face_at(sheet, id).part_of);
  const Vec2 flat = bend ? development[index_of(*bend)].develop(uv) : uv;
  return placement[index_of(id)] * flat;
}

const Curve2& UnfoldingTree::image(const BorderRef& ref) const {
  return images[index_of(ref.face)][ref.loop][ref.border];
}

Result<UnfoldingTree> grow_unfolding_tree(const Sheet& sheet, const FlattenOptions& options) {
  if (sheet.faces.empty()) return fail(ErrorCode::not_a_sheet, "The sheet has no faces.");
  return Grower(sheet, options).run();
}

}  // namespace planish
