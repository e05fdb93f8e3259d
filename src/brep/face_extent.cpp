#include "face_extent.hpp"

#include "kernel_points.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <BndLib_Add3dCurve.hxx>
#include <Bnd_Box.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace planish::brep {
namespace {

/// What may lie beyond another face's plane and still be on one side of it, of the depth.
constexpr double kBeyond = 0.125;
/// Sine of the angle up to which planes may lie on each other.
constexpr double kSameDirection = 0.01;
/// Across so many straight edges of a plane face, in different directions, it may end.
constexpr std::size_t kDirections = 8;

Vec3 vector_of_direction(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }

void add_corners(std::vector<Reach>& hull, const Bnd_Box& box) {
  if (box.IsVoid()) return;
  const Vec3 low = vector_of(box.CornerMin()), high = vector_of(box.CornerMax());
  for (int i = 0; i < 8; ++i)
    hull.push_back({{(i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                     (i & 4) != 0 ? high.z() : low.z()}});
}

void add_edge(FaceExtent& extent, const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return;
  const BRepAdaptor_Curve curve(edge);
  const double from = curve.FirstParameter(), to = curve.LastParameter();
  if (curve.GetType() == GeomAbs_Line) {
    extent.hull.push_back({vector_of(curve.Value(from))});
    extent.hull.push_back({vector_of(curve.Value(to))});
    extent.directions.push_back(vector_of_direction(curve.Line().Direction()));
  } else if (curve.GetType() == GeomAbs_Circle) {
    const gp_Circ circle = curve.Circle();
    extent.hull.push_back({vector_of(circle.Location()),
                           circle.Radius() * vector_of_direction(circle.XAxis().Direction()),
                           circle.Radius() * vector_of_direction(circle.YAxis().Direction()), from,
                           to});
  } else if (curve.GetType() == GeomAbs_BSplineCurve) {
    const Handle(Geom_BSplineCurve) spline = curve.BSpline();
    for (int i = 1; i <= spline->NbPoles(); ++i)
      extent.hull.push_back({vector_of(spline->Pole(i))});
  } else {
    Bnd_Box box;
    BndLib_Add3dCurve::Add(curve, 0.0, box);
    add_corners(extent.hull, box);
  }
}

/// The greatest value of a cos t + b sin t over a range.
double greatest(double a, double b, double from, double to) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double top = std::atan2(b, a);
  const double first = top + kTurn * std::ceil((from - top) / kTurn);
  if (first <= to) return std::hypot(a, b);
  return std::max(a * std::cos(from) + b * std::sin(from), a * std::cos(to) + b * std::sin(to));
}

bool on_one_side(const FaceExtent& face, const FaceExtent::Plane& plane, double beyond) {
  const Extent extent = face.along(plane.normal, plane.point);
  return extent.low > -beyond || extent.high < beyond;
}

bool lie_on_each_other(const FaceExtent& a, const FaceExtent& b, double depth) {
  if (!a.plane || !b.plane) return false;
  if (a.plane->normal.dot(b.plane->normal) < 0.0) return false;
  if (a.plane->normal.cross(b.plane->normal).norm() > kSameDirection) return false;
  const Extent extent = b.along(a.plane->normal, a.plane->point);
  return extent.low < depth && extent.high > -depth;
}

/// Whether a plane across one of the first face's directions has them on its two sides.
bool beside(const FaceExtent& a, const FaceExtent& b, double beyond) {
  return std::ranges::any_of(a.directions, [&](const Vec3& direction) {
    const Vec3& from = a.hull.front().centre;
    const Extent one = a.along(direction, from), other = b.along(direction, from);
    return one.high < other.low + beyond || other.high < one.low + beyond;
  });
}

/// One within the other, about the same axis.
bool coaxial(const FaceExtent::Axis& a, const FaceExtent::Axis& b, double depth) {
  const double off = a.direction.cross(b.point - a.point).norm();
  return a.direction.cross(b.direction).norm() < kSameDirection && off < kBeyond * depth &&
         std::abs(a.radius - b.radius) > depth;
}

void set_plane(FaceExtent& extent, const gp_Pln& plane, bool reversed) {
  Vec3 normal = vector_of_direction(plane.Axis().Direction());
  if (!plane.Direct()) normal = -normal;
  if (reversed) normal = -normal;
  extent.plane = FaceExtent::Plane{vector_of(plane.Location()), normal};
  const std::vector<Vec3> along = std::move(extent.directions);
  extent.directions = {normal};
  for (const Vec3& edge : along) {
    const Vec3 across = normal.cross(edge).normalized();
    const bool known = std::ranges::any_of(extent.directions, [&](const Vec3& direction) {
      return direction.cross(across).norm() < kSameDirection;
    });
    if (!known) extent.directions.push_back(across);
    if (extent.directions.size() > kDirections) return;
  }
}

/// Its rulings end on its borders, so the hull of these contains it. It is likely to end at planes
/// through the axis, or at tangent planes, at the ends of its borders.
void set_cylinder(FaceExtent& extent, const gp_Cylinder& cylinder) {
  const FaceExtent::Axis axis{vector_of(cylinder.Location()),
                              vector_of_direction(cylinder.Axis().Direction()), cylinder.Radius()};
  extent.cylinder = axis;
  extent.directions = {axis.direction};
  for (const Reach& reach : extent.hull)
    for (const double t : {reach.from, reach.to}) {
      if (extent.directions.size() > 2 * kDirections) return;
      const Vec3 spoke = reach.centre + std::cos(t) * reach.x + std::sin(t) * reach.y - axis.point;
      const Vec3 tangent = axis.direction.cross(spoke).normalized();
      extent.directions.push_back(tangent);
      extent.directions.push_back(tangent.cross(axis.direction));
    }
}

bool is_ruled(const Geom_BSplineSurface& spline) {
  return (spline.UDegree() == 1 && spline.NbUPoles() == 2) ||
         (spline.VDegree() == 1 && spline.NbVPoles() == 2);
}

/// A face within the hull of its poles, or, if it is ruled, of its borders.
void set_spline(FaceExtent& extent, const Geom_BSplineSurface& spline) {
  extent.directions = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  if (is_ruled(spline)) return;
  extent.hull.clear();
  for (int i = 1; i <= spline.NbUPoles(); ++i)
    for (int j = 1; j <= spline.NbVPoles(); ++j)
      extent.hull.push_back({vector_of(spline.Pole(i, j))});
}

/// A face that may bulge beyond its borders.
void set_box(FaceExtent& extent, const TopoDS_Face& face) {
  Bnd_Box box;
  BRepBndLib::Add(face, box, false);
  extent.hull.clear();
  extent.directions = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  add_corners(extent.hull, box);
}

Eigen::AlignedBox3d box_about(const FaceExtent& extent) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3 && !extent.hull.empty(); ++axis) {
    const Extent along = extent.along(Vec3::Unit(axis), Vec3::Zero());
    box.min()[axis] = along.low;
    box.max()[axis] = along.high;
  }
  return box;
}

}  // namespace

Extent FaceExtent::along(const Vec3& direction, const Vec3& from) const {
  Extent extent{HUGE_VAL, -HUGE_VAL};
  for (const Reach& reach : hull) {
    const double at = direction.dot(reach.centre - from);
    const double a = direction.dot(reach.x), b = direction.dot(reach.y);
    extent.low = std::min(extent.low, at - greatest(-a, -b, reach.from, reach.to));
    extent.high = std::max(extent.high, at + greatest(a, b, reach.from, reach.to));
  }
  return extent;
}

FaceExtent extent_of(const TopoDS_Face& face) {
  FaceExtent extent;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
    add_edge(extent, TopoDS::Edge(edges.Current()));
  if (extent.hull.empty()) return extent;
  const BRepAdaptor_Surface surface(face, false);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      set_plane(extent, surface.Plane(), face.Orientation() == TopAbs_REVERSED);
      break;
    case GeomAbs_Cylinder:
      set_cylinder(extent, surface.Cylinder());
      break;
    case GeomAbs_Cone:
    case GeomAbs_SurfaceOfExtrusion:
      break;  // rulings end on its borders here too
    case GeomAbs_BSplineSurface:
      set_spline(extent, *surface.BSpline());
      break;
    default:
      set_box(extent, face);
  }
  extent.box = box_about(extent);
  return extent;
}

bool may_cross(const FaceExtent& a, const FaceExtent& b, double depth) {
  if (a.hull.empty() || b.hull.empty() || !a.box.intersects(b.box)) return false;
  const double beyond = kBeyond * depth;
  if (beside(a, b, beyond) || beside(b, a, beyond)) return false;
  if (lie_on_each_other(a, b, depth)) return true;
  if (b.plane && on_one_side(a, *b.plane, beyond)) return false;
  if (a.plane && on_one_side(b, *a.plane, beyond)) return false;
  return !(a.cylinder && b.cylinder && coaxial(*a.cylinder, *b.cylinder, depth));
}

}  // namespace planish::brep
