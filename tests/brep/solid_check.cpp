#include "solid_check.hpp"

#include "exchange_lock.hpp"
#include "guarded.hpp"
#include "kernel_points.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/brep/codes.hpp>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <sstream>

// What an independent reader finds in a STEP text, for tests and tools: the kernel reads it, checks
// it, counts its parts and surfaces and measures it. Nothing that reads or writes parts is used
// here, so an error there cannot hide.

namespace planish::brep {
namespace {

void count_surfaces(const TopoDS_Shape& shape, SolidCheck& check) {
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const auto type = BRepAdaptor_Surface(TopoDS::Face(faces.Current())).GetType();
    ++(type == GeomAbs_Plane                ? check.planes
       : type == GeomAbs_Cylinder           ? check.cylinders
       : type == GeomAbs_Cone               ? check.cones
       : type == GeomAbs_SurfaceOfExtrusion ? check.extrusions
       : type == GeomAbs_BSplineSurface     ? check.splines
                                            : check.other_surfaces);
  }
}

void count_parts(const TopoDS_Shape& shape, SolidCheck& check) {
  for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
    ++check.solids;
  for (TopExp_Explorer shells(shape, TopAbs_SHELL); shells.More(); shells.Next())
    ++check.shells;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    ++check.faces;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (int i = 1; i <= faces_of_edge.Extent(); ++i)
    if (faces_of_edge(i).Extent() == 1) ++check.free_edges;
}

bool closed(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  for (int i = 1; i <= faces_of_edge.Extent(); ++i)
    if (faces_of_edge(i).Extent() != 2 &&
        !BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edge.FindKey(i))))
      return false;
  return faces_of_edge.Extent() > 0;
}

void measure(const TopoDS_Shape& shape, SolidCheck& check) {
  GProp_GProps volume, area;
  // The kernel's other integrators are up to a per cent off on planes bounded by splines.
  BRepGProp::VolumePropertiesGK(shape, volume, tolerance::kComputed);
  BRepGProp::SurfaceProperties(shape, area, tolerance::kComputed);
  check.volume = volume.Mass();
  check.area = area.Mass();
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  if (!box.IsVoid()) {
    check.lo = vector_of(box.CornerMin());
    check.hi = vector_of(box.CornerMax());
  }
  check.largest_tolerance = ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1);
}

std::string product_name(const Handle(StepData_StepModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i)
    if (const auto product = Handle(StepBasic_Product)::DownCast(model->Entity(i));
        !product.IsNull())
      return product->Name()->ToCString();
  return {};
}

SolidCheck checked(const TopoDS_Shape& shape) {
  SolidCheck check;
  count_parts(shape, check);
  check.valid = BRepCheck_Analyzer(shape).IsValid();
  check.closed = closed(shape);
  count_surfaces(shape, check);
  measure(shape, check);
  return check;
}

}  // namespace

Result<SolidCheck> check_step_solid(const std::string& text) {
  return guarded([&]() -> Result<SolidCheck> {
    const auto lock = exchange_lock();
    STEPControl_Reader reader;
    std::istringstream stream(text);
    if (reader.ReadStream("check", stream) != IFSelect_RetDone)
      return fail(code::not_step, "the text is not a STEP file");
    reader.TransferRoots();
    SolidCheck check = checked(reader.OneShape());
    check.product = product_name(reader.StepModel());
    return check;
  });
}

}  // namespace planish::brep
