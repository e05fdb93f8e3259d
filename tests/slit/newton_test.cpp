#include "newton.hpp"

#include "sample_sheets.hpp"
#include "sample_strips.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

// Strips of least bending energy against shapes found by other means: the planar elastica by
// quadrature and shooting, a twisted strip by Wunderlich's functional of its centre line.

namespace planish::test {
namespace {

using std::numbers::pi;

/// Of unit length and width, from upright to level: the state at its end.
struct Elastica {
  double angle = 0.0, away = 0.0, energy = 0.0;
};

/// φ″ = −F cos φ from φ(0) = 0, by Runge and Kutta's method.
Elastica shot(double curvature, double force) {
  constexpr int kSteps = 2000;
  using State = Eigen::Vector4d;  // angle, curvature, away, energy
  const auto slope = [&](const State& s) -> State {
    return {s[1], -force * std::cos(s[0]), std::sin(s[0]), 0.5 * s[1] * s[1]};
  };
  State s(0.0, curvature, 0.0, 0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double h = 1.0 / kSteps;
    const State a = slope(s), b = slope(s + 0.5 * h * a), c = slope(s + 0.5 * h * b),
                d = slope(s + h * c);
    s += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return {s[0], s[2], s[3]};
}

/// Energy of the elastica whose end is that far away, found from the quarter circle on, which needs
/// no force, in small steps.
double elastica_energy(double away) {
  double curvature = 0.5 * pi, force = 0.0;
  const double natural = 2.0 / pi;
  constexpr int kStages = 60;
  for (int stage = 1; stage <= kStages; ++stage) {
    const double wanted = natural + (away - natural) * stage / kStages;
    for (int i = 0; i < 30; ++i) {
      const auto missed = [&](double k, double f) {
        const Elastica end = shot(k, f);
        return Eigen::Vector2d(end.angle - 0.5 * pi, end.away - wanted);
      };
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
  return shot(curvature, force).energy;
}

/// One strip of 600 × 60 from an upright panel to the symmetry plane.
SlitDesign up_to_plane(double away, int ridges) {
  SlitDesign design;
  design.sheet.thickness = 4.0;
  design.sheet.panel_height = 420.0;
  design.sheet.half_length = 600.0;
  design.sheet.strips = equal_strips(1, 60.0);
  design.leg_curve = {{{600.0 * away, 0}, {600.0 * away, 60}}};
  design.ridges = ridges;
  design.objective = SlitObjective::energy;
  return design;
}

/// In units of the elastica of unit length and width.
double energy_found(double away, int ridges) {
  const SlitSession session = solved(up_to_plane(away, ridges));
  EXPECT_EQ(session.state(0).status, StripStatus::solved) << away;
  return session.state(0).energy * 600.0 / 60.0;
}

class LeastEnergy : public testing::TestWithParam<double> {};

TEST_P(LeastEnergy, IsThatOfTheElastica) {
  const double away = GetParam(), exact = elastica_energy(away);
  const double coarse = energy_found(away, 40), fine = energy_found(away, 80);
  EXPECT_LE(coarse, 1.001 * exact);
  EXPECT_GE(coarse, (1.0 - 4e-3) * exact);
  // Half the spacing, a quarter of the error; where it is small it also changes its sign.
  EXPECT_LE(std::abs(fine - exact), std::max(0.3 * std::abs(coarse - exact), 2e-5 * exact));
}

TEST_P(LeastEnergy, StaysAboveTheGround) {
  const FoldedSlitSheet folded = solved(up_to_plane(GetParam(), 40)).folded();
  for (const SlitRidge& ridge : folded.strips[0].ridges)
    for (const Vec3& end : ridge.folded)
      EXPECT_GE(end.y(), 420.0 - 1e-6);
}

/// Near the plane a strip may also turn once more; far from it there is one shape.
TEST(RunnerUp, IsToldWhereAnotherShapeIsKnown) {
  const StripState near = solved(up_to_plane(0.1, 20)).state(0),
                   far = solved(up_to_plane(0.6, 20)).state(0);
  ASSERT_TRUE(near.runner_up_energy);
  EXPECT_GT(*near.runner_up_energy, 1.5 * near.energy);
  EXPECT_FALSE(far.runner_up_energy);
}

INSTANTIATE_TEST_SUITE_P(NineDistances, LeastEnergy,
                         testing::Values(0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9));

/// A strip of length and width by its centre line: curvature κ and slope η = τ/κ of its rulings,
/// linear between nodes. Both ends of rulings are held across.
class CentreLine {
 public:
  CentreLine(double length, double width, int nodes)
      : length_(length), width_(width), nodes_(nodes) {}

  int unknowns() const { return 2 * nodes_ + 2; }

  /// End of the centre line, its direction and the direction across there, and the energy's roots:
  /// U = ½ Σ r² (Wunderlich).
  struct Shape {
    Vec3 end = Vec3::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // along, across, normal
    Eigen::VectorXd roots;
  };
  Shape shape(const Eigen::VectorXd& x) const {
    constexpr int kParts = 8;
    Shape shape;
    shape.roots.resize((nodes_ + 1) * kParts);
    const double h = length_ / (nodes_ + 1), part = h / kParts;
    for (int i = 0; i <= nodes_; ++i)
      for (int j = 0; j < kParts; ++j) {
        const double at = (j + 0.5) / kParts;
        const double curvature = (1.0 - at) * x[i] + at * x[i + 1];
        const double before = i > 0 ? x[nodes_ + 2 + i - 1] : 0.0,
                     after = i < nodes_ ? x[nodes_ + 2 + i] : 0.0;
        const double slope = (1.0 - at) * before + at * after, change = (after - before) / h;
        // Turned about the ruling, which runs along η t + b.
        const Vec3 turn = part * curvature * (slope * Vec3::UnitX() + Vec3::UnitY());
        const Eigen::Matrix3d half(Eigen::AngleAxisd(0.5 * turn.norm(), turn.normalized()));
        shape.axes *= half;
        shape.end += part * shape.axes.col(0);
        shape.axes *= half;
        const double u = 0.5 * change * width_;
        const double spread = std::abs(u) < 1e-3 ? 1.0 + u * u / 3.0 : std::atanh(u) / u;
        shape.roots[i * kParts + j] = curvature * (1.0 + slope * slope) *
                                      std::sqrt(part * width_ * spread);
      }
    return shape;
  }

  /// The least energy with that end, from a start, by an augmented Lagrangian and Gauss–Newton
  /// steps.
  double least(const Shape& wanted, Eigen::VectorXd x) const {
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(6);
    const double weight = 300.0;
    const auto missed = [&](const Shape& s) {
      Eigen::VectorXd c(6);
      c << (s.end - wanted.end) / length_,
          0.5 * (s.axes.col(0).cross(wanted.axes.col(0)) + s.axes.col(1).cross(wanted.axes.col(1)));
      return c;
    };
    const auto residuals = [&](const Eigen::VectorXd& at) {
      const Shape s = shape(at);
      Eigen::VectorXd r(s.roots.size() + 6);
      r << s.roots, std::sqrt(weight) * (missed(s) + multipliers / weight);
      return r;
    };
    double damping = 1e-3;
    for (int round = 0; round < 12; ++round) {
      for (int i = 0; i < 60; ++i) {
        const Eigen::VectorXd now = residuals(x);
        Eigen::MatrixXd jacobian(now.size(), x.size());
        for (Eigen::Index q = 0; q < x.size(); ++q) {
          Eigen::VectorXd up = x;
          up[q] += 1e-7;
          jacobian.col(q) = (residuals(up) - now) / 1e-7;
        }
        Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
        normal.diagonal() *= 1.0 + damping;
        const Eigen::VectorXd step = normal.ldlt().solve(-jacobian.transpose() * now);
        const double gain = now.squaredNorm() - residuals(x + step).squaredNorm();
        damping = std::clamp(gain > 0.0 ? 0.2 * damping : 5.0 * damping, 1e-9, 1e3);
        if (gain > 0.0) x += step;
        if (gain > 0.0 && gain < 1e-10 * now.squaredNorm()) break;
      }
      multipliers += weight * missed(shape(x));
    }
    EXPECT_LT(missed(shape(x)).norm(), 1e-6);
    return 0.5 * shape(x).roots.squaredNorm();
  }

 private:
  double length_, width_;
  int nodes_;
};

/// Bent by a quarter of a turn and twisted on the way: its end lies beside the plane in which it
/// began, and is turned out of it.
TEST(LeastEnergyOfATwistedStrip, IsThatOfWunderlichsFunctional) {
  const double length = 600.0, width = 60.0;
  SlitDesign design;
  design.sheet.thickness = 1.0;
  design.sheet.panel_height = 50.0;
  design.sheet.half_length = length;
  design.sheet.symmetric = false;
  design.sheet.strips = equal_strips(1, width);
  design.leg_curve = {{{100, 0}, {100, width}}};
  design.objective = SlitObjective::energy;
  design.ridges = 20;
  // The panel's front faces +x: along is up (y), across +z, the normal along × across.
  Eigen::Matrix3d panel;
  panel.col(0) = Vec3::UnitY();
  panel.col(1) = Vec3::UnitZ();
  panel.col(2) = Vec3::UnitX();
  const Vec3 begin(100, 50, 0.5 * width);

  CentreLine line(length, width, 24);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(line.unknowns());
  for (int i = 0; i < 26; ++i)
    x[i] = -0.5 * pi / length * (1.0 + 0.8 * std::sin(2.0 * pi * i / 25.0));
  for (int i = 1; i < 25; ++i)
    x[25 + i] = 0.6 * std::sin(pi * i / 25.0) * (0.3 + i / 25.0);
  const CentreLine::Shape wanted = line.shape(x);
  const double least = line.least(wanted, x);

  design.ends = {{.position = begin + panel * wanted.end,
                  .direction = panel * wanted.axes.col(0),
                  .across = panel * wanted.axes.col(1)}};
  auto session = solved_slit_sheet(design, 2);
  ASSERT_TRUE(session);
  EXPECT_EQ(session->state(0).status, StripStatus::solved);
  EXPECT_NEAR(session->state(0).energy, least, 1e-3 * least);
}

/// From an upright panel to an end that points up as well, as low as the panel: it swings below.
SlitDesign hanging(SlitObjective objective, bool ground) {
  SlitDesign design;
  design.sheet.thickness = 2.0;
  design.sheet.panel_height = 20.0;
  design.sheet.half_length = 600.0;
  design.sheet.symmetric = false;
  design.sheet.strips = equal_strips(1, 40.0);
  design.leg_curve = {{{0, 0}, {0, 40}}};
  design.ends = {
      {.position = Vec3(-150, 20, 20), .direction = Vec3::UnitY(), .across = Vec3::UnitZ()}};
  design.ridges = 40;
  design.objective = objective;
  design.ground = ground;
  return design;
}

TEST(Ground, IsNotGoneBelow) {
  const auto lowest = [](const SlitSession& session) {
    const FoldedSlitSheet folded = session.folded();
    double y = std::numeric_limits<double>::infinity();
    for (const SlitRidge& ridge : folded.strips[0].ridges)
      for (const Vec3& end : ridge.folded)
        y = std::min(y, end.y());
    return y;
  };
  const SlitSession free = solved(hanging(SlitObjective::energy, false));
  ASSERT_EQ(free.state(0).status, StripStatus::solved);
  ASSERT_LT(lowest(free), -20.0);
  const SlitSession held = solved(hanging(SlitObjective::energy, true));
  EXPECT_EQ(held.state(0).status, StripStatus::solved);
  EXPECT_GE(lowest(held), 1.0 - 1e-4);  // half the thickness, within 1e-7 of the length
  EXPECT_EQ(held.state(0).below_ground, 0.0);
  EXPECT_GT(held.state(0).energy, free.state(0).energy);
}

TEST(DescendByNewton, TakesFewStepsNearTheMinimum) {
  StripProblem problem;
  problem.base = some_base(40);
  problem.objective = SlitObjective::energy;
  problem.ends = {{EndCondition::Of::left_end, Vec3::UnitX(), 60},
                  {EndCondition::Of::right_end, Vec3::UnitX(), 60}};
  const Reach start = meet_ends(problem, random_parameters(problem.base, 2, 0.1));
  ASSERT_TRUE(start.met());
  const Descent least = descend_by_newton(problem, start.p, {.function_tolerance = 1e-12});
  ASSERT_TRUE(least.converged);
  StripParameters moved = least.p;
  moved[20] += 0.002;
  const Descent again = descend_by_newton(problem, meet_ends(problem, moved).p,
                                          {.function_tolerance = 1e-12});
  EXPECT_TRUE(again.converged);
  EXPECT_LE(again.iterations, 4);
  EXPECT_NEAR(again.objective, least.objective, 1e-10 * least.objective);
  EXPECT_LE(end_violation(problem, folded(problem.base, again.p)).cwiseAbs().maxCoeff(), kEndsMet);
}

TEST(DescendByNewton, StopsWhenAsked) {
  StripProblem problem;
  problem.base = some_base(8);
  problem.objective = SlitObjective::energy;
  const Descent descent = descend_by_newton(problem, random_parameters(problem.base, 2, 0.3),
                                            {.stop = [] { return true; }});
  EXPECT_FALSE(descent.converged);
  EXPECT_LE(descent.iterations, 1);
}

}  // namespace
}  // namespace planish::test
