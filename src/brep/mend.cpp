#include "mend.hpp"

#include "soundness.hpp"

#include <BRepBuilderAPI_Copy.hxx>
#include <Precision.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Solid.hxx>
#include <ShapeFix_Wire.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <vector>

// As little mending as possible (docs/decisions/0010): a closed solid whose faces are readable is
// not touched, since the kernel's mending takes time with the square of a face's loops. Faces that
// are not readable are mended each by itself; only what does not close then is mended as a whole.

namespace planish::brep {
namespace {

using FaceTest = bool (*)(const TopoDS_Face&);

std::vector<TopoDS_Face> faces_without(FaceTest test, const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    if (!test(TopoDS::Face(face.Current()))) faces.push_back(TopoDS::Face(face.Current()));
  return faces;
}

/// Each of the faces by itself; edges that it shares with others change with it.
TopoDS_Shape with_faces_mended(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces,
                               const Fit& fit) {
  const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape;
  for (const TopoDS_Face& face : faces) {
    const Handle(ShapeFix_Face) mending = new ShapeFix_Face;
    mending->SetContext(changes);
    mending->SetPrecision(fit.precision);
    mending->SetMaxTolerance(fit.largest_tolerance);
    mending->FixWireTool()->FixSameParameterMode() = false;
    mending->Init(TopoDS::Face(face.Oriented(TopAbs_FORWARD)));
    mending->Perform();
  }
  return changes->Apply(shape);
}

/// What the kernel does to every shape that it reads by default.
TopoDS_Shape mended_whole(const TopoDS_Shape& shape, const Fit& fit) {
  const Handle(ShapeFix_Shape) mending = new ShapeFix_Shape(shape);
  mending->SetPrecision(fit.precision);
  mending->SetMaxTolerance(fit.largest_tolerance);
  mending->FixFaceTool()->FixWireTool()->FixSameParameterMode() = false;
  mending->FixSolidTool()->CreateOpenSolidMode() = false;
  try {
    mending->Perform();
  } catch (const Standard_Failure&) {
    return shape;  // what the kernel cannot mend is refused by whoever cannot read it
  }
  return mending->Shape().IsNull() ? shape : mending->Shape();
}

}  // namespace

Mended mended(const TopoDS_Shape& shape, const Fit& fit) {
  Mended result{shape};
  if (is_closed_solid(shape)) {
    const std::vector<TopoDS_Face> faces = faces_without(is_readable, shape);
    if (faces.empty()) return result;
    result.faces = static_cast<int>(faces.size());
    result.shape = with_faces_mended(shape, faces, fit);
    if (is_closed_solid(result.shape) && faces_without(is_readable, result.shape).empty())
      return result;
  }
  result.whole = true;
  result.shape = mended_whole(result.shape, fit);
  return result;
}

TopoDS_Shape with_parameter_curves(const TopoDS_Shape& shape) {
  if (faces_without(has_parameter_curves, shape).empty()) return shape;
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape, false).Shape();
  return with_faces_mended(copy, faces_without(has_parameter_curves, copy),
                           {.precision = Precision::Confusion()});
}

TopoDS_Shape meshable(const TopoDS_Shape& shape) {
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape).Shape();
  const std::vector<TopoDS_Face> faces = faces_without(follows_in_parameters, copy);
  if (faces.empty()) return copy;
  return with_faces_mended(copy, faces, {.precision = Precision::Confusion()});
}

}  // namespace planish::brep
