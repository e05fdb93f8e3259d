#include "body.hpp"

#include "guarded.hpp"
#include "kernel_points.hpp"
#include "mend.hpp"
#include "patch_volume.hpp"

#include <planish/base/assert.hpp>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>

namespace planish {

Body::Body(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)) {
  PLANISH_ASSERT(shape_ != nullptr);
}

const std::string& Body::name() const { return shape_->name; }
int Body::quantity() const { return shape_->quantity; }
const std::string& Body::material() const { return shape_->material; }
std::optional<double> Body::density() const { return shape_->density; }
const std::string& Body::colour() const { return shape_->colour; }
int Body::face_count() const { return shape_->faces; }

double Body::volume() const {
  const auto volume = brep::guarded([&] {
    const TopoDS_Shape solid = brep::with_parameter_curves(shape_->solid);
    Bnd_Box box;
    BRepBndLib::Add(solid, box, false);
    const Vec3 low = brep::vector_of(box.CornerMin()), high = brep::vector_of(box.CornerMax());
    constexpr double kAccuracy = 1e-11;  // of the cube about the body, for each border
    const double error = kAccuracy * std::pow((high - low).norm(), 3);
    double sum = 0.0;
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
      sum += brep::patch_volume(TopoDS::Face(faces.Current()), 0.5 * (low + high), error);
    return std::abs(sum);
  });
  return volume.value_or(0.0);
}

Vec3 Body::size() const {
  const auto size = brep::guarded([&] {
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape_->solid, box, false, false);
    const gp_Pnt lo = box.CornerMin();
    const gp_Pnt hi = box.CornerMax();
    return Vec3(hi.X() - lo.X(), hi.Y() - lo.Y(), hi.Z() - lo.Z());
  });
  return size.value_or(Vec3::Zero());
}

}  // namespace planish
