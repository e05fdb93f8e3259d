#include "solid_model.hpp"

#include "solid_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace planish::brep::test {
namespace {

using ::testing::ElementsAre;

TEST(FaceAcross, IsTheOtherOneTheSameAtASeamAndNoneAtAnOpenEdge) {
  SolidEdge edge;
  edge.faces = {4, 7};
  EXPECT_EQ(face_across(edge, 4), 7);
  EXPECT_EQ(face_across(edge, 7), 4);
  edge.faces = {5, 5};
  EXPECT_EQ(face_across(edge, 5), 5);
  edge.faces = {6, -1};
  EXPECT_EQ(face_across(edge, 6), -1);
}

TEST(FaceAsRead, RemembersWhatHasBecomePartOfAnother) {
  SolidEdge edge;
  edge.faces = {4, 7};
  edge.merged_faces = {-1, 0};
  EXPECT_EQ(face_as_read(edge, 0), 4);
  EXPECT_EQ(face_as_read(edge, 1), 0);
}

TEST(EdgesByFace, ListsEachEdgeForBothOfItsFaces) {
  const SolidModel model = plate(2, {100, 60});
  const auto edges = edges_by_face(model);
  ASSERT_EQ(edges.size(), 6u);
  for (int f = 0; f < 6; ++f) {
    EXPECT_EQ(edges[f].size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(edges[f]));
    for (const int e : edges[f])
      EXPECT_TRUE(model.edges[e].faces[0] == f || model.edges[e].faces[1] == f);
  }
  SolidModel open;
  open.faces.resize(2);
  open.edges.resize(3);
  open.edges[0].faces = {1, -1};
  open.edges[1].faces = {0, 1};
  open.edges[2].faces = {-1, -1};
  EXPECT_THAT(edges_by_face(open), ElementsAre(ElementsAre(1), ElementsAre(0, 1)));
}

}  // namespace
}  // namespace planish::brep::test
