#include "body.hpp"

#include "guarded.hpp"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <cmath>

namespace planish {

Body::Body(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)) {}

const std::string& Body::name() const { return shape_->name; }
int Body::quantity() const { return shape_->quantity; }
int Body::face_count() const { return shape_->faces; }

double Body::volume() const {
  const auto volume = brep::guarded([&] {
    constexpr double kRelative = 1e-6;  // per face; without it the kernel is off by percents on spline walls
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape_->solid, properties, kRelative);
    return std::abs(properties.Mass());
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
