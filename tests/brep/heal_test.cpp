#include "heal.hpp"

#include "face_volume.hpp"
#include "solid_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::brep::test {
namespace {

using ::testing::ElementsAre;

Vec3 at(double x, double y, double z) { return {x, y, z}; }

/// A box of 100 × 60 × 2 whose top is two faces that meet at x = 40: faces 0 and 1.
SolidModel split_top() {
  SolidMaker maker;
  maker.plane(Vec3::UnitZ(),
              {polygon_path({at(0, 0, 2), at(40, 0, 2), at(40, 60, 2), at(0, 60, 2)})});
  maker.plane(Vec3::UnitZ(),
              {polygon_path({at(40, 0, 2), at(100, 0, 2), at(100, 60, 2), at(40, 60, 2)})});
  maker.plane(-Vec3::UnitZ(),
              {polygon_path({at(0, 60, 0), at(100, 60, 0), at(100, 0, 0), at(0, 0, 0)})});
  maker.plane(
      -Vec3::UnitY(),
      {polygon_path({at(0, 0, 0), at(100, 0, 0), at(100, 0, 2), at(40, 0, 2), at(0, 0, 2)})});
  maker.plane(Vec3::UnitX(),
              {polygon_path({at(100, 0, 0), at(100, 60, 0), at(100, 60, 2), at(100, 0, 2)})});
  maker.plane(
      Vec3::UnitY(),
      {polygon_path({at(100, 60, 0), at(0, 60, 0), at(0, 60, 2), at(40, 60, 2), at(100, 60, 2)})});
  maker.plane(-Vec3::UnitX(),
              {polygon_path({at(0, 60, 0), at(0, 0, 0), at(0, 0, 2), at(0, 60, 2)})});
  return std::move(maker).build();
}

TEST(Healed, MakesOneFaceOfTwoOnOnePlane) {
  const SolidModel model = healed(split_top());
  EXPECT_THAT(model.faces[0].merged, ElementsAre(1));
  ASSERT_EQ(model.faces[0].loops.size(), 1u);
  EXPECT_EQ(model.faces[0].loops.front().size(), 6u);
  EXPECT_TRUE(model.faces[1].loops.empty());
  EXPECT_NEAR(outlines_of(model)[0].area, 6000.0, 1e-9);
  EXPECT_NEAR(volume_of(model), 12000.0, 1e-8);
}

TEST(Healed, LeavesTheEdgeBetweenThemUnusedAndTheOthersToTheWhole) {
  const SolidModel model = healed(split_top());
  int unused = 0;
  for (const SolidEdge& edge : model.edges) {
    unused += edge.uses == 0;
    EXPECT_NE(edge.faces[0], 1);
    EXPECT_NE(edge.faces[1], 1);
  }
  EXPECT_EQ(unused, 1);
}

TEST(Healed, KeepsTheOpeningThatMergedFacesSurround) {
  const std::vector<Vec3> outer{at(0, 0, 0), at(90, 0, 0), at(90, 90, 0), at(0, 90, 0)};
  const std::vector<Vec3> inner{at(30, 30, 0), at(60, 30, 0), at(60, 60, 0), at(30, 60, 0)};
  SolidMaker maker;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    maker.plane(Vec3::UnitZ(), {polygon_path({outer[i], outer[j], inner[j], inner[i]})});
  }
  const SolidModel model = healed(std::move(maker).build_open());
  ASSERT_EQ(model.faces[0].loops.size(), 2u);
  EXPECT_THAT(model.faces[0].merged, ElementsAre(1, 2, 3));
  EXPECT_NEAR(outlines_of(model)[0].area, 8100 - 900, 1e-9);
}

TEST(Healed, KeepsPlanesThatMeetAtAnAngle) {
  const SolidModel box = plate(2, {100, 60});
  const SolidModel model = healed(box);
  for (const SolidFace& face : model.faces) {
    EXPECT_EQ(face.loops.size(), 1u);
    EXPECT_TRUE(face.merged.empty());
  }
}

}  // namespace
}  // namespace planish::brep::test
