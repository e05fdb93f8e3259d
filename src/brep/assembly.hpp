#pragma once

#include "bend_openings.hpp"
#include "grouping.hpp"
#include "rim.hpp"
#include "tangent_openings.hpp"
#include "windows.hpp"

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
  std::vector<TangentOpening> tangent_openings = {};
  std::vector<BendOpening> bend_openings = {};
  std::vector<FarRun> far_runs = {};
};

/// Which of the parts of the rim this is.
inline int number_of(const Recognition& of, const RimPart& part) {
  return static_cast<int>(&part - of.rim.parts.data());
}

/// Loops that a part touches on the reference skin, and on the other one.
const std::vector<LoopRef>& loops_here(const Recognition& of, const RimPart& part);
const std::vector<LoopRef>& loops_there(const Recognition& of, const RimPart& part);

/// Builds the Sheet: faces, joints, flanges, bends, features. Errors: `doubly_curved` when two
/// faces meet tangentially along a curve (no development keeps both), those of `check`.
Result<Sheet> assemble_sheet(const Recognition& of);

}  // namespace planish::brep
