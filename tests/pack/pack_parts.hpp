#pragma once

#include "part_list.hpp"
#include "support/flat_plate.hpp"

#include <string>

namespace planish::test {

/// A part of 200 × 100 with round figures.
inline pack::PackPart pack_part(const std::string& material, int quantity) {
  pack::PackPart part;
  part.name = material + " part";
  part.stem = part.name;
  part.material = material;
  part.quantity = quantity;
  part.size = {200.0, 100.0};
  part.cut_length = 700.0;
  part.pierces = 3;
  part.flat.area = 19'000.0;
  part.flat.bends.resize(2);
  part.mass = 0.25;
  return part;
}

}  // namespace planish::test
