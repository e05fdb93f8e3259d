#pragma once

#include <planish/base/place.hpp>
#include <planish/sheet/sheet.hpp>

#include <string>

namespace planish {

/// The row as a path into the value `Sheet`: "/faces/3", "/faces/3/loops/0/borders/2", "/bends/1".
std::string pointer_to(FaceId face);
std::string pointer_to(const BorderRef& border);
std::string pointer_to(BendId bend);

/// A face by its number in the solid, with a point on it; that of a sheet that comes from no solid
/// by its row.
Place place_of(const Sheet& sheet, FaceId face);
/// The face at a border: if several were merged, the one that the border belonged to.
Place face_at(const Sheet& sheet, const BorderRef& border);
/// A bend by its name in reports, and a point on it. A bend that the sheet does not have is no more
/// than named.
Place place_of(const Sheet& sheet, BendId bend);
/// The solid's edge along a joint, and its middle.
Place edge_at(const Sheet& sheet, const Joint& joint, int edge);

}  // namespace planish
