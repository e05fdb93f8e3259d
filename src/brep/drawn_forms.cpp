#include "drawn_forms.hpp"

#include "borders.hpp"
#include "form_volume.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>

// A dome with a hollow across, or one part of the rim that touches both skins, is drawn from the
// sheet if what lies between its faces is as thick: the volume of the form and of the sheet where
// it stands, over the mean of the areas on both sides. A boss has no hollow and counts for nothing.

namespace planish::brep {
namespace {

double area_of(const Recognition& of, const RimPart& part) {
  return sum_of(part.faces, [&](int f) {
    const double curved = of.model.faces[f].curved_area;
    return curved > 0.0 ? curved : of.outlines[f].area;
  });
}

double curved_area_of(const Recognition& of, const RimPart& part) {
  return sum_of(part.faces, [&](int f) { return of.model.faces[f].curved_area; });
}

/// The area of the plane that is opened on one skin.
double footprint(const Recognition& of, const std::vector<LoopRef>& loops) {
  return sum_of(loops, [&](const LoopRef& ref) {
    const SolidFace& face = of.model.faces[ref.face];
    return loop_area(read_borders(of.model, face.loops[ref.loop], std::get<Frame>(face.surface),
                                  0.0, of.tolerance));
  });
}

Box3 box_of(const Recognition& of, const RimPart& part) {
  Box3 box;
  for (const int f : part.faces)
    box.extend(of.outlines[f].space);
  return box;
}

/// The part across the sheet from one that touches the reference skin alone.
const RimPart* part_across(const Recognition& of, const RimPart& part) {
  const Box3 near = enlarged(box_of(of, part), of.skins.thickness);
  for (const RimPart& other : of.rim.parts)
    if (loops_here(of, other).empty() && loops_there(of, other).size() == 1 &&
        near.contains(box_of(of, other).center()))
      return &other;
  return nullptr;
}

/// Half the areas of its curved faces times the thickness, if the form is as thick as the sheet.
double drawn_volume(const Recognition& of, const RimPart& part, const RimPart& across) {
  constexpr double kAsThick = 0.5;  // of the thickness: drawn walls are thinner, their corners not
  const auto in_planes = [&](const std::vector<LoopRef>& loops) {
    return std::ranges::all_of(loops,
                               [&](const LoopRef& ref) { return opening_in_plane(of, ref); });
  };
  if (!in_planes(loops_here(of, part)) || !in_planes(loops_there(of, across))) return 0.0;
  const auto here = form_volume(of, part);
  const bool same = &across == &part;
  const auto there = same ? std::optional(0.0) : form_volume(of, across);
  if (!here || !there) return 0.0;
  const double thickness = of.skins.thickness;
  const double foot = std::max(footprint(of, loops_here(of, part)),
                               footprint(of, loops_there(of, across)));
  const double area = area_of(of, part) + (same ? 0.0 : area_of(of, across));
  const double mean = 2 * (*here + *there + foot * thickness) / area;
  if (!(std::abs(mean - thickness) < kAsThick * thickness)) return 0.0;
  return thickness / 2 * (curved_area_of(of, part) + (same ? 0.0 : curved_area_of(of, across)));
}

}  // namespace

double drawn_volume(const Recognition& of) {
  return sum_of(of.rim.parts, [&](const RimPart& part) {
    if (loops_here(of, part).empty() || curved_area_of(of, part) == 0.0) return 0.0;
    const RimPart* across = loops_there(of, part).empty() ? part_across(of, part) : &part;
    if (!across || (part.within && across->within)) return 0.0;
    return drawn_volume(of, part, *across);
  });
}

}  // namespace planish::brep
