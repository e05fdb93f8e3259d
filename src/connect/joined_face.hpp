#pragma once

#include "parts.hpp"

#include <planish/sheet/sheet.hpp>

#include <vector>

namespace planish::connect_detail {

/// A face of the reference skin, and the borders at which a bend joins a plate.
struct JoinedFace {
  Face face;
  struct Joint {
    int plate = 0, bend = 0;  ///< indices into the parts
    int border = 0;
    int loop = 0;
  };
  std::vector<Joint> joints;
};

/// The face of a plate with its extensions; `sense` as in `Orientation`. Error: `overlap` as in
/// `extended_outline`.
Result<JoinedFace> plate_face(const Parts& parts, int plate, int sense);

/// The face of a bend.
JoinedFace bend_face(const Parts& parts, int bend, int sense);

}  // namespace planish::connect_detail
