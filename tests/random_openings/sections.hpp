#pragma once

#include "random_part.hpp"

#include <vector>

namespace planish::openings {

/// A closed wire of a section, in the axes of its flange.
struct SectionWire {
  double x = 0.0, y = 0.0;  ///< middle of its box
  double height = 0.0;
  double area = 0.0;
  bool outer = false;
};

/// The kernel's sections of a solid by planes at heights in a flange's axes.
std::vector<SectionWire> sections(const TopoDS_Shape& solid, const Flange& flange,
                                  const std::vector<double>& heights);

}  // namespace planish::openings
