// The sheet as flat polygons in the pattern, each with the motion that puts it into space: a flange
// is one, a bend its strips (bend_facets.cpp). Walking the tree of hinges from the root folds any
// share of every bend. A border has one number through all its facets, so that an edge can be drawn
// and named as a whole.

#include "bend_facets.hpp"
#include "feature_borders.hpp"
#include "unplaced.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/search.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/sheet/facets.hpp>
#include <planish/sheet/topology.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace planish {
namespace {

using namespace sheet_detail;

const Segment kNoHinge{Vec2::Zero(), Vec2::Zero()};

/// How a facet is hinged: to which facet, about which line, by what angle.
struct Hinge {
  std::optional<int> parent = {};
  Segment line = kNoHinge;
  double turn = 0.0;
};

/// The quadrilateral between the two borders of a joint, which run the same way.
struct Band {
  Segment line;
  Segment across;
};

std::vector<Vec2> oriented(std::vector<Vec2> ring, bool counter_clockwise) {
  if ((ring_area(ring) > 0.0) != counter_clockwise) std::ranges::reverse(ring);
  return ring;
}

Segment ends_of(const Curve2& curve) { return {start_of(curve), end_of(curve)}; }

Segment longest_border(const Loop& loop) {
  Segment longest = kNoHinge;
  for (const Curve2& curve : loop)
    if (length(ends_of(curve)) > length(longest)) longest = ends_of(curve);
  return longest;
}

/// Which borders of a loop are joined to others; the rest are edges of the sheet.
std::vector<bool> joined_borders(const Sheet& sheet, const Topology& topology, FaceId face,
                                 int loop) {
  std::vector<bool> joined;
  for (int i = 0; i < std::ssize(sheet[face].loops[loop]); ++i)
    joined.push_back(!topology.is_free(BorderRef{face, loop, i}));
  return joined;
}

/// Whether the sheet goes on at the end of a border and the beginning of its twin: another joint
/// follows there.
bool goes_on(const Topology& topology, BorderId border, BorderId twin) {
  const auto across = topology.twin(topology.next(border));
  return across && topology.next(*across) == twin;
}

/// Facets that grow from a root: flanges and bends are hinged to existing facets.
class FacetTree {
 public:
  FacetTree(const Sheet& sheet, const Layout& layout, const FacetOptions& options)
      : sheet_(sheet),
        layout_(layout),
        options_(options),
        topology_(sheet),
        strips_(sheet.bends.size()),
        facet_of_face_(sheet.faces.size(), -1),
        facets_of_bend_(sheet.bends.size()) {}

  const Topology& topology() const { return topology_; }
  void set_root(const Eigen::Isometry3d& root) { made_.root = root; }
  Facets take() && { return std::move(made_); }

  /// The flange or bend of a face, entered over that border (of a root: any of the face).
  void hang_part(const BorderRef& entry, const Hinge& hinge) {
    if (std::holds_alternative<FlangeId>(sheet_[entry.face].part_of))
      hang_flange(entry.face, hinge);
    else
      hang_bend(std::get<BendId>(sheet_[entry.face].part_of), strip_beside(entry), hinge);
  }
  void hang_flange(FaceId first, const Hinge& hinge);
  void hang_bend(BendId bend, int entry, const Hinge& hinge);
  /// Adds the part beyond a joint whose side a exists already.
  void hang(const Joint& joint);
  /// Adds the band of a sharp bend at a joint both of whose sides exist already.
  void add_band(const Joint& joint);

  const BendFacets& strips_of(BendId bend);

 private:
  /// Numbers a border of the sheet's outline.
  int add_border(FacetBorder border) {
    made_.borders.push_back(std::move(border));
    return static_cast<int>(made_.borders.size()) - 1;
  }
  void add_outline(int facet, const FacetBorder& border);
  void add_features(FaceId face, int facet);
  int add(const PartId& part, const Hinge& hinge, std::vector<Polygon> polygons) {
    made_.facets.push_back(
        {part, hinge.parent, hinge.line, Angle::radians(hinge.turn), std::move(polygons)});
    return static_cast<int>(made_.facets.size()) - 1;
  }
  void hang_flange_face(FaceId face, const Hinge& hinge);
  int strip_beside(const BorderRef& ref);
  Vec3 normal_beside(const BorderRef& ref);
  int facet_beside(const BorderRef& ref);
  double turn_at(const Joint& joint);
  std::optional<Band> band_at(const Joint& joint) const;
  int hang_band(const Joint& joint, const Band& band);

  const Sheet& sheet_;
  const Layout& layout_;
  const FacetOptions& options_;
  Topology topology_;
  IdVector<BendId, std::optional<BendFacets>> strips_;
  IdVector<FaceId, int> facet_of_face_;
  IdVector<BendId, std::vector<int>> facets_of_bend_;
  Facets made_;
};

/// The faces of a flange that are not the first lie in its plane, hinged to it without an angle.
void FacetTree::hang_flange(FaceId first, const Hinge& hinge) {
  hang_flange_face(first, hinge);
  for (const FaceId face : sheet_.faces_of(sheet_[first].part_of))
    if (face != first)
      hang_flange_face(face, {facet_of_face_[first], longest_border(layout_.outline(face)), 0.0});
}

void FacetTree::add_outline(int facet, const FacetBorder& border) {
  const std::vector<Vec2> points = sampled(border.curve, options_.chord);
  const int number = add_border(border);
  for (size_t k = 1; k < points.size(); ++k)
    made_.edges.push_back({facet, {points[k - 1], points[k]}, number});
}

void FacetTree::add_features(FaceId face, int facet) {
  const FeatureBorders features = feature_borders(sheet_, layout_, face, options_.extruded);
  for (const Loop& hole : features.holes)
    made_.facets[facet].polygons.front().holes.push_back(
        oriented(sampled(hole, options_.chord), false));
  for (const FacetBorder& border : features.borders)
    add_outline(facet, border);
}

void FacetTree::hang_flange_face(FaceId face, const Hinge& hinge) {
  const std::vector<Loop>& loops = layout_.images[face];
  Polygon polygon{oriented(sampled(loops.front(), options_.chord), true), {}};
  std::vector<FacetBorder> outlines;
  for (int loop = 0; loop < std::ssize(loops); ++loop) {
    const auto joined = joined_borders(sheet_, topology_, face, loop);
    const auto form = outlined_form(sheet_[face], loop, joined);
    if (loop > 0 && !form)
      polygon.holes.push_back(oriented(sampled(loops[loop], options_.chord), false));
    for (int i = 0; i < std::ssize(loops[loop]); ++i)
      if (!joined[i])
        outlines.push_back({loops[loop][i], feature_at(sheet_[BorderRef{face, loop, i}], form)});
  }
  const int facet = add(sheet_[face].part_of, hinge, {std::move(polygon)});
  facet_of_face_[face] = facet;
  for (const FacetBorder& outline : outlines)
    add_outline(facet, outline);
  add_features(face, facet);
}

const BendFacets& FacetTree::strips_of(BendId bend) {
  auto& strips = strips_[bend];
  if (strips) return *strips;
  strips.emplace(sheet_, layout_, bend, options_);
  for (const FaceId face : sheet_[bend].faces)
    for (int loop = 0; loop < std::ssize(sheet_[face].loops); ++loop)
      strips->add_loop(face, loop, joined_borders(sheet_, topology_, face, loop));
  strips->close();
  return *strips;
}

/// The facet numbered `entry` is hinged to the parent, the others to their neighbours.
void FacetTree::hang_bend(BendId bend, int entry, const Hinge& hinge) {
  const BendFacets& strips = strips_of(bend);
  std::vector<int> facets(strips.count());
  const int first = static_cast<int>(made_.borders.size());
  for (const auto& [ref, feature] : strips.borders())
    add_border({layout_.image(ref), feature});
  const auto add_strip = [&](int strip, const Hinge& on) {
    facets[strip] = add(bend, on, strips.polygons(strip));
    for (const BendFacets::Edge& edge : strips.edges(strip))
      made_.edges.push_back({facets[strip], edge.line, first + edge.border});
  };
  const auto beside = [&](int from, int strip) -> Hinge {
    return {facets[from], strips.ruling(std::max(from, strip)), strips.turn(from, strip)};
  };
  add_strip(entry, hinge);
  for (int strip = entry + 1; strip < strips.count(); ++strip)
    add_strip(strip, beside(strip - 1, strip));
  for (int strip = entry - 1; strip >= 0; --strip)
    add_strip(strip, beside(strip + 1, strip));
  facets_of_bend_[bend] = std::move(facets);
}

int FacetTree::strip_beside(const BorderRef& ref) {
  const Curve2& curve = sheet_[ref].curve;
  return strips_of(std::get<BendId>(sheet_[ref.face].part_of))
      .beside(ref.face, 0.5 * (start_of(curve).x() + end_of(curve).x()));
}

Vec3 FacetTree::normal_beside(const BorderRef& ref) {
  const Face& face = sheet_[ref.face];
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->z;
  return strips_of(std::get<BendId>(face.part_of)).normal(strip_beside(ref));
}

int FacetTree::facet_beside(const BorderRef& ref) {
  const auto* bend = std::get_if<BendId>(&sheet_[ref.face].part_of);
  return bend ? facets_of_bend_[*bend][strip_beside(ref)] : facet_of_face_[ref.face];
}

/// The angle by which the part beyond a placed border is turned about it.
double FacetTree::turn_at(const Joint& joint) {
  const Vec3 a = normal_beside(joint.a), b = normal_beside(joint.b);
  const Face& face = sheet_[joint.a.face];
  const Curve2& curve = sheet_[joint.a].curve;
  const Vec3 line = (skin_point(face, end_of(curve)) - skin_point(face, start_of(curve)))
                        .normalized();
  constexpr double kFoldedOver = -0.98;  // cosine near which normals do not determine the sense of
                                         // the turn
  if (joint.sharp && a.dot(b) < kFoldedOver) {
    const Bend& bend = sheet_[*joint.sharp];
    return bend.reference_inside ? -bend.angle.radians() : bend.angle.radians();
  }
  return std::atan2(line.dot(a.cross(b)), a.dot(b));
}

/// The band that a sharp bend takes at a joint: empty where its borders are one line.
std::optional<Band> FacetTree::band_at(const Joint& joint) const {
  const Segment line = ends_of(layout_.image(joint.a));
  const Segment other = ends_of(layout_.image(joint.b));  // runs the other way
  const Segment across{other.b, other.a};
  const Vec2 along = (line.b - line.a).normalized(), step = across.a - line.a;
  constexpr double kNoGap = tolerance::kComputed;  // mm
  if (std::abs(cross(along, step)) <= kNoGap) return std::nullopt;
  return Band{line, across};
}

/// The band turns in two halves, one at each of its borders.
int FacetTree::hang_band(const Joint& joint, const Band& band) {
  const auto& [line, across] = band;
  const int strip = add(*joint.sharp, {facet_beside(joint.a), line, 0.5 * turn_at(joint)},
                        {Polygon{oriented({line.a, line.b, across.b, across.a}, true), {}}});
  const BorderId a = topology_.id_of(joint.a), b = topology_.id_of(joint.b);
  if (!goes_on(topology_, b, a)) add_outline(strip, {Segment{line.a, across.a}});
  if (!goes_on(topology_, a, b)) add_outline(strip, {Segment{line.b, across.b}});
  return strip;
}

void FacetTree::hang(const Joint& joint) {
  const double turn = turn_at(joint);
  const auto band = joint.sharp ? band_at(joint) : std::nullopt;
  if (!band)
    return hang_part(joint.b, {facet_beside(joint.a), ends_of(layout_.image(joint.a)), turn});
  const int strip = hang_band(joint, *band);
  hang_part(joint.b, {strip, band->across, 0.5 * turn});
}

void FacetTree::add_band(const Joint& joint) {
  if (!joint.sharp) return;
  if (const auto band = band_at(joint)) hang_band(joint, *band);
}

/// From the reference surface to the middle of the material.
double middle_depth(const Sheet& sheet) { return 0.5 * sheet.thickness - sheet.reference_depth; }

/// Begins with the largest face, or in sheets without flanges with the middle of a bend. Returns
/// the node added.
int hang_root(const Sheet& sheet, const Layout& layout, FacetTree& tree) {
  const FaceId face = largest_flange_face(sheet);
  if (std::holds_alternative<FlangeId>(sheet[face].part_of)) {
    tree.set_root(flange_in_space(sheet, layout, face));
    tree.hang_flange(face, {});
    return tree.topology().node_of(face);
  }
  const BendId bend = std::get<BendId>(sheet.faces.front().part_of);
  const BendFacets& strips = tree.strips_of(bend);
  const int middle = strips.count() / 2;
  tree.set_root(strips.in_space(middle, middle_depth(sheet)));
  tree.hang_bend(bend, middle, {});
  return tree.topology().node_of(bend);
}

}  // namespace

Facets facets_of(const Sheet& sheet, const Layout& layout, const FacetOptions& options) {
  require_valid(sheet);
  PLANISH_ASSERT(layout.placement.size() == sheet.faces.size());
  for (const int joint : layout.tree)
    PLANISH_ASSERT(joint >= 0 && joint < std::ssize(sheet.joints));
  PLANISH_ASSERT(options.chord > 0.0 && options.most.radians() > 0.0);
  FacetTree tree(sheet, layout, options);
  const Topology& topology = tree.topology();
  std::vector<bool> hung(topology.node_count());
  std::vector<std::vector<int>> joints_of(topology.node_count());
  for (const int number : layout.tree)
    for (const BorderRef& ref : {sheet.joints[number].a, sheet.joints[number].b})
      joints_of[topology.node_of(ref.face)].push_back(number);
  std::vector<int> kept = layout.tree;
  std::ranges::sort(kept);
  Frontier<std::pair<double, int>, std::less<>> front;  // the longest first
  const auto enter = [&](int node) {
    hung[node] = true;
    for (const int number : joints_of[node])
      front.add({length(ends_of(layout.image(sheet.joints[number].a))), number});
  };
  enter(hang_root(sheet, layout, tree));
  while (!front.empty()) {
    Joint joint = sheet.joints[front.take().second];
    if (!hung[topology.node_of(joint.a.face)]) std::swap(joint.a, joint.b);
    if (hung[topology.node_of(joint.b.face)]) continue;
    tree.hang(joint);
    enter(topology.node_of(joint.b.face));
  }
  // A bend in several lines, or one that closes a cycle, has a band at each of its joints.
  for (int number = 0; number < std::ssize(sheet.joints); ++number)
    if (!std::ranges::binary_search(kept, number)) tree.add_band(sheet.joints[number]);
  return std::move(tree).take();
}

Eigen::Isometry3d flange_in_space(const Sheet& sheet, const Layout& layout, FaceId face) {
  const Frame& frame = std::get<Frame>(sheet[face].surface);
  const Isometry2 from_pattern = layout.placement[face].inverse();
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity(), space = placed;
  placed.linear().topLeftCorner<2, 2>() = from_pattern.linear();
  placed.linear()(2, 2) = from_pattern.linear().determinant() < 0.0 ? -1.0 : 1.0;
  placed.translation().head<2>() = from_pattern.translation();
  space.linear() << frame.x, frame.y, frame.z;
  space.translation() = frame.origin - middle_depth(sheet) * frame.z;
  return space * placed;
}

std::vector<Eigen::Isometry3d> folded(const Facets& facets, double share) {
  PLANISH_ASSERT(std::isfinite(share));
  std::vector<Eigen::Isometry3d> placed;
  for (const Facet& facet : facets.facets) {
    if (!facet.parent) {
      placed.push_back(facets.root);
      continue;
    }
    const Vec3 from(facet.hinge.a.x(), facet.hinge.a.y(), 0.0),
        to(facet.hinge.b.x(), facet.hinge.b.y(), 0.0);
    const Eigen::AngleAxisd turn(share * facet.angle.radians(), (to - from).normalized());
    placed.push_back(placed[*facet.parent] * Eigen::Translation3d(from) * turn *
                     Eigen::Translation3d(-from));
  }
  return placed;
}

}  // namespace planish
