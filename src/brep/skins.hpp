#pragma once

#include "sharp_edges.hpp"

#include <planish/base/result.hpp>

namespace planish::brep {

/// Which skin of the sheet a face belongs to.
enum class Skin { none, first, second };
/// The skin across the sheet. Requires one that is not `none`.
constexpr Skin other_skin(Skin skin) { return skin == Skin::first ? Skin::second : Skin::first; }

/// The two skins of a sheet in a solid.
struct Skins {
  double thickness = 0.0;
  double spread = 0.0;                         ///< of the depths met between the skins, mm
  std::vector<Skin> skin_of;                   ///< by face
  std::vector<std::vector<int>> partners;      ///< by face: faces opposite at the thickness
  std::vector<SharpEdge> sharp;                ///< on both skins
  double area_first = 0.0, area_second = 0.0;  ///< mm², coarse
  double pressed_volume = 0.0;                 ///< of forms taken from the skins, mm³, coarse
  int islands_first = 0, islands_second = 0;   ///< faces of a skin that are not connected to it
};

/// Where the first skin starts.
enum class SkinStart {
  largest,        ///< at the faces that together are the largest
  largest_plane,  ///< at the largest of those that lie in one plane: the skin of a flat plate
  milled,         ///< at the largest, some of them opposite pockets that leave little of a skin
};

/// Grows both skins of a sheet of that thickness over smooth and sharp-bent edges from the faces at
/// which the first one starts. `tolerance` is the largest deviation of depths, as a share of the
/// thickness. Errors: `not_a_sheet`, `unsupported_shape`.
Result<Skins> find_skins(const SolidModel& model, const std::vector<Outline>& outlines,
                         double thickness, double tolerance, SkinStart start = SkinStart::largest);

}  // namespace planish::brep
