#include "bend_facets.hpp"

#include "support/sheets.hpp"

#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>

#include <cmath>

// The bend of a strip along x, from x = 50 on, cut into facets of 10°.

namespace planish::test {
namespace {

using sheet_detail::BendFacets;

struct Faceted {
  Sheet sheet;
  Layout layout;
  FacetOptions options;
};

Faceted faceted(BendDirection direction, double chord = 10.0) {
  Sheet sheet = strip({Straight{50}, Turn{Angle::degrees(90), 3.0, direction}, Straight{30}}, 40,
                      2);
  FlattenOptions options;
  options.allowance = ConstantK{0.4, "test"};
  options.root = FaceId{0};
  Layout layout = *lay_out(sheet, options);
  return {std::move(sheet), std::move(layout), {.chord = chord, .most = Angle::degrees(10)}};
}

const double kBendLength = std::acos(0.0) * 3.8;

TEST(BendFacets, AreAsManyAsTheTurnTakes) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const Faceted f = faceted(direction);
    const BendFacets facets(f.sheet, f.layout, BendId{0}, f.options);
    ASSERT_EQ(facets.count(), 9);
    for (int i = 0; i <= 9; ++i) {
      // Rulings run towards growing v, which may be either way along y.
      const Segment ruling = facets.ruling(i);
      double near = 1e9;
      for (int k = 0; k <= 9; ++k)
        near = std::min(near, std::abs(ruling.a.x() - (50 + kBendLength * k / 9)));
      EXPECT_LT(near, 1e-9);
      EXPECT_NEAR((ruling.b - ruling.a).norm(), 40, 1e-9);
      EXPECT_NEAR(ruling.a.x(), ruling.b.x(), 1e-9);
    }
  }
}

TEST(BendFacets, AreMoreWhereTheChordsMustComeNearer) {
  // Over an angle a the chord of an arc deviates by R (1 − cos a/2).
  const double chord = 0.002, radius = 3.8;
  const Faceted f = faceted(BendDirection::up, chord);
  const BendFacets facets(f.sheet, f.layout, BendId{0}, f.options);
  const double wanted = std::acos(0.0) / (2 * std::acos(1 - chord / radius));
  EXPECT_EQ(facets.count(), static_cast<int>(std::ceil(wanted)));
  EXPECT_GT(facets.count(), 9);
}

TEST(BendFacets, TurnTheNormalAboutTheRulingBetweenThem) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const Faceted f = faceted(direction);
    const BendFacets facets(f.sheet, f.layout, BendId{0}, f.options);
    const Face& face = f.sheet[f.sheet[BendId{0}].faces.front()];
    for (int i = 0; i + 1 < facets.count(); ++i) {
      const double turn = facets.turn(i, i + 1);
      EXPECT_NEAR(std::abs(turn), 10 * std::acos(-1.0) / 180, 1e-9);
      EXPECT_NEAR(facets.turn(i + 1, i), -turn, 1e-12);
      const Eigen::AngleAxisd about(turn, ruling_on(std::get<Developable>(face.surface), 0.1));
      EXPECT_LT((about * facets.normal(i) - facets.normal(i + 1)).norm(), 1e-9);
    }
  }
}

TEST(BendFacets, LieInSpaceOnTheSurfaceOrBelowIt) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const Faceted f = faceted(direction);
    const BendFacets facets(f.sheet, f.layout, BendId{0}, f.options);
    const FaceId face = f.sheet[BendId{0}].faces.front();
    const double way = direction == BendDirection::up ? 1.0 : -1.0;
    const double radius = direction == BendDirection::up ? 3.0 : 5.0;
    for (int strip = 0; strip < facets.count(); ++strip)
      for (const double depth : {0.0, 0.7}) {
        const Eigen::Isometry3d space = facets.in_space(strip, depth);
        const Segment a = facets.ruling(strip), b = facets.ruling(strip + 1);
        const Vec2 flat = 0.25 * (a.a + a.b + b.a + b.b);
        // From the start of the bend, where the strip leaves z = 0, by its share of the turn.
        const double turned = std::acos(0.0) * (flat.x() - 50) / kBendLength;
        const Vec3 normal(-way * std::sin(turned), 0, std::cos(turned));
        const Vec3 axis(50, flat.y(), way * radius);
        const Vec3 middle = axis - way * radius * normal;
        EXPECT_LT((space * Vec3(flat.x(), flat.y(), 0) - (middle - depth * normal)).norm(), 1e-9);
        EXPECT_LT((space.linear() * Vec3::UnitZ() - normal).norm(), 1e-9);
        EXPECT_LT((space.linear() * Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-9);
        EXPECT_NEAR(space.linear().determinant(), 1.0, 1e-12);
        EXPECT_LT((facets.normal(strip) - normal).norm(), 1e-9);
      }
    EXPECT_EQ(f.sheet[face].sense > 0, direction == BendDirection::down);
  }
}

TEST(BendFacets, CoverTheBendAndKnowItsEdges) {
  const Faceted f = faceted(BendDirection::up);
  BendFacets facets(f.sheet, f.layout, BendId{0}, f.options);
  const FaceId face = f.sheet[BendId{0}].faces.front();
  // Borders 0 and 2 run along the flanges.
  facets.add_loop(face, 0, {true, false, true, false});
  facets.close();
  ASSERT_EQ(facets.borders().size(), 2u);
  EXPECT_EQ(facets.borders()[1].border.border, 3);
  for (int strip = 0; strip < facets.count(); ++strip) {
    ASSERT_EQ(facets.polygons(strip).size(), 1u);
    EXPECT_NEAR(ring_area(facets.polygons(strip).front().outer), 40 * kBendLength / 9, 1e-9);
    ASSERT_EQ(facets.edges(strip).size(), 2u);
    for (const BendFacets::Edge& edge : facets.edges(strip)) {
      EXPECT_NEAR((edge.line.b - edge.line.a).norm(), kBendLength / 9, 1e-9);
      EXPECT_NEAR(edge.line.a.y(), edge.line.b.y(), 1e-9);
    }
    EXPECT_NE(facets.edges(strip)[0].border, facets.edges(strip)[1].border);
  }
}

TEST(BendFacets, LeaveOutARoundHole) {
  const double diameter = 4.0;
  const Sheet sheet = hole_in_bend(diameter, 0.4);
  FlattenOptions options;
  options.allowance = ConstantK{0.4, "test"};
  options.root = FaceId{0};
  const Layout layout = *lay_out(sheet, options);
  BendFacets facets(sheet, layout, BendId{0}, {.chord = 0.001, .most = Angle::degrees(10)});
  const FaceId face = sheet[BendId{0}].faces.front();
  for (int loop = 0; loop < std::ssize(sheet[face].loops); ++loop)
    facets.add_loop(face, loop, std::vector<bool>(sheet[face].loops[loop].size(), false));
  facets.close();
  const double whole = std::acos(0.0) * (4.0 + 0.4 * 2.0) * 60;
  double area = 0.0, rim = 0.0;
  for (int strip = 0; strip < facets.count(); ++strip) {
    for (const Polygon& polygon : facets.polygons(strip))
      area += ring_area(polygon.outer);
    for (const BendFacets::Edge& edge : facets.edges(strip)) {
      if (facets.borders()[edge.border].border.loop == 0) continue;
      rim += (edge.line.b - edge.line.a).norm();
      EXPECT_LE(
          0.5 * diameter - (0.5 * (edge.line.a + edge.line.b) - Vec2(40 + whole / 120, 30)).norm(),
          0.0011);
    }
  }
  const double hole = std::acos(-1.0) * diameter * diameter / 4;
  EXPECT_GT(area, whole - hole - 1e-6);
  EXPECT_LT(area, whole - hole + 0.001 * std::acos(-1.0) * diameter);
  EXPECT_NEAR(rim, std::acos(-1.0) * diameter, 0.01);
}

TEST(BendFacets, AtARulingAreThoseOnTheSideOfTheFace) {
  const Faceted f = faceted(BendDirection::up);
  const BendFacets facets(f.sheet, f.layout, BendId{0}, f.options);
  const FaceId face = f.sheet[BendId{0}].faces.front();
  const Box2 box = parameter_box(f.sheet[face]);
  const auto beside = [&](double share) {
    return facets.beside(face, std::lerp(box.lo.x(), box.hi.x(), share));
  };
  EXPECT_EQ(beside(0.0), 0);
  EXPECT_EQ(beside(2.0 / 9), 2);
  EXPECT_EQ(beside(7.0 / 9), 6);
  EXPECT_EQ(beside(1.0), 8);
  EXPECT_EQ(beside(2.5 / 9), 2);
}

}  // namespace
}  // namespace planish::test
