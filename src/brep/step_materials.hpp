#pragma once

#include <NCollection_DataMap.hxx>
#include <Standard_Handle.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

#include <map>
#include <optional>
#include <string>

class StepBasic_ProductDefinition;
class XSControl_WorkSession;

namespace planish::brep {

/// What a STEP file says a product is made of.
struct StepMaterial {
  std::string name;                    ///< as it is spelled; empty: not said
  std::optional<double> density = {};  ///< kg/dm³
};

/// The materials of products, as AP214 and AP242 write them: properties called "material property"
/// with a name and a density in units of the standard. Of one product the first counts.
std::map<const StepBasic_ProductDefinition*, StepMaterial> step_materials(
    const Handle(XSControl_WorkSession) & session);

/// The colours of shapes as "#rrggbb": of solids, of faces, of whole products, as the file styles
/// them.
using ShapeColours = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;
ShapeColours shape_colours(const Handle(XSControl_WorkSession) & session);

/// The colour of a solid: its own, or that of all its faces, or that of `product`; empty if it has
/// none, or several. All without place.
std::string colour_of(const TopoDS_Shape& solid, const TopoDS_Shape& product,
                      const ShapeColours& colours);

}  // namespace planish::brep
