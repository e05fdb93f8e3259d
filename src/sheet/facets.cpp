#include "bend_strips.hpp"
#include "unfolding_tree.hpp"

#include <planish/sheet/facets.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

namespace planish {
namespace {

using Part = std::variant<FlangeId, BendId>;

const Segment kNone{Vec2::Zero(), Vec2::Zero()};

const Face& face_at(const Sheet& sheet, FaceId id) { return sheet.faces[index_of(id)]; }

std::vector<Vec2> oriented(std::vector<Vec2> ring, bool counter_clockwise) {
  if ((ring_area(ring) > 0.0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

class FacetMaker {
 public:
  FacetMaker(const Sheet& sheet, const FlatPattern& pattern, const FacetOptions& options)
      : sheet_(sheet),
        pattern_(pattern),
        options_(options),
        strips_(sheet.bends.size()),
        facet_of_face_(sheet.faces.size(), -1) {
    for (const Joint& joint : sheet.joints) {
      mark_joined(joint.a);
      mark_joined(joint.b);
    }
  }

  Facets run() {
    begin();
    grow();
    return std::move(made_);
  }

 private:
  // --- where things are in the pattern ---------------------------------------------------------

  const Loop& image(FaceId face, int loop) const {
    const auto f = static_cast<size_t>(index_of(face));
    return loop == 0 ? pattern_.face_outlines[f]
                     : pattern_.face_openings[f][static_cast<size_t>(loop) - 1];
  }
  Segment image(const BorderRef& ref) const {
    const Curve2& curve = image(ref.face, ref.loop)[ref.border];
    return {start_of(curve), end_of(curve)};
  }
  Segment longest_border(FaceId face) const {
    Segment longest = kNone;
    for (const Curve2& curve : image(face, 0))
      if ((end_of(curve) - start_of(curve)).norm() > (longest.b - longest.a).norm())
        longest = {start_of(curve), end_of(curve)};
    return longest;
  }
  std::vector<bool>& joined(FaceId face, int loop) {
    joined_.resize(sheet_.faces.size());
    auto& of_face = joined_[index_of(face)];
    of_face.resize(face_at(sheet_, face).loops.size());
    auto& of_loop = of_face[loop];
    of_loop.resize(face_at(sheet_, face).loops[loop].size());
    return of_loop;
  }
  void mark_joined(const BorderRef& ref) { joined(ref.face, ref.loop)[ref.border] = true; }

  // --- facets of a node ------------------------------------------------------------------------

  int add(const Part& part, int parent, const Segment& hinge, double angle,
          std::vector<Polygon> polygons) {
    made_.facets.push_back({part, parent, hinge, Angle::radians(angle), std::move(polygons)});
    return static_cast<int>(made_.facets.size()) - 1;
  }

  /// Of a flange's face; its other faces lie in its plane, hinged to it without an angle.
  void add_flange(FaceId first, int parent, const Segment& hinge, double angle) {
    const FlangeId flange = std::get<FlangeId>(face_at(sheet_, first).part_of);
    add_flange_face(first, parent, hinge, angle);
    const int facet = facet_of_face_[index_of(first)];
    for (const FaceId face : sheet_.flanges[index_of(flange)].faces)
      if (face != first) add_flange_face(face, facet, longest_border(face), 0.0);
  }

  void add_flange_face(FaceId face, int parent, const Segment& hinge, double angle) {
    Polygon polygon;
    const int loops = static_cast<int>(face_at(sheet_, face).loops.size());
    for (int loop = 0; loop < loops; ++loop) {
      auto ring = oriented(sampled(image(face, loop), options_.chord), loop == 0);
      if (loop == 0)
        polygon.outer = std::move(ring);
      else
        polygon.holes.push_back(std::move(ring));
    }
    const int facet = add(face_at(sheet_, face).part_of, parent, hinge, angle,
                          {std::move(polygon)});
    facet_of_face_[index_of(face)] = facet;
    for (int loop = 0; loop < loops; ++loop) {
      const Loop& curves = image(face, loop);
      for (size_t i = 0; i < curves.size(); ++i) {
        if (joined(face, loop)[i]) continue;
        const auto points = sampled(curves[i], options_.chord);
        for (size_t k = 1; k < points.size(); ++k)
          made_.edges.push_back({facet, {points[k - 1], points[k]}, borders_});
        ++borders_;
      }
    }
  }

  BendStrips& strips_of(BendId bend) {
    auto& strips = strips_[index_of(bend)];
    if (!strips) {
      strips.emplace(sheet_, pattern_, bend, options_);
      for (const FaceId face : sheet_.bends[index_of(bend)].faces)
        for (size_t loop = 0; loop < face_at(sheet_, face).loops.size(); ++loop)
          strips->add_loop(face, static_cast<int>(loop), joined(face, static_cast<int>(loop)));
      strips->close();
    }
    return *strips;
  }

  /// All strips of a bend; the one numbered `entry` is hinged to the parent, the others to those
  /// beside them.
  void add_bend(BendId bend, int entry, int parent, const Segment& hinge, double angle) {
    const BendStrips& strips = strips_of(bend);
    std::vector<int> facets(static_cast<size_t>(strips.count()));
    const auto add_strip = [&](int strip, int from) {
      const bool first = strip == entry;
      const int up = strip > from ? strip : strip + 1;  // the ruling between both
      const Segment between = first ? hinge : strips.ruling(up);
      const double turn = first ? angle : strips.turn(from, strip);
      const int facet = add(bend, first ? parent : facets[from], between, turn,
                            strips.polygons(strip));
      facets[strip] = facet;
      for (const BendStrips::Edge& edge : strips.edges(strip))
        made_.edges.push_back({facet, edge.line, borders_ + edge.border});
    };
    add_strip(entry, entry);
    for (int strip = entry + 1; strip < strips.count(); ++strip)
      add_strip(strip, strip - 1);
    for (int strip = entry - 1; strip >= 0; --strip)
      add_strip(strip, strip + 1);
    borders_ += strips.border_count();
    bend_facets_.resize(sheet_.bends.size());
    bend_facets_[index_of(bend)] = std::move(facets);
  }

  // --- the tree ----------------------------------------------------------------------------------

  int node_of(FaceId face) const {
    const Part& part = face_at(sheet_, face).part_of;
    if (const auto* flange = std::get_if<FlangeId>(&part)) return index_of(*flange);
    return static_cast<int>(sheet_.flanges.size()) + index_of(std::get<BendId>(part));
  }

  void begin() {
    std::optional<FaceId> root;
    double largest = 0.0;
    for (size_t f = 0; f < sheet_.faces.size(); ++f) {
      if (!std::holds_alternative<FlangeId>(sheet_.faces[f].part_of)) continue;
      double area = std::abs(signed_area(pattern_.face_outlines[f]));
      for (const Loop& opening : pattern_.face_openings[f])
        area -= std::abs(signed_area(opening));
      if (root && area <= largest) continue;
      root = FaceId{static_cast<int>(f)};
      largest = area;
    }
    placed_.resize(sheet_.flanges.size() + sheet_.bends.size());
    if (root) {
      made_.root = flange_in_space(*root);
      add_flange(*root, -1, kNone, 0.0);
      enter(node_of(*root));
      return;
    }
    const BendId bend = std::get<BendId>(sheet_.faces.front().part_of);
    const BendStrips& strips = strips_of(bend);
    const int middle = strips.count() / 2;
    made_.root = strips.in_space(middle, middle_depth());
    add_bend(bend, middle, -1, kNone, 0.0);
    enter(node_of(FaceId{0}));
  }

  /// From the reference surface to the middle of the material.
  double middle_depth() const { return 0.5 * sheet_.thickness - sheet_.reference_depth; }

  Eigen::Isometry3d flange_in_space(FaceId face) const {
    const Frame& frame = std::get<Frame>(face_at(sheet_, face).surface);
    const Isometry2 from_pattern = pattern_.placement[index_of(face)].inverse();
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity(), space = placed;
    placed.linear().topLeftCorner<2, 2>() = from_pattern.linear();
    placed.linear()(2, 2) = from_pattern.linear().determinant() < 0.0 ? -1.0 : 1.0;
    placed.translation().head<2>() = from_pattern.translation();
    space.linear() << frame.x, frame.y, frame.z;
    space.translation() = frame.origin - middle_depth() * frame.z;
    return space * placed;
  }

  void enter(int node) {
    placed_[node] = true;
    for (size_t i = 0; i < sheet_.joints.size(); ++i) {
      const int a = node_of(sheet_.joints[i].a.face), b = node_of(sheet_.joints[i].b.face);
      if (a == b || (a != node && b != node)) continue;
      const Segment line = image(sheet_.joints[i].a);
      front_.emplace((line.b - line.a).norm(), static_cast<int>(i));
    }
  }

  /// Over the longest joints first, as the pattern was laid.
  void grow() {
    while (!front_.empty()) {
      Joint joint = sheet_.joints[front_.top().second];
      front_.pop();
      const bool has_a = placed_[node_of(joint.a.face)], has_b = placed_[node_of(joint.b.face)];
      if (has_a && has_b) continue;
      if (!has_a) std::swap(joint.a, joint.b);
      hang(joint);
      enter(node_of(joint.b.face));
    }
  }

  int strip_beside(const BorderRef& ref) {
    const Curve2& curve = border_at(sheet_, ref).curve;
    return strips_of(std::get<BendId>(face_at(sheet_, ref.face).part_of))
        .beside(ref.face, 0.5 * (start_of(curve).x() + end_of(curve).x()));
  }

  Vec3 normal_beside(const BorderRef& ref) {
    const Face& face = face_at(sheet_, ref.face);
    if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->z;
    return strips_of(std::get<BendId>(face.part_of)).normal(strip_beside(ref));
  }

  int facet_beside(const BorderRef& ref) {
    const Face& face = face_at(sheet_, ref.face);
    if (std::holds_alternative<FlangeId>(face.part_of)) return facet_of_face_[index_of(ref.face)];
    const auto bend = static_cast<size_t>(index_of(std::get<BendId>(face.part_of)));
    return bend_facets_[bend][strip_beside(ref)];
  }

  /// By how much what lies beyond a placed border is turned about it.
  double turn_at(const Joint& joint) {
    const Vec3 a = normal_beside(joint.a), b = normal_beside(joint.b);
    const Face& face = face_at(sheet_, joint.a.face);
    const Curve2& curve = border_at(sheet_, joint.a).curve;
    const Vec3 line = (skin_point(face, end_of(curve)) - skin_point(face, start_of(curve)))
                          .normalized();
    constexpr double kFoldedOver = -0.98;  // cosine near which normals do not tell the way round
    if (joint.sharp && a.dot(b) < kFoldedOver) {
      const Bend& bend = sheet_.bends[index_of(*joint.sharp)];
      return bend.reference_inside ? -bend.angle.radians() : bend.angle.radians();
    }
    return std::atan2(line.dot(a.cross(b)), a.dot(b));
  }

  void hang(const Joint& joint) {
    const double turn = turn_at(joint);
    int parent = facet_beside(joint.a);
    Segment hinge = image(joint.a);
    if (!joint.sharp) {
      add_node(joint.b, parent, hinge, turn);
      return;
    }
    const Segment other = image(joint.b);  // runs the other way
    const Segment across{other.b, other.a};
    const Vec2 along = (hinge.b - hinge.a).normalized();
    const double gap = std::abs(along.x() * (across.a - hinge.a).y() -
                                along.y() * (across.a - hinge.a).x());
    constexpr double kNoGap = 1e-9;
    if (gap <= kNoGap) {
      add_node(joint.b, parent, hinge, turn);
      return;
    }
    // What a sharp bend takes of the sheet, turned in two halves.
    const std::vector<Vec2> ring = oriented({hinge.a, hinge.b, across.b, across.a}, true);
    parent = add(*joint.sharp, parent, hinge, 0.5 * turn, {Polygon{ring, {}}});
    made_.edges.push_back({parent, {hinge.a, across.a}, borders_++});
    made_.edges.push_back({parent, {hinge.b, across.b}, borders_++});
    add_node(joint.b, parent, across, 0.5 * turn);
  }

  void add_node(const BorderRef& ref, int parent, const Segment& hinge, double turn) {
    if (std::holds_alternative<FlangeId>(face_at(sheet_, ref.face).part_of))
      add_flange(ref.face, parent, hinge, turn);
    else
      add_bend(std::get<BendId>(face_at(sheet_, ref.face).part_of), strip_beside(ref), parent,
               hinge, turn);
  }

  const Sheet& sheet_;
  const FlatPattern& pattern_;
  const FacetOptions& options_;
  std::vector<std::optional<BendStrips>> strips_;
  std::vector<std::vector<int>> bend_facets_;
  std::vector<int> facet_of_face_;
  std::vector<std::vector<std::vector<bool>>> joined_;
  std::vector<bool> placed_;
  std::priority_queue<std::pair<double, int>> front_;
  int borders_ = 0;  ///< of which there are edges
  Facets made_;
};

}  // namespace

Facets facets_of(const Sheet& sheet, const FlatPattern& pattern, const FacetOptions& options) {
  return FacetMaker(sheet, pattern, options).run();
}

std::vector<Eigen::Isometry3d> folded(const Facets& facets, double share) {
  std::vector<Eigen::Isometry3d> placed;
  for (const Facet& facet : facets.facets) {
    if (facet.parent < 0) {
      placed.push_back(facets.root);
      continue;
    }
    const Vec3 from(facet.hinge.a.x(), facet.hinge.a.y(), 0.0),
        to(facet.hinge.b.x(), facet.hinge.b.y(), 0.0);
    const Eigen::AngleAxisd turn(share * facet.angle.radians(), (to - from).normalized());
    placed.push_back(placed[facet.parent] * Eigen::Translation3d(from) * turn *
                     Eigen::Translation3d(-from));
  }
  return placed;
}

}  // namespace planish
