#include "ruled_patch.hpp"
#include "sample_rings.hpp"

#include <planish/geometry/curve.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace planish::test {
namespace {

using namespace transition_detail;

Vec3 in_space(const Face& face, const Curve2& curve, double t) {
  return skin_point(face, point_at(curve, t));
}

/// Borders follow each other, those on rulings run along them, and all are as long as in space.
void expect_framed_by_rulings(const RuledPatch& patch, double from, double to) {
  const RuledPatch::Part part = patch.part(from, to, {});
  ASSERT_EQ(part.face.loops.size(), 1u);
  const BorderLoop& loop = part.face.loops[0];
  for (std::size_t i = 0; i < loop.size(); ++i)
    EXPECT_LT((end_of(loop[i].curve) - start_of(loop[(i + 1) % loop.size()].curve)).norm(), 1e-10);
  const auto [p1, q1] = patch.ruling(to);
  const Border& last = loop[part.ruling_borders[1]];
  EXPECT_LT((in_space(part.face, last.curve, 0.0) - p1).norm(), 1e-7);
  EXPECT_LT((in_space(part.face, last.curve, 1.0) - q1).norm(), 1e-7);
  EXPECT_NEAR(last.edge_length.value(), (q1 - p1).norm(), 1e-7);
  const auto [p0, q0] = patch.ruling(from);
  const Border& first = loop[part.ruling_borders[0]];
  EXPECT_LT((in_space(part.face, first.curve, 0.0) - q0).norm(), 1e-7);
  EXPECT_LT((in_space(part.face, first.curve, 1.0) - p0).norm(), 1e-7);
}

TEST(PatchPart, IsAFaceBetweenItsRulings) {
  for (const Ring& ring :
       {frustum(), square_to_circle(), pyramid(), antiprism(),
        ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80})})
    for (const RuledPatch& patch : ring.patches) {
      expect_framed_by_rulings(patch, 0.0, 1.0);
      expect_framed_by_rulings(patch, 0.2, 0.7);
    }
}

TEST(PatchPart, LiesOnTheRulings) {
  for (const Ring& ring :
       {frustum(), square_to_circle(),
        ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80})})
    for (const RuledPatch& patch : ring.patches) {
      if (patch.plane()) continue;
      const RuledPatch::Part part = patch.part(0.1, 0.9, {});
      const auto& surface = std::get<Developable>(part.face.surface);
      for (const double at : {0.1, 0.35, 0.8}) {
        const auto [p, q] = patch.ruling(at);
        const Vec3 line = ruling_on(surface, part.u(at)), on = point_on(surface, {part.u(at), 0.0});
        EXPECT_LT((p - on).cross(line).norm(), 1e-7);
        EXPECT_LT((q - on).cross(line).norm(), 1e-7);
        EXPECT_GT(normal_on(surface, part.u(at)).dot(patch.normal(at)), 1.0 - 1e-9);
      }
    }
}

TEST(PatchPart, OfAPlaneLeavesOutASideThatStands) {
  for (const RuledPatch& patch : antiprism().patches)
    EXPECT_EQ(patch.part(0.0, 1.0, {}).face.loops[0].size(), 3u);
  EXPECT_EQ(pyramid().patch(0).part(0.0, 1.0, {}).face.loops[0].size(), 4u);
}

TEST(PatchPart, OfAPlaneLosesItsTips) {
  const RuledPatch patch = pyramid().patch(0);
  const RuledPatch::Tips tips{.at_from = {2.0, 0.0}, .at_to = {3.0, 0.0}};
  const RuledPatch::Part part = patch.part(0.0, 1.0, tips);
  ASSERT_EQ(part.face.loops[0].size(), 6u);
  Loop loop;
  for (const Border& border : part.face.loops[0])
    loop.push_back(border.curve);
  EXPECT_NEAR(signed_area(loop), patch.area(0.0, 1.0) - patch.tip_area(0.0, 1.0, tips), 1e-9);
  const double cut = length(part.face.loops[0][part.ruling_borders[0]].curve);
  const auto [p, q] = patch.ruling(0.0);
  EXPECT_NEAR(cut, (q - p).norm() - 2.0, 1e-10);
}

TEST(PatchPart, OfAConeLosesItsApex) {
  const Ring ring = square_to_circle();
  for (const RuledPatch& patch : ring.patches) {
    if (patch.plane()) continue;
    const RuledPatch::Part part = patch.part(0.0, 1.0,
                                             {.at_from = {4.0, 0.0}, .at_to = {4.0, 0.0}});
    const auto [p, q] = patch.ruling(0.0);
    const Border& ruling = part.face.loops[0][part.ruling_borders[0]];
    EXPECT_NEAR(length(ruling.curve), (q - p).norm() - 4.0, 1e-9);
    for (const Border& border : part.face.loops[0])
      for (const double t : {0.0, 0.5, 1.0})
        EXPECT_GT((in_space(part.face, border.curve, t) - p).norm(), 4.0 - 1e-8);
  }
}

/// Length of a border in space, by chords.
double length_in_space(const Face& face, const Curve2& curve) {
  constexpr int kChords = 2000;
  double sum = 0.0;
  for (int i = 0; i < kChords; ++i)
    sum += (in_space(face, curve, (i + 1.0) / kChords) - in_space(face, curve, i / double(kChords)))
               .norm();
  return sum;
}

/// The four cones of a rectangle and a circle above one of its corners: one is a right cone.
Ring cornered() {
  return ring_between(PolygonProfile{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}},
                      EllipseProfile{30, 30}, {0, 0, 80});
}

TEST(PatchPart, KnowsTheLengthsOfItsBordersAlsoWithoutItsTips) {
  int right = 0;
  for (const Ring& ring :
       {frustum(), square_to_circle(), cornered(), pyramid(), antiprism(),
        ring_between(EllipseProfile{30, 20}, rectangle(200, 60), {25, 10, 80}),
        ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80})})
    for (const RuledPatch& patch : ring.patches) {
      right += patch.bend_kind() == BendKind::cone && !patch.plane();
      // Curved patches lose what is at their apex, planes at each corner.
      RuledPatch::Tips tips;
      for (const std::size_t side : {0u, 1u})
        if (patch.plane() || patch.stands(static_cast<int>(side)))
          tips.at_from[side] = tips.at_to[side] = 3.0;
      for (const auto& [from, to] : {std::pair{0.0, 1.0}, std::pair{0.2, 0.7}})
        for (const RuledPatch::Tips& cut : {RuledPatch::Tips{}, tips}) {
          const RuledPatch::Part part = patch.part(from, to, cut);
          for (const Border& border : part.face.loops[0]) {
            // The arc that is left about an apex stands for a point, which has no length.
            if (*border.edge_length == 0.0) continue;
            EXPECT_NEAR(*border.edge_length / length_in_space(part.face, border.curve), 1.0, 1e-5);
          }
        }
    }
  EXPECT_EQ(right, 2) << "the frustum, and the cone above a corner";
}

TEST(PatchPart, OfARightConeLosesItsApex) {
  const PolygonProfile rectangle{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
  for (const std::size_t side : {0u, 1u}) {  // on which the apex lies
    const Ring ring = side == 0 ? cornered()
                                : ring_between(EllipseProfile{30, 30}, rectangle, {0, 0, 80});
    const auto cone = std::ranges::find_if(ring.patches, [](const RuledPatch& patch) {
      return !patch.plane() && patch.bend_kind() == BendKind::cone;
    });
    ASSERT_NE(cone, ring.patches.end());
    const double slant = std::hypot(80, 30);
    RuledPatch::Tips tips;
    tips.at_from[side] = tips.at_to[side] = 4.0;
    tips.at_from[1 - side] = tips.at_to[1 - side] = 2.0;  // no corner: nothing is cut there
    const RuledPatch::Part part = cone->part(0.25, 1.0, tips);
    const auto& loop = part.face.loops[0];
    for (const int ruling : part.ruling_borders)
      EXPECT_NEAR(*loop[ruling].edge_length, slant - 4.0, 1e-9);
    EXPECT_NEAR(part.u(0.25), part.u0, 1e-12);
    EXPECT_NEAR(part.u(1.0), part.u1, 1e-12);
    EXPECT_NEAR(std::abs(part.u1 - part.u0), 0.75 * 0.5 * kPi, 1e-12);
    const Vec3 apex = cone->ruling(0.25)[side];
    for (const Border& border : loop)
      for (const double t : {0.0, 0.5, 1.0})
        EXPECT_GT((in_space(part.face, border.curve, t) - apex).norm(), 4.0 - 1e-8) << side;
  }
}

/// Tips of 55 % of an edge: room is only needed beside folds, so that of rulings all is cut.
TEST(PatchPart, OfAPlaneLosesNoMoreThanFortyHundredthsOfAnEdge) {
  std::vector<RuledPatch> planes = antiprism().patches;
  planes.push_back(pyramid().patch(0));
  for (const RuledPatch& patch : planes)
    for (const int side : {0, 1}) {
      if (patch.stands(side)) continue;
      const double edge = patch.border_length(side, 0.0, 1.0);
      RuledPatch::Tips tips;
      tips.at_from[side] = tips.at_to[side] = 0.55 * edge;
      const RuledPatch::Part part = patch.part(0.0, 1.0, tips);
      const BorderLoop& loop = part.face.loops[0];
      EXPECT_TRUE(std::ranges::any_of(loop, [&](const Border& border) {
        return std::abs(*border.edge_length - 0.2 * edge) < 1e-9;
      })) << "a fifth is left";
      for (const std::size_t end : {0u, 1u}) {
        const auto [p, q] = patch.ruling(double(end));
        EXPECT_NEAR(*loop[part.ruling_borders[end]].edge_length, (q - p).norm() - 0.55 * edge,
                    1e-9);
      }
    }
}

}  // namespace
}  // namespace planish::test
