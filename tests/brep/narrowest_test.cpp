#include "narrowest.hpp"

#include "form_volume.hpp"
#include "recognised.hpp"

#include <planish/geometry/curve.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

/// What is seen of the opening of a 2 mm plate whose walls are no plain cut.
struct SeenOpening {
  Recognised model;
  std::optional<BorderLoop> section;
  double intrusion = 0.0;
};
SeenOpening opening_in(SolidModel model, int reference) {
  SeenOpening seen{recognised(std::move(model), 2, reference), {}, 0.0};
  const Recognition of = seen.model.view();
  for (const RimPart& part : of.rim.parts) {
    const auto& here = loops_here(of, part);
    if (here.size() != 1 || !opening_in_plane(of, here.front())) continue;
    const auto& plane = std::get<Frame>(of.model.faces[here.front().face].surface);
    seen.section = narrowest_section(of, part, plane);
    if (seen.section) seen.intrusion = intrusion_into(of, part, plane, *seen.section);
  }
  return seen;
}

TEST(NarrowestSection, OfRoundHolesIsTheLeastOfTheirRadii) {
  // As paths (radius, height) from the top of a sheet of 2 mm.
  const std::vector<Vec2> paths[] = {{{4, 2}, {4, 0}},
                                     {{6, 2}, {4, 0}},
                                     {{4, 2}, {6, 0}},
                                     {{5, 2}, {4, 1}, {6, 0}},
                                     {{5, 2}, {4, 1.2}, {4, 0.5}, {6, 0}},
                                     {{8, 2}, {8, 1.3}, {4, 1.3}, {4, 0.7}, {7, 0.7}, {7, 0}},
                                     {{9, 2}, {9, 1.6}, {7, 1.6}, {7, 1.0}, {4, 1.0}, {4, 0}},
                                     {{4, 2}, {4, 1.5}, {6, 1.5}, {6, 0.5}, {5, 0.5}, {5, 0}},
                                     {{5, 2}, {5, 1.5}, {6, 1.5}, {6, 0.5}, {4, 0.5}, {4, 0}}};
  for (const auto& path : paths)
    for (const int reference : {kTop, kBottom}) {
      const SeenOpening seen = opening_in(plate(2, {100, 60}, {{{30, 30}, path}}), reference);
      ASSERT_TRUE(seen.section) << path.size() << " points from " << path.front().transpose();
      EXPECT_NEAR(loop_area(*seen.section), pi * 16, 1e-8) << path.front().transpose();
      EXPECT_LT(std::get<Arc>(seen.section->front().curve).sweep, 0.0) << "openings run clockwise";
      EXPECT_NEAR(seen.intrusion, 0.0, 1e-9);
    }
}

TEST(NarrowestSection, OfAWindowThatIsChamferedUnevenlyIsItsLand) {
  const auto land = clockwise(rectangle_at({40, 20}, {60, 40}));
  const auto above = clockwise(rectangle_at({39.6, 19.6}, {60.4, 40.4}));
  const auto below = clockwise(rectangle_at({39, 19}, {61, 41}));
  const auto outer = rectangle_at({0, 0}, {100, 60});
  for (const int reference : {kTop, kBottom}) {
    const SeenOpening seen = opening_in(
        plate(2, {{{outer, outer}, {0, 2}}, {{below, land, land, above}, {0, 0.7, 1.5, 2}}}),
        reference);
    ASSERT_TRUE(seen.section);
    EXPECT_NEAR(loop_area(*seen.section), 400.0, 1e-8);
    ASSERT_EQ(seen.section->size(), 4u);
    for (const Border& border : *seen.section) {
      EXPECT_TRUE(border.edge);
      EXPECT_GT(border.edge_depth, 0.4);
      EXPECT_LT(border.edge_depth, 1.6);
    }
  }
}

TEST(NarrowestSection, IsNoneOfASlantedCut) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto low = clockwise(rectangle_at({40, 20}, {60, 40}));
  const auto high = clockwise(rectangle_at({41, 20}, {61, 40}));
  const SeenOpening seen = opening_in(plate(2, {{{outer, outer}, {0, 2}}, {{low, high}, {0, 2}}}),
                                      kTop);
  EXPECT_FALSE(seen.section);
}

TEST(IntrusionInto, IsHowFarWallsReachIntoACut) {
  const Recognised model = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {4, 1}, {6, 0}}}}),
                                      2, kTop);
  const Recognition of = model.view();
  for (const RimPart& part : of.rim.parts) {
    const auto& here = loops_here(of, part);
    if (!opening_in_plane(of, here.front())) continue;
    const auto& plane = std::get<Frame>(of.model.faces[here.front().face].surface);
    const Vec2 middle = plane.local2({30, 30, 2});
    const BorderLoop wide{{Arc{middle, 4.3, 0.0, -2 * pi}}};
    EXPECT_NEAR(intrusion_into(of, part, plane, wide), 0.3, 1e-9);
  }
}

TEST(BulgeBelow, FollowsACylinderAlongABorder) {
  // A bar with a round side towards y = 0: the axis lies 1 mm below the top, at y = 1.
  SolidMaker maker;
  const Frame left = frame_from_axes({0, 1, 1}, {1, 0, 0}, {0, 0, 1});
  const Frame right = frame_from_axes({20, 1, 1}, {1, 0, 0}, {0, 0, 1});
  const SpaceCurve front = line({0, 1, 2}, {20, 1, 2}), back = line({20, 1, 0}, {0, 1, 0});
  const int wall = maker.curved(Cylinder{left, 1.0}, 1,
                                {{front, arc(right, 1.0, 0.0, pi), back, arc(left, 1.0, pi, 0.0)}});
  Recognised model{std::move(maker).build_open(), {}, {}, {}, {}, Skin::first};
  model.outlines = outlines_of(model.model);
  model.rim.part_of = {0};
  const Frame top = frame_from_axes({0, 0, 2}, {0, 0, 1}, {1, 0, 0});
  const Border border{Segment{{0, 1}, {20, 1}}, 1};
  const auto bulge = bulge_below(model.view(), wall, top, border);
  ASSERT_TRUE(bulge);
  EXPECT_NEAR(start_of(bulge->curve).y(), 0.0, 1e-12);
  EXPECT_NEAR(end_of(bulge->curve).x(), 20.0, 1e-12);
  EXPECT_NEAR(bulge->edge_depth, 1.0, 1e-12);
  EXPECT_FALSE(bulge->edge) << "it lies on no edge";
}

}  // namespace
}  // namespace planish::brep::test
