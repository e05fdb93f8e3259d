#pragma once

#include "solid_model.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace planish::brep {

using EdgeTest = std::function<bool(int edge)>;

/// Genus of the solid, summed over its shells (math.md#openings-and-genus): half of what
/// V − E + Σ (2 − loops of the face) misses of twice the number of shells. Seams count as edges,
/// degenerate edges are not there; shells that touch in a vertex only are told apart there. None
/// where it is not defined: an edge without exactly two faces, or run by both the same way.
std::optional<int> genus_of(const SolidModel& model);

/// How many openings of a solid pass through these connected faces, whose borders lie on the skins:
/// (b − χ) / 2 for b closed borders. The wall of a hole has one, so has the outer rim of a sheet, a
/// pocket or a boss none, an emboss with three holes three.
int openings_through(const SolidModel& model, const std::vector<int>& faces);

/// How many closed borders of the faces have an edge that is wanted.
int closed_borders(const SolidModel& model, const std::vector<int>& faces, const EdgeTest& wanted);

/// What a surface of faces is like: V − E + F, and its closed borders.
struct PatchShape {
  int euler = 0, borders = 0;
  friend bool operator==(const PatchShape&, const PatchShape&) = default;
};
/// Of faces that are cut apart along the edges of a test.
PatchShape shape_of_patch(const SolidModel& model, const std::vector<int>& faces,
                          const EdgeTest& parts);

}  // namespace planish::brep
