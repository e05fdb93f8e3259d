#include "face_reader.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

TEST(ReadFace, TakesTheOuterLoopFirst) {
  Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), 2, 1);
  std::swap(seen.model.faces[1].loops[0], seen.model.faces[1].loops[1]);
  std::swap(seen.outlines[1].flat[0], seen.outlines[1].flat[1]);
  seen.outlines[1].outer = outer_loop(seen.outlines[1]);
  const ReadFace read = read_face(seen.view(), 1, 1);
  ASSERT_EQ(read.face.loops.size(), 2u);
  EXPECT_EQ(read.face.loops[0].size(), 4u);
  EXPECT_EQ(read.face.loops[1].size(), 1u);
  EXPECT_EQ(read.loops[0].place, 1);
  EXPECT_EQ(read.loops[1].place, 0);
  EXPECT_EQ(read.face.source_face, 2);
}

TEST(ReadFace, OfABendIsItsRectangleInTurnAndHeight) {
  const Recognised seen = recognised(prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40), 2, 2);
  const ReadFace read = read_face(seen.view(), 3, 3);
  EXPECT_EQ(read.face.sense, 1);
  const Box2 box = parameter_box(read.face);
  EXPECT_NEAR(box.size().x(), pi / 2, 1e-12);
  EXPECT_NEAR(box.size().y(), 40.0, 1e-12);
  EXPECT_FALSE(read.loops.front().widened);
}

TEST(ReadFace, ReachesAsFarAsAChamferedRim) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inset = rectangle_at({0.5, 0.5}, {99.5, 59.5});
  const Recognised seen = recognised(plate(2, {{{outer, outer, inset}, {0, 1.5, 2}}}), 2, 1);
  const ReadFace read = read_face(seen.view(), 1, 1);
  EXPECT_TRUE(read.silhouette.has_value());
  ASSERT_EQ(read.face.loops.front().size(), 4u);
  EXPECT_NEAR(parameter_box(read.face).size().prod(), 6000.0, 1e-9);
  for (const Border& border : read.face.loops.front())
    EXPECT_NEAR(border.edge_depth, 0.5, 1e-12);
}

TEST(ReadFace, ClosesTheContourWhereAChamferEnds) {
  // Only the side along y = 0 is chamfered: its ends are stepped by the chamfer's width.
  const std::vector<Vec2> outer = rectangle_at({0, 0}, {100, 60});
  const std::vector<Vec2> inset{{0, 0.5}, {100, 0.5}, {100, 60}, {0, 60}};
  const Recognised seen = recognised(plate(2, {{{outer, outer, inset}, {0, 1.5, 2}}}), 2, 1);
  const ReadFace read = read_face(seen.view(), 1, 1);
  EXPECT_EQ(read.face.loops.front().size(), 6u) << "four sides and two short steps";
  double area = 0.0;
  for (const Border& border : read.face.loops.front())
    area += green_area(border.curve);
  EXPECT_NEAR(area, 6000.0, 1e-9);
  EXPECT_EQ(read.loops.front().borders.size(), 4u);
}

TEST(TurnedBy, MovesByWholeTurns) {
  Face face;
  face.surface = Developable(Cylinder{Frame{}, 5});
  face.loops.push_back({{.curve = Segment{{0, 0}, {1, 0}}}});
  EXPECT_NEAR(start_of(turned_by(face, 6.0).loops[0][0].curve).x(), 2 * pi, 1e-12);
  EXPECT_EQ(start_of(turned_by(face, 3.0).loops[0][0].curve).x(), 0.0) << "less than half a turn";
}

}  // namespace
}  // namespace planish::brep::test
