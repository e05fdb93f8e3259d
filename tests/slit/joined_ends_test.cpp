#include "joined_ends.hpp"

#include "sample_sheets.hpp"

#include <planish/slit/slit_curves.hpp>

#include <cmath>

// Uncut sheet beyond slits that end in the middle of it: which strips it joins, its facets, and how
// they move.

namespace planish::test {
namespace {

using namespace slit_detail;

/// Five strips; all slits but the third end early, at different places.
SlitSheet joined_sheet() {
  SlitSheet sheet = chair().sheet;
  CurvedSlits curves;
  curves.width = 300.0;
  const std::array<double, 4> ends{820.0, 850.0, 884.0, 800.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const double across = 60.0 * (static_cast<double>(i) + 1.0);
    curves.slits.push_back({{420.0, across}, {ends[i], across}});
  }
  auto strips = strips_between(sheet, curves);
  if (!strips) throw std::runtime_error(strips.error().message);
  sheet.strips = *strips;
  return sheet;
}

JoinedEnds some_ends() {
  JoinedEnds joined{0, 2, {}, {0.3, -0.2}};
  joined.frame = frame_from_axes({120, -30, 55}, Vec3(0.3, -0.2, 0.9).normalized(), {1, 0.4, 0});
  return joined;
}

TEST(JoinedEnds, AreRunsOfStripsWhoseSlitsEndEarly) {
  const SlitSheet sheet = joined_sheet();
  EXPECT_EQ(joined_strips(sheet), (std::vector<std::pair<int, int>>{{0, 2}, {3, 4}}));
  EXPECT_TRUE(joined_strips(chair().sheet).empty());
  // Beside a slit that goes on, the last ridge runs straight across.
  EXPECT_EQ(sheet.ends_of(0), (std::array{820.0, 820.0}));
  EXPECT_EQ(sheet.ends_of(1), (std::array{820.0, 850.0}));
  EXPECT_EQ(sheet.ends_of(2), (std::array{850.0, 850.0}));
  EXPECT_EQ(sheet.ends_of(3), (std::array{800.0, 800.0}));
  EXPECT_EQ(sheet.reach(), 884.0);
  double area = 420.0 * 300.0;
  for (int strip = 0; strip < 5; ++strip)
    area += sheet.area_of(strip);
  for (const auto& [first, last] : joined_strips(sheet))
    for (const PanelFacet& facet :
         facets_of(sheet, {first, last, {}, std::vector<double>(last - first)}))
      area += slit_detail::area_of(facet);
  EXPECT_NEAR(area, 884.0 * 300.0, 1e-9);
}

TEST(JoinedEnds, ShareTheirBorders) {
  const SlitSheet sheet = joined_sheet();
  const auto facets = facets_of(sheet, some_ends());
  ASSERT_EQ(facets.size(), 3u);
  EXPECT_FALSE(facets[0].joined);
  for (std::size_t i = 0; i + 1 < facets.size(); ++i) {
    const PanelFacet &one = facets[i], &next = facets[i + 1];
    EXPECT_TRUE(next.joined);
    for (const Vec2& on : {one.corners[3], one.corners[2]})
      EXPECT_NEAR((one.frame.point(on) - next.frame.point(on)).norm(), 0.0, 1e-12 * 884);
    EXPECT_NEAR(std::acos(one.frame.z.dot(next.frame.z)), std::abs(some_ends().turns[i]), 1e-12);
    EXPECT_GT(some_ends().turns[i] * one.frame.y.dot(-next.frame.z), -1e-12);
    EXPECT_NEAR((next.frame.x.cross(next.frame.y) - next.frame.z).norm(), 0.0, 1e-14);
  }
}

/// A turn costs what an arc of that angle over half of both widths does.
TEST(JoinedEnds, TurnsCostTheEnergyOfTheirArea) {
  const SlitSheet sheet = joined_sheet();
  const double first = 0.3 / 60.0, second = -0.2 / 60.0;  // curvatures
  EXPECT_NEAR(turning_energy(sheet, some_ends()),
              0.5 * first * first * 60.0 * (884 - 820) + 0.5 * second * second * 60.0 * (884 - 850),
              1e-12);
}

TEST(JoinedEnds, MoveAsTheirMovesSay) {
  const SlitSheet sheet = joined_sheet();
  JoinedEnds level = some_ends();
  level.frame = {
      {884, 10, 40}, -Vec3::UnitX(), Vec3(0, 0.6, 0.8), -Vec3::UnitX().cross(Vec3(0, 0.6, 0.8))};
  for (const bool symmetric : {false, true}) {
    const JoinedEnds& joined = symmetric ? level : some_ends();
    const auto facets = facets_of(sheet, joined);
    const auto moves = moves_of(facets, symmetric);
    ASSERT_EQ(moves.size(), symmetric ? 5u : 8u);
    for (std::size_t k = 0; k < moves.size(); ++k) {
      Eigen::VectorXd step = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(moves.size()));
      const double small = 1e-6;
      step[static_cast<Eigen::Index>(k)] = small;
      const auto there = facets_of(sheet, moved(sheet, joined, symmetric, step)),
                 back = facets_of(sheet, moved(sheet, joined, symmetric, -step));
      for (std::size_t i = 0; i < facets.size(); ++i)
        for (const Vec2& corner : facets[i].corners) {
          const Vec3 rate = (there[i].frame.point(corner) - back[i].frame.point(corner)) /
                            (2.0 * small);
          const Vec3 expected = moves[k].from <= static_cast<int>(i)
                                    ? moves[k].at(facets[i].frame.point(corner))
                                    : Vec3(0, 0, 0);
          EXPECT_NEAR((rate - expected).norm(), 0.0, 1e-5) << k << ' ' << i;
          if (symmetric) {
            EXPECT_NEAR(there[i].frame.x.x(), -1.0, 1e-15);
          }
        }
    }
  }
}

TEST(JoinedEnds, CentroidOfAFacetIsThatOfItsTriangles) {
  const PanelFacet facet = facets_of(joined_sheet(), some_ends())[1];
  const auto& c = facet.corners;
  const auto half = [&](const Vec2& a, const Vec2& b, const Vec2& p) {
    return 0.5 * std::abs((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x());
  };
  const double one = half(c[0], c[1], c[2]), two = half(c[0], c[2], c[3]);
  const Vec2 middle = (one * (c[0] + c[1] + c[2]) + two * (c[0] + c[2] + c[3])) / (3 * (one + two));
  EXPECT_NEAR((centroid_of(facet) - facet.frame.point(middle)).norm(), 0.0, 1e-10);
  EXPECT_NEAR(slit_detail::area_of(facet), one + two, 1e-10);
}

}  // namespace
}  // namespace planish::test
