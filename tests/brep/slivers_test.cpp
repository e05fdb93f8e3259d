#include "slivers.hpp"

#include "solid_models.hpp"

#include <gtest/gtest.h>

namespace planish::brep::test {
namespace {

/// Two planes with a step of this height between them. Faces: lower, step, upper.
SolidModel step(double height) {
  const auto at = [](double x, double y, double z) { return Vec3(x, y, z); };
  SolidMaker maker;
  maker.plane(Vec3::UnitZ(),
              {polygon_path({at(0, 0, 0), at(40, 0, 0), at(40, 60, 0), at(0, 60, 0)})});
  maker.plane(-Vec3::UnitX(),
              {polygon_path({at(40, 60, 0), at(40, 0, 0), at(40, 0, height), at(40, 60, height)})});
  maker.plane(Vec3::UnitZ(), {polygon_path({at(40, 0, height), at(100, 0, height),
                                            at(100, 60, height), at(40, 60, height)})});
  return std::move(maker).build_open();
}

int shared_edges(const SolidModel& model, int a, int b) {
  int count = 0;
  for (const SolidEdge& edge : model.edges)
    count += (edge.faces[0] == a && edge.faces[1] == b) ||
             (edge.faces[0] == b && edge.faces[1] == a);
  return count;
}

TEST(WithoutSlivers, LetsTheFacesOnBothSidesMeet) {
  const SolidModel model = without_slivers(step(5e-4));
  EXPECT_TRUE(model.faces[1].loops.empty());
  EXPECT_EQ(shared_edges(model, 0, 2), 1);
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const SolidEdge& edge = model.edges[e];
    if (edge.uses != 2) continue;
    EXPECT_NE(edge.forward[0], edge.forward[1]) << "both faces keep it on their left";
    for (const int side : {0, 1})
      for (const auto& loop : model.faces[edge.faces[side]].loops)
        for (const CoEdge& use : loop)
          EXPECT_TRUE(use.edge != e || use.forward == edge.forward[side]);
  }
}

TEST(WithoutSlivers, KeepsStepsThatAreMeant) {
  const SolidModel model = without_slivers(step(0.01));
  EXPECT_EQ(model.faces[1].loops.size(), 1u);
  EXPECT_EQ(shared_edges(model, 0, 2), 0);
}

TEST(WithoutSlivers, KeepsNarrowWallsBetweenOppositeFaces) {
  // A foil: its walls are as narrow as slivers, but top and bottom look away from each other.
  const SolidModel model = without_slivers(plate(5e-4, {100, 60}));
  for (const SolidFace& face : model.faces)
    EXPECT_EQ(face.loops.size(), 1u);
}

}  // namespace
}  // namespace planish::brep::test
