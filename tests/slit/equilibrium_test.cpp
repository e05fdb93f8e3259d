#include "equilibrium.hpp"

#include "sample_sheets.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

// Loaded sheets against beams by shooting, closed forms, and the balance of all forces.

namespace planish::test {
namespace {

using std::numbers::pi;

constexpr double kNewtons = 9.80665e-6;  // per mm³ of density 1 kg/dm³

/// Steel of 1 mm, whose density is chosen for its weight.
SlitMaterial steel(double density = 7.85) { return {210000.0, 0.3, density, 235.0}; }

/// One strip of 600 × 60 from a panel that leans, with a free end.
SlitDesign cantilever(double lean, int ridges) {
  SlitDesign design;
  design.sheet.thickness = 1.0;
  design.sheet.panel_height = 100.0;
  design.sheet.half_length = 600.0;
  design.sheet.symmetric = false;
  design.sheet.strips = equal_strips(1, 60.0);
  design.leg_curve = {{{500, 0}, {500, 60}}};
  design.lean = Angle::degrees(lean);
  design.ridges = ridges;
  design.material = steel();
  return design;
}

/// A beam of unit length and rigidity from level: φ″ = −q (1 − s) cos φ − f cos φ, φ′(1) = 0.
struct Beam {
  double drop = 0.0, clamp = 0.0;  ///< of its end, and the curvature at its beginning
};
Beam beam_shot(double weight, double force, double curvature, double* missed) {
  constexpr int kSteps = 4000;
  using State = Eigen::Vector3d;  // angle, curvature, drop
  const auto slope = [&](double at, const State& s) -> State {
    return {s[1], -(weight * (1.0 - at) + force) * std::cos(s[0]), std::sin(s[0])};
  };
  State s(0.0, curvature, 0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double h = 1.0 / kSteps, at = i * h;
    const State a = slope(at, s), b = slope(at + 0.5 * h, s + 0.5 * h * a),
                c = slope(at + 0.5 * h, s + 0.5 * h * b), d = slope(at + h, s + h * c);
    s += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  *missed = s[1];
  return {s[2], curvature};
}
Beam beam(double weight, double force) {
  double low = 0.0, high = weight + force + 1.0, missed = 0.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    beam_shot(weight, force, middle, &missed);
    (missed > 0.0 ? high : low) = middle;
  }
  return beam_shot(weight, force, 0.5 * (low + high), &missed);
}

double end_height(const SlitSession& session) {
  const FoldedSlitSheet folded = session.folded();
  const SlitRidge& last = folded.strips[0].ridges.back();
  return 0.5 * (last.folded[0] + last.folded[1]).y();
}
double begin_height(const SlitSession& session) {
  return session.folded().strips[0].ridges.front().folded[0].y();
}

/// Density for which q L³/D has a value.
double density_for(const SlitDesign& design, double weight) {
  const double length = design.sheet.half_length;
  return weight * design.material->rigidity(design.sheet.thickness) / std::pow(length, 3) /
         (kNewtons * design.sheet.thickness);
}

TEST(Equilibrium, HeavyCantileverHangsAsABeam) {
  for (const double weight : {0.01, 1.0, 5.0, 30.0}) {
    SlitDesign design = cantilever(90.0, 40);
    design.material->density = density_for(design, weight);
    design.gravity = true;
    const SlitSession session = solved(design);
    ASSERT_EQ(session.state(0).status, StripStatus::solved) << weight;
    const Beam expected = beam(weight, 0.0);
    EXPECT_NEAR(begin_height(session) - end_height(session), 600.0 * expected.drop,
                2e-3 * 600.0 * expected.drop)
        << weight;
    if (weight < 0.1) {
      EXPECT_NEAR(expected.drop, weight / 8.0, 1e-4 * weight);
    }
    const auto state = session.equilibrium();
    const double stress = 210000.0 / (2.0 * 0.91) * expected.clamp / 600.0;
    EXPECT_NEAR(state->stress[0], stress, 3e-3 * stress) << weight;
    EXPECT_TRUE(state->is_stable[0]);
  }
}

TEST(Equilibrium, ForceAtTheEndBendsAsABeam) {
  for (const double force : {0.01, 2.0, 10.0}) {
    SlitDesign design = cantilever(90.0, 40);
    const double newtons = force * design.material->rigidity(1.0) * 60.0 / (600.0 * 600.0);
    design.loads = {{0, 1.0, Vec3(0, -newtons, 0)}};
    const SlitSession session = solved(design);
    const Beam expected = beam(0.0, force);
    EXPECT_NEAR(begin_height(session) - end_height(session), 600.0 * expected.drop,
                2e-3 * 600.0 * expected.drop)
        << force;
    if (force < 0.1) {
      EXPECT_NEAR(expected.drop, force / 3.0, 1e-4 * force);
    }
  }
}

/// Spread over a strip a force is a weight.
TEST(Equilibrium, SpreadForceActsAsWeight) {
  SlitDesign heavy = cantilever(90.0, 20);
  heavy.gravity = true;
  SlitDesign loaded = cantilever(90.0, 20);
  loaded.loads = {{0, std::nullopt, Vec3(0, -7.85 * kNewtons * 600.0 * 60.0, 0)}};
  EXPECT_NEAR(end_height(solved(heavy)), end_height(solved(loaded)), 1e-6);
}

/// A strip that stands upright buckles at q L³/D = 7.8373 (Greenhill).
TEST(Equilibrium, UprightStripBucklesUnderItsWeight) {
  for (const double weight : {7.0, 9.0}) {
    SlitDesign design = cantilever(0.0, 20);
    design.material->density = density_for(design, weight);
    design.gravity = true;
    const SlitSession session = solved(design);
    const bool is_upright = session.state(0).energy < 1e-9;
    if (weight < 7.8373) {
      EXPECT_TRUE(is_upright);
      EXPECT_TRUE(session.equilibrium()->is_stable[0]);
    } else {
      EXPECT_NE(is_upright, session.equilibrium()->is_stable[0]);
    }
  }
}

/// One strip of 600 × 60 from an upright panel to the symmetry plane.
SlitDesign up_to_plane(double away, int ridges) {
  SlitDesign design = cantilever(0.0, ridges);
  design.sheet.symmetric = true;
  design.leg_curve = {{{600.0 * away, 0}, {600.0 * away, 60}}};
  return design;
}

/// Upright at first, level at the symmetry plane, of unit length: φ″ = −q (1 − s) sin φ − F cos φ.
/// How far up it ends, and the force F across the plane.
struct HeavyElastica {
  double up = 0.0, force = 0.0;
};
HeavyElastica heavy_elastica(double away, double weight) {
  constexpr int kSteps = 2000;
  using State = Eigen::Vector4d;  // angle, curvature, away, up
  const auto shot = [&](double curvature, double force, double q) {
    const auto slope = [&](double at, const State& s) -> State {
      return {s[1], -q * (1.0 - at) * std::sin(s[0]) - force * std::cos(s[0]), std::sin(s[0]),
              std::cos(s[0])};
    };
    State s(0.0, curvature, 0.0, 0.0);
    for (int i = 0; i < kSteps; ++i) {
      const double h = 1.0 / kSteps, at = i * h;
      const State a = slope(at, s), b = slope(at + 0.5 * h, s + 0.5 * h * a),
                  c = slope(at + 0.5 * h, s + 0.5 * h * b), d = slope(at + h, s + h * c);
      s += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return s;
  };
  double curvature = 0.5 * pi, force = 0.0;
  constexpr int kStages = 40;
  for (int stage = 1; stage <= kStages; ++stage) {
    const double share = static_cast<double>(stage) / kStages;
    const double wanted = 2.0 / pi + (away - 2.0 / pi) * share, q = weight * share;
    const auto missed = [&](double k, double f) {
      const State end = shot(k, f, q);
      return Eigen::Vector2d(end[0] - 0.5 * pi, end[2] - wanted);
    };
    for (int i = 0; i < 30; ++i) {
      const Eigen::Vector2d now = missed(curvature, force);
      if (now.norm() < 1e-11) break;
      constexpr double kStep = 1e-6;
      Eigen::Matrix2d slopes;
      slopes << (missed(curvature + kStep, force) - now) / kStep,
          (missed(curvature, force + kStep) - now) / kStep;
      const Eigen::Vector2d step = slopes.inverse() * now;
      curvature -= step[0];
      force -= step[1];
    }
  }
  return {shot(curvature, force, weight)[3], force};
}

SlitReaction reaction_of(const SlitEquilibrium& state, int strip, HeldBy by) {
  for (const SlitReaction& one : state.reactions)
    if (one.strip == strip && one.end == by) return one;
  ADD_FAILURE() << "no such reaction";
  return {};
}

TEST(Equilibrium, HeavyElasticaIsThatOfShooting) {
  for (const double away : {0.55, 0.65, 0.75})
    for (const double weight : {0.5, 3.0, 6.0}) {
      SlitDesign design = up_to_plane(away, 40);
      design.material->density = density_for(design, weight);
      design.gravity = true;
      const SlitSession session = solved(design);
      const HeavyElastica expected = heavy_elastica(away, weight);
      EXPECT_NEAR(end_height(session) - begin_height(session), 600.0 * expected.up, 1.0)
          << away << ", " << weight;
      const double unit = design.material->rigidity(1.0) * 60.0 / (600.0 * 600.0);
      const SlitReaction end = reaction_of(*session.equilibrium(), 0, HeldBy::end);
      EXPECT_NEAR(std::abs(end.force.x()), std::abs(unit * expected.force),
                  0.01 * unit * (1.0 + std::abs(expected.force)))
          << away << ", " << weight;
      EXPECT_NEAR(end.force.y(), 0.0, 1e-6 * unit);
    }
}

/// A chair with a load at a point, a spread one, weight and a seat curve that draws.
SlitDesign loaded_chair() {
  SlitDesign design = chair();
  design.material = steel();
  design.gravity = true;
  design.loads = {{2, 1.0, Vec3(0, -300, 0)}, {3, std::nullopt, Vec3(0, -200, 40)}};
  return design;
}

/// Forces and moments about the origin on a strip, by its triangles.
std::array<Vec3, 2> outside_of(const SlitDesign& design, const FoldedStrip& strip, int number) {
  std::array<Vec3, 2> sum{Vec3::Zero(), Vec3::Zero()};
  const auto add = [&](const Vec3& at, const Vec3& force) {
    sum[0] += force;
    sum[1] += at.cross(force);
  };
  double whole = 0.0;
  std::vector<std::pair<Vec3, double>> pieces;
  for (std::size_t i = 0; i < strip.quads.size(); ++i) {
    const auto &near = strip.ridges[i].folded, &far = strip.ridges[i + 1].folded;
    for (const std::array<Vec3, 3>& c :
         {std::array{near[0], near[1], far[1]}, std::array{near[0], far[1], far[0]}}) {
      const double area = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
      pieces.emplace_back((c[0] + c[1] + c[2]) / 3.0, area);
      whole += area;
    }
  }
  const double half = design.sheet.symmetric ? 0.5 : 1.0;
  for (const auto& [at, area] : pieces) {
    add(at, -*design.material->density * kNewtons * design.sheet.thickness * area * Vec3::UnitY());
    for (const SlitLoad& load : design.loads)
      if (load.strip == number && !load.at) add(at, half * area / whole * load.force);
  }
  for (const SlitLoad& load : design.loads)
    if (load.strip == number && load.at) {
      EXPECT_EQ(*load.at, 1.0);
      const auto& end = strip.ridges.back().folded;
      add(0.5 * (end[0] + end[1]), half * load.force);
    }
  return sum;
}

TEST(Equilibrium, ForcesAndMomentsOfEachStripBalance) {
  const SlitDesign design = loaded_chair();
  const SlitSession session = solved(design, 1);
  const auto state = session.equilibrium();
  const FoldedSlitSheet folded = session.folded();
  for (int strip = 0; strip < 6; ++strip) {
    auto [force, moment] = outside_of(design, folded.strips[strip], strip);
    double largest = 0.0;
    for (const SlitReaction& one : state->reactions) {
      if (one.strip != strip) continue;
      force += one.force;
      moment += one.moment + one.at.cross(one.force);
      largest = std::max(largest, one.force.norm());
    }
    EXPECT_LT(force.norm(), 1e-9 * largest) << strip;
    EXPECT_LT(moment.norm(), 1e-6 * largest) << strip;
  }
}

/// The panel's moment about a strip's first ridge is what its fold there bears: the reaction comes
/// from what acts beyond, the fold from the shape.
TEST(Equilibrium, FirstFoldBearsWhatThePanelHolds) {
  SlitDesign design = loaded_chair();
  design.seat_curve.reset();
  const SlitSession session = solved(design);
  const auto state = session.equilibrium();
  const FoldedSlitSheet folded = session.folded();
  for (int strip = 0; strip < 6; ++strip) {
    const auto& ridges = folded.strips[strip].ridges;
    const Vec3 axis = (ridges[0].folded[1] - ridges[0].folded[0]).normalized();
    const auto spacing = [&](int side) {
      return 0.5 * (ridges[1].flat[side].x() - ridges[0].flat[side].x());
    };
    const double left = spacing(0), right = spacing(1);
    const double wide = std::abs(right / left - 1.0) < 1e-9
                            ? 1.0 / left
                            : std::log(right / left) / (right - left);
    const double bears = design.material->rigidity(design.sheet.thickness) *
                         ridges[0].fold.radians() * 60.0 * wide;
    const SlitReaction panel = reaction_of(*state, strip, HeldBy::panel);
    EXPECT_NEAR(-panel.moment.dot(axis), bears, 1e-3 * std::abs(bears)) << strip;
  }
}

/// The same arch as a half and as a whole that may sway: they lose their stability together.
TEST(Equilibrium, HalfOfAnArchKnowsThatTheWholeSways) {
  const auto half = [](double newtons) -> bool {
    SlitDesign design = up_to_plane(0.2, 12);
    design.loads = {{0, 1.0, Vec3(0, -newtons, 0)}};
    return solved(design).equilibrium()->is_stable[0];
  };
  const auto whole = [](double newtons) {
    SlitDesign design = up_to_plane(0.2, 24);
    design.sheet.symmetric = false;
    design.sheet.half_length = 1200.0;
    design.second_panel = SecondPanel{{{{-120, 0}, {-120, 60}}}, 100.0, {}, false};
    design.loads = {{0, 0.5, Vec3(0, -newtons, 0)}};
    const SlitSession session = solved(design);
    const FoldedSlitSheet folded = session.folded();
    const auto& ridges = folded.strips[0].ridges;
    const double aside = 0.5 * (ridges[12].folded[0] + ridges[12].folded[1]).x();
    return std::abs(aside) < 1.0;
  };
  const auto loses = [](const std::function<bool(double)>& stays) {
    double low = 10.0, high = 150.0;
    for (int i = 0; i < 12; ++i) {
      const double middle = 0.5 * (low + high);
      (stays(middle) ? low : high) = middle;
    }
    return low;
  };
  const double of_half = loses(half), of_whole = loses(whole);
  EXPECT_GT(of_half, 20.0);
  EXPECT_LT(of_half, 140.0);
  EXPECT_NEAR(of_half, of_whole, 0.02 * of_half);
}

TEST(Equilibrium, GroundCarriesWhatRestsOnIt) {
  SlitDesign design = cantilever(90.0, 20);
  design.ground = true;
  design.gravity = true;
  design.material->density = density_for(design, 40.0);
  const SlitSession session = solved(design);
  const auto state = session.equilibrium();
  const SlitReaction ground = reaction_of(*state, 0, HeldBy::ground);
  const double weight = *design.material->density * kNewtons * 600.0 * 60.0;
  EXPECT_GT(ground.force.y(), 0.5 * weight);
  EXPECT_LT(ground.force.y(), weight * (1.0 + 1e-6));
}

TEST(Equilibrium, OfNoMaterialIsNothing) {
  EXPECT_FALSE(solved(small_chair()).equilibrium());
  SlitDesign smooth = small_chair();
  smooth.objective = SlitObjective::smooth;
  smooth.material = steel();
  const auto state = solved(smooth).equilibrium();
  EXPECT_EQ(state->stress.size(), 2u);
  EXPECT_TRUE(state->reactions.empty());
}

/// Beyond its yield stress a sheet keeps what it cannot spring back: M of an elastic, perfectly
/// plastic section, (t²/4) σ (1 − (κ_y/κ)²/3), over D.
TEST(Equilibrium, KeptCurvatureIsWhatTheMomentDoesNotUndo) {
  const SlitMaterial material = steel();
  const double t = 2.0, yields = 235.0 / material.stress(t, 1.0);
  EXPECT_EQ(material.kept_curvature(t, 0.999 * yields), 0.0);
  const double curvature = 3.0 * yields;
  constexpr int kLayers = 20000;
  double moment = 0.0;
  for (int i = 0; i < kLayers; ++i) {
    const double z = t * (i + 0.5) / kLayers - 0.5 * t;
    const double stress = material.young / 0.91 * curvature * z;
    moment += std::clamp(stress, -235.0, 235.0) * z * t / kLayers;
  }
  EXPECT_NEAR(material.kept_curvature(t, curvature), curvature - moment / material.rigidity(t),
              1e-6 * curvature);
}

}  // namespace
}  // namespace planish::test
