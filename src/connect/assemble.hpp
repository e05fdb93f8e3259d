#pragma once

#include "bend_fit.hpp"

#include <string>
#include <vector>

namespace planish::connect_detail {

/// Plates and the bends that join them, ready to become a sheet. The bends form a tree.
struct Parts {
  double thickness = 0.0;
  std::vector<PlacedPlate> plates;
  std::vector<std::string> ids;
  std::vector<BendFit> fits;
  int root = 0;  ///< row of the plates
};

struct Assembled {
  Sheet sheet;
  std::vector<FaceId> plate_faces;
  std::vector<BendId> bends;  ///< by fit
  FaceId root{};
};

/// The sheet: flange i is plate i with its extensions, bend i is fit i. The reference skin is that
/// to which the root's normal points. Errors: `overlap` as in `extended_outline`.
Result<Assembled> assembled(const Parts& parts);

}  // namespace planish::connect_detail
