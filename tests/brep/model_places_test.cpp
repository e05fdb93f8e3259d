#include "model_places.hpp"

#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

TEST(ModelPlaces, CountFromOneAndLieOnTheirFaceAndEdge) {
  const SolidModel model = plate(2, {100, 60});
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    const Place place = face_place(model, f);
    EXPECT_EQ(place.kind, PlaceKind::face);
    EXPECT_EQ(std::get<int>(place.id), f + 1);
    ASSERT_EQ(place.at.size(), 3u);
    const Vec3 at(place.at[0], place.at[1], place.at[2]);
    EXPECT_NEAR(std::get<Frame>(model.faces[f].surface).local(at).z(), 0.0, 1e-12);
  }
  // A plate's edges are 100, 60 and 2 long: their middles lie at half of that along one axis, and
  // at an end along the two others.
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const Place place = edge_place(model, e);
    EXPECT_EQ(place.kind, PlaceKind::edge);
    EXPECT_EQ(std::get<int>(place.id), e + 1);
    const std::vector<double> size{100, 60, 2};
    int halves = 0, ends = 0;
    for (int k = 0; k < 3; ++k) {
      halves += std::abs(place.at.at(k) - size[k] / 2) < 1e-12;
      ends += std::abs(place.at.at(k)) < 1e-12 || std::abs(place.at.at(k) - size[k]) < 1e-12;
    }
    EXPECT_EQ(halves, 1);
    EXPECT_EQ(ends, 2);
  }
}

TEST(ModelPlaces, AreInTheMiddleOfAnArc) {
  SolidModel model;
  model.faces.resize(1);
  model.edges.resize(1);
  model.edges[0].curve = arc(Frame{}, 5, 0.0, std::numbers::pi);
  model.faces[0].loops = {{{0, true}}};
  for (const Place& place : {face_place(model, 0), edge_place(model, 0)}) {
    ASSERT_EQ(place.at.size(), 3u);
    EXPECT_NEAR(place.at[0], 0.0, 1e-12);
    EXPECT_NEAR(place.at[1], 5.0, 1e-12);
  }
}

TEST(ModelPlaces, OfAFaceWithoutEdgesAreItsNumberAlone) {
  SolidModel model;
  model.faces.resize(3);
  model.faces[2].loops.resize(1);
  EXPECT_EQ(face_place(model, 1), place::face(2));
  EXPECT_EQ(face_place(model, 2), place::face(3));
}

}  // namespace
}  // namespace planish::brep::test
