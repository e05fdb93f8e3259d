#pragma once

#include <planish/sheet/layout.hpp>

#include <vector>

namespace planish {

/// Where material of the flat sheet comes to lie near a point in space when it is folded.
struct MaterialPlace {
  PartId part;
  Vec2 at;            ///< in the coordinates of the layout, within the part's face
  double away = 0.0;  ///< of the point from the material there, mm; 0 within it
};

/// The places whose material lies at most `reach` from p in the folded sheet, nearest first: one
/// for each face, and one for each turn of a bend about its axis. The material is that between the
/// skins along their normals, without what formed features add and what mitres of sharp bends add
/// or take. Requires the layout of that sheet. Cost: linear in the sheet.
std::vector<MaterialPlace> material_places(const Sheet& sheet, const Layout& layout, const Vec3& p,
                                           double reach);

}  // namespace planish
