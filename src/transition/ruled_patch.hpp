#pragma once

#include "hull.hpp"
#include "right_surface.hpp"

#include <planish/geometry/ruled_fit.hpp>
#include <planish/sheet/sheet.hpp>
#include <planish/transition/transition.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace planish::transition_detail {

/// Length of an element's curve.
double arc_length(const Element& element, double t0, double t1);

/// One patch of the hull with its rulings numbered from 0 to 1, as the profiles run.
class RuledPatch {
 public:
  /// `tolerance`: largest error of points of general developables, mm.
  RuledPatch(std::shared_ptr<const Hull> hull, const HullPatch& patch, double tolerance);

  bool plane() const { return hull_patch_.plane; }
  PatchKind kind() const;
  BendKind bend_kind() const;

  /// The ends of a ruling on both profiles.
  std::array<Vec3, 2> ruling(double at) const;
  /// Normal of the surface along it, away from the hull.
  Vec3 normal(double at) const;
  /// The ruling that leaves a profile at the curve's parameter t (or share of an edge).
  double ruling_at(int side, double t) const;
  /// The inverse.
  double parameter(int side, double at) const { return pairing(at).t[side]; }
  const HullPatch& hull_patch() const { return hull_patch_; }

  double area(double from, double to) const;
  double border_length(int side, double from, double to) const;
  /// By how much the normal turns.
  double turn(double from, double to) const;
  /// The bend angle from start to end: between the normals, the long way around if it turns that
  /// far.
  double turned(double from, double to) const;
  /// A ruling on which the sheet is pressed, and the angle (radians).
  struct Press {
    double at = 0.0, turn = 0.0;
  };
  /// Presses by equal angles: the turn between `from` and `to` is divided into `count` parts, each
  /// pressed in its middle.
  std::vector<Press> evenly_turned(double from, double to, int count) const;
  /// Presses at equal distances along a side: its border is divided, each part pressed in its
  /// middle by its share of the turn.
  std::vector<Press> evenly_along(int side, double from, double to, int count) const;
  /// Smallest radius of curvature between `from` and `to`: at mid-length of the rulings, and at the
  /// tighter of their ends (of cones: the one away from the apex).
  struct Radii {
    double middle = 0.0, end = 0.0;
  };
  Radii smallest_radii(double from, double to) const;

  /// The part between two rulings as a face. Its borders: first profile, ruling at `to`, second
  /// profile, ruling at `from`; if a side stands still, its border is a point (for bends) or
  /// omitted (for planes).
  struct Part {
    Face face;
    std::array<int, 2> ruling_borders{};  ///< positions of the borders at `from` and `to`
    double u(double at) const { return u0 + (u1 - u0) * (at - from) / (to - from); }
    double from = 0.0, to = 1.0, u0 = 0.0, u1 = 1.0;
  };
  /// `tips`: how much is cut off the patch's corners at both ends of both sides, mm along its
  /// rulings (if a side stands still its two corners are one).
  struct Tips {
    std::array<double, 2> at_from{}, at_to{};
  };
  Part part(double from, double to, const Tips& tips) const;
  /// Area that `tips` cut off.
  double tip_area(double from, double to, const Tips& tips) const;
  /// Where the patch is a cone with its apex in a profile's corner: how far from there its radius
  /// is at least `radius`.
  double distance_of_radius(double radius) const;
  bool stands(int side) const { return !hull_patch_.sides[side].moves(); }

 private:
  /// Parameters on both profiles at a ruling, and their derivatives.
  struct Pairing {
    std::array<double, 2> t{}, rate{};
  };
  Pairing pairing(double at) const;
  Pairing solved(double at) const;

  /// A ruling as seen from the base side.
  struct Local {
    Ruled::Knot knot;
    double length = 0.0, length_rate = 0.0;  ///< of the ruling
    double across = 0.0,
           far_across = 0.0;  ///< speed across the ruling at the base and on the other side
    Vec3 normal;
    double turn_rate = 0.0;
  };
  Local local(double at) const;

  /// The integral of `rate` from `from` to `to`, and the rulings up to which it reaches `shares`
  /// (ascending) of the whole.
  struct Divided {
    double whole = 0.0;
    std::vector<double> rulings;
  };
  template <typename Rate>
  Divided divided(const Rate& rate, double from, double to,
                  const std::vector<double>& shares) const;

  /// `from`, the rulings between at which one of the curves is less smooth, and `to`.
  std::vector<double> breaks_between(double from, double to) const;

  /// A corner of a plane part, and where its two borders are cut.
  struct PanelCorner {
    Vec3 at, cut_before, cut_after;
  };
  std::vector<PanelCorner> panel_corners(double from, double to, const Tips& tips) const;

  Part plane_part(double from, double to, const Tips& tips) const;
  Part right_part(double from, double to, const Tips& tips) const;
  Part ruled_part(double from, double to, const Tips& tips) const;

  bool has_parallel_rulings() const;
  SpaceCurvePoint point(int side, double t) const { return curves_[side]->curve(t); }
  void find_breaks();

  std::shared_ptr<const Hull> hull_;
  HullPatch hull_patch_;
  std::array<const Element*, 2> curves_;
  double tolerance_;
  std::vector<double> breaks_;  ///< rulings at which one of the curves is less smooth, ascending
  int base_ = 0;                ///< the base side, about which the surface is written; it moves
  std::optional<RightSurface> right_;  ///< of right cones and cylinders
};

}  // namespace planish::transition_detail
