#pragma once

#include "rim.hpp"

#include <planish/sheet/sheet.hpp>

#include <vector>

namespace planish::brep {

struct Recognition;

/// An opening within a bend, on the reference skin, that is machined or wider there than where it
/// lets through.
struct BendOpening {
  int part = 0;  ///< of the rim
  LoopRef here;
  BorderLoop cut;  ///< the narrowest section, in (u, v) of the bend at any turn; empty: as drawn
  bool up = false, down = false;  ///< machined on this skin, on the other one
};

/// Those of a solid. May throw the kernel's exceptions.
std::vector<BendOpening> bend_openings(const Recognition& of);

/// The plane along whose normal an opening lets through: upright to its drill, else to the flange
/// beside it, else to the bend in its middle. z looks out of the reference skin.
Frame plane_across(const Recognition& of, const RimPart& part);

}  // namespace planish::brep
