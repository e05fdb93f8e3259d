#include "joint_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::brep {
namespace {

Face face_on(const std::variant<Frame, Developable>& surface) {
  Face face;
  face.surface = surface;
  return face;
}

TEST(OffRuling, OnAPlaneIsTheSagittaOfAnArc) {
  const Arc arc{{0, 0}, 50, 0.1, 0.6};
  EXPECT_NEAR(off_ruling(face_on(Frame{}), arc), 50 * (1 - std::cos(0.3)), 1e-12);
  EXPECT_NEAR(off_ruling(face_on(Frame{}), Segment{{0, 0}, {30, 40}}), 0.0, 1e-12);
}

TEST(OffRuling, OnACylinderIsTheChordToTheRuling) {
  const Face face = face_on(Developable(Cylinder{Frame{}, 5}));
  EXPECT_NEAR(off_ruling(face, Segment{{0.4, 0}, {0.4, 30}}), 0.0, 1e-12);
  // The ends lie 0.01 rad on both sides of the ruling between them.
  EXPECT_NEAR(off_ruling(face, Segment{{0.4, 0}, {0.42, 30}}), 2 * 5 * std::sin(0.005), 1e-12);
}

TEST(AsRuling, KeepsTheEndsOnAPlaneAndTheMiddleAzimuthOnABend) {
  const Segment line = as_ruling(face_on(Frame{}), Arc{{0, 0}, 50, 0.0, 1.0});
  EXPECT_NEAR((line.b - 50 * Vec2(std::cos(1.0), std::sin(1.0))).norm(), 0.0, 1e-12);
  const Segment ruling = as_ruling(face_on(Developable(Cylinder{Frame{}, 5})),
                                   Segment{{0.4, 0}, {0.42, 30}});
  EXPECT_NEAR(ruling.a.x(), 0.41, 1e-12);
  EXPECT_DOUBLE_EQ(ruling.a.x(), ruling.b.x());
  EXPECT_DOUBLE_EQ(ruling.b.y(), 30.0);
}

}  // namespace
}  // namespace planish::brep
