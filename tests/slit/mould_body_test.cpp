#include "sample_sheets.hpp"
#include "support/closed_mesh.hpp"

#include <planish/geometry/region.hpp>
#include <planish/slit/mould.hpp>

#include <cmath>
#include <numeric>
#include <set>

// The mould as one body: ribs, walls behind the panels, a plate.

namespace planish::test {
namespace {

Mould body(const FoldedSlitSheet& folded, MouldOptions options = {}) {
  options.form = MouldForm::body;
  auto result = mould_of(folded, options);
  if (!result) throw std::runtime_error(result.error().message + " at " + result.error().where);
  return *result;
}

/// Connected parts, by shared points.
std::size_t parts_in(const Mesh& mesh) {
  std::vector<int> root(mesh.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&](int point) {
    while (root[point] != point)
      point = root[point];
    return point;
  };
  for (const auto& t : mesh.triangles)
    for (const int other : {t[1], t[2]})
      root[root_of(other)] = root_of(t[0]);
  std::set<int> roots;
  for (const auto& t : mesh.triangles)
    roots.insert(root_of(t[0]));
  return roots.size();
}

/// Prisms below the facets, walls and the plate, from their sizes.
double volume_from_parts(const Mould& mould, double base) {
  double sum = 0.0;
  Box2 box;
  for (const MouldRib& rib : mould.ribs) {
    for (const Vec2& p : rib.footprint)
      box.add(p);
    for (const auto& facet : rib.facets)
      for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        const Vec3 p = mould.base.local(facet[a]), q = mould.base.local(facet[b]),
                   r = mould.base.local(facet[c]);
        const Vec2 u = (q - p).head<2>(), v = (r - p).head<2>();
        sum += 0.5 * std::abs(u.x() * v.y() - u.y() * v.x()) *
               ((p.z() + q.z() + r.z()) / 3.0 - 0.5 * base);
      }
  }
  for (const MouldWall& wall : mould.walls) {
    for (const Vec2& p : wall.footprint)
      box.add(p);
    sum += ring_area(wall.footprint) *
           (wall.top - mould.base.origin.dot(mould.base.z) - 0.5 * base);
  }
  const Vec2 size = box.hi - box.lo;
  return sum + (size.x() + 2.0 * base) * (size.y() + 2.0 * base) * 0.5 * base;
}

/// An upright panel 100 high at x = 0, and a strip that leaves it level for 200, in two quads.
FoldedSlitSheet bracket() {
  FoldedSlitSheet folded;
  folded.thickness = 6.0;
  folded.reach = 300.0;
  folded.symmetric = false;
  PanelFacet facet{{Vec2(0, 0), Vec2(100, 0), Vec2(100, 50), Vec2(0, 50)}, {}, 0};
  facet.frame.x = Vec3::UnitY();
  facet.frame.y = Vec3::UnitZ();
  facet.frame.z = Vec3::UnitX();
  folded.panel = {facet};
  Frame quad;
  quad.x = -Vec3::UnitX();
  quad.y = Vec3::UnitZ();
  quad.z = Vec3::UnitY();
  quad.origin = Vec3(100, 100, 0);  // at along 100 it is at x = 0
  FoldedStrip strip;
  for (const double along : {100.0, 180.0, 300.0})
    strip.ridges.push_back({{Vec2(along, 0), Vec2(along, 50)},
                            {quad.point({along, 0}), quad.point({along, 50})},
                            Angle()});
  strip.quads = {quad, quad};
  folded.strips = {strip};
  return folded;
}

TEST(MouldBody, OfABracketIsAWallABlockAndAPlate) {
  const Mould mould = body(bracket(), {.base = 30.0, .inset = 4.0});
  // The wall takes the place of a rib under the first quad. The plate is 15 thick, its top 15 below
  // the panel's edge; all stands up to the skin of the strip, at 97.
  ASSERT_EQ(mould.ribs.size(), 1u);
  ASSERT_EQ(mould.walls.size(), 1u);
  EXPECT_NEAR(mould.base.origin.y(), -30.0, 1e-9);
  EXPECT_NEAR(ring_area(mould.walls[0].footprint), 30.0 * 50.0, 1e-9);
  EXPECT_NEAR(mould.walls[0].top, 97.0, 1e-9);
  EXPECT_NEAR(mould.volume, 120 * 42 * 112.0 + 30 * 50 * 112.0 + (197 + 60) * (50 + 60) * 15.0,
              1e-6);
  expect_closed(*mould.body);
  EXPECT_EQ(parts_in(*mould.body), 1u);
  ASSERT_EQ(mould.bare.size(), 1u);
  EXPECT_EQ(mould.bare[0].quad, 0);
}

TEST(MouldBody, OfAChairHasBothSidePanels) {
  const Mould mould = body(solved(chair(), 1).folded());
  EXPECT_EQ(mould.walls.size(), 2u);
  for (const MouldWall& wall : mould.walls) {
    // The mould leans within the panels' planes, so that their free edges are seen shortened.
    EXPECT_NEAR(ring_area(wall.footprint), 20.0 * 360.0 * mould.base.z.y(), 1e-6);
    for (const Vec2& p : wall.footprint) {
      const double x = std::abs(mould.base.point(p).x());
      EXPECT_TRUE(std::abs(x - 358.0) < 1e-9 || std::abs(x - 338.0) < 1e-9) << x;
    }
  }
  expect_closed(*mould.body);
  EXPECT_EQ(parts_in(*mould.body), 1u);
  EXPECT_NEAR(mould.volume / volume_from_parts(mould, 20.0), 1.0, 1e-9);
}

TEST(MouldBody, GoesOnUnderPanelsThatAreLevel) {
  SlitDesign design = chair();
  design.leg_curve = {{{700, 0}, {700, 360}}};
  design.lean = Angle::degrees(90);
  design.sheet.half_length = 460.0;
  design.seat_curve = BezierCurve{{{330, 0}, {330, 360}}};
  const FoldedSlitSheet folded = solved(design, 1).folded();
  const Mould mould = body(folded);
  EXPECT_TRUE(mould.walls.empty());
  std::set<int> under_panel;
  for (const MouldRib& rib : mould.ribs) {
    if (rib.first_quad != -1) continue;
    under_panel.insert(rib.strip);
    for (const Vec3& corner : {rib.facets[0][0], rib.facets[0][3]}) {
      EXPECT_NEAR(corner.y(), -2.0, 1e-9);  // half the thickness below the ground
      EXPECT_NEAR(corner.x(), 700.0, 1e-9);
    }
  }
  EXPECT_EQ(under_panel.size(), 6u);
  expect_closed(*mould.body);
  EXPECT_EQ(parts_in(*mould.body), 1u);
  EXPECT_NEAR(mould.volume / volume_from_parts(mould, 20.0), 1.0, 1e-9);
}

TEST(MouldBody, StandsUprightBehindBothPanelsOfASheetThatIsNotSymmetric) {
  SlitDesign design = arcade();
  design.second_panel->height = 150.0;
  const Mould mould = body(solved(design, 1).folded(), {.up = Vec3::UnitY()});
  EXPECT_EQ(mould.walls.size(), 2u);
  expect_closed(*mould.body);
  EXPECT_EQ(parts_in(*mould.body), 1u);
  EXPECT_NEAR(mould.volume / volume_from_parts(mould, 20.0), 1.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
