#include "solid_builder.hpp"

#include "kernel_points.hpp"

#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include <algorithm>

// Topology for the kernel with tolerances that are true: each edge covers how far its curve is from
// its curves in the surfaces, at parameters between all knots, where fits are off most, and each
// vertex covers its edges. Loops are turned to run counter-clockwise about the surface's own
// normal, and an edge that a loop uses twice is a seam, which needs both of its curves at once.

namespace planish::brep {
namespace {

template <typename Spline, typename Curve>
void add_knots(const opencascade::handle<Curve>& curve, double length, std::vector<double>& knots) {
  const auto spline = opencascade::handle<Spline>::DownCast(curve);
  for (int i = 1; !spline.IsNull() && i <= spline->NbKnots(); ++i)
    if (spline->Knot(i) > 0.0 && spline->Knot(i) < length) knots.push_back(spline->Knot(i));
}

/// Parameters at which to compare an edge's curve with that in the surface: between the knots of
/// both, where fits are not exact.
std::vector<double> sample_parameters(const EdgeUse& use) {
  const double length = use.edge->length;
  std::vector<double> knots{0.0, length};
  add_knots<Geom_BSplineCurve>(use.edge->curve, length, knots);
  add_knots<Geom2d_BSplineCurve>(use.curve, length, knots);
  std::ranges::sort(knots);
  std::vector<double> parameters;
  const int per_span = knots.size() > 8 ? 4 : 32;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int j = 0; j <= per_span; ++j)
      parameters.push_back(knots[i] + (knots[i + 1] - knots[i]) * j / per_span);
  return parameters;
}

/// Largest distance between the edge's curve and its place in the surface, at equal parameters.
double deviation(const EdgeUse& use, const Handle(Geom_Surface) & surface) {
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(surface);
  double largest = 0.0;
  for (double s : sample_parameters(use)) {
    const gp_Pnt on_edge = use.edge->curve->Value(s);
    if (!plane.IsNull()) {
      largest = std::max(largest, plane->Pln().Distance(on_edge));
    } else {
      const gp_Pnt2d uv = use.curve->Value(s);
      largest = std::max(largest, surface->Value(uv.X(), uv.Y()).Distance(on_edge));
    }
  }
  return largest;
}

TopAbs_Orientation orientation(bool forward) { return forward ? TopAbs_FORWARD : TopAbs_REVERSED; }

/// The other use of the same edge in the loop, when it is a seam.
const EdgeUse* other_use(const std::vector<EdgeUse>& loop, const EdgeUse& use) {
  const auto other = std::ranges::find_if(
      loop, [&](const EdgeUse& u) { return &u != &use && u.edge->edge.IsSame(use.edge->edge); });
  return other == loop.end() ? nullptr : &*other;
}

}  // namespace

TopoDS_Vertex SolidBuilder::vertex(const Vec3& point) {
  TopoDS_Vertex v;
  builder_.MakeVertex(v, kernel_point(point), Precision::Confusion());
  return v;
}

BuiltEdge SolidBuilder::edge(const Handle(Geom_Curve) & curve, double length,
                             const TopoDS_Vertex& start, const TopoDS_Vertex& end) {
  BuiltEdge built{{}, curve, length, start, end};
  builder_.MakeEdge(built.edge, curve, Precision::Confusion());
  builder_.Add(built.edge, start.Oriented(TopAbs_FORWARD));
  builder_.Add(built.edge, end.Oriented(TopAbs_REVERSED));
  builder_.Range(built.edge, 0.0, length);
  loosen(built, 0.0);
  return built;
}

BuiltEdge SolidBuilder::straight_edge(const TopoDS_Vertex& start, const TopoDS_Vertex& end) {
  const gp_Pnt a = BRep_Tool::Pnt(start), b = BRep_Tool::Pnt(end);
  return edge(new Geom_Line(a, gp_Dir(gp_Vec(a, b))), a.Distance(b), start, end);
}

void SolidBuilder::loosen(const BuiltEdge& built, double deviation) {
  // Slightly more than measured, because the kernel samples elsewhere.
  constexpr double margin = 1.5;
  const double tolerance = std::max(Precision::Confusion(), margin * deviation);
  builder_.UpdateEdge(built.edge, tolerance);
  const auto reach = [&](const TopoDS_Vertex& v, double s) {
    const double gap = BRep_Tool::Pnt(v).Distance(built.curve->Value(s));
    builder_.UpdateVertex(v, std::max(tolerance, margin * gap));
  };
  reach(built.start, 0.0);
  reach(built.end, built.length);
}

void SolidBuilder::attach(const EdgeUse& use, const Handle(Geom_Surface) & surface) {
  if (!use.curve.IsNull())
    builder_.UpdateEdge(use.edge->edge, use.curve, surface, TopLoc_Location(),
                        Precision::Confusion());
  loosen(*use.edge, deviation(use, surface));
}

void SolidBuilder::face(const Handle(Geom_Surface) & surface, int outside,
                        const std::vector<std::vector<EdgeUse>>& loops) {
  TopoDS_Face result;
  builder_.MakeFace(result, surface, Precision::Confusion());
  for (std::vector<EdgeUse> loop : loops) {
    // The kernel wants loops that run counter-clockwise about the surface's own normal.
    if (outside < 0) {
      std::ranges::reverse(loop);
      for (EdgeUse& use : loop)
        use.forward = !use.forward;
    }
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const EdgeUse& use : loop) {
      attach(use, surface);
      if (const EdgeUse* seam = other_use(loop, use); seam != nullptr && !use.curve.IsNull())
        builder_.UpdateEdge(use.edge->edge, use.forward ? use.curve : seam->curve,
                            use.forward ? seam->curve : use.curve, surface, TopLoc_Location(),
                            Precision::Confusion());
      builder_.Add(wire, use.edge->edge.Oriented(orientation(use.forward)));
    }
    wire.Closed(true);
    builder_.Add(result, wire);
  }
  faces_.push_back(TopoDS_Face(result));
  faces_.back().Orientation(orientation(outside > 0));
}

TopoDS_Shell SolidBuilder::shell() const {
  TopoDS_Shell shell;
  builder_.MakeShell(shell);
  for (const TopoDS_Face& face : faces_)
    builder_.Add(shell, face);
  shell.Closed(true);
  return shell;
}

TopoDS_Shell SolidBuilder::open_shell(const std::vector<int>& faces) const {
  TopoDS_Shell shell;
  builder_.MakeShell(shell);
  for (const int face : faces)
    builder_.Add(shell, faces_[face]);
  return shell;
}

}  // namespace planish::brep
