// The bending energy of a strip (math.md#bending-energy): a fold stands for the material up to the
// middles of its two quads, whose distance from the ridge goes linearly from one end to the other.
// At a clamped end a ridge has half of one quad; where the last quad is held in its direction it
// belongs to the last ridge whole, as there is no other to bend the rest. What must hold: the
// shares of all quads add up, so that the energy is that of the whole strip. Derivatives are
// automatic, of second order.
#include "bend_energy.hpp"

#include "end_curvature.hpp"
#include "second_jet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace planish::slit_detail {
namespace {

constexpr int kOfFold = 7;  // its angle, and both ends of the ridge before, of its own, of the next
using Second = SecondJet<kOfFold>;

/// 1 / the logarithmic mean: ln(b/a)/(b − a).
template <typename T>
T inverse_log_mean(const T& a, const T& b) {
  using std::log;
  constexpr double kAlike = 0.1;
  const T sum = a + b, u = (b - a) / sum;
  if (std::abs(value_of(u)) > kAlike) return log(b / a) / (b - a);
  // 2 artanh(u) / (b − a), as a series that ends below rounding.
  const T square = u * u;
  T series = constant<T>(0.0), power = constant<T>(2.0);
  for (int k = 1; k < 19; k += 2) {
    series += constant<T>(1.0 / k) * power;
    power *= square;
  }
  return series / sum;
}

/// The shares of the quads before and behind a ridge that are bent with it.
struct Shares {
  double before = 0.5, after = 0.5;
};

/// How long a ridge is, and how far the material that is bent with it goes at its ends, at right
/// angles to it.
template <typename T>
struct Bent {
  T length, left, right;
};
/// `places`: abscissae of left and right ends in turn.
template <typename T>
Bent<T> bent_with(const std::array<T, 6>& places, double width, const Shares& shares) {
  using std::sqrt;
  const T skew = places[3] - places[2], length = sqrt(skew * skew + constant<T>(width * width));
  const auto apart = [&](std::size_t side) {
    return (constant<T>(shares.before) * (places[2 + side] - places[side]) +
            constant<T>(shares.after) * (places[4 + side] - places[2 + side])) *
           constant<T>(width) / length;
  };
  return {length, apart(0), apart(1)};
}

/// ½ θ² ℓ ln(h_R/h_L)/(h_R − h_L).
template <typename T>
T energy_of_fold(const T& angle, const std::array<T, 6>& places, double width,
                 const Shares& shares) {
  const Bent<T> bent = bent_with(places, width, shares);
  return constant<T>(0.5) * angle * angle * bent.length * inverse_log_mean(bent.left, bent.right);
}

bool is_held_in_direction(const StripProblem& problem) {
  if (problem.far_facet) return false;
  return std::ranges::any_of(problem.ends, [](const EndCondition& end) {
    return end.of == EndCondition::Of::along || end.of == EndCondition::Of::normal;
  });
}

/// A fold with all that its energy depends on. Before the first ridge and behind the last there is
/// nothing: the abscissae there do not count.
struct Fold {
  int ridge = 0;
  std::array<double, 6> places{};
  Shares shares;
};

Fold fold_at(const StripProblem& problem, const StripParameters& p, int ridge) {
  const StripBase& base = problem.base;
  Fold fold{ridge, {}, {}};
  for (int near = 0; near < 3; ++near)
    for (int side = 0; side < 2; ++side) {
      const int at = std::clamp(ridge - 1 + near, 0, base.quads);
      fold.places[2 * near + side] = abscissa(base, p, at, side);
    }
  if (ridge == 0) fold.shares.before = 0.0;
  if (ridge == base.quads) fold.shares.after = 0.0;
  if (ridge + 1 == base.quads && is_held_in_direction(problem)) fold.shares.after = 1.0;
  return fold;
}

double energy_of(const Fold& fold, double angle, double width) {
  return energy_of_fold<double>(angle, fold.places, width, fold.shares);
}

/// The energy of a fold with derivatives by its seven numbers.
Second derivatives_of(const Fold& fold, double angle, double width) {
  std::array<Second, 6> places;
  for (int i = 0; i < 6; ++i)
    places[i] = variable<kOfFold>(fold.places[i], i + 1);
  return energy_of_fold<Second>(variable<kOfFold>(angle, 0), places, width, fold.shares);
}

/// Where the seven numbers stand among the parameters (−1: fixed), and their units.
std::array<int, kOfFold> numbers_of(const StripBase& base, int ridge) {
  std::array<int, kOfFold> numbers{};
  numbers[0] = ridge < base.quads ? ridge : -1;
  for (int near = 0; near < 3; ++near)
    for (int side = 0; side < 2; ++side) {
      const int at = ridge - 1 + near;
      numbers[1 + 2 * near + side] = at > 0 && at < base.quads
                                         ? abscissa_index(base.quads, at, side)
                                         : -1;
    }
  return numbers;
}

void add(SecondOrder& to, const StripBase& base, int ridge, const Second& energy) {
  const auto numbers = numbers_of(base, ridge);
  const auto unit = [&](std::size_t i) { return i == 0 ? 1.0 : base.unit(); };
  to.value += energy.a.a;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0) continue;
    const auto row = static_cast<Eigen::Index>(i);
    to.gradient[numbers[i]] += unit(i) * energy.a.v[row];
    for (std::size_t j = 0; j < numbers.size(); ++j)
      if (numbers[j] >= 0)
        to.hessian(numbers[i], numbers[j]) += unit(i) * unit(j) *
                                              energy.v[row].v[static_cast<Eigen::Index>(j)];
  }
}

/// The fold into the panel at the end, an angle of the last quad, with its derivatives.
SecondOrder far_angle(const StripProblem& problem, const StripParameters& p,
                      const StripFold& fold) {
  const Frame& facet = *problem.far_facet;
  const int quads = problem.base.quads;
  const Frame& last = fold.quad(quads - 1);
  const double sine = -facet.x.dot(last.z), cosine = facet.x.dot(last.x),
               square = sine * sine + cosine * cosine;
  const std::vector<Twist> all = twists(problem.base, fold);
  SecondOrder angle{fold_into(last, facet).radians(), Eigen::VectorXd(problem.parameters()), {}};
  for (std::size_t q = 0; q < all.size(); ++q) {
    const double of_sine = -facet.x.dot(all[q].axis.cross(last.z)),
                 of_cosine = facet.x.dot(all[q].axis.cross(last.x));
    angle.gradient[static_cast<Eigen::Index>(q)] = (cosine * of_sine - sine * of_cosine) / square;
  }
  // What the square of sine and cosine contributes vanishes where the ridge lies on the facet.
  angle.hessian = second_derivatives(problem.base, p, fold,
                                     {{quads, false, last.z, -cosine / square * facet.x},
                                      {quads, false, last.x, -sine / square * facet.x}});
  return angle;
}

/// ½ θ² ℓ/h as a function of the angle and of abscissae, the angle one of all parameters.
void add_far_fold(SecondOrder& to, const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  const SecondOrder angle = far_angle(problem, p, folded(base, p));
  const Fold fold = fold_at(problem, p, base.quads);
  const Second energy = derivatives_of(fold, angle.value, base.width());
  add(to, base, base.quads, energy);
  const double slope = energy.a.v[0];
  to.gradient += slope * angle.gradient;
  to.hessian += slope * angle.hessian +
                energy.v[0].v[0] * angle.gradient * angle.gradient.transpose();
  const auto numbers = numbers_of(base, base.quads);
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] < 0) continue;
    const double mixed = base.unit() * energy.v[0].v[static_cast<Eigen::Index>(i)];
    to.hessian.row(numbers[i]) += mixed * angle.gradient.transpose();
    to.hessian.col(numbers[i]) += mixed * angle.gradient;
  }
}

}  // namespace

double bend_energy(const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  double energy = 0.0;
  for (int ridge = 0; ridge < base.quads; ++ridge)
    energy += energy_of(fold_at(problem, p, ridge), p[ridge], base.width());
  if (problem.far_facet)
    energy += energy_of(
        fold_at(problem, p, base.quads),
        fold_into(folded(base, p).quad(base.quads - 1), *problem.far_facet).radians(),
        base.width());
  return energy;
}

SecondOrder bend_energy_derivatives(const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  SecondOrder energy{0.0, Eigen::VectorXd::Zero(p.size()),
                     Eigen::MatrixXd::Zero(p.size(), p.size())};
  for (int ridge = 0; ridge < base.quads; ++ridge)
    add(energy, base, ridge, derivatives_of(fold_at(problem, p, ridge), p[ridge], base.width()));
  if (problem.far_facet) add_far_fold(energy, problem, p);
  return energy;
}

double largest_curvature(const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  double largest = 0.0;
  const auto see = [&](int ridge, double angle) {
    const Fold fold = fold_at(problem, p, ridge);
    const Bent<double> bent = bent_with(fold.places, base.width(), fold.shares);
    largest = std::max(largest, std::abs(angle) / std::min(bent.left, bent.right));
  };
  for (int ridge = 0; ridge < base.quads; ++ridge)
    see(ridge, p[ridge]);
  if (problem.far_facet)
    see(base.quads, fold_into(folded(base, p).quad(base.quads - 1), *problem.far_facet).radians());
  return largest;
}

Vec3 far_moment(const StripProblem& problem, const StripParameters& p) {
  if (!problem.far_facet) return Vec3::Zero();
  const Vec3& along = problem.far_facet->x;
  const Frame last = folded(problem.base, p).quad(problem.base.quads - 1);
  const double sine = -along.dot(last.z), cosine = along.dot(last.x),
               angle = std::atan2(sine, cosine);
  const double slope = derivatives_of(fold_at(problem, p, problem.base.quads), angle,
                                      problem.base.width())
                           .a.v[0];
  return slope / (sine * sine + cosine * cosine) *
         (cosine * last.z.cross(along) + sine * last.x.cross(along));
}

double energy_scale(const StripBase& base) {
  constexpr double kWeight = 0.001;
  return kWeight * base.unit() / base.width();
}

}  // namespace planish::slit_detail
