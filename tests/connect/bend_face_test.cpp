#include "joined_face.hpp"
#include "sample_parts.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

using std::numbers::pi;

Loop outer(const Face& face) {
  Loop curves;
  for (const Border& border : face.loops[0])
    curves.push_back(border.curve);
  return curves;
}

TEST(BendFace, IsTheSkinHalfAThicknessOffTheMiddle) {
  const Parts parts = parts_of(angle_pair(14.0, 200, 4.0));
  for (const int sense : {1, -1}) {
    const JoinedFace made = bend_face(parts, 0, sense);
    const auto& surface = std::get<Developable>(made.face.surface);
    EXPECT_NEAR(std::get<Cylinder>(surface).radius, 14.0 + 2.0 * sense, 1e-9);
    EXPECT_EQ(made.face.sense, sense);
  }
}

TEST(BendFace, OfAConeKeepsItsAxisAndItsNormals) {
  const Parts parts = parts_of(cone_pair(0.2, 200, 500, 3.0));
  const BendFit& fit = parts.fits[0];
  for (const int sense : {1, -1}) {
    const JoinedFace made = bend_face(parts, 0, sense);
    const auto& surface = std::get<Developable>(made.face.surface);
    for (const Border& border : made.face.loops[0])
      for (const double t : {0.0, 0.5, 1.0}) {
        // The same azimuth on the mid-surface lies half a thickness below.
        const Vec2 uv = point_at(border.curve, t);
        const Vec3 mid = point_on(surface, uv) - 1.5 * sense * normal_on(surface, uv.x());
        const Vec2 there = parameters_of(fit.surface.mid, mid, uv.x());
        EXPECT_LT((point_on(fit.surface.mid, there) - mid).norm(), 1e-9);
        EXPECT_NEAR(there.x(), uv.x(), 1e-9);
        EXPECT_GE(there.y(), std::min(fit.boundaries.low.v[0], fit.boundaries.low.v[1]) - 20);
      }
  }
}

TEST(BendFace, RunsCounterClockwiseSeenFromOutside) {
  for (const PlateStructure& s : {angle_pair(14.0), cone_pair(), u_pair()}) {
    const Parts parts = parts_of(s);
    EXPECT_GT(signed_area(outer(bend_face(parts, 0, 1).face)), 0.0);
    EXPECT_LT(signed_area(outer(bend_face(parts, 0, -1).face)), 0.0) << "in (u, v), from inside";
  }
}

TEST(BendFace, HasItsJointsOnBothRulings) {
  const Parts parts = parts_of(angle_pair(14.0, 200, 4.0));
  const JoinedFace made = bend_face(parts, 0, 1);
  ASSERT_EQ(made.joints.size(), 2u);
  for (const auto& joint : made.joints) {
    const int side = joint.plate;  // plates 0 and 1 are sides 0 and 1
    const Curve2& curve = made.face.loops[0][joint.border].curve;
    EXPECT_NEAR(start_of(curve).x(), parts.fits[0].surface.azimuth(side), 1e-12);
    EXPECT_NEAR(length(curve), 200.0, 1e-9);
  }
}

TEST(BendFace, MeasuresItsBordersInSpace) {
  const Parts parts = parts_of(angle_pair(14.0, 200, 4.0));
  for (const int sense : {1, -1}) {
    const JoinedFace made = bend_face(parts, 0, sense);
    double sum = 0.0;
    for (const Border& border : made.face.loops[0])
      sum += border.edge_length.value();
    EXPECT_NEAR(sum, 2 * 200.0 + 2 * (pi / 2) * (14.0 + 2.0 * sense), 1e-8);
  }
}

}  // namespace
}  // namespace planish::test
