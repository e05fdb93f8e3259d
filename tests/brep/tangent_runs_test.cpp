#include "tangent_runs.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

/// An angle of 2 mm, bent by 90° round an inside radius of 3 mm after 40 mm along x.
Recognised angle() {
  return recognised(prism({strip_profile(2, {{40, std::numbers::pi / 2, 3}, {30, 0, 0}})}, 50), 2,
                    2);
}

constexpr int kFlange = 2, kBend = 3;  // outside

TEST(TangentRuns, GoOnFromTheEndOfTheirLoop) {
  const Recognised seen = angle();
  const auto& loop = seen.model.faces[kBend].loops.front();
  ASSERT_EQ(loop.size(), 4u);
  const auto uses = uses_of(seen.view(), {{kBend, 0}, 3, 2});
  ASSERT_EQ(uses.size(), 2u);
  EXPECT_EQ(uses[0].edge, loop[3].edge);
  EXPECT_EQ(uses[1].edge, loop[0].edge);
  EXPECT_LT((point_of(seen.view(), uses[0], true) - point_of(seen.view(), uses[1], false)).norm(),
            1e-9);
}

TEST(TangentRuns, MeasureTheBendHalfWayBetweenItsSkins) {
  const Recognised seen = angle();
  EXPECT_EQ(cylinder_of(seen.view(), kFlange), nullptr);
  ASSERT_NE(cylinder_of(seen.view(), kBend), nullptr);
  EXPECT_NEAR(cylinder_of(seen.view(), kBend)->radius, 5.0, 1e-9);
  EXPECT_NEAR(middle_radius(seen.view(), {{{kFlange, 0}, 0, 1}, LoopRun{{kBend, 0}, 0, 1}}), 4.0,
              1e-9);
}

TEST(TangentRuns, LookAcrossTheTangentLineIntoTheBend) {
  const Recognised seen = angle();
  const auto& plane = std::get<Frame>(seen.model.faces[kFlange].surface);
  // Round the bend from one end of the tangent line to the other: all edges but the joint.
  const auto& loop = seen.model.faces[kBend].loops.front();
  int joint = 0;
  while (face_across(seen.model.edges[loop[joint].edge], kBend) != kFlange)
    ++joint;
  const Frame across = across_tangent(seen.view(), plane,
                                      {{{kFlange, 0}, 0, 1}, LoopRun{{kBend, 0}, joint + 1, 3}});
  EXPECT_NEAR(across.x.x(), 1.0, 1e-9);
  EXPECT_NEAR(across.origin.x(), 40.0, 1e-9);
  EXPECT_NEAR(std::abs(across.y.z()), 1.0, 1e-9);
}

}  // namespace
}  // namespace planish::brep::test
