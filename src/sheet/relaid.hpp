#pragma once

#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/topology.hpp>

#include <optional>

namespace planish::sheet_detail {

/// A sheet laid out for its certificate, with the K-factors, allowances and place of the root that
/// a pattern states. It uses nothing of the layout that made the pattern, so that a mistake in one
/// shows against the other: joints are taken in order of length into a tree (Kruskal), and sharp
/// bends are not set back.
struct Relaid {
  IdVector<FaceId, std::optional<Development>> development;  ///< of bends, at the neutral surface
  IdVector<FaceId, Isometry2> placement;                     ///< developed plane → pattern

  Vec2 image(FaceId face, const Vec2& uv) const;
  /// (u, v) of what lies at p.
  Vec2 fold(FaceId face, const Vec2& p) const;
};

/// What the pattern states about each bend. Error: `pattern_wrong` (it leaves out a bend).
Result<IdVector<BendId, BendAllowance>> stated_allowances(const Sheet& sheet,
                                                          const FlatPattern& pattern);
/// The same at K = ½.
IdVector<BendId, BendAllowance> at_half(const Sheet& sheet,
                                        IdVector<BendId, BendAllowance> allowances);

/// Lays the sheet out anew with these allowances. Error: `not_a_sheet` (joints do not lead to every
/// face).
Result<Relaid> relaid(const Sheet& sheet, const FlatPattern& pattern,
                      const IdVector<BendId, BendAllowance>& allowances);

/// How far the faces at a sharp joint with the reference skin outside are cut back, mm; 0 at other
/// joints.
double setback_at(const Sheet& sheet, const Joint& joint);

/// The band that a sharp bend takes in the pattern, between the borders that it joins.
struct HingeBand {
  Vec2 origin, along, outwards;
  double length = 0.0, width = 0.0;
  bool holds(const Vec2& p, double tolerance) const;
};
HingeBand hinge_band(const Sheet& sheet, const Relaid& laid, const Joint& joint, double allowance);

}  // namespace planish::sheet_detail
