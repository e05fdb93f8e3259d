#include "assembly.hpp"

#include "borders.hpp"
#include "dihedral.hpp"
#include "face_volume.hpp"
#include "features.hpp"
#include "widest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace planish::brep {
namespace {

class Assembler {
 public:
  explicit Assembler(const Recognition& of)
      : of_(of), model_(of.model), outlines_(of.outlines), groups_(of.groups) {
    map_.face_id.assign(model_.faces.size(), FaceId{-1});
  }

  Result<Sheet> run() {
    sheet_.thickness = of_.skins.thickness;
    sheet_.thickness_spread = of_.skins.spread;
    number_groups();
    for (size_t g = 0; g < groups_.rows.size(); ++g)
      add_faces(static_cast<int>(g));
    align_turns();
    if (auto done = add_joints(); !done) return tl::unexpected(done.error());
    for (size_t g = 0; g < groups_.rows.size(); ++g)
      if (!groups_.rows[g].flange) measure_bend(static_cast<int>(g));
    add_features(sheet_, map_, of_);
    sheet_.volume = volume_of(model_);
    return std::move(sheet_);
  }

 private:
  const SolidFace& solid_face(int f) const { return model_.faces[f]; }
  Face& face_of(int f) { return sheet_.faces[map_.face_id[f]]; }

  void number_groups() {
    for (const Group& group : groups_.rows) {
      if (group.flange) {
        group_part_.emplace_back(sheet_.flanges.push_back({}));
      } else {
        group_part_.emplace_back(sheet_.bends.push_back({}));
      }
    }
  }

  void add_faces(int g) {
    const Group& group = groups_.rows[g];
    for (const int f : group.faces) {
      const FaceId id{static_cast<int>(sheet_.faces.size())};
      map_.face_id[f] = id;
      sheet_.faces.push_back(read_face(f, group.leader, g));
      if (group.flange)
        sheet_.flanges[std::get<FlangeId>(group_part_[g])].faces.push_back(id);
      else
        sheet_.bends[std::get<BendId>(group_part_[g])].faces.push_back(id);
    }
  }

  Face read_face(int f, int leader, int g) {
    const SolidFace& stands = solid_face(leader);
    Face face;
    face.source_face = f + 1;
    for (const int other : solid_face(f).merged)
      face.merged_faces.push_back(other + 1);
    face.sense = stands.sense;
    face.part_of = group_part_[g];
    if (const auto* plane = std::get_if<Frame>(&stands.surface))
      face.surface = *plane;
    else
      face.surface = std::get<Developable>(stands.surface);
    const int outer = outer_loop(outlines_[f]);
    double u_near = outlines_[leader].u_middle;
    face.loops.push_back(read_loop(f, outer, stands.surface, u_near));
    Box2 box;
    for (const Border& border : face.loops.front())
      box.add(bounds(border.curve));
    u_near = (box.lo.x() + box.hi.x()) / 2;
    for (size_t l = 0; l < solid_face(f).loops.size(); ++l)
      if (static_cast<int>(l) != outer)
        face.loops.push_back(centred(read_loop(f, static_cast<int>(l), stands.surface, u_near),
                                     face.surface, u_near));
    return face;
  }

  BorderLoop read_loop(int f, int l, const SolidSurface& surface, double u_near) {
    const auto& loop = solid_face(f).loops[l];
    std::vector<CoEdge> widened;
    for (const CoEdge& use : loop) {
      widened.push_back(widest_edge(model_, of_.rim, of_.skins.thickness, f, use));
      if (widened.back().edge != use.edge) map_.widened.emplace(f, l);
    }
    BorderLoop read = read_borders(model_, widened, surface, u_near, of_.tolerance);
    BorderLoop borders;
    for (size_t i = 0; i < loop.size(); ++i) {
      if (widened[i].edge != loop[i].edge) set_depth(f, read[i]);
      if (map_.widened.count({f, l})) connect(borders, read[i]);
      const int outer = outer_loop(outlines_[f]);
      // The outer loop of every face comes first in the sheet.
      const int place = l == outer ? 0 : (l < outer ? l + 1 : l);
      map_.borders[{f, loop[i].edge, loop[i].forward}] = {map_.face_id[f], place,
                                                          static_cast<int>(borders.size())};
      borders.push_back(std::move(read[i]));
    }
    if (map_.widened.count({f, l})) connect(borders, Border(borders.front()));
    return borders;
  }

  /// Beside a chamfer that ends, its short side closes the contour.
  void connect(BorderLoop& borders, const Border& next) const {
    if (borders.empty()) return;
    const Vec2 from = end_of(borders.back().curve);
    const Vec2 to = start_of(next.curve);
    constexpr double kStep = 1e-3;  // mm: less is the rounding of the file, which merging closes
    if ((to - from).norm() <= kStep) return;
    Border step;
    step.curve = Segment{from, to};
    borders.push_back(step);
  }

  void set_depth(int f, Border& border) const {
    const SolidFace& face = solid_face(f);
    const Vec3 point = model_.edges[*border.edge].curve.start;
    if (const auto* plane = std::get_if<Frame>(&face.surface)) {
      border.edge_depth = -plane->local(point).z();
    } else {
      const auto& surface = std::get<Developable>(face.surface);
      const Vec2 uv = parameters_of(surface, point, 0.0);
      border.edge_depth = -face.sense *
                          (point - point_on(surface, uv)).dot(normal_on(surface, uv.x()));
      border.edge_length.reset();  // a length below the skin is not the skin's
    }
  }

  /// A hole read from its own first point may lie a turn away from the face's outer loop.
  static BorderLoop centred(BorderLoop loop, const std::variant<Frame, Developable>& surface,
                            double u_near) {
    if (!std::holds_alternative<Developable>(surface) ||
        std::holds_alternative<Ruled>(std::get<Developable>(surface)))
      return loop;
    Box2 box;
    for (const Border& border : loop)
      box.add(bounds(border.curve));
    const double turns = std::round((u_near - (box.lo.x() + box.hi.x()) / 2) /
                                    (2 * std::numbers::pi));
    if (turns != 0.0)
      for (Border& border : loop)
        border.curve = shifted_u(border.curve, turns * 2 * std::numbers::pi);
    return loop;
  }

  std::pair<BorderRef, BorderRef> refs_of(int e) const {
    const SolidEdge& edge = model_.edges[e];
    return {map_.borders.at({edge.faces[0], e, edge.forward[0]}),
            map_.borders.at({edge.faces[1], e, edge.forward[1]})};
  }
  const Border& border_at(const BorderRef& ref) const { return sheet_[ref]; }

  /// Faces of one bend meet along seams: each follows the turn of its neighbour.
  void align_turns() {
    for (const Group& group : groups_.rows) {
      if (group.flange || group.faces.size() < 2) continue;
      if (!std::holds_alternative<Developable>(face_of(group.leader).surface) ||
          std::holds_alternative<Ruled>(std::get<Developable>(face_of(group.leader).surface)))
        continue;
      std::set<int> settled{group.leader};
      for (bool moved = true; moved;) {
        moved = false;
        for (const GroupJoint& joint : groups_.joints) {
          if (joint.a != joint.b || groups_.of_face[group.leader] != joint.a) continue;
          const SolidEdge& edge = model_.edges[joint.edge];
          const bool has0 = settled.count(edge.faces[0]) > 0;
          if (has0 == (settled.count(edge.faces[1]) > 0)) continue;
          auto [known, loose] = refs_of(joint.edge);
          if (!has0) std::swap(known, loose);
          shift_face(loose.face,
                     start_of(border_at(known).curve).x() - end_of(border_at(loose).curve).x());
          settled.insert(has0 ? edge.faces[1] : edge.faces[0]);
          moved = true;
        }
      }
      for (const int f : group.faces)
        if (!settled.count(f))
          shift_face(map_.face_id[f], middle_u(face_of(group.leader)) - middle_u(face_of(f)));
    }
  }

  static double middle_u(const Face& face) {
    Box2 box;
    for (const Border& border : face.loops.front())
      box.add(bounds(border.curve));
    return (box.lo.x() + box.hi.x()) / 2;
  }

  void shift_face(FaceId id, double by) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const double turns = kTurn * std::round(by / kTurn);
    if (turns == 0.0) return;
    for (BorderLoop& loop : sheet_.faces[id].loops)
      for (Border& border : loop)
        border.curve = shifted_u(border.curve, turns);
  }

  Result<void> add_joints() {
    std::map<std::pair<int, int>, BendId> sharp_bends;
    for (const GroupJoint& joint : groups_.joints) {
      const auto [a, b] = refs_of(joint.edge);
      Joint row{a, b, {}};
      if (joint.sharp) {
        const auto key = std::minmax(joint.a, joint.b);
        const auto found = sharp_bends.find(key);
        row.sharp = found != sharp_bends.end() ? found->second : add_sharp_bend(joint.edge);
        sharp_bends.emplace(key, *row.sharp);
        add_mitre(joint.edge);
      } else if (joint.a != joint.b) {
        if (auto straightened = straighten(joint.edge, a, b); !straightened)
          return tl::unexpected(straightened.error());
      }
      sheet_.joints.push_back(row);
    }
    return {};
  }

  /// A joint between different surfaces runs along a ruling; what the file's rounding bent a little
  /// is made straight.
  Result<void> straighten(int e, const BorderRef& a, const BorderRef& b) {
    constexpr double kCurved = 0.02;  // mm: twice what surfaces may be off
                                      // (RecognizeOptions::surface_tolerance)
    const double off = std::max(off_ruling(a), off_ruling(b));
    if (off > kCurved) {
      const auto& faces = model_.edges[e].faces;
      return fail(ErrorCode::doubly_curved,
                  fmt::format("Faces {} and {} run into each other along a line that is curved by "
                              "{:.3g} mm; no flat "
                              "shape bends to that.",
                              faces[0] + 1, faces[1] + 1, off),
                  fmt::format("faces {} and {}", faces[0] + 1, faces[1] + 1));
    }
    for (const BorderRef& ref : {a, b}) {
      Border& border = sheet_[ref];
      Segment line{start_of(border.curve), end_of(border.curve)};
      if (std::holds_alternative<Developable>(sheet_.faces[ref.face].surface))
        line.a.x() = line.b.x() = (line.a.x() + line.b.x()) / 2;
      border.curve = line;
    }
    return {};
  }

  /// How far a border is from the ruling, or the line, between its ends, mm.
  double off_ruling(const BorderRef& ref) const {
    const Face& face = sheet_.faces[ref.face];
    const Curve2& curve = border_at(ref).curve;
    const Vec2 start = start_of(curve);
    const Vec2 end = end_of(curve);
    const auto* surface = std::get_if<Developable>(&face.surface);
    const double u = (start.x() + end.x()) / 2;
    constexpr int kSteps = 16;
    double off = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
      const Vec2 p = point_at(curve, static_cast<double>(i) / kSteps);
      off = std::max(off,
                     surface ? (point_on(*surface, p) - point_on(*surface, {u, p.y()})).norm()
                             : Eigen::ParametrizedLine<double, 2>::Through(start, end).distance(p));
    }
    return off;
  }

  /// A mitred corner holds more than the arc of material that bends to it: per length T² (tan α/2 −
  /// α/2).
  void add_mitre(int e) {
    const bool rounded = std::any_of(
        of_.skins.sharp.begin(), of_.skins.sharp.end(),
        [&](const SharpEdge& sharp) { return sharp.edge == e && sharp.rounded; });
    if (rounded) return;
    const double half = std::abs(*dihedral(model_, e)) / 2;
    const double t = sheet_.thickness;
    sheet_.mitres_volume += model_.edges[e].curve.length() * t * t * (std::tan(half) - half);
  }

  BendId add_sharp_bend(int e) {
    const double angle = *dihedral(model_, e);
    Bend bend;
    bend.kind = BendKind::sharp;
    bend.angle = Angle::radians(std::abs(angle));
    bend.reference_inside = angle < 0;
    return sheet_.bends.push_back(bend);
  }

  void measure_bend(int g) {
    Bend& bend = sheet_.bends[std::get<BendId>(group_part_[g])];
    const Face& face = sheet_.faces[bend.faces.front()];
    Box2 box;
    for (const FaceId id : bend.faces)
      for (const Border& border : sheet_.faces[id].loops.front())
        box.add(bounds(border.curve));
    const double turn = box.size().x();
    const double skin_to_inside = face.sense > 0 ? sheet_.thickness : 0.0;
    bend.reference_inside = face.sense < 0;
    const auto& surface = std::get<Developable>(face.surface);
    if (const auto* cylinder = std::get_if<Cylinder>(&surface)) {
      bend.kind = BendKind::cylinder;
      bend.angle = Angle::radians(turn);
      bend.inside_radius = std::max(0.0, cylinder->radius - skin_to_inside);
    } else if (const auto* cone = std::get_if<Cone>(&surface)) {
      bend.kind = BendKind::cone;
      const double s = std::sin(cone->half_angle);
      const double c = std::cos(cone->half_angle);
      const double between = std::acos(std::clamp(c * c * std::cos(turn) + s * s, -1.0, 1.0));
      bend.angle = Angle::radians(turn <= std::numbers::pi ? between
                                                           : 2 * std::numbers::pi - between);
      bend.inside_radius = std::max(
          0.0, (box.lo.y() + box.hi.y()) / 2 * std::tan(cone->half_angle) - skin_to_inside);
    } else {
      measure_general(bend, face, box);
    }
  }

  /// Middle of the part of the ruling at u that lies on the face.
  static double middle_of_ruling(const Face& face, double u, const Box2& box) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Border& border : face.loops.front())
      for (const double t : crossings(border.curve, {u, 0.0}, Vec2::UnitY())) {
        const double v = point_at(border.curve, t).y();
        low = std::min(low, v);
        high = std::max(high, v);
      }
    return low <= high ? 0.5 * (low + high) : 0.5 * (box.lo.y() + box.hi.y());
  }

  /// Normals along the middle of the bend tell its turn, its smallest radius and its inside.
  void measure_general(Bend& bend, const Face& face, const Box2& box) const {
    constexpr int kSteps = 256;
    double turned = 0.0;
    std::vector<double> radii;
    for (int i = 0; i < kSteps; ++i) {
      const double u0 = box.lo.x() + box.size().x() * i / kSteps;
      const double u1 = box.lo.x() + box.size().x() * (i + 1) / kSteps;
      const double v = middle_of_ruling(face, 0.5 * (u0 + u1), box);
      const Vec2 a(u0, v), b(u1, v);
      const Vec3 n0 = outward_normal(face, a);
      const Vec3 n1 = outward_normal(face, b);
      const Vec3 d = skin_point(face, b) - skin_point(face, a);
      const Vec3 ruling = ruling_on(std::get<Developable>(face.surface), 0.5 * (u0 + u1));
      const double across = (d - d.dot(ruling) * ruling).norm();
      const double step = std::atan2(n0.cross(n1).norm(), n0.dot(n1));
      turned += d.dot(n1 - n0) > 0 ? step : -step;
      radii.push_back(step > 0 ? across / step : std::numeric_limits<double>::infinity());
    }
    bend.kind = BendKind::general;
    bend.angle = Angle::radians(turn_between(face, box, std::abs(turned)));
    bend.reference_inside = turned < 0;
    bend.inside_radius = std::max(
        0.0, smallest_of(radii) - (bend.reference_inside ? 0.0 : sheet_.thickness));
  }

  /// Smallest of radii taken in the middles of equal steps, the ends of the first and the last step
  /// included: there the parabola through the three nearest goes on.
  static double smallest_of(const std::vector<double>& radii) {
    double smallest = *std::min_element(radii.begin(), radii.end());
    const auto end_beyond = [&](auto first) {
      return (15 * first[0] - 10 * first[1] + 3 * first[2]) / 8;
    };
    for (const double end : {end_beyond(radii.begin()), end_beyond(radii.rbegin())})
      if (end > 0) smallest = std::min(smallest, end);
    return smallest;
  }

  /// The angle between the sheet at both ends; `along` is how far the normal travels between, which
  /// is more where it does not stay in one plane.
  static double turn_between(const Face& face, const Box2& box, double along) {
    const Vec3 n0 = outward_normal(face, box.lo), n1 = outward_normal(face, box.hi);
    const double between = std::atan2(n0.cross(n1).norm(), n0.dot(n1));
    return along <= std::numbers::pi ? between : 2 * std::numbers::pi - between;
  }

  const Recognition& of_;
  const SolidModel& model_;
  const std::vector<Outline>& outlines_;
  const Groups& groups_;
  Sheet sheet_;
  SheetMap map_;
  std::vector<PartId> group_part_;
};

}  // namespace

Result<Sheet> assemble_sheet(const Recognition& of) { return Assembler(of).run(); }

}  // namespace planish::brep
