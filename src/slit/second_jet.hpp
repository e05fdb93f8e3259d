#pragma once

#include <ceres/jet.h>

namespace planish::slit_detail {

/// A number with first and second derivatives by N others: `x.a.a`, `x.a.v[i]`, `x.v[i].v[j]`.
template <int N>
using SecondJet = ceres::Jet<ceres::Jet<double, N>, N>;

/// One of the N.
template <int N>
SecondJet<N> variable(double value, int number) {
  SecondJet<N> x(ceres::Jet<double, N>(value), number);
  x.a.v[number] = 1.0;
  return x;
}

inline double value_of(double x) { return x; }
template <typename T, int N>
double value_of(const ceres::Jet<T, N>& x) {
  return value_of(x.a);
}

template <typename T>
struct Constant {
  static T of(double value) { return value; }
};
template <typename T, int N>
struct Constant<ceres::Jet<T, N>> {
  static ceres::Jet<T, N> of(double value) { return ceres::Jet<T, N>(Constant<T>::of(value)); }
};
/// A number that depends on none of the N.
template <typename T>
T constant(double value) {
  return Constant<T>::of(value);
}

}  // namespace planish::slit_detail
