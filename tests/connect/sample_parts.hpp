#pragma once

#include "join_tree.hpp"
#include "parts.hpp"
#include "sample_fits.hpp"

#include <utility>

namespace planish::test {

/// The plates of a structure with the bends that join them.
inline connect_detail::Parts parts_of(const PlateStructure& structure, int root = 0) {
  connect_detail::Parts parts;
  parts.thickness = structure.thickness;
  parts.root = root;
  for (const Plate& plate : structure.plates) {
    parts.plates.push_back(laid(plate));
    parts.ids.push_back(plate.id);
  }
  auto fits = structure.bends.empty()
                  ? connect_detail::fit_tree(structure, parts.plates, {}, {}, {})
                  : connect_detail::fit_requested(structure, parts.plates, {}, {});
  EXPECT_TRUE(fits) << (fits ? "" : fits.error().message);
  if (fits) parts.fits = std::move(*fits);
  return parts;
}

inline PlateStructure pipe_structure() {
  PlateStructure s;
  s.thickness = 2.0;
  s.bends = {{.inside_radius = 49.0, .angle = Angle::degrees(360), .length = 300.0}};
  return s;
}

}  // namespace planish::test
