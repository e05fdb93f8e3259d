#pragma once

#include "skins.hpp"

namespace planish::brep {

/// A loop of a skin face: faces[face].loops[loop].
struct LoopRef {
  int face = 0;
  int loop = 0;
  friend auto operator<=>(const LoopRef&, const LoopRef&) = default;
};

/// Connected faces that belong to no skin: the walls of a cut, a countersink, an emboss, a boss.
struct RimPart {
  std::vector<int> faces;
  std::vector<LoopRef> first, second;  ///< loops it touches on either skin
  bool within = true;  ///< stays between the skins: walls, chamfers, fillets, pockets
  Error refusal;       ///< why the body has no flat pattern if this part is at its outer contour
};

struct Rim {
  std::vector<RimPart> parts;
  std::vector<int> part_of;  ///< by face, −1 for skin faces
};

Rim find_rim(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins);

/// Index of a face's outer loop: the one with the largest area.
int outer_loop(const Outline& outline);

}  // namespace planish::brep
