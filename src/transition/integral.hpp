#pragma once

// Integrals by Gauss's rule with halving, and their inverse: the place up to which an integral is a
// given amount. Parts are halved until both halves agree with the whole; the inverse reads
// polynomials through Gauss's points, so that a length along a curve is found without integrating
// again.

#include "roots.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace planish::transition_detail {

/// ∫ f over [a, b] by Gauss's rule of eight points on parts that are halved until both halves agree
/// with the whole within 1e-13 of it, 2^12 parts at most.
template <typename Function>
double integral(const Function& f, double a, double b) {
  static constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290,
                                                0.7966664774136267, 0.9602898564975363};
  static constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873,
                                                  0.2223810344533745, 0.1012285362903763};
  const auto rule = [&](double low, double high) {
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    double sum = 0.0;
    for (std::size_t i = 0; i < kNodes.size(); ++i)
      sum += kWeights[i] * (f(middle - kNodes[i] * half) + f(middle + kNodes[i] * half));
    return half * sum;
  };
  const double whole = rule(a, b);
  const auto halved = [&](const auto& self, double low, double high, double value,
                          int halvings) -> double {
    const double middle = 0.5 * (low + high), left = rule(low, middle), right = rule(middle, high);
    constexpr double kAgreement = 1e-13;
    if (halvings == 0 || std::abs(left + right - value) <= kAgreement * std::abs(whole))
      return left + right;
    return self(self, low, middle, left, halvings - 1) +
           self(self, middle, high, right, halvings - 1);
  };
  constexpr int kHalvings = 12;
  return a == b ? 0.0 : halved(halved, a, b, whole, kHalvings);
}

/// ∫ f from the start of an interval on, f > 0 being nearly a polynomial of the fourth degree
/// there: the one through Gauss's five points.
class PartIntegral {
 public:
  template <typename Function>
  PartIntegral(const Function& f, double a, double b) : start_(a), run_(b - a) {
    static constexpr std::array<double, 5> kNodes{0.04691007703066800, 0.2307653449471585, 0.5,
                                                  0.7692346550528415, 0.9530899229693320};
    static constexpr std::array<double, 5> kWeights{0.1184634425280945, 0.2393143352496832,
                                                    0.2844444444444444, 0.2393143352496832,
                                                    0.1184634425280945};
    // Legendre's polynomials on [0, 1], by ascending powers: orthogonal also as sums over the five
    // points.
    static constexpr std::array<std::array<double, 5>, 5> kLegendre{{{1, 0, 0, 0, 0},
                                                                     {-1, 2, 0, 0, 0},
                                                                     {1, -6, 6, 0, 0},
                                                                     {-1, 12, -30, 20, 0},
                                                                     {1, -20, 90, -140, 70}}};
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double weighted = run_ * kWeights[i] * f(a + kNodes[i] * run_);
      for (std::size_t k = 0; k < kLegendre.size(); ++k) {
        const double share = (2.0 * static_cast<double>(k) + 1.0) * weighted *
                             value(kLegendre[k], kNodes[i]);
        for (std::size_t power = 0; power <= k; ++power)
          rate_[power] += share * kLegendre[k][power];
      }
    }
    for (std::size_t power = 0; power < rate_.size(); ++power)
      sum_[power] = rate_[power] / (static_cast<double>(power) + 1.0);
  }

  double whole() const { return value(sum_, 1.0); }
  double first_half() const { return 0.5 * value(sum_, 0.5); }
  /// The place up to which the integral is `amount`, from 0 to the whole.
  double place_of(double amount) const {
    return start_ + run_ * root_between(
                               [&](double x) {
                                 return std::pair{x * value(sum_, x) - amount, value(rate_, x)};
                               },
                               0.0, 1.0);
  }

 private:
  static double value(const std::array<double, 5>& powers, double x) {
    double value = 0.0;
    for (std::size_t i = powers.size(); i-- > 0;)
      value = value * x + powers[i];
    return value;
  }

  double start_, run_;
  std::array<double, 5> rate_{}, sum_{};  ///< ascending powers of the share of the interval; of
                                          ///< `sum_`, those of the integral but one
};

/// Appends parts from a to b, halved until integrals up to any place are within 2e-9 of the whole,
/// 2^10 parts at most.
template <typename Function>
void add_parts(std::vector<PartIntegral>& parts, const Function& f, double a, double b) {
  const PartIntegral whole(f, a, b);
  const auto halved = [&](const auto& self, double low, double high, const PartIntegral& part,
                          int halvings) -> void {
    const double middle = 0.5 * (low + high);
    const PartIntegral left(f, low, middle), right(f, middle, high);
    // Halving reduces the error by 2^6.
    constexpr double kNear = 1e-7;
    if (halvings == 0 ||
        std::abs(left.whole() - part.first_half()) <= kNear * std::abs(whole.whole())) {
      parts.push_back(left);
      parts.push_back(right);
      return;
    }
    self(self, low, middle, left, halvings - 1);
    self(self, middle, high, right, halvings - 1);
  };
  constexpr int kHalvings = 9;
  halved(halved, a, b, whole, kHalvings);
}

/// The same as `integral` from the first to the last of `breaks`, at which f may be less smooth.
template <typename Function>
double integral_over(const Function& f, const std::vector<double>& breaks) {
  double sum = 0.0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
    sum += integral(f, breaks[i - 1], breaks[i]);
  return sum;
}

}  // namespace planish::transition_detail
