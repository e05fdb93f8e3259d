#include "coupling.hpp"

#include "sample_sheets.hpp"

#include <planish/slit/codes.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

// Coupled strips against closed forms: what bonds cost, how a wish of growing weight is met, gaps
// within their limits, and forces that balance.

namespace planish::test {
using namespace slit_detail;
namespace {

StripProblem upright(double across, int quads) {
  StripProblem problem;
  problem.base = {{Vec3::Zero(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()},
                  {across, across + 50.0},
                  {0.0, 0.0},
                  {600.0, 600.0},
                  quads};
  return problem;
}

/// Middles of the middle strip lie a distance beside the middle of the others: the second
/// difference is twice that, in thirtieths of the length, whatever the number of ridges.
TEST(Bonds, CostTheSquareOfTheSecondDifference) {
  for (const int quads : {3, 8, 20, 41})
    for (const double aside : {0.0, 7.0}) {
      StripSystem system;
      for (const double across : {0.0, 60.0 + aside, 120.0})
        system.strips.push_back(upright(across, quads));
      system.held = {false, false, false};
      Shapes flat;
      for (const StripProblem& problem : system.strips)
        flat.push_back(flat_parameters(problem.base));
      const double alone = objective_of(system, flat);
      system.bonds = bonds_of(system.strips, 0.5);
      EXPECT_NEAR(objective_of(system, flat) - alone,
                  0.5 * 0.5 * std::pow(2.0 * aside * 30.0 / 600.0, 2), 1e-9)
          << quads;
      EXPECT_TRUE(bonds_of(system.strips, 0.0).empty());
    }
}

FoldedStrip ends_at(const Vec3& left, const Vec3& right) {
  FoldedStrip strip;
  strip.ridges.push_back({{}, {left, right}, {}});
  return strip;
}

TEST(Gap, IsThatOfFacingCorners) {
  const FoldedStrip first = ends_at({0, 0, 0}, {0, 0, 50});
  EXPECT_NEAR(gap_between(first, ends_at({0, 3, 54}, {0, 3, 104})), 5.0, 1e-12);
  EXPECT_NEAR(gap_between(first, ends_at({0, 0, 44}, {0, 0, 94})), -6.0, 1e-12);
}

Vec3 middle(const SlitSession& session, int strip, int ridge) {
  const FoldedSlitSheet folded = session.folded();
  const auto& ends = folded.strips[strip].ridges[ridge].folded;
  return 0.5 * (ends[0] + ends[1]);
}

/// Three strips over a straight leg, the middle one drawn upwards.
SlitDesign drawn() {
  SlitDesign design = small_chair();
  design.sheet.strips = equal_strips(3, 60.0);
  design.leg_curve = {{{360, 0}, {360, 180}}};
  design.anchors = {{1, 10, StripEdge::left, Vec3(0, 700, 60)},
                    {1, 10, StripEdge::right, Vec3(0, 700, 120)}};
  return design;
}

double unevenness(const SlitSession& session) {
  double squares = 0.0;
  for (int ridge = 1; ridge <= session.design().ridges; ++ridge)
    squares += (middle(session, 0, ridge) - 2.0 * middle(session, 1, ridge) +
                middle(session, 2, ridge))
                   .squaredNorm();
  return std::sqrt(squares);
}

TEST(Coupling, EqualStripsStayAsTheyAre) {
  SlitDesign design = drawn();
  design.anchors.clear();
  const SlitSession alone = solved(design);
  design.coupling = SlitCoupling{10.0};
  const SlitSession together = solved(design);
  EXPECT_LT(unevenness(together), 1e-6);
  for (int strip = 0; strip < 3; ++strip)
    EXPECT_NEAR(together.state(strip).energy, alone.state(strip).energy,
                1e-6 * alone.state(strip).energy);
}

/// What a quadratic wish of a large weight leaves is inversely proportional to it.
TEST(Coupling, LargeWeightsMakeStripsEven) {
  SlitDesign design = drawn();
  const double free = unevenness(solved(design));
  const auto left_by = [&](double weight) {
    design.coupling = SlitCoupling{weight};
    return unevenness(solved(design));
  };
  const double some = left_by(1.0), little = left_by(10.0);
  EXPECT_LT(left_by(0.003), free);
  EXPECT_LT(some, 0.2 * free);
  EXPECT_NEAR(little / some, 0.1, 0.02);
}

TEST(Coupling, KeepsGapsWithinTheirLimits) {
  for (const auto& gap : {std::array{2.0, 3.0}, std::array{20.0, 25.0}, std::array{40.0, 45.0}}) {
    SlitDesign design = chair();
    design.coupling = SlitCoupling{0.0, gap};
    const SlitSession session = solved(design, 1);
    const FoldedSlitSheet folded = session.folded();
    for (int strip = 0; strip + 1 < 6; ++strip) {
      const double found = (folded.strips[strip + 1].ridges.back().folded[0] -
                            folded.strips[strip].ridges.back().folded[1])
                               .norm();
      EXPECT_GT(found, gap[0] - 5e-3) << strip;
      EXPECT_LT(found, gap[1] + 5e-3) << strip;
      EXPECT_LT(session.state(strip).gap, 1e-9 * 464.0);
    }
  }
}

TEST(Coupling, AnEditMovesAllStrips) {
  SlitDesign design = drawn();
  for (const bool coupled : {false, true}) {
    if (coupled) design.coupling = SlitCoupling{0.1};
    SlitSession session = solved(design);
    const Vec3 before = middle(session, 0, 5);
    SlitDesign edited = design;
    for (SlitAnchor& anchor : edited.anchors)
      anchor.at.y() -= 40.0;
    ASSERT_TRUE(session.set_design(edited));
    ASSERT_TRUE(session.solve());
    EXPECT_EQ((middle(session, 0, 5) - before).norm() > 1.0, coupled);
  }
}

/// The panel's moment about a strip's first ridge is what its fold there bears, bonds counted.
TEST(Coupling, ForcesOfBondsAreReactions) {
  SlitDesign design = drawn();
  design.anchors.clear();
  design.material = SlitMaterial{210000.0, 0.3, 7.85, 235.0};
  design.loads = {{1, 1.0, Vec3(0, -100, 0)}};
  design.coupling = SlitCoupling{0.003};
  const SlitSession session = solved(design);
  const auto state = session.equilibrium();
  const FoldedSlitSheet folded = session.folded();
  for (int strip = 0; strip < 3; ++strip) {
    const auto& ridges = folded.strips[strip].ridges;
    const Vec3 axis = (ridges[0].folded[1] - ridges[0].folded[0]).normalized();
    const double h0 = 0.5 * (ridges[1].flat[0] - ridges[0].flat[0]).x(),
                 h1 = 0.5 * (ridges[1].flat[1] - ridges[0].flat[1]).x();
    const double wide = std::abs(h1 / h0 - 1.0) < 1e-9 ? 1.0 / h0 : std::log(h1 / h0) / (h1 - h0);
    const double bears = design.material->rigidity(4.0) * ridges[0].fold.radians() * 60.0 * wide;
    const auto panel = std::ranges::find_if(state->reactions, [&](const SlitReaction& one) {
      return one.strip == strip && one.end == HeldBy::panel;
    });
    EXPECT_NEAR(-panel->moment.dot(axis), bears, 2e-3 * std::abs(bears)) << strip;
  }
}

TEST(Coupling, IsRefusedWhereItMeansNothing) {
  const auto refused = [](const std::function<void(SlitDesign&)>& change) {
    SlitDesign design = drawn();
    design.coupling = SlitCoupling{};
    change(design);
    const auto session = SlitSession::start(design);
    return session ? std::string() : session.error().where;
  };
  EXPECT_EQ(refused([](SlitDesign&) {}), "");
  EXPECT_EQ(refused([](SlitDesign& d) { d.objective = SlitObjective::smooth; }), "/coupling");
  EXPECT_EQ(refused([](SlitDesign& d) { d.coupling->smooth = -1.0; }), "/coupling/smooth");
  EXPECT_EQ(refused([](SlitDesign& d) { d.coupling->gap = {5.0, 2.0}; }), "/coupling/gap");
  EXPECT_EQ(refused([](SlitDesign& d) { d.coupling->gap = {-1.0, 2.0}; }), "/coupling/gap");
  SlitDesign between = arcade();
  between.coupling = SlitCoupling{0.003, std::array{0.0, 5.0}};
  const auto session = SlitSession::start(between);
  ASSERT_FALSE(session);
  EXPECT_EQ(session.error().where, "/coupling/gap");
}

}  // namespace
}  // namespace planish::test
