#pragma once

#include "parts.hpp"

#include <planish/sheet/sheet.hpp>

#include <vector>

namespace planish::connect_detail {

struct Assembled {
  Sheet sheet;
  std::vector<FaceId> plate_faces;
  std::vector<BendId> bends;  ///< by fit
  FaceId root{};
};

/// The sheet: flange i is plate i with its extensions, bend i is fit i. The reference skin is that
/// to which the root's normal points; with folds of inside radius 0 the one that is inside most of
/// them. Errors: `overlap` as in `extended_outline`, `invalid_sheet`.
Result<Assembled> assembled(Parts parts);

}  // namespace planish::connect_detail
