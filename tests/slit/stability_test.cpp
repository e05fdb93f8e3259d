#include "stability.hpp"

#include "sample_strips.hpp"

#include <cmath>
#include <numbers>
#include <vector>

// Strips that hold or push each other against columns in closed form or by shooting: what each does
// by itself is not what they do together.

namespace planish::test {
namespace {

constexpr double kLength = 600.0, kWidth = 60.0;
constexpr int kQuads = 40;

StripProblem flat_strip(const Frame& facet) {
  StripProblem problem;
  problem.base = {facet, {0.0, kWidth}, {0.0, 0.0}, {kLength, kLength}, kQuads};
  problem.objective = SlitObjective::energy;
  return problem;
}

/// Upright at x = 0, its normal along x; `weight`: q L³/D.
StripProblem column(double weight) {
  StripProblem problem = flat_strip({Vec3::Zero(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()});
  problem.load.spread = -weight / std::pow(kLength, 3) * Vec3::UnitY();
  return problem;
}

StripPoint tip(int strip) { return {strip, {{0, kQuads, 0.5}, {1, kQuads, 0.5}}}; }

RestingStrip resting(const StripProblem& problem, std::vector<PointForce> pressed = {}) {
  return {problem, flat_parameters(problem.base), std::move(pressed)};
}

/// Of a tip that must stay in front of another one.
Contact touching(int front, int back) { return {tip(front), tip(back), Vec3::UnitX(), 0.0, 0.0}; }
/// Tips that cannot leave each other across the strips.
std::vector<Contact> joined(int a, int b) { return {touching(a, b), touching(b, a)}; }

/// Force that moves the tip of a heavy column of unit length and rigidity aside by one:
/// φ″ + q (1 − s) φ + F = 0, φ(0) = φ′(1) = 0.
double tip_stiffness(double weight) {
  constexpr int kSteps = 4000;
  using State = Eigen::Vector3d;  // angle, curvature, aside
  const auto shot = [&](double curvature, double force) {
    const auto slope = [&](double at, const State& s) -> State {
      return {s[1], -weight * (1.0 - at) * s[0] - force, s[0]};
    };
    State s(0.0, curvature, 0.0);
    for (int i = 0; i < kSteps; ++i) {
      const double h = 1.0 / kSteps, at = i * h;
      const State a = slope(at, s), b = slope(at + 0.5 * h, s + 0.5 * h * a),
                  c = slope(at + 0.5 * h, s + 0.5 * h * b), d = slope(at + h, s + h * c);
      s += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return s;
  };
  const State of_curvature = shot(1.0, 0.0), of_force = shot(0.0, 1.0);
  const double curvature = -of_force[1] / of_curvature[1];
  return 1.0 / (curvature * of_curvature[2] + of_force[2]);
}

TEST(Stability, OfOneColumnIsLostAtGreenhillsLoad) {
  EXPECT_NEAR(tip_stiffness(0.0), 3.0, 1e-6);
  EXPECT_NEAR(tip_stiffness(7.8373), 0.0, 1e-4);
  for (const double weight : {7.75, 7.92})
    EXPECT_EQ(those_that_stay({resting(column(weight))}, {}, kLength, false),
              std::vector<bool>{weight < 7.8373})
        << weight;
}

/// A column too heavy for itself stands as long as the stiffness of a lighter one outweighs what it
/// lacks: k(q₁) + k(q₂) = 0.
TEST(Stability, LighterColumnHoldsAHeavierOne) {
  for (const double heavy : {9.0, 12.0, 15.0}) {
    double low = 0.0, high = 7.8373;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (tip_stiffness(middle) + tip_stiffness(heavy) > 0.0 ? low : high) = middle;
    }
    for (const double light : {low - 0.2, low + 0.2}) {
      const std::vector<RestingStrip> both{resting(column(heavy)), resting(column(light))};
      const bool stays = light < low;
      EXPECT_EQ(those_that_stay(both, joined(0, 1), kLength, false),
                (std::vector<bool>{stays, stays}))
          << heavy << ", " << light;
      EXPECT_EQ(those_that_stay(both, joined(1, 0), kLength, false),
                (std::vector<bool>{stays, stays}));
      EXPECT_EQ(those_that_stay(both, {}, kLength, false), (std::vector<bool>{false, true}));
    }
  }
}

/// Two columns that each stand while the other is held still fall over together; a third one that
/// they do not touch stands.
TEST(Stability, ColumnsThatLeanOnEachOtherFallTogether) {
  StripProblem beside_a_held_one = column(9.0);
  beside_a_held_one.ends = {{EndCondition::Of::middle, Vec3::UnitX(), 0.0}};
  EXPECT_TRUE(those_that_stay({resting(beside_a_held_one)}, {}, kLength, false)[0]);
  const std::vector<RestingStrip> strips{resting(column(9.0)), resting(column(5.0)),
                                         resting(column(9.0))};
  EXPECT_EQ(those_that_stay(strips, joined(0, 2), kLength, false),
            (std::vector<bool>{false, true, false}));
  std::vector<Contact> two_pairs = joined(0, 1);
  for (const Contact& contact : joined(2, 1))
    two_pairs.push_back(contact);
  EXPECT_EQ(those_that_stay(strips, two_pairs, kLength, false),
            std::vector<bool>(3, tip_stiffness(5.0) + 2.0 * tip_stiffness(9.0) > 0.0));
}

/// A column that is too heavy for itself, between two that touch it: where it may fall away from
/// one of them it does.
TEST(Stability, TouchingColumnsHoldFromOneSide) {
  const std::vector<RestingStrip> strips{resting(column(8.5)), resting(column(1.0)),
                                         resting(column(1.0))};
  EXPECT_EQ(those_that_stay(strips, {touching(0, 1)}, kLength, false),
            (std::vector<bool>{false, true, true}));
  EXPECT_EQ(those_that_stay(strips, {touching(0, 1), touching(0, 2)}, kLength, false),
            (std::vector<bool>{false, true, true}));
  EXPECT_EQ(those_that_stay(strips, {touching(0, 1), touching(2, 0)}, kLength, false),
            std::vector<bool>(3, true));
}

/// A strip that lies on the tip of a column and is pressed down there. The column by itself bears
/// π²/4, as Euler's does; but the strip's end turns and with it the force: k(F) · 4 = F², where
/// k(F) = λ³/(tan λ − λ), λ² = F, is the stiffness of the column's tip and 4 that of the strip's
/// end against a turn.
TEST(Stability, StripOnAColumnTurnsTheForceOnIt) {
  const auto is_enough = [](double force) {
    const double root = std::sqrt(force);
    return 4.0 * std::pow(root, 3) / (std::tan(root) - root) > force * force;
  };
  double critical = 1.0;
  while (is_enough(critical))
    critical += 1e-4;
  EXPECT_LT(critical, 0.75 * std::numbers::pi * std::numbers::pi / 4.0);
  for (const double force : {0.97 * critical, 1.03 * critical}) {
    StripProblem lying = flat_strip(
        {Vec3(-kLength, kLength, 0), Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()});
    const Vec3 down = -force * kWidth / (kLength * kLength) * Vec3::UnitY();
    lying.load.forces = {{1.0, down}};
    const Vec3 counted = energy_scale(lying.base) * down;
    const std::vector<RestingStrip> strips{resting(column(0.0), {{tip(0), counted}}),
                                           resting(lying, {{tip(1), -counted}})};
    const Contact contact{tip(0), tip(1), -Vec3::UnitY(), 0.0, counted.norm() * kLength};
    const bool stays = force < critical;
    EXPECT_EQ(those_that_stay(strips, {contact}, kLength, false)[0], stays) << force;
    EXPECT_TRUE(those_that_stay({strips[0]}, {}, kLength, false)[0]);
  }
}

}  // namespace
}  // namespace planish::test
