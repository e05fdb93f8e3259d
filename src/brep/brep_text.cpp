#include "brep_text.hpp"

#include "coordinate_bound.hpp"
#include "refusals.hpp"

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <ios>
#include <sstream>

// Shapes in the kernel's own form, text or binary, which have no names and no unit (mm). The first
// line tells them apart. Where a file was cut short the kernel would read on for ever, so the
// stream throws at its end. A damaged file may also give no shape, or one beyond any size; both are
// refused.

namespace planish::brep {
namespace {

constexpr std::string_view kText = "CASCADE Topology V";
constexpr std::string_view kBinary = "Open CASCADE Topology V";
constexpr std::string_view kDrawn = "DBRep_DrawableShape";  // before the text, as some write it
constexpr std::size_t kTitle = 100;                         // bytes in which the title stands

/// The first line that is not empty.
std::string_view title_of(std::string_view bytes) {
  bytes = bytes.substr(0, kTitle);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : bytes.substr(first);
}

/// Behind its shapes a binary file says which of them it is about: the kernel in a byte for the
/// orientation and two numbers for shape and location; FreeCAD in three numbers, shape, location
/// and orientation.
TopoDS_Shape read_binary(std::istream& stream, std::size_t size) {
  BinTools_ShapeSet shapes;
  shapes.Read(stream);
  const auto left = static_cast<std::streamoff>(size) - stream.tellg();
  TopoDS_Shape shape;
  if (left != 3 * static_cast<std::streamoff>(sizeof(Standard_Integer))) {
    shapes.ReadSubs(shape, stream, shapes.NbShapes());
    return shape;
  }
  Standard_Integer row = 0, location = 0, orientation = 0;
  for (Standard_Integer* number : {&row, &location, &orientation})
    BinTools::GetInteger(stream, *number);
  if (row < 1 || row > shapes.NbShapes() || location < 0 ||
      location > shapes.Locations().NbLocations() || orientation < TopAbs_FORWARD ||
      orientation > TopAbs_EXTERNAL)
    return shape;
  shape = shapes.Shape(row);
  shape.Location(shapes.Locations().Location(location));
  shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
  return shape;
}

TopoDS_Shape read_shape(const std::string& bytes) {
  TopoDS_Shape shape;
  // The kernel reads on for ever behind the end of a file that was cut short, unless that throws.
  // What follows keeps the end of a whole one from being touched.
  std::istringstream stream(bytes + "\n\n");
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  if (title_of(bytes).starts_with(kBinary)) {
    shape = read_binary(stream, bytes.size());
  } else {
    BRep_Builder builder;
    BRepTools::Read(shape, stream, builder);
  }
  return shape;
}

std::optional<Error> too_far_away(const TopoDS_Shape& shape, const std::string& name) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  if (box.IsVoid()) return std::nullopt;
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  double farthest = 0.0;
  for (int k = 1; k <= 3; ++k)
    farthest = std::max({farthest, std::abs(low.Coord(k)), std::abs(high.Coord(k))});
  if (farthest <= kFarthestPoint) return std::nullopt;
  return error_of(refuse::shape_too_far_away,
                  {{"file", name},
                   {"reach", farthest / kKilometre, unit::kilometres},
                   {"limit", kFarthestPoint / kKilometre, unit::kilometres}},
                  name);
}

}  // namespace

bool is_kernel_shape(std::string_view bytes) {
  const std::string_view title = title_of(bytes);
  return title.starts_with(kText) || title.starts_with(kBinary) || title.starts_with(kDrawn);
}

Result<ProductTree> read_kernel_shape(const std::string& bytes, const std::string& name) {
  TopoDS_Shape shape;
  try {
    shape = read_shape(bytes);
  } catch (const std::ios::failure&) {
    return fail(refuse::shape_ends_early, {{"file", name}}, name);
  }
  if (shape.IsNull()) return fail(refuse::damaged_shape, {{"file", name}}, name);
  if (auto error = too_far_away(shape, name)) return tl::unexpected(std::move(*error));
  ProductTree tree;
  for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next())
    tree.solids.push_back({TopoDS::Solid(at.Current()), {}, {}, {}});
  for (TopExp_Explorer at(shape, TopAbs_SHELL, TopAbs_SOLID); at.More(); at.Next())
    ++tree.surface_bodies;
  for (TopExp_Explorer at(shape, TopAbs_FACE, TopAbs_SHELL); at.More(); at.Next())
    ++tree.surface_bodies;
  tree.unit = "mm";
  return tree;
}

}  // namespace planish::brep
