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
  double zone = 0.0;                 ///< width of the bend zone, behind the corner, mm
  /// From behind the zone to an edge, mm, if that is less than the rules ask for between opening
  /// and edge; else 0.
  double web = 0.0;
  /// Whether the flange at the zone's other side asks for as much depth.
  bool on_both_sides = false;
};

/// The places of the finding `bend_relief` of `check_rules`.
std::vector<MissingRelief> missing_reliefs(const Sheet& sheet, const FlatPattern& pattern,
                                           const Rules& rules);

}  // namespace planish
