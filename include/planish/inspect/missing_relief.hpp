#pragma once

#include <planish/inspect/findings.hpp>

#include <string>
#include <vector>

namespace planish {

/// An end of a bend at which the rules ask for a relief that is missing or too small, and what is
/// to be cut there: a strip beside the bend, over its zone and into the flange.
struct MissingRelief {
  std::string bend;
  Vec2 corner = Vec2::Zero();        ///< end of a tangent line
  Vec2 beyond = Vec2::UnitX();       ///< unit vector along it, out of the bend
  Vec2 into_flange = Vec2::UnitY();  ///< unit vector across it, away from the bend zone
  double width = 0.0;                ///< along `beyond`, mm
  double depth = 0.0;                ///< from the corner into the flange, mm
  /// From the corner over the bend zone, mm; through to an edge so near behind it that the web
  /// between would be narrower than the rules ask for.
  double back = 0.0;
  /// Whether the flange at the zone's other side asks for as much depth.
  bool on_both_sides = false;
};

/// Each place for which the finding `bend_relief` of `check_rules` names a relief. None where the
/// sheet beside a bend ends at its tangent line and nothing would be cut.
std::vector<MissingRelief> missing_reliefs(const Sheet& sheet, const FlatPattern& pattern,
                                           const Rules& rules);

}  // namespace planish
