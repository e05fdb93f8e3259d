#pragma once

#include <TopoDS_Solid.hxx>
#include <planish/brep/step.hpp>

namespace planish {

/// The kernel's side of a Body.
struct Body::Shape {
  TopoDS_Solid solid;
  std::string name;
  int quantity = 1;
  int faces = 0;
};

}  // namespace planish
