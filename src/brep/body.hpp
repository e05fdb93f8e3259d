#pragma once

#include <planish/brep/step.hpp>

#include <TopoDS_Solid.hxx>

namespace planish {

/// The kernel's side of a Body.
struct Body::Shape {
  TopoDS_Solid solid;
  std::string name;
  int quantity = 1;
  int faces = 0;
  std::string material = {}, colour = {};
  std::optional<double> density = {};
};

}  // namespace planish
