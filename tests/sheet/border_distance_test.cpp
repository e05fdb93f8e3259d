#include "support/sheets.hpp"

#include <planish/sheet/certificate.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

TEST(BorderDistance, IsZeroOnEveryBorderAndTheOffsetBesideIt) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), cone_joined({}), plate_with_holes()}) {
    const EdgeDistance distance = border_distance(sheet);
    for (const Face& face : sheet.faces)
      for (const BorderLoop& loop : face.loops)
        for (const Border& border : loop)
          for (const double t : {0.0, 0.21, 0.5, 1.0}) {
            const Vec2 uv = point_at(border.curve, t);
            const Vec3 p = skin_point(face, uv);
            EXPECT_NEAR(distance(*border.edge, p), 0.0, 1e-7);
            EXPECT_NEAR(distance(*border.edge, p + 0.25 * outward_normal(face, uv)), 0.25, 1e-7);
          }
  }
}

TEST(BorderDistance, GoesToTheEdgeBelowTheSkin) {
  Sheet sheet = l_bracket();
  Face& face = sheet.faces.front();
  Border& border = face.loops[0][0];
  border.edge = 1000;
  border.edge_depth = 2.0;
  const Vec2 uv = point_at(border.curve, 0.4);
  const EdgeDistance distance = border_distance(sheet);
  EXPECT_NEAR(distance(1000, skin_point(face, uv) - 2.0 * outward_normal(face, uv)), 0.0, 1e-12);
  EXPECT_NEAR(distance(1000, skin_point(face, uv)), 2.0, 1e-12);
}

TEST(BorderDistance, IsInfiniteForAnEdgeOfNoBorder) {
  EXPECT_TRUE(std::isinf(border_distance(l_bracket())(4711, Vec3::Zero())));
}

}  // namespace
}  // namespace planish::test
