#pragma once

#include <planish/sheet/sheet.hpp>

#include <Geom2d_Curve.hxx>

#include <array>

namespace planish::brep {

/// |∂x/∂u| across the ruling, `depth` below the reference skin of a face on a ruled surface;
/// negative past the edge of regression. Linear in v and in the depth. By differences: relative
/// accuracy about 1e-9.
double speed_across(const Face& face, const Vec2& uv, double depth);

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
  static constexpr std::size_t nodes = 5;

  double node(std::size_t i) const {
    return box_.lo.x() + box_.size().x() * static_cast<double>(i) / (nodes - 1);
  }
  double narrowing(double u) const;
  double limit(double u) const;

  Box2 box_;
  /// The surface narrows along a ruling as 1 + q v, and is 1/(1 + |q| L) as wide at −L/(1 + q L)
  /// (q > 0), at L/(1 − q L) (q < 0): never nothing. q by the polynomial through its values at the
  /// nodes, so that the limit is smooth; L is `reach_`, of the sign of the side.
  std::array<double, nodes> narrowing_{};
  double reach_ = 0.0;
};
RulingRange ruling_range(const Face& face, double depth);

/// A curve in the face's (u, v), run over 0 … length, carried to the range's rectangle box(), which
/// represents lo(u) … hi(u): rulings exactly, others within `tolerance`.
Handle(Geom2d_Curve) carried_into(const RulingRange& range, const Handle(Geom2d_Curve) & curve,
                                  double length, double tolerance);

}  // namespace planish::brep
