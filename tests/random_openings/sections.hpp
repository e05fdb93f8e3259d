#pragma once

#include "random_part.hpp"

#include <vector>

namespace planish::openings {

/// A closed wire of a section, in the axes of its flange.
struct SectionWire {
  double x = 0.0, y = 0.0;  ///< middle of its box
  double area = 0.0;
  double perimeter = 0.0;
  bool outer = false;
};

/// The kernel's section of a solid by a plane at a height in a flange's axes.
std::vector<SectionWire> section_at(const TopoDS_Shape& solid, const Flange& flange, double height);

}  // namespace planish::openings
