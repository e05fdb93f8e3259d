#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::test {

/// A plate of one thickness whose outer contour can be cut.
inline FlatPattern flat_plate(double length, double width) {
  FlatPattern flat;
  flat.thickness = 2.0;
  flat.outer.loop = {Segment{{0, 0}, {length, 0}}, Segment{{length, 0}, {length, width}},
                     Segment{{length, width}, {0, width}}, Segment{{0, width}, {0, 0}}};
  flat.area = length * width;
  flat.perimeter = 2 * (length + width);
  return flat;
}

}  // namespace planish::test
