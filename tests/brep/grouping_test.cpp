#include "grouping.hpp"

#include "recognised.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using ::testing::ElementsAre;

using std::numbers::pi;

TEST(GroupFaces, MakesFlangesAndBends) {
  const Groups groups = recognised(prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40), 2, 2)
                            .groups;
  ASSERT_EQ(groups.rows.size(), 3u);
  EXPECT_TRUE(groups.rows[0].flange);
  EXPECT_FALSE(groups.rows[1].flange);
  EXPECT_TRUE(groups.rows[2].flange);
  EXPECT_THAT(groups.rows[1].faces, ElementsAre(3));
  ASSERT_EQ(groups.joints.size(), 2u);
  for (const GroupJoint& joint : groups.joints) {
    EXPECT_FALSE(joint.sharp);
    EXPECT_TRUE(joint.a == 1 || joint.b == 1) << "both joints are the bend's";
  }
  EXPECT_EQ(groups.of_face[7], -1) << "on the other skin";
}

TEST(GroupFaces, JoinsFlangesAtSharpEdges) {
  const Groups groups = recognised(prism({strip_profile(2, {{50, pi / 2, 0}, {30}})}, 40), 2, 6)
                            .groups;
  ASSERT_EQ(groups.rows.size(), 2u);
  ASSERT_EQ(groups.joints.size(), 1u);
  EXPECT_TRUE(groups.joints.front().sharp);
}

/// Part of a skin: a flange below, one to the right, and two pieces of the bend between them with a
/// notch of 10 mm in the middle. Faces: flange, piece, piece, flange.
SolidModel interrupted_bend(const Cylinder& second) {
  const auto at = [](double x, double y, double z) { return Vec3(x, y, z); };
  const auto piece = [&](double low, double high) -> std::vector<Path> {
    Frame foot, head;
    foot.origin = at(50, 5, low);
    head.origin = at(50, 5, high);
    return {{arc(foot, 5, -pi / 2, 0), line(at(55, 5, low), at(55, 5, high)),
             arc(head, 5, 0, -pi / 2), line(at(50, 0, high), at(50, 0, low))}};
  };
  Frame axis;
  axis.origin = at(50, 5, 0);
  SolidMaker maker;
  maker.plane(-Vec3::UnitY(), {polygon_path({at(0, 0, 0), at(50, 0, 0), at(50, 0, 10),
                                             at(50, 0, 20), at(50, 0, 40), at(0, 0, 40)})});
  maker.curved(Cylinder{axis, 5}, 1, piece(0, 10));
  maker.curved(second, 1, piece(20, 40));
  maker.plane(Vec3::UnitX(), {polygon_path({at(55, 5, 0), at(55, 35, 0), at(55, 35, 40),
                                            at(55, 5, 40), at(55, 5, 20), at(55, 5, 10)})});
  return std::move(maker).build_open();
}

Groups groups_of(const SolidModel& model) {
  Skins skins;
  skins.skin_of.assign(model.faces.size(), Skin::first);
  return group_faces(model, outlines_of(model), skins, Skin::first);
}

TEST(GroupFaces, MakesOneBendOfPiecesBetweenTheSameFlanges) {
  Frame axis;
  axis.origin = {50, 5, 25};
  const Groups groups = groups_of(interrupted_bend({axis, 5}));
  ASSERT_EQ(groups.rows.size(), 3u);
  EXPECT_THAT(groups.rows[1].faces, ElementsAre(1, 2));
  EXPECT_EQ(groups.rows[1].leader, 2) << "20 mm of 30";
  EXPECT_EQ(groups.joints.size(), 4u);
}

TEST(GroupFaces, KeepsPiecesOfAnotherRadiusApart) {
  Frame axis;
  axis.origin = {50.02, 5.02, 25};
  const Groups groups = groups_of(interrupted_bend({axis, 5.02}));
  EXPECT_EQ(groups.rows.size(), 4u);
}

TEST(GroupFaces, MakesOneBendOfFacesThatMeetAtASeam) {
  // A quarter bend in two eighths.
  const SolidModel model = prism(
      {{Segment{{0, 0}, {50, 0}}, Arc{{50, 5}, 5, -pi / 2, pi / 4},
        Arc{{50, 5}, 5, -pi / 4, pi / 4}, Segment{{55, 5}, {55, 35}}, Segment{{55, 35}, {53, 35}},
        Segment{{53, 35}, {53, 5}}, Arc{{50, 5}, 3, 0, -pi / 2}, Segment{{50, 2}, {0, 2}},
        Segment{{0, 2}, {0, 0}}}},
      40);
  const Groups groups = recognised(model, 2, 2).groups;
  ASSERT_EQ(groups.rows.size(), 3u);
  EXPECT_THAT(groups.rows[1].faces, ElementsAre(3, 4));
}

}  // namespace
}  // namespace planish::brep::test
