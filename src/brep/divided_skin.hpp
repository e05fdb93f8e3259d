#pragma once

#include "grouping.hpp"

#include <set>

namespace planish::brep {

/// Faces across the edges of a face; −1 where an edge has no other side.
std::set<int> faces_beside(const SolidModel& model, int face);

/// Plane faces that grooves cut off from a skin, added to it: candidates of no skin that lie in the
/// plane of one of its faces and have a wall in common with it.
void add_divided(Skins& skins, const SolidModel& model, const std::vector<bool>& candidates);

/// Whether two planes are one, to the digits of a file or `spread`, and look the same way.
bool in_plane_of(const SolidModel& model, int face, int other, double spread);

/// A flange that a groove divides, by the faces on both sides of it: they lie in one plane and
/// opposite one face, and have a wall in common.
struct DividedFlange {
  int face = -1, piece = -1;
};

/// Those of a skin, one for each piece beyond the first.
std::vector<DividedFlange> divided_flanges(const SolidModel& model, const Skins& skins,
                                           const Groups& groups);
/// Their number.
int divided_pieces(const SolidModel& model, const std::vector<Outline>& outlines,
                   const Skins& skins, Skin skin);

/// The skins without the plane faces of the reference skin that no joint leads to and that lie in
/// the plane of one to which joints lead. They look as the floors of grooves beside them do, and
/// are a part of the blank as those are.
Skins without_divided(const SolidModel& model, const std::vector<Outline>& outlines, Skins skins,
                      Skin reference);

}  // namespace planish::brep
