#include "patch_volume.hpp"

#include <planish/geometry/quadrature.hpp>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

// The volume share, or the area, of a face of any surface: an integral along its borders in the
// parameters, of the integral across the patch up to there (Green). The inner one is made span by
// span, so that Gauss rules meet smooth functions only; the outer one is broken at knots that a
// straight border crosses, and halved until it agrees elsewhere. Written because the kernel's own
// are off by per cents on surfaces of many spans, or do not end.

namespace planish::brep {
namespace {

/// Where a surface has knots along u or v, within [from, to].
std::vector<double> knots_of(const BRepAdaptor_Surface& surface, bool along_v, double from,
                             double to) {
  TColStd_Array1OfReal all(
      1, (along_v ? surface.NbVIntervals(GeomAbs_CN) : surface.NbUIntervals(GeomAbs_CN)) + 1);
  if (along_v)
    surface.VIntervals(all, GeomAbs_CN);
  else
    surface.UIntervals(all, GeomAbs_CN);
  std::vector<double> knots{from};
  for (const double knot : all)
    if (knot > from && knot < to) knots.push_back(knot);
  knots.push_back(to);
  return knots;
}

/// A patch with the parameter that is integrated across first: the one with fewer spans.
class IntegratedPatch {
 public:
  /// Of (x − centre)·n; without a centre, of 1.
  IntegratedPatch(const TopoDS_Face& face, const std::optional<Vec3>& centre)
      : surface_(face, false) {
    if (centre) centre_ = gp_Pnt(centre->x(), centre->y(), centre->z());
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const std::vector<double> u = knots_of(surface_, false, u0, u1);
    const std::vector<double> v = knots_of(surface_, true, v0, v1);
    across_v_ = v.size() <= u.size();
    along_ = across_v_ ? u : v;
    across_ = across_v_ ? v : u;
    // Spans of surfaces other than splines may turn a long way.
    const GeomAbs_SurfaceType type = surface_.GetType();
    if (type != GeomAbs_BSplineSurface && type != GeomAbs_BezierSurface)
      across_ = quartered(across_);
  }

  /// The border's integrand at a point with that derivative.
  double form(const gp_Pnt2d& p, const gp_Vec2d& d) const {
    const double step = across_v_ ? d.X() : d.Y();
    if (step == 0.0) return 0.0;
    return across_v_ ? -across(p.X(), p.Y()) * step : across(p.Y(), p.X()) * step;
  }

  /// Knots of the other parameter, which borders cross.
  const std::vector<double>& knots_along() const { return along_; }
  double along(const gp_Pnt2d& p) const { return across_v_ ? p.X() : p.Y(); }

 private:
  static std::vector<double> quartered(const std::vector<double>& knots) {
    constexpr int kParts = 4;
    std::vector<double> finer;
    for (size_t i = 0; i + 1 < knots.size(); ++i)
      for (int k = 0; k < kParts; ++k)
        finer.push_back(knots[i] + (knots[i + 1] - knots[i]) * k / kParts);
    finer.push_back(knots.back());
    return finer;
  }

  /// ∫ (x − c)·(∂u × ∂v), or its length's, from the patch's lower end to `end`, the other parameter
  /// held.
  double across(double held, double end) const {
    const auto density = [&](double w) {
      gp_Pnt p;
      gp_Vec du, dv;
      surface_.D1(across_v_ ? held : w, across_v_ ? w : held, p, du, dv);
      const gp_Vec normal = du.Crossed(dv);
      return centre_ ? gp_Vec(*centre_, p).Dot(normal) : normal.Magnitude();
    };
    double sum = 0.0;
    for (size_t i = 0; i + 1 < across_.size() && (i == 0 || across_[i] < end); ++i) {
      const bool last = i + 2 == across_.size();
      sum += gauss(density, across_[i], last ? end : std::min(end, across_[i + 1]));
    }
    return sum;
  }

  BRepAdaptor_Surface surface_;
  std::optional<gp_Pnt> centre_;
  bool across_v_ = true;
  std::vector<double> across_, along_;
};

/// Parameters at which the border's form is not smooth: its own knots, and on a straight border
/// those of the patch. Curved borders cross the patch's knots anywhere; there halving intervals
/// must suffice.
std::vector<double> breaks_of(const IntegratedPatch& patch, const Geom2dAdaptor_Curve& border) {
  TColStd_Array1OfReal own(1, border.NbIntervals(GeomAbs_CN) + 1);
  border.Intervals(own, GeomAbs_CN);
  std::vector<double> breaks(own.begin(), own.end());
  if (border.GetType() == GeomAbs_Line) {
    const double t0 = border.FirstParameter();
    const double t1 = border.LastParameter();
    const double a = patch.along(border.Value(t0));
    const double b = patch.along(border.Value(t1));
    for (const double knot : patch.knots_along())
      if ((knot - a) * (knot - b) < 0) breaks.push_back(t0 + (t1 - t0) * (knot - a) / (b - a));
    std::ranges::sort(breaks);
  }
  return breaks;
}

double along_border(const IntegratedPatch& patch, const Geom2dAdaptor_Curve& border, double error) {
  const auto form = [&](double t) {
    gp_Pnt2d p;
    gp_Vec2d d;
    border.D1(t, p, d);
    return patch.form(p, d);
  };
  const std::vector<double> breaks = breaks_of(patch, border);
  double sum = 0.0;
  for (size_t i = 0; i + 1 < breaks.size(); ++i)
    sum += adaptive_gauss(form, breaks[i], breaks[i + 1], error);
  return sum;
}

/// Over a face that is taken to be forward.
double integral_over(const TopoDS_Face& face, const std::optional<Vec3>& centre, double error) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const IntegratedPatch patch(forward, centre);
  double sum = 0.0;
  for (TopExp_Explorer edges(forward, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    double t0 = 0.0, t1 = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, forward, t0, t1);
    if (curve.IsNull()) continue;
    const double part = along_border(patch, Geom2dAdaptor_Curve(curve, t0, t1), error);
    sum += edge.Orientation() == TopAbs_REVERSED ? -part : part;
  }
  return sum;
}

}  // namespace

double patch_volume(const TopoDS_Face& face, const Vec3& centre, double error) {
  const double sum = integral_over(face, centre, error);
  return (face.Orientation() == TopAbs_REVERSED ? -sum : sum) / 3;
}

double patch_area(const TopoDS_Face& face, double error) {
  return std::abs(integral_over(face, {}, error));
}

}  // namespace planish::brep
