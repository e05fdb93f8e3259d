#include "form_side.hpp"

#include "form_volume.hpp"

#include <algorithm>

namespace planish::brep {
namespace {

/// What stands out as far on both sides, but for this share of the thickness, has no side.
constexpr double kAsFar = 0.05;

FormSide side_of(double rise, double least) {
  if (std::abs(rise) <= least) return FormSide::both;
  return rise > 0.0 ? FormSide::up : FormSide::down;
}

/// How much farther a part rises above the reference skin than it reaches below the other one;
/// below the reference skin, if it does not touch the other. Of a flange's, if it lies along one.
double rise_of(const Recognition& of, const RimPart& part) {
  const auto& here = loops_here(of, part);
  const auto flange = std::ranges::find_if(here, [&](const LoopRef& ref) {
    return std::holds_alternative<Frame>(of.model.faces[ref.face].surface);
  });
  const int skin = (flange == here.end() ? here.front() : *flange).face;
  double highest = 0.0, lowest = 0.0;
  for (const int f : part.faces)
    for (const auto& ring : of.outlines[f].rings)
      for (const Vec3& point : ring) {
        const double height = -depth_below(of.model.faces[skin], of.outlines[skin], point);
        highest = std::max(highest, height);
        lowest = std::min(lowest, height);
      }
  return highest + lowest + (loops_there(of, part).empty() ? 0.0 : of.skins.thickness);
}

}  // namespace

FormSide raised_side(const Recognition& of, const RimPart& part) {
  const double least = kAsFar * of.skins.thickness;
  const FormSide side = side_of(rise_of(of, part), least);
  if (side != FormSide::both || !loops_there(of, part).empty()) return side;
  // A dome has no edge above its rim.
  return side_of(form_volume(of, part).value_or(0.0),
                 least * sum_of(part.faces, [&](int f) { return of.outlines[f].area; }));
}

FormSide wider_side(const BorderLoop& mine, const BorderLoop& theirs, double ratio) {
  const double here = loop_area(mine), there = loop_area(theirs);
  if (here > ratio * there) return FormSide::up;
  return there > ratio * here ? FormSide::down : FormSide::both;
}

}  // namespace planish::brep
