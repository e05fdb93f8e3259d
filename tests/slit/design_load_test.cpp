#include "design_load.hpp"

#include "sample_sheets.hpp"

#include <cmath>
#include <limits>

// What loads a strip, and what is refused.

namespace planish::test {
namespace {

using namespace slit_detail;

SlitDesign loaded() {
  SlitDesign design = chair();
  design.material = SlitMaterial{210000.0, 0.3, 7.85, 235.0};
  design.gravity = true;
  design.loads = {{1, 0.5, Vec3(0, -100, 10)}, {1, std::nullopt, Vec3(0, -464 * 60, 0)}};
  return design;
}

std::string refused(SlitDesign design) {
  const auto session = SlitSession::start(std::move(design));
  return session ? "none" : session.error().where;
}

TEST(DesignLoad, IsSharedByTheHalvesAndTheRigidity) {
  const SlitDesign design = loaded();
  const double rigidity = 210000.0 * 64.0 / (12.0 * 0.91);
  EXPECT_NEAR(design.material->rigidity(4.0), rigidity, 1e-9 * rigidity);
  const StripLoad load = load_of(design, 1);
  ASSERT_EQ(load.forces.size(), 1u);
  EXPECT_LT((load.forces[0].force - Vec3(0, -50, 5) / rigidity).norm(), 1e-15);
  const double weight = 7.85e-6 * 9.80665 * 4.0;
  EXPECT_NEAR(load.spread.y(), -(weight + 0.5) / rigidity, 1e-12 / rigidity);
  EXPECT_NEAR(load_of(design, 0).spread.y(), -weight / rigidity, 1e-12 / rigidity);
  EXPECT_TRUE(load_of(chair(), 0).empty());
}

TEST(DesignLoad, ChangedLoadsOpenTheStrips) {
  SlitDesign design = loaded();
  SlitSession session = solved(design);
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.state(0).status, StripStatus::solved);
  design.loads[0].force.y() = -101.0;
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.state(0).status, StripStatus::open);
}

TEST(DesignLoad, RefusalsNameTheirPlace) {
  const auto with = [](auto&& change) {
    SlitDesign design = loaded();
    change(design);
    return refused(design);
  };
  EXPECT_EQ(with([](SlitDesign&) {}), "none");
  EXPECT_EQ(with([](SlitDesign& d) { d.material->density.reset(); }), "/gravity");
  EXPECT_EQ(with([](SlitDesign& d) { d.material.reset(); }), "/gravity");
  EXPECT_EQ(with([](SlitDesign& d) { d.material.reset(), d.gravity = false; }), "/loads");
  EXPECT_EQ(with([](SlitDesign& d) { d.objective = SlitObjective::smooth; }), "/gravity");
  EXPECT_EQ(with([](SlitDesign& d) { d.loads[1].strip = 6; }), "/loads/1/strip");
  EXPECT_EQ(with([](SlitDesign& d) { d.loads[0].at = 1.5; }), "/loads/0/at");
  EXPECT_EQ(with([](SlitDesign& d) { d.loads[0].force.x() = 1.0; }), "/loads/0/force");
  EXPECT_EQ(with([](SlitDesign& d) { d.loads[0].force.y() = std::nan(""); }), "/loads/0/force");
  EXPECT_EQ(with([](SlitDesign& d) { d.material->young = 0.0; }), "/material/young");
  EXPECT_EQ(with([](SlitDesign& d) { d.material->poisson = 0.5; }), "/material/poisson");
  EXPECT_EQ(with([](SlitDesign& d) { d.material->density = -1.0; }), "/material/density");
  EXPECT_EQ(with([](SlitDesign& d) { d.material->yield = 0.0; }), "/material/yield");
}

}  // namespace
}  // namespace planish::test
