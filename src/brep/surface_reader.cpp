#include "surface_reader.hpp"

#include "fit_surface.hpp"

#include <planish/base/tolerance.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Torus.hxx>

#include <algorithm>
#include <cmath>

// What a face's surface is: the kernel's plane, cylinder or cone, the same fitted through samples
// of any other (fit_surface.cpp), or a developable with rulings along a direction in which the
// patch is straight and its normal constant. Knots are doubled until points half-way between, where
// interpolation is worst, are near. A kernel's cone goes on through its apex: the border's farthest
// point tells the nappe.

namespace planish::brep {
namespace {

Vec3 vec(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

struct Domain {
  double u0, u1, v0, v1;
};

/// The kernel's surface, with the parameter range that the face uses.
struct KernelPatch {
  BRepAdaptor_Surface surface;
  Domain domain;
  bool reversed;

  gp_Vec normal(double u, double v) const {
    gp_Pnt p;
    gp_Vec du, dv;
    surface.D1(u, v, p, du, dv);
    gp_Vec n = du.Crossed(dv);
    if (reversed) n.Reverse();
    return n;
  }
};

std::vector<SurfaceSample> samples_of(const KernelPatch& patch) {
  constexpr int kGrid = 7;
  std::vector<SurfaceSample> taken;
  for (int i = 0; i < kGrid; ++i)
    for (int j = 0; j < kGrid; ++j) {
      const double u = patch.domain.u0 + (patch.domain.u1 - patch.domain.u0) * i / (kGrid - 1);
      const double v = patch.domain.v0 + (patch.domain.v1 - patch.domain.v0) * j / (kGrid - 1);
      const gp_Vec n = patch.normal(u, v);
      if (n.Magnitude() < gp::Resolution()) continue;  // a pole of the parametrisation
      taken.push_back({vec(patch.surface.Value(u, v).XYZ()), vec(n.Normalized().XYZ())});
    }
  return taken;
}

/// +1 when the outward normal at a sample is the surface's normal, −1 when it is the opposite.
int sense_of(const Developable& surface, const SurfaceSample& sample) {
  const Vec2 uv = parameters_of(surface, sample.point, 0.0);
  return normal_on(surface, uv.x()).dot(sample.normal) >= 0 ? 1 : -1;
}

Frame frame_of(const gp_Ax3& axes) {
  return frame_from_axes(vec(axes.Location().XYZ()), vec(axes.Direction().XYZ()),
                         vec(axes.XDirection().XYZ()));
}

/// Opening along its axis or against it: `towards` tells.
Cone cone_of(const gp_Cone& cone) {
  Frame frame = frame_of(cone.Position());
  frame.origin = vec(cone.Apex().XYZ());
  return {frame, std::abs(cone.SemiAngle())};
}

/// The kernel's cones continue through their apex; the nappe in use determines the axis.
Cone towards(Cone cone, const Vec3& point) {
  if ((point - cone.frame.origin).dot(cone.frame.z) < 0)
    cone.frame = frame_from_axes(cone.frame.origin, -cone.frame.z, cone.frame.x);
  return cone;
}

/// The point of the face's border that is farthest from the apex: there the nappe is certain.
SurfaceSample sample_of_cone(const KernelPatch& patch, const TopoDS_Face& face) {
  const gp_Cone cone = patch.surface.Cone();
  gp_Pnt farthest = cone.Apex();
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(edges.Current()))) continue;
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges.Current()));
    for (const double share : {0.0, 0.5, 1.0}) {
      const gp_Pnt p = curve.Value(std::lerp(curve.FirstParameter(), curve.LastParameter(), share));
      if (p.Distance(cone.Apex()) > farthest.Distance(cone.Apex())) farthest = p;
    }
  }
  double u = 0.0, v = 0.0;
  ElSLib::Parameters(cone, farthest, u, v);
  return {vec(patch.surface.Value(u, v).XYZ()), vec(patch.normal(u, v).Normalized().XYZ())};
}

/// A parameter direction along which the patch is straight, with its rulings.
class RulingReader {
 public:
  RulingReader(const KernelPatch& patch, bool along_v) : patch_(patch), along_v_(along_v) {}

  double first() const { return along_v_ ? patch_.domain.u0 : patch_.domain.v0; }
  double last() const { return along_v_ ? patch_.domain.u1 : patch_.domain.v1; }

  /// Lines of the patch are straight and the normal stays constant along them.
  bool developable(double tolerance) const {
    constexpr int kLines = 9;
    constexpr int kPoints = 5;
    constexpr double kTwist = 2e-3;  // radians by which a tangent plane may turn along a ruling
    for (int i = 0; i < kLines; ++i) {
      const double u = first() + (last() - first()) * (i + 0.5) / kLines;
      const Vec3 a = point(u, 0.0);
      const Vec3 b = point(u, 1.0);
      const Vec3 along = (b - a).normalized();
      const Vec3 n0 = normal(u, 0.0);
      for (int j = 1; j <= kPoints; ++j) {
        const double share = static_cast<double>(j) / kPoints;
        const Vec3 d = point(u, share) - a;
        if ((d - d.dot(along) * along).norm() > tolerance) return false;
        if (normal(u, share).dot(n0) < std::cos(kTwist)) return false;
      }
    }
    return true;
  }

  /// With as many knots as are needed for the directrix and the far border to be within the
  /// tolerance.
  Ruled ruled(double tolerance) const {
    constexpr int kFewest = 8;
    constexpr int kMost = 512;
    for (int pieces = kFewest;; pieces *= 2) {
      Ruled result = with_knots(pieces);
      if (pieces >= kMost || deviation(result) <= tolerance) return result;
    }
  }

 private:
  Ruled with_knots(int pieces) const {
    Ruled result;
    for (int i = 0; i <= pieces; ++i) {
      const double u = first() + (last() - first()) * i / pieces;
      const Vec3 b = point(u, 0.0);
      const Vec3 d = point(u, 1.0) - b;
      const Vec3 b_prime = across(u, 0.0);
      const Vec3 d_prime = across(u, 1.0) - b_prime;
      const Vec3 g = d.normalized();
      result.knots.push_back({u, b, b_prime, g, (d_prime - g * g.dot(d_prime)) / d.norm()});
    }
    return result;
  }

  /// The interpolation is worst half-way between knots.
  double deviation(const Ruled& ruled) const {
    const Developable surface = ruled;
    double worst = 0.0;
    for (size_t i = 0; i + 1 < ruled.knots.size(); ++i) {
      const double u = (ruled.knots[i].u + ruled.knots[i + 1].u) / 2;
      const Vec3 near = point(u, 0.0);
      const Vec3 far = point(u, 1.0);
      worst = std::max(worst, (point_on(surface, {u, 0.0}) - near).norm());
      worst = std::max(worst, (point_on(surface, {u, (far - near).norm()}) - far).norm());
    }
    return worst;
  }

  std::pair<double, double> uv(double u, double share) const {
    const Domain& d = patch_.domain;
    return along_v_ ? std::pair{u, d.v0 + share * (d.v1 - d.v0)}
                    : std::pair{d.u0 + share * (d.u1 - d.u0), u};
  }
  Vec3 point(double u, double share) const {
    const auto [a, b] = uv(u, share);
    return vec(patch_.surface.Value(a, b).XYZ());
  }
  Vec3 normal(double u, double share) const {
    const auto [a, b] = uv(u, share);
    const gp_Vec n = patch_.normal(a, b);
    return n.Magnitude() < gp::Resolution() ? Vec3(Vec3::Zero()) : vec(n.Normalized().XYZ());
  }
  Vec3 across(double u, double share) const {
    const auto [a, b] = uv(u, share);
    gp_Pnt p;
    gp_Vec du, dv;
    patch_.surface.D1(a, b, p, du, dv);
    return vec((along_v_ ? du : dv).XYZ());
  }

  const KernelPatch& patch_;
  bool along_v_;
};

/// mm; far below the accuracy of borders.
constexpr double kInterpolation = 1e-7;

std::optional<Ruled> ruled_of(const KernelPatch& patch, double tolerance) {
  for (const bool along_v : {true, false}) {
    const RulingReader reader(patch, along_v);
    if (reader.developable(tolerance)) return reader.ruled(kInterpolation);
  }
  return {};
}

std::string kind_name(GeomAbs_SurfaceType type) {
  switch (type) {
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    case GeomAbs_BSplineSurface:
    case GeomAbs_BezierSurface:
      return "spline";
    case GeomAbs_SurfaceOfRevolution:
      return "surface of revolution";
    case GeomAbs_OffsetSurface:
      return "offset surface";
    default:
      return "free-form";
  }
}

/// A torus, also as a circle that is turned about an axis in its plane.
std::optional<Torus> torus_of(const BRepAdaptor_Surface& surface) {
  if (surface.GetType() == GeomAbs_Torus) {
    const gp_Torus torus = surface.Torus();
    return Torus{frame_of(torus.Position()), torus.MajorRadius(), torus.MinorRadius()};
  }
  if (surface.GetType() != GeomAbs_SurfaceOfRevolution) return {};
  const Handle(Adaptor3d_Curve) turned = surface.BasisCurve();
  if (turned->GetType() != GeomAbs_Circle) return {};
  const gp_Circ circle = turned->Circle();
  const gp_Ax1 axis = surface.AxeOfRevolution();
  const Vec3 origin = vec(axis.Location().XYZ()), along = vec(axis.Direction().XYZ());
  const Vec3 from = vec(circle.Location().XYZ()) - origin;
  const Vec3 foot = from.dot(along) * along;
  const Vec3 normal = vec(circle.Axis().Direction().XYZ());
  constexpr double kInPlane = tolerance::kComputed;
  if (std::abs(normal.dot(along)) > kInPlane ||
      std::abs(normal.dot(from - foot)) > kInPlane * from.norm())
    return {};
  return Torus{frame_from_normal(origin + foot, along), (from - foot).norm(), circle.Radius()};
}

/// What is known of a face that is curved in two directions; its outward normal at a sample tells
/// the sense of a torus.
SolidFace curved_face(const KernelPatch& patch, const SurfaceSample& sample) {
  SolidFace face;
  const auto torus = torus_of(patch.surface);
  face.surface = DoublyCurved{kind_name(patch.surface.GetType()), torus};
  if (!torus) return face;
  const Vec3 local = torus->frame.local(sample.point);
  const Vec2 middle = torus->major * Vec2(local.head<2>()).normalized();
  face.sense = (sample.point - torus->frame.point(middle)).dot(sample.normal) >= 0 ? 1 : -1;
  return face;
}

SolidFace fitted_face(const KernelPatch& patch, double tolerance) {
  SolidFace face;
  const std::vector<SurfaceSample> taken = samples_of(patch);
  face.surface = DoublyCurved{kind_name(patch.surface.GetType())};
  const GeomAbs_SurfaceType type = patch.surface.GetType();
  if (taken.empty() || type == GeomAbs_Sphere) return face;
  face = curved_face(patch, taken[taken.size() / 2]);
  if (type == GeomAbs_Torus) return face;
  if (auto fit = fit_surface(taken, tolerance)) {
    face.fitted = fit->deviation;
    if (const auto* developable = std::get_if<Developable>(&fit->surface)) {
      face.sense = sense_of(*developable, taken[taken.size() / 2]);
      face.surface = *developable;
    } else {
      face.surface = std::get<Frame>(fit->surface);
    }
  } else if (auto ruled = ruled_of(patch, tolerance)) {
    const Developable developable = std::move(*ruled);
    face.sense = sense_of(developable, taken[taken.size() / 2]);
    face.surface = developable;
  }
  return face;
}

}  // namespace

SolidFace read_surface(const TopoDS_Face& face, double tolerance) {
  KernelPatch patch{BRepAdaptor_Surface(face, false), {}, face.Orientation() == TopAbs_REVERSED};
  SolidFace result;
  const GeomAbs_SurfaceType type = patch.surface.GetType();
  if (type == GeomAbs_Plane) {
    const gp_Pln plane = patch.surface.Plane();
    Vec3 normal = vec(plane.Position().Direction().XYZ());
    if (!plane.Direct()) normal = -normal;
    if (patch.reversed) normal = -normal;
    result.surface = frame_from_axes(vec(plane.Location().XYZ()), normal,
                                     vec(plane.XAxis().Direction().XYZ()));
    return result;
  }
  if (type == GeomAbs_Cylinder) {
    // The kernel's normal ∂u × ∂v points away from the axis in right-handed axes.
    const gp_Cylinder cylinder = patch.surface.Cylinder();
    result.sense = cylinder.Position().Direct() != patch.reversed ? 1 : -1;
    result.surface = Developable(Cylinder{frame_of(cylinder.Position()), cylinder.Radius()});
    return result;
  }
  if (type != GeomAbs_Cone) {
    BRepTools::UVBounds(face, patch.domain.u0, patch.domain.u1, patch.domain.v0, patch.domain.v1);
    return fitted_face(patch, tolerance);
  }
  const SurfaceSample sample = sample_of_cone(patch, face);
  Developable developable = towards(cone_of(patch.surface.Cone()), sample.point);
  result.sense = sense_of(developable, sample);
  result.surface = std::move(developable);
  return result;
}

}  // namespace planish::brep
