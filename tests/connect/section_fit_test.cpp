#include "sample_fits.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

using std::numbers::pi;

/// A section behind edge 2 of a plate of 200 × 100, or of its own.
struct Section {
  PlacedPlate plate = laid(rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}));
  FitTask task;
  Section(BendRequest request, bool on_plate) {
    task.request = std::move(request);
    task.thickness = 2.0;
    task.pointer = "/bends/0";
    if (!on_plate) return;
    task.plates[0] = &plate;
    if (!task.request.edges[0]) task.request.edges[0] = {2};
  }
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;
};

BendFit fit(const Section& section) {
  auto made = fit_section(section.task, {});
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? std::move(*made) : BendFit{};
}

TEST(FitSection, CurvesOnTangentiallyBehindAnEdge) {
  for (const double degrees : {90.0, -90.0}) {
    const Section section({.inside_radius = 30.0, .angle = Angle::degrees(degrees)}, true);
    const BendFit made = fit(section);
    EXPECT_NEAR(std::get<Cylinder>(made.surface.mid).radius, 31.0, 1e-12);
    EXPECT_NEAR(made.surface.sweep, pi / 2, 1e-12);
    const double v = made.boundaries.low.v[0];
    const Vec3 begin = point_on(made.surface.mid, {made.surface.azimuth(0), v});
    EXPECT_NEAR(begin.y(), 100.0, 1e-10);
    EXPECT_NEAR(begin.z(), 0.0, 1e-10);
    // A quarter further it stands upright, up or down.
    const Vec3 end = point_on(made.surface.mid, {made.surface.azimuth(1), v});
    EXPECT_NEAR(end.y(), 131.0, 1e-10);
    EXPECT_NEAR(end.z(), degrees > 0 ? 31.0 : -31.0, 1e-10);
    EXPECT_NEAR(made.boundaries.high.v[0] - made.boundaries.low.v[0], 200.0, 1e-10);
  }
}

TEST(FitSection, RollsAConeBehindAnEdge) {
  const Section section({.inside_radii = std::array{20.0, 40.0}, .angle = Angle::degrees(90)},
                        true);
  const BendFit made = fit(section);
  EXPECT_EQ(made.report.kind, BendKind::cone);
  EXPECT_NEAR(made.surface.tan_half_angle, 20.0 / 200, 1e-12);
  EXPECT_NEAR(made.surface.radius(made.boundaries.low.v[0]), 21.0, 1e-10);
  EXPECT_NEAR(made.surface.radius(made.boundaries.high.v[0]), 41.0, 1e-10);
  // Edge 2 runs from (200, 100) to (0, 100): the first radius is at x = 200.
  const double u = made.surface.azimuth(0);
  EXPECT_LT((point_on(made.surface.mid, {u, made.boundaries.low.v[0]}) - Vec3(200, 100, 0)).norm(),
            1e-9);
  EXPECT_LT((point_on(made.surface.mid, {u, made.boundaries.high.v[0]}) - Vec3(0, 100, 0)).norm(),
            1e-9);
}

TEST(FitSection, RollsAPipeAboutTheOrigin) {
  const Section section({.inside_radius = 49.0, .angle = Angle::degrees(360), .length = 300.0},
                        false);
  const BendFit made = fit(section);
  EXPECT_DOUBLE_EQ(made.surface.sweep, 2 * pi);
  for (const double u : {0.0, 1.0, 4.0})
    EXPECT_NEAR(point_on(made.surface.mid, {u, 10.0}).head<2>().norm(), 50.0, 1e-12);
  EXPECT_NEAR(made.boundaries.high.v[0] - made.boundaries.low.v[0], 300.0, 1e-12);
}

TEST(FitSection, RollsAFrustumWhoseRadiiAreCirclesOfItsInside) {
  const Section section(
      {.inside_radii = std::array{60.0, 30.0}, .angle = Angle::degrees(360), .length = 100.0},
      false);
  const BendFit made = fit(section);
  const Cone& cone = std::get<Cone>(made.surface.mid);
  EXPECT_NEAR(cone.half_angle, std::atan(0.3), 1e-12);
  // Half a thickness inwards along the normal lie the circles that were given, 100 apart.
  std::array<Vec3, 2> ends{point_on(made.surface.mid, {0.5, made.boundaries.low.v[0]}, -1.0),
                           point_on(made.surface.mid, {0.5, made.boundaries.high.v[0]}, -1.0)};
  EXPECT_NEAR(ends[0].head<2>().norm(), 30.0, 1e-9);
  EXPECT_NEAR(ends[1].head<2>().norm(), 60.0, 1e-9);
  EXPECT_NEAR(std::abs(ends[0].z() - ends[1].z()), 100.0, 1e-9);
}

TEST(FitSection, RefusesWhatDoesNotSayEnough) {
  const auto where = [](BendRequest request, bool on_plate) {
    const Section section(std::move(request), on_plate);
    const auto made = fit_section(section.task, {});
    EXPECT_FALSE(made);
    return made ? "" : made.error().where;
  };
  const Angle quarter = Angle::degrees(90);
  EXPECT_EQ(where({.inside_radius = 30.0}, true), "/bends/0/angle");
  EXPECT_EQ(where({.inside_radius = 30.0, .angle = Angle::degrees(361)}, true), "/bends/0/angle");
  EXPECT_EQ(where({.angle = quarter}, true), "/bends/0/inside_radius");
  EXPECT_EQ(where({.inside_radius = 30.0, .angle = quarter}, false), "/bends/0/length");
  EXPECT_EQ(where({.inside_radius = 1e-4, .angle = quarter}, true), "/bends/0/inside_radius");
  EXPECT_EQ(where({.edges = {std::vector{1, 2}}, .inside_radius = 30.0, .angle = quarter}, true),
            "/bends/0/edges");
}

TEST(FitSection, RefusesAnEdgeThatAnotherBendUses) {
  Section section({.inside_radius = 30.0, .angle = Angle::degrees(90)}, true);
  section.task.taken[0].whole = {2};
  EXPECT_EQ(fit_section(section.task, {}).error().code, code::unknown_edge);
}

}  // namespace
}  // namespace planish::test
