#pragma once

#include <planish/sheet/sheet.hpp>

#include <Geom2d_Curve.hxx>

#include <functional>
#include <vector>

namespace planish::brep {

/// |∂x/∂u| across the ruling, `depth` below the reference skin of a face on a ruled surface;
/// negative past the edge of regression. Linear in v and in the depth. By differences: relative
/// accuracy about 1e-9.
double speed_across(const Face& face, const Vec2& uv, double depth);

/// The polynomial through the values of a function at the extrema of a Chebyshev polynomial in [lo,
/// hi]: of an analytic function its error falls geometrically with the number of nodes.
class NodePolynomial {
 public:
  NodePolynomial() = default;
  /// Requires: lo < hi, 2 nodes or more.
  NodePolynomial(const std::function<double(double)>& f, double lo, double hi, int nodes);

  double operator()(double u) const;

 private:
  std::vector<double> nodes_, values_;
};

/// The part of each ruling that a face on a ruled surface uses: the face lies in lo(u) … hi(u).
/// This is the face's extent for all u, unless the edge of regression enters it; then the limit on
/// that side stays clear of it.
class RulingRange {
 public:
  explicit RulingRange(const Box2& box) : box_(box) {}

  double lo(double u) const;
  double hi(double u) const;
  bool constant() const { return reach_ == 0.0; }
  const Box2& box() const { return box_; }

 private:
  friend RulingRange ruling_range(const Face& face, double depth);

  double limit(double u) const;

  Box2 box_;
  /// The surface narrows along a ruling as 1 + q v, and is 1/(1 + |q| L) as wide at −L/(1 + q L)
  /// (q > 0), at L/(1 − q L) (q < 0): never nothing. L is `reach_`, of the sign of the side.
  NodePolynomial narrowing_;
  double reach_ = 0.0;
};
RulingRange ruling_range(const Face& face, double depth);

/// A curve in the face's (u, v), run over 0 … length, carried to the range's rectangle box(), which
/// represents lo(u) … hi(u): rulings exactly, others within `tolerance`.
Handle(Geom2d_Curve) carried_into(const RulingRange& range, const Handle(Geom2d_Curve) & curve,
                                  double length, double tolerance);

}  // namespace planish::brep
