#include "workpiece.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

constexpr double kOutlineChord = 0.01;  // mm: a fifth of what may be penetrated

/// An outline within which a form goes on: no opening.
bool is_form(const BorderLoop& loop) {
  return std::ranges::any_of(loop, [](const Border& border) { return border.feature.has_value(); });
}

}  // namespace

std::vector<Convex> face_material(const Sheet& sheet, const Layout& layout, FaceId face) {
  const std::vector<Loop>& images = layout.images[face];
  Polygon polygon{sampled(images.front(), kOutlineChord), {}};
  for (int loop = 1; loop < std::ssize(images); ++loop)
    if (!is_form(sheet[face].loops[loop]))
      polygon.holes.push_back(sampled(images[loop], kOutlineChord));
  return convex_pieces(polygon);
}

}  // namespace planish::brake_detail
