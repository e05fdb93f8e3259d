#include "closed_hem.hpp"

#include "brake/hemming_tools.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Where a closed hem lies: as it is drawn. (Of an open one the tools decide.)
TEST(ClosedHem, LiesAsItIsDrawn) {
  const Sheet sheet = strip(
      {Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up}, Straight{60},
       Turn{Angle::degrees(90), 1.0, BendDirection::up}, Straight{40}},
      50, 1.0);
  const auto flat = flat_sheet(sheet);
  const auto work = workpiece_of(sheet, flat->layout, {1.0, Angle::degrees(150)});
  ASSERT_TRUE(work);
  const PartTree tree(*work, 1);
  LineSet formed = no_lines(3);
  insert(formed, 0);
  insert(formed, 2);
  // From the wall's line: the return lies 2 r + T above the base's middle, its end 60 − 15 from the
  // wall's tangent line.
  const double half_zone = 0.5 * work->lines[1].bend.allowance;
  const int body = work->lines[0].bodies[0] == work->lines[1].bodies[0] ||
                           work->lines[0].bodies[0] == work->lines[1].bodies[1]
                       ? work->lines[0].bodies[1]
                       : work->lines[0].bodies[0];
  const Eigen::Isometry3d at = tree.place(tree.part_of_body(body), formed);
  double nearest = 1e9;
  for (const Convex& piece : work->bodies[body].pieces)
    for (const Vec2& p : piece) {
      const Vec3 placed = at * Vec3(p.x(), p.y(), 0.0);
      EXPECT_NEAR(placed.z(), -0.5 + 2.0, 1e-9);
      nearest = std::min(nearest, std::abs(placed.y()));
    }
  EXPECT_NEAR(nearest, half_zone + 45.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
