#pragma once

#include "part_list.hpp"

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

/// A plate whose outer contour can be cut.
inline FlatPattern pack_plate(double length, double width) {
  FlatPattern flat;
  flat.thickness = 2.0;
  flat.outer.loop = {Segment{{0, 0}, {length, 0}}, Segment{{length, 0}, {length, width}},
                     Segment{{length, width}, {0, width}}, Segment{{0, width}, {0, 0}}};
  flat.area = length * width;
  flat.perimeter = 2 * (length + width);
  return flat;
}

}  // namespace planish::test
