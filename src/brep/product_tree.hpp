#pragma once

#include "step_materials.hpp"

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>

#include <TopoDS_Solid.hxx>

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace planish::brep {

/// A solid where a product of an assembly has it; that of another product or place is another one,
/// though it may be the same shape.
struct PlacedSolid {
  TopoDS_Solid solid;
  std::string name;       ///< of its product; empty where that has none
  StepMaterial material;  ///< of its product
  std::string colour;     ///< "#rrggbb"; empty where it has none, or several
};

/// What a STEP file holds, product by product down the tree of its assemblies.
struct ProductTree {
  std::vector<PlacedSolid> solids;
  int surface_bodies = 0;  ///< shells, and faces without shell, that belong to no solid
  std::string unit;  ///< length unit of the file: "mm" (also where it names none), "m", or as it
                     ///< spells it
  std::shared_ptr<const void> content;  ///< what the kernel made of the text; the solids do not
                                        ///< need it
};

/// Reads a STEP text. Files that it refers to are looked for beside `path`, its own place. Errors:
/// `invalid_input` (broken syntax), `too_far_away`, `no_solid` (nothing in it is a shape),
/// `cancelled`; they call the file `name`. Requires the exchange lock.
Result<ProductTree> read_products(std::istream& text, const std::filesystem::path& path,
                                  const std::string& name, const Progress& progress);

}  // namespace planish::brep
