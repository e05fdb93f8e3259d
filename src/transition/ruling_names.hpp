#pragma once

#include "hull.hpp"

#include <planish/transition/transition.hpp>

#include <array>
#include <string>
#include <vector>

namespace planish::transition_detail {

/// Names of the ends of rulings, as on templates: corners of the first profile are A, B, C …, of
/// the second a, b, c …; other points are numbered in order, those of the second profile with a
/// prime.
class RulingNames {
 public:
  /// Points within `near` (mm) of each other are one.
  RulingNames(const Hull& hull, double near) : hull_(hull), near_(near) {}

  /// Names both ends of a ruling, which becomes a true length of that piece. A known ruling keeps
  /// its name and piece.
  std::array<std::string, 2> add(const std::array<Vec3, 2>& points, const std::string& press,
                                 int piece);

  const std::vector<TrueLength>& true_lengths() const { return lengths_; }

 private:
  std::string name(int side, const Vec3& p);
  bool same(const Vec3& a, const Vec3& b) const { return (a - b).norm() <= near_; }

  const Hull& hull_;
  double near_;
  std::vector<TrueLength> lengths_;
  std::array<std::vector<Vec3>, 2> points_;  // that have a number
};

}  // namespace planish::transition_detail
