#pragma once

#include <TopoDS_Shape.hxx>
#include <gp_Ax3.hxx>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace planish::openings {

/// An opening as it was designed.
struct Opening {
  int flange = 0;
  double x = 0.0, y = 0.0;  ///< its middle in the flange's axes
  double area = 0.0;        ///< of its narrowest section, mm²
  double perimeter = 0.0;
  bool land = true;  ///< the narrowest section has a height of its own, at `depth`
  double depth = 0.0;
  std::string how;
};

/// A flange between z = 0 and z = the thickness of its axes.
struct Flange {
  gp_Ax3 axes;
  std::array<double, 2> size{};
};

/// A plate or a bracket of two flanges, with openings that are rounded, chamfered, countersunk,
/// counterbored, stepped or tapered, and rims rounded or chamfered.
struct Part {
  TopoDS_Shape shape;
  std::string how;
  double thickness = 0.0;
  double blank_area = 0.0, blank_perimeter = 0.0;  ///< of the outline at K = ½, mm², mm
  std::vector<Flange> flanges;
  std::vector<Opening> openings;
};

/// Throws the kernel's exceptions; the shape is null where the kernel could not round it.
Part random_part(std::uint64_t seed, int index);

}  // namespace planish::openings
