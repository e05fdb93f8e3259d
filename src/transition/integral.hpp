#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace planish::transition_detail {

/// ∫ f over [a, b] by Gauss's rule of eight points on parts that are halved until both halves agree with the
/// whole within 1e-13 of it, 2^12 parts at most.
template <typename Function>
double integral(const Function& f, double a, double b) {
  static constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  static constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  const auto rule = [&](double low, double high) {
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    double sum = 0.0;
    for (std::size_t i = 0; i < kNodes.size(); ++i)
      sum += kWeights[i] * (f(middle - kNodes[i] * half) + f(middle + kNodes[i] * half));
    return half * sum;
  };
  const double whole = rule(a, b);
  const auto halved = [&](const auto& self, double low, double high, double value, int halvings) -> double {
    const double middle = 0.5 * (low + high), left = rule(low, middle), right = rule(middle, high);
    constexpr double kAgreement = 1e-13;
    if (halvings == 0 || std::abs(left + right - value) <= kAgreement * std::abs(whole)) return left + right;
    return self(self, low, middle, left, halvings - 1) + self(self, middle, high, right, halvings - 1);
  };
  constexpr int kHalvings = 12;
  return a == b ? 0.0 : halved(halved, a, b, whole, kHalvings);
}

/// ∫ f over an interval on which f is nearly a polynomial of the fifth degree, by Gauss's rule of three points.
template <typename Function>
double short_integral(const Function& f, double a, double b) {
  const double middle = 0.5 * (a + b), aside = 0.5 * (b - a) * std::sqrt(0.6);
  return (b - a) / 18.0 * (5.0 * f(middle - aside) + 8.0 * f(middle) + 5.0 * f(middle + aside));
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
