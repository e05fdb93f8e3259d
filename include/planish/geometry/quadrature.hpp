#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace planish {

/// ∫ f over [a, b] by the 5-point Gauss–Legendre rule: exact for polynomials up to degree 9.
template <typename Function>
double gauss(const Function& f, double a, double b) {
  constexpr std::array<double, 3> kNodes{0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> kWeights{0.5688888888888889, 0.4786286704993665,
                                           0.2369268850561891};
  const double middle = (a + b) / 2;
  const double half = (b - a) / 2;
  double sum = kWeights[0] * f(middle);
  for (std::size_t i = 1; i < kNodes.size(); ++i)
    sum += kWeights[i] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
  return sum * half;
}

/// The same with intervals halved until two halves agree with their whole within `error`. Twelve
/// times at most, which is enough even at a kink of f.
template <typename Function>
double adaptive_gauss(const Function& f, double a, double b, double whole, double error,
                      int halvings = 12) {
  const double middle = (a + b) / 2;
  const double left = gauss(f, a, middle);
  const double right = gauss(f, middle, b);
  if (halvings == 0 || std::abs(left + right - whole) <= error) return left + right;
  return adaptive_gauss(f, a, middle, left, error, halvings - 1) +
         adaptive_gauss(f, middle, b, right, error, halvings - 1);
}

template <typename Function>
double adaptive_gauss(const Function& f, double a, double b, double error) {
  return adaptive_gauss(f, a, b, gauss(f, a, b), error);
}

}  // namespace planish
