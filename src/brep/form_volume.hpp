#pragma once

#include "assembly.hpp"

#include <array>

namespace planish::brep {

/// Area inside borders, above 0 where they run counter-clockwise; and without its sign.
double signed_loop_area(const BorderLoop& borders);
double loop_area(const BorderLoop& borders);

/// With its sign, half-way between the skins, of borders on the surface of a skin's face.
double signed_middle_area(const Recognition& of, int face, const BorderLoop& borders);

/// Whether the loop is an opening of a plane.
bool opening_in_plane(const Recognition& of, const LoopRef& ref);

/// The volume of a form beyond the plain sheet that its outlines cover (negative for a pocket),
/// mm³: by the divergence theorem its faces' volumes less those of the covers. Empty unless all its
/// outlines are openings of planes.
std::optional<double> form_volume(const Recognition& of, const RimPart& part);

/// The same for a hole through the sheet, between openings of two parallel planes, cut with the
/// area `cut`.
double opening_volume(const Recognition& of, const RimPart& part,
                      const std::array<LoopRef, 2>& openings, double cut);

/// The same along the rim of a plate, cut with the area `cut` inside its outline; empty along
/// others.
std::optional<double> plate_rim_volume(const Recognition& of, const RimPart& part, double cut);

}  // namespace planish::brep
