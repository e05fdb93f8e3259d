#pragma once

#include "grouping.hpp"
#include "rim.hpp"

#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// The facts recognised about a solid, from which its sheet is built.
struct Recognition {
  const SolidModel& model;
  const std::vector<Outline>& outlines;
  const Skins& skins;
  const Rim& rim;
  const Groups& groups;
  Skin skin;         ///< the reference skin
  double tolerance;  ///< to which borders are read, mm
};

/// Builds the Sheet: faces, joints, flanges, bends, features. Errors: `doubly_curved` when two
/// faces meet tangentially along a curve (no development keeps both), those of `check`.
Result<Sheet> assemble_sheet(const Recognition& of);

}  // namespace planish::brep
