#include "guarded.hpp"
#include "step_out.hpp"
#include "thicken.hpp"

#include <planish/brep/step.hpp>

namespace planish {
namespace {

BorderLoop borders_of(const Contour& contour) {
  return mapped(contour.loop, [&](const Curve2& curve) { return Border{curve}; });
}

/// The pattern as a sheet of one flange: the reference skin at z = 0, the material below.
Sheet flat_sheet(const FlatPattern& pattern) {
  Face face;
  face.surface = Frame{};
  face.loops = {borders_of(pattern.outer)};
  face.part_of = FlangeId{0};
  for (const Contour& opening : pattern.openings)
    face.loops.push_back(borders_of(opening));
  Sheet sheet;
  sheet.thickness = pattern.thickness;
  sheet.faces.push_back(std::move(face));
  sheet.flanges.push_back({{FaceId{0}}});
  return sheet;
}

}  // namespace

Result<std::string> flat_solid_step(const FlatPattern& pattern, const std::string& name) {
  if (auto sound = check(pattern); !sound) return pass_on(sound);
  return brep::guarded(
      [&]() -> Result<std::string> {
        const auto solid = brep::thicken(flat_sheet(pattern));
        if (!solid) return pass_on(solid);
        return brep::step_text(*solid, name);
      },
      name);
}

}  // namespace planish
