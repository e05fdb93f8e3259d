// The bending energy of a strip (math.md#bending-energy): a fold stands for the material up to the
// middles of its two quads, whose distance from the ridge goes linearly from one end to the other.
// At a clamped end a ridge has half of one quad; where the last quad is held in its direction it
// belongs to the last ridge whole, as there is no other to bend the rest. What must hold: the
// shares of all quads add up, so that the energy is that of the whole strip. Squares of lengths and
// areas are polynomials of the ridges' ends, so that only the logarithmic mean of two of them needs
// automatic derivatives.
#include "bend_energy.hpp"

#include "bent_fold.hpp"
#include "end_curvature.hpp"
#include "second_jet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace planish::slit_detail {
namespace {

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

/// ½ θ² ℓ ln(h_R/h_L)/(h_R − h_L), with ℓ h in place of h.
double energy_of(const BentFold& fold, double angle) {
  return 0.5 * angle * angle * fold.along().squaredNorm() *
         inverse_log_mean(fold.swept(0), fold.swept(1));
}

/// The energy of a fold with derivatives by its seven numbers.
struct FoldEnergy {
  double value = 0.0;
  OfFold gradient;
  TwiceOfFold hessian;
};

FoldEnergy derivatives_of(const BentFold& fold, double angle) {
  using Number = SecondJet<2>;
  const OfPlaces square = fold.square_of_length();
  const std::array<OfPlaces, 2> swept{fold.swept_by(0), fold.swept_by(1)};
  const Number mean = inverse_log_mean(variable<2>(swept[0].value, 0),
                                       variable<2>(swept[1].value, 1));
  // ½ θ² q m(a, b), by the chain rule; first all but the half square of the angle.
  OfFold of_mean = OfFold::Zero();
  TwiceOfFold twice_of_mean = TwiceOfFold::Zero();
  for (int i = 0; i < 2; ++i) {
    of_mean += mean.a.v[i] * swept[i].gradient;
    twice_of_mean += mean.a.v[i] * swept[i].hessian;
    for (int j = 0; j < 2; ++j)
      twice_of_mean += mean.v[i].v[j] * swept[i].gradient * swept[j].gradient.transpose();
  }
  const double m = mean.a.a, q = square.value;
  const OfFold slope = m * square.gradient + q * of_mean;
  const TwiceOfFold mixed = square.gradient * of_mean.transpose();
  FoldEnergy energy{
      0.5 * angle * angle * q * m, 0.5 * angle * angle * slope,
      0.5 * angle * angle * (m * square.hessian + q * twice_of_mean + mixed + mixed.transpose())};
  energy.gradient[0] = angle * q * m;
  energy.hessian(0, 0) = q * m;
  energy.hessian.row(0).tail<6>() = angle * slope.tail<6>().transpose();
  energy.hessian.col(0).tail<6>() = angle * slope.tail<6>();
  return energy;
}

void add(SecondOrder& to, const StripBase& base, int ridge, const FoldEnergy& energy) {
  const auto numbers = numbers_of_fold(base, ridge);
  const auto unit = [&](int i) { return i == 0 ? 1.0 : base.unit(); };
  to.value += energy.value;
  for (int i = 0; i < kOfFold; ++i) {
    if (numbers[i] < 0) continue;
    to.gradient[numbers[i]] += unit(i) * energy.gradient[i];
    for (int j = 0; j < kOfFold; ++j)
      if (numbers[j] >= 0)
        to.hessian(numbers[i], numbers[j]) += unit(i) * unit(j) * energy.hessian(i, j);
  }
}

/// The fold into the panel at the end, an angle of the last quad, with its derivatives.
SecondOrder far_angle(const StripProblem& problem, const StripParameters& p,
                      const StripFold& fold) {
  const Frame& facet = *problem.far_facet;
  const int quads = problem.base.quads;
  const Frame last = problem.base.along_last_ridge(fold.quad(quads - 1));
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
  const BentFold fold = fold_at(problem, p, base.quads);
  const FoldEnergy energy = derivatives_of(fold, angle.value);
  add(to, base, base.quads, energy);
  const double slope = energy.gradient[0];
  to.gradient += slope * angle.gradient;
  to.hessian += slope * angle.hessian +
                energy.hessian(0, 0) * angle.gradient * angle.gradient.transpose();
  const auto numbers = numbers_of_fold(base, base.quads);
  for (int i = 1; i < kOfFold; ++i) {
    if (numbers[i] < 0) continue;
    const double mixed = base.unit() * energy.hessian(0, i);
    to.hessian.row(numbers[i]) += mixed * angle.gradient.transpose();
    to.hessian.col(numbers[i]) += mixed * angle.gradient;
  }
}

}  // namespace

double bend_energy(const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  double energy = 0.0;
  for (int ridge = 0; ridge < base.quads; ++ridge)
    energy += energy_of(fold_at(problem, p, ridge), p[ridge]);
  if (problem.far_facet)
    energy += energy_of(fold_at(problem, p, base.quads),
                        fold_into(last_frame(base, p), *problem.far_facet).radians());
  return energy;
}

SecondOrder bend_energy_derivatives(const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  SecondOrder energy{0.0, Eigen::VectorXd::Zero(p.size()),
                     Eigen::MatrixXd::Zero(p.size(), p.size())};
  for (int ridge = 0; ridge < base.quads; ++ridge)
    add(energy, base, ridge, derivatives_of(fold_at(problem, p, ridge), p[ridge]));
  if (problem.far_facet) add_far_fold(energy, problem, p);
  return energy;
}

double largest_curvature(const StripProblem& problem, const StripParameters& p) {
  const StripBase& base = problem.base;
  double largest = 0.0;
  const auto see = [&](int ridge, double angle) {
    const BentFold fold = fold_at(problem, p, ridge);
    largest = std::max(largest, std::abs(angle) / std::min(fold.bent(0), fold.bent(1)));
  };
  for (int ridge = 0; ridge < base.quads; ++ridge)
    see(ridge, p[ridge]);
  if (problem.far_facet)
    see(base.quads, fold_into(last_frame(base, p), *problem.far_facet).radians());
  return largest;
}

Vec3 far_moment(const StripProblem& problem, const StripParameters& p) {
  if (!problem.far_facet) return Vec3::Zero();
  const Vec3& along = problem.far_facet->x;
  const Frame last = last_frame(problem.base, p);
  const double sine = -along.dot(last.z), cosine = along.dot(last.x),
               angle = std::atan2(sine, cosine);
  const double slope = derivatives_of(fold_at(problem, p, problem.base.quads), angle).gradient[0];
  return slope / (sine * sine + cosine * cosine) *
         (cosine * last.z.cross(along) + sine * last.x.cross(along));
}

double energy_scale(const StripBase& base) {
  constexpr double kWeight = 0.001;
  return kWeight * base.unit() / base.width();
}

}  // namespace planish::slit_detail
