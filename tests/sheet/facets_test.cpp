#include "support/sheets.hpp"

#include <planish/sheet/facets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

// The folded facets against the sheet they stand for, whose place in space is known.

namespace planish::test {
namespace {

using std::numbers::pi;

FlatSheet laid(const Sheet& sheet, UpSide up = UpSide::automatic) {
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "test"};
  options.up = up;
  auto flat = flat_sheet(sheet, options);
  EXPECT_TRUE(flat) << (flat ? "" : flat.error().message);
  return std::move(*flat);
}

Vec3 placed(const Eigen::Isometry3d& motion, const Vec2& p) {
  return motion * Vec3(p.x(), p.y(), 0.0);
}

/// Largest distance of what folded facets of flanges hold from the middle of their flange's
/// material in space.
double off_flanges(const Sheet& sheet, const Layout& layout, const Facets& facets) {
  const auto motions = folded(facets);
  double off = 0.0;
  for (const FaceId id : sheet.faces.ids()) {
    const auto* frame = std::get_if<Frame>(&sheet[id].surface);
    if (!frame) continue;
    const Vec2 flat = start_of(layout.outline(id).front());
    const Vec3 wanted = frame->point(layout.placement[id].inverse() * flat) -
                        (0.5 * sheet.thickness - sheet.reference_depth) * frame->z;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < facets.facets.size(); ++i)
      if (facets.facets[i].part == sheet[id].part_of)
        nearest = std::min(nearest, (placed(motions[i], flat) - wanted).norm());
    off = std::max(off, nearest);
  }
  return off;
}

double area_of(const Facets& facets) {
  double area = 0.0;
  for (const Facet& facet : facets.facets)
    for (const Polygon& polygon : facet.polygons) {
      EXPECT_GE(ring_area(polygon.outer), 0.0);
      area += ring_area(polygon.outer);
      for (const auto& hole : polygon.holes)
        area += ring_area(hole);
    }
  return area;
}

const std::vector<std::pair<const char*, Sheet>>& named_samples() {
  static const std::vector<std::pair<const char*, Sheet>> sheets{
      {"l_bracket", l_bracket()},
      {"l_bracket_down", l_bracket_down()},
      {"u_channel", u_channel()},
      {"z_profile", z_profile()},
      {"hem", hem()},
      {"turn_of_250", turn_of_250()},
      {"box", box()},
      {"cone_joined", cone_joined()},
      {"staircase", staircase(6)},
      {"slot_across_bend", slot_across_bend()},
      {"plate_with_holes", plate_with_holes()}};
  return sheets;
}

TEST(Facets, FoldToWhereTheFlangesAreInSpace) {
  for (const auto& [name, sheet] : named_samples())
    for (const UpSide up : {UpSide::reference, UpSide::other}) {
      const auto [layout, pattern] = laid(sheet, up);
      EXPECT_LT(off_flanges(sheet, layout, facets_of(sheet, layout)), 0.02) << name;
    }
}

TEST(Facets, KnowWhereFlangesAreExactlyWhateverIsFoldedAsPolygons) {
  for (const auto& [name, sheet] : named_samples())
    for (const UpSide up : {UpSide::reference, UpSide::other}) {
      const auto [layout, pattern] = laid(sheet, up);
      for (const FaceId id : sheet.faces.ids()) {
        const auto* frame = std::get_if<Frame>(&sheet[id].surface);
        if (!frame || !std::holds_alternative<FlangeId>(sheet[id].part_of)) continue;
        const Eigen::Isometry3d place = flange_in_space(sheet, layout, id);
        EXPECT_NEAR(place.linear().determinant(), 1.0, 1e-12) << name;
        for (const Curve2& curve : layout.outline(id)) {
          const Vec2 flat = start_of(curve);
          const Vec3 wanted = frame->point(layout.fold(sheet, id, flat)) -
                              (0.5 * sheet.thickness - sheet.reference_depth) * frame->z;
          EXPECT_LT((placed(place, flat) - wanted).norm(), 1e-9) << name;
        }
      }
    }
}

TEST(Facets, ComeNearerWithSmallerTurns) {
  const Sheet sheet = cone_joined();
  const auto [layout, pattern] = laid(sheet);
  const double coarse = off_flanges(
      sheet, layout, facets_of(sheet, layout, {.chord = 1.0, .most = Angle::degrees(12)}));
  const double fine = off_flanges(
      sheet, layout, facets_of(sheet, layout, {.chord = 1.0, .most = Angle::degrees(3)}));
  EXPECT_LT(fine, coarse / 10.0);  // of second order
}

TEST(Facets, CoverThePattern) {
  for (const auto& [name, sheet] : named_samples()) {
    const auto [layout, pattern] = laid(sheet);
    EXPECT_NEAR(area_of(facets_of(sheet, layout, {.chord = 1e-3})) / pattern.area, 1.0, 2e-4)
        << name;
  }
  const Sheet tube = rolled();
  const auto [layout, pattern] = laid(tube);
  EXPECT_NEAR(area_of(facets_of(tube, layout)) / pattern.area, 1.0, 1e-9);
}

/// Of a wall at the right of a floor of 50 × 40.
Frame wall_frame() {
  Frame up;
  up.origin = {50, 40, 0};
  up.x = -Vec3::UnitY();
  up.y = Vec3::UnitZ();
  up.z = -Vec3::UnitX();
  return up;
}

Bend sharp_right_angle() {
  Bend sharp;
  sharp.kind = BendKind::sharp;
  sharp.angle = Angle::degrees(90);
  sharp.reference_inside = true;
  return sharp;
}

/// Two flanges, 50 × 40 and 40 × 30, of 2 mm, folded sharply along two lines of 15 mm; a window of
/// 10 × 20 lies between these.
Sheet sharp_in_two_lines() {
  SheetBuilder builder(2.0);
  const FaceId floor = builder.flange(
      Frame{},
      {polygon({{0, 0}, {50, 0}, {50, 15}, {40, 15}, {40, 25}, {50, 25}, {50, 40}, {0, 40}})});
  const FaceId wall = builder.flange(
      wall_frame(),
      {polygon({{0, 0}, {15, 0}, {15, 10}, {25, 10}, {25, 0}, {40, 0}, {40, 30}, {0, 30}})});
  const BendId bend = builder.new_bend(sharp_right_angle());
  builder.join({floor, 0, 1}, {wall, 0, 4}, bend);
  builder.join({floor, 0, 5}, {wall, 0, 0}, bend);
  return builder.finish();
}

TEST(Facets, OfASharpBendLieAtEachOfItsLines) {
  const Sheet sheet = sharp_in_two_lines();
  const auto [layout, pattern] = laid(sheet);
  const Facets facets = facets_of(sheet, layout);
  const double allowance = std::numbers::pi / 2;  // α k t
  EXPECT_NEAR(area_of(facets), 50 * 40 - 100 + 40 * 30 - 100 + 2 * 15 * allowance, 1e-9);
  EXPECT_EQ(facets.facets.size(), 4u);
  ASSERT_EQ(pattern.bends.front().lines.size(), 2u);
  EXPECT_LT(off_flanges(sheet, layout, facets),
            1.0);  // a sharp bend is shown as wide as it is flat
  // The two lines are one: at every stage the bands lie in one plane.
  for (const double share : {0.0, 0.4, 1.0}) {
    const auto motions = folded(facets, share);
    std::vector<Vec3> normals;
    for (std::size_t i = 0; i < facets.facets.size(); ++i)
      if (facets.facets[i].part == PartId(BendId{0})) normals.push_back(motions[i].linear().col(2));
    ASSERT_EQ(normals.size(), 2u);
    EXPECT_LT((normals[0] - normals[1]).norm(), 1e-9) << share;
  }
}

/// Two flanges of 50 × 40 and 40 × 30, of 2 mm, folded sharply along one line that two joints
/// share.
Sheet sharp_in_two_joints() {
  SheetBuilder builder(2.0);
  const FaceId floor = builder.flange(Frame{},
                                      {polygon({{0, 0}, {50, 0}, {50, 25}, {50, 40}, {0, 40}})});
  const FaceId wall = builder.flange(wall_frame(),
                                     {polygon({{0, 0}, {15, 0}, {40, 0}, {40, 30}, {0, 30}})});
  const BendId bend = builder.new_bend(sharp_right_angle());
  builder.join({floor, 0, 1}, {wall, 0, 1}, bend);
  builder.join({floor, 0, 2}, {wall, 0, 0}, bend);
  return builder.finish();
}

TEST(Facets, OfASharpBendGoOnFromJointToJointWithoutACut) {
  const Sheet sheet = sharp_in_two_joints();
  const auto [layout, pattern] = laid(sheet);
  const double allowance = std::numbers::pi / 2;  // α k t
  double cut = 0.0;
  for (const FacetEdge& edge : facets_of(sheet, layout).edges)
    cut += (edge.line.b - edge.line.a).norm();
  EXPECT_NEAR(cut, 2 * 50 + 40 + 2 * 30 + 40 + 2 * allowance, 1e-9);
  EXPECT_NEAR(pattern.perimeter, cut, 1e-9);
}

TEST(Facets, KeepTheBordersExactly) {
  const Sheet sheet = plate_with_holes();
  const auto [layout, pattern] = laid(sheet);
  const Facets facets = facets_of(sheet, layout, {.chord = 1.0});
  const auto of = [&](double wanted) {
    return std::ranges::count_if(facets.borders, [&](const FacetBorder& border) {
      return std::abs(length(border.curve) - wanted) < 1e-9;
    });
  };
  EXPECT_EQ(of(std::numbers::pi * 6.6), 1);
  EXPECT_EQ(of(std::numbers::pi * 10), 1);
  for (const FacetEdge& edge : facets.edges)
    for (const Vec2& end : {edge.line.a, edge.line.b})
      EXPECT_LT(nearest(facets.borders[edge.border].curve, end).distance, 1e-9);
}

TEST(Facets, EdgesAreTheContours) {
  for (const auto& [name, sheet] : named_samples()) {
    const auto [layout, pattern] = laid(sheet);
    double sum = 0.0;
    for (const FacetEdge& edge : facets_of(sheet, layout, {.chord = 1e-3}).edges)
      sum += (edge.line.b - edge.line.a).norm();
    EXPECT_NEAR(sum / pattern.perimeter, 1.0, 1e-3) << name;
  }
}

/// By border, the length of its pieces; in ascending order.
std::vector<double> border_lengths(const Facets& facets) {
  std::vector<double> lengths;
  for (const FacetEdge& edge : facets.edges) {
    lengths.resize(std::max(lengths.size(), static_cast<std::size_t>(edge.border) + 1));
    lengths[edge.border] += (edge.line.b - edge.line.a).norm();
  }
  std::ranges::sort(lengths);
  return lengths;
}

void expect_border_lengths(const Sheet& sheet, std::vector<double> wanted) {
  const auto lengths = border_lengths(facets_of(sheet, laid(sheet).layout, {.chord = 1e-3}));
  std::ranges::sort(wanted);
  ASSERT_EQ(lengths.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_NEAR(lengths[i] / wanted[i], 1.0, 1e-3);
}

TEST(Facets, EdgesOfOneBorderHaveOneNumber) {
  expect_border_lengths(plate_with_holes(),
                        {100, 60, 100, 60, 2 * pi * 5, 2 * pi * 3.3, 12, 4 * pi, 12, 4 * pi});
  const double bend = 0.5 * pi * (3.0 + 0.5 * 2.0);
  expect_border_lengths(l_bracket(), {50, 40, 50, bend, bend, 30, 40, 30});
}

TEST(Facets, AHoleInABendHasTheLengthOfItsCircleAcrossTheStrips) {
  constexpr double kDiameter = 4.0;
  const Sheet sheet = hole_in_bend(kDiameter, 0.5);
  const auto [layout, pattern] = laid(sheet);
  const Facets facets = facets_of(sheet, layout, {.chord = 1e-3});
  const Box2 hole = bounds(pattern.openings.front().loop);
  const Vec2 middle = 0.5 * (hole.lo + hole.hi);
  std::set<int> borders, strips;
  double length = 0.0;
  for (const FacetEdge& edge : facets.edges) {
    if ((edge.line.a - middle).norm() > 0.6 * kDiameter) continue;
    borders.insert(edge.border);
    strips.insert(edge.facet);
    length += (edge.line.b - edge.line.a).norm();
  }
  EXPECT_NEAR(length / (std::numbers::pi * kDiameter), 1.0, 2e-3);
  EXPECT_GT(strips.size(), 3U);
  EXPECT_EQ(borders.size(), 1U);
  EXPECT_EQ(border_lengths(facets).size(), 9U);
}

TEST(Facets, LieInThePlaneOfTheRootUntilTheyAreFolded) {
  const Sheet sheet = box();
  const auto [layout, pattern] = laid(sheet);
  const Facets facets = facets_of(sheet, layout);
  for (const Eigen::Isometry3d& motion : folded(facets, 0.0))
    EXPECT_LT((motion.matrix() - facets.root.matrix()).norm(), 1e-9);
}

TEST(Facets, AreHingedWhereTheSheetIs) {
  for (const auto& [name, sheet] : named_samples()) {
    const auto [layout, pattern] = laid(sheet);
    const Box2 box = bounds(pattern.outer.loop);
    for (const Facet& facet : facets_of(sheet, layout).facets) {
      if (!facet.parent) continue;
      for (const Vec2& p : {facet.hinge.a, facet.hinge.b})
        EXPECT_TRUE(((p - box.lo).array() > -1e-6).all() && ((box.hi - p).array() > -1e-6).all())
            << name;
      EXPECT_GT((facet.hinge.b - facet.hinge.a).norm(), 0.0) << name;
    }
  }
}

TEST(Facets, OfATubeCloseToItsCircle) {
  const Sheet sheet = rolled();
  const auto [layout, pattern] = laid(sheet);
  const Facets facets = facets_of(sheet, layout);
  const auto motions = folded(facets);
  const auto& cylinder = std::get<Cylinder>(std::get<Developable>(sheet.faces.front().surface));
  const double depth = 0.5 * sheet.thickness - sheet.reference_depth;
  const double radius = cylinder.radius - sheet.faces.front().sense * depth;
  for (std::size_t i = 0; i < facets.facets.size(); ++i)
    for (const Polygon& polygon : facets.facets[i].polygons)
      for (const Vec2& p : polygon.outer)
        EXPECT_NEAR(cylinder.frame.local2(placed(motions[i], p)).norm(), radius, 0.1);
}

}  // namespace
}  // namespace planish::test
