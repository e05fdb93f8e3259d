#pragma once

#include "strip_problem.hpp"

#include <Eigen/Core>

#include <array>

namespace planish::slit_detail {

/// What a fold depends on: its angle, and where the ends of the ridge before, of its own and of the
/// next one are on their edges, left and right in turn.
inline constexpr int kOfFold = 7;
using OfFold = Eigen::Matrix<double, kOfFold, 1>;
using TwiceOfFold = Eigen::Matrix<double, kOfFold, kOfFold>;

/// A number made of places of a fold, with its derivatives by them.
struct OfPlaces {
  double value = 0.0;
  OfFold gradient = OfFold::Zero();
  TwiceOfFold hessian = TwiceOfFold::Zero();
};

/// A fold and the material that is bent with it (math.md#bending-energy): a share of the quads
/// before and behind its ridge. Before the first ridge and behind the last there is nothing: the
/// places there do not count.
struct BentFold {
  int ridge = 0;
  std::array<EdgePlace, 6> places;
  double before = 0.5, after = 0.5;  ///< the shares

  /// Of the ridge, from left to right.
  Vec2 along() const;
  /// How far the material goes at the end of the ridge, at right angles to it, times the ridge's
  /// length: a product of places.
  double swept(int side) const;
  double bent(int side) const { return swept(side) / along().norm(); }
  /// Radius of the arc that turns by an angle on it, where it is narrower.
  double radius(double angle) const;

  OfPlaces square_of_length() const;
  OfPlaces swept_by(int side) const;

 private:
  double share_of(int place) const;
  Vec2 way(int side) const;
};

BentFold fold_at(const StripProblem& problem, const StripParameters& p, int ridge);

/// Where the seven numbers stand among the parameters; −1: fixed.
std::array<int, kOfFold> numbers_of_fold(const StripBase& base, int ridge);

}  // namespace planish::slit_detail
