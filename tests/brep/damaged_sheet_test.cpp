#include "support/damaged_sheets.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(DamagedSheet, HasNoSolidNoSurfaceAndNoMesh) {
  for (const Damage& damage : damages()) {
    Sheet sheet = u_channel();
    damage.inflict(sheet);
    const auto solid = folded_solid_step(sheet, "part");
    ASSERT_FALSE(solid) << damage.rule;
    EXPECT_EQ(solid.error().code, code::invalid_input) << damage.rule;
    EXPECT_EQ(solid.error().where, damage.where);
    ASSERT_FALSE(solid.error().places.empty());
    EXPECT_EQ(solid.error().places.front().kind, PlaceKind::pointer);
    EXPECT_FALSE(folded_surface_step(sheet, "part")) << damage.rule;
    EXPECT_FALSE(folded_mesh(sheet)) << damage.rule;
  }
}

}  // namespace
}  // namespace planish::test
