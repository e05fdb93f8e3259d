#pragma once

#include "assembly.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace planish::brep {

/// What a flange covers seen along the normal of its reference skin, where the rim between the
/// skins has steps, chamfers, bores and pockets: the blank (math.md#silhouette).
struct Silhouette {
  std::vector<BorderLoop> loops;  ///< in the plane's (u, v), the outer one first
  bool outer_kept = false;        ///< loops[0] is the skin's own outline: no part reaches it
  std::vector<int> parts;         ///< of the rim, that it accounts for
  bool over_bend = false;         ///< one of these reaches over a bend, on the other skin alone
  std::vector<int> leaning;       ///< faces of those that stand not upright
  std::vector<int> skin_loops;    ///< loops of the skin face that it stands for
  int first_opening = 0;          ///< where its openings begin among the loops of the sheet's face
  /// By loop and use of those, where it is in `loops`; what is missing is not cut.
  std::map<std::pair<int, int>, std::pair<int, int>> places;
};

/// The silhouette of a plane face of the reference skin in the plane of `leader`. Empty where no
/// part of the rim asks for it (walls of one cut, an opening of its own), or one leans from skin to
/// skin, looks both ways, or leaves the flange. May throw the kernel's exceptions.
std::optional<Silhouette> silhouette_of(const Recognition& of, int face, int leader);

/// Faces between the skins beside the outline of a plane face of the reference skin that look its
/// way, if not upright, and do not lean from skin to skin: the blank covers them.
std::vector<int> ledges_of(const Recognition& of, int face);

}  // namespace planish::brep
