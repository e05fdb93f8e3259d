#include "random_part.hpp"

#include "support/bent_bracket.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace planish::openings {
namespace {

using std::numbers::pi;

class Random {
 public:
  Random(std::uint64_t seed, int index)
      : engine_(seed * 1000003 + static_cast<std::uint64_t>(index)) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  bool one_in(int count) { return below(count) == 0; }

 private:
  std::mt19937_64 engine_;
};

/// Points and directions of a flange's axes.
class In {
 public:
  explicit In(const gp_Ax3& axes) : axes_(axes) {}
  gp_Pnt point(double x, double y, double z) const {
    return axes_.Location().Translated(x * gp_Vec(axes_.XDirection()) +
                                       y * gp_Vec(axes_.YDirection()) +
                                       z * gp_Vec(axes_.Direction()));
  }
  gp_XYZ local(const gp_Pnt& p) const {
    const gp_Vec from(axes_.Location(), p);
    return {from.Dot(gp_Vec(axes_.XDirection())), from.Dot(gp_Vec(axes_.YDirection())),
            from.Dot(gp_Vec(axes_.Direction()))};
  }
  gp_Vec up() const { return gp_Vec(axes_.Direction()); }

 private:
  gp_Ax3 axes_;
};

enum class Shape { circle, slot, rounded, sharp };

/// What an opening looks like from above: a rectangle of half sizes a, b with corners of radius r.
struct Plan {
  Shape shape = Shape::circle;
  double x = 0.0, y = 0.0, a = 0.0, b = 0.0, r = 0.0;

  Plan wider(double by) const {
    return {shape, x, y, a + by, b + by, shape == Shape::sharp ? 0.0 : r + by};
  }
  double area() const { return 4 * a * b - (4 - pi) * r * r; }
  double perimeter() const { return 4 * (a + b) - (8 - 2 * pi) * r; }

  TopoDS_Wire wire(const In& in, double z) const {
    BRepBuilderAPI_MakeWire made;
    const auto at = [&](double dx, double dy) { return in.point(x + dx, y + dy, z); };
    if (shape == Shape::circle) {
      const gp_Circ circle(gp_Ax2(at(0, 0), gp_Dir(in.up())), r);
      made.Add(BRepBuilderAPI_MakeEdge(circle).Edge());
      return made.Wire();
    }
    const auto line = [&](const gp_Pnt& from, const gp_Pnt& to) {
      if (from.Distance(to) > 1e-9) made.Add(BRepBuilderAPI_MakeEdge(from, to).Edge());
    };
    const auto arc = [&](const gp_Pnt& from, double cx, double cy, double angle, const gp_Pnt& to) {
      if (r <= 0.0) return;
      const gp_Pnt middle = at(cx + r * std::cos(angle), cy + r * std::sin(angle));
      made.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, middle, to).Value()).Edge());
    };
    const double u = a - r, v = b - r;
    line(at(-u, -b), at(u, -b));
    arc(at(u, -b), u, -v, -pi / 4, at(a, -v));
    line(at(a, -v), at(a, v));
    arc(at(a, v), u, v, pi / 4, at(u, b));
    line(at(u, b), at(-u, b));
    arc(at(-u, b), -u, v, 3 * pi / 4, at(-a, v));
    line(at(-a, v), at(-a, -v));
    arc(at(-a, -v), -u, -v, -3 * pi / 4, at(-u, -b));
    return made.Wire();
  }
  TopoDS_Shape prism(const In& in, double from, double to) const {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(wire(in, from)).Face();
    return BRepPrimAPI_MakePrism(face, (to - from) * in.up()).Shape();
  }
};

enum class Edge { plain, fillet, chamfer, step, steps };

/// How an opening meets a skin: depth below it, width beyond the narrowest section.
struct Side {
  Edge edge = Edge::plain;
  double depth = 0.0, width = 0.0;
  double reach() const { return edge == Edge::steps ? 2 * width : width; }
  double deep() const { return edge == Edge::steps ? 2 * depth : depth; }
  std::string text() const {
    constexpr std::array kNames{"plain", "fillet", "chamfer", "step", "steps"};
    return fmt::format("{} {:.3f} {:.3f}", kNames[static_cast<int>(edge)], depth, width);
  }
};

Side random_side(Random& random, double t) {
  Side side{static_cast<Edge>(random.below(5)), 0.0, 0.0};
  switch (side.edge) {
    case Edge::plain:
      break;
    case Edge::fillet:
      side.depth = side.width = random.between(0.05, 0.45) * t;
      break;
    case Edge::chamfer:
      side.depth = random.between(0.05, 0.45) * t;
      side.width = side.depth * random.between(0.5, 1.7);
      break;
    case Edge::step:
      side.depth = random.between(0.15, 0.45) * t;
      side.width = random.between(0.5, 3.0);
      break;
    case Edge::steps:
      side.depth = random.between(0.1, 0.22) * t;
      side.width = random.between(0.5, 2.0);
      break;
  }
  return side;
}

/// The outline of a round opening's void beside its axis, from below one skin to above the other.
class Turned {
 public:
  Turned(const In& in, double x, double y) : in_(in), x_(x), y_(y) {}
  void to(double r, double z) {
    if (started_ && std::hypot(r - r_, z - z_) > 1e-9)
      wire_.Add(BRepBuilderAPI_MakeEdge(at(r_, z_), at(r, z)).Edge());
    start(r, z);
  }
  /// Over a point between.
  void round_to(double mid_r, double mid_z, double r, double z) {
    const auto arc = GC_MakeArcOfCircle(at(r_, z_), at(mid_r, mid_z), at(r, z));
    wire_.Add(BRepBuilderAPI_MakeEdge(arc.Value()).Edge());
    start(r, z);
  }
  TopoDS_Shape solid(double low, double high) {
    to(0.0, high);
    to(0.0, low);
    to(first_r_, first_z_);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(wire_.Wire()).Face();
    return BRepPrimAPI_MakeRevol(face, gp_Ax1(at(0, 0), gp_Dir(in_.up()))).Shape();
  }

 private:
  gp_Pnt at(double r, double z) const { return in_.point(x_ + r, y_, z); }
  void start(double r, double z) {
    if (!started_) {
      first_r_ = r;
      first_z_ = z;
    }
    started_ = true;
    r_ = r;
    z_ = z;
  }
  In in_;
  double x_, y_;
  BRepBuilderAPI_MakeWire wire_;
  bool started_ = false;
  double r_ = 0.0, z_ = 0.0, first_r_ = 0.0, first_z_ = 0.0;
};

struct Groove {
  double from = 0.0, to = 0.0, width = 0.0;  ///< in the middle of the sheet; width 0: none
};

/// One side's edge, on the way up (`sign` 1: from the lower skin at z) or down to the upper one.
void turn_lower(Turned& turned, const Side& side, double r) {
  const double d = side.depth, w = side.width;
  const double root = std::sqrt(0.5);
  switch (side.edge) {
    case Edge::plain:
      return;
    case Edge::fillet:
      turned.to(r + w, -1.0);
      turned.to(r + w, 0.0);
      turned.round_to(r + w - w * root, w - w * root, r, w);
      return;
    case Edge::chamfer:
      turned.to(r + w, -1.0);
      turned.to(r + w, 0.0);
      turned.to(r, d);
      return;
    case Edge::step:
      turned.to(r + w, -1.0);
      turned.to(r + w, d);
      turned.to(r, d);
      return;
    case Edge::steps:
      turned.to(r + 2 * w, -1.0);
      turned.to(r + 2 * w, d);
      turned.to(r + w, d);
      turned.to(r + w, 2 * d);
      turned.to(r, 2 * d);
      return;
  }
}

void turn_upper(Turned& turned, const Side& side, double r, double t) {
  const double d = side.depth, w = side.width;
  const double root = std::sqrt(0.5);
  switch (side.edge) {
    case Edge::plain:
      turned.to(r, t + 1);
      return;
    case Edge::fillet:
      turned.to(r, t - w);
      turned.round_to(r + w - w * root, t - w + w * root, r + w, t);
      turned.to(r + w, t + 1);
      return;
    case Edge::chamfer:
      turned.to(r, t - d);
      turned.to(r + w, t);
      turned.to(r + w, t + 1);
      return;
    case Edge::step:
      turned.to(r, t - d);
      turned.to(r + w, t - d);
      turned.to(r + w, t + 1);
      return;
    case Edge::steps:
      turned.to(r, t - 2 * d);
      turned.to(r + w, t - 2 * d);
      turned.to(r + w, t - d);
      turned.to(r + 2 * w, t - d);
      turned.to(r + 2 * w, t + 1);
      return;
  }
}

/// A round opening without a land: a taper, cones that meet, one rounding from skin to skin.
TopoDS_Shape landless(Random& random, const In& in, double t, Opening& opening, double r) {
  Turned turned(in, opening.x, opening.y);
  opening.land = false;
  const double w = random.between(0.1, 0.6) * t, z = random.between(0.2, 0.8) * t;
  switch (random.below(4)) {
    case 0:
      opening.how = "taper";
      turned.to(r - w / t, -1.0);
      turned.to(r + w + w / t, t + 1.0);
      break;
    case 1:
      opening.how = "taper, wide below";
      turned.to(r + w + w / t, -1.0);
      turned.to(r - w / t, t + 1.0);
      break;
    case 2:
      opening.how = "two cones";
      turned.to(r + w, -1.0);
      turned.to(r + w, 0.0);
      turned.to(r, z);
      turned.to(r + random.between(0.1, 0.6) * t, t);
      turned.to(r + 10.0, t + 10.0 / 0.6);
      break;
    default:
      opening.how = "one rounding";
      turned.to(r + t / 2, -1.0);
      turned.to(r + t / 2, 0.0);
      turned.round_to(r, t / 2, r + t / 2, t);
      turned.to(r + t / 2, t + 1.0);
      break;
  }
  return turned.solid(-1.0, opening.how == "two cones" ? t + 10.0 / 0.6 : t + 1.0);
}

TopoDS_Shape turned_tool(const In& in, const Plan& plan, const Side& lower, const Side& upper,
                         const Groove& groove, double t) {
  Turned turned(in, plan.x, plan.y);
  if (lower.edge == Edge::plain) turned.to(plan.r, -1.0);
  turn_lower(turned, lower, plan.r);
  if (groove.width > 0.0) {
    turned.to(plan.r, groove.from);
    turned.to(plan.r + groove.width, groove.from);
    turned.to(plan.r + groove.width, groove.to);
    turned.to(plan.r, groove.to);
  }
  turn_upper(turned, upper, plan.r, t);
  return turned.solid(-1.0, t + 1.0);
}

using Wanted = std::function<bool(const gp_Pnt& a, const gp_Pnt& middle, const gp_Pnt& b)>;

std::vector<TopoDS_Edge> edges_where(const TopoDS_Shape& shape, const Wanted& wanted) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::vector<TopoDS_Edge> found;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double a = curve.FirstParameter(), b = curve.LastParameter();
    if (wanted(curve.Value(a), curve.Value((a + b) / 2), curve.Value(b))) found.push_back(edge);
  }
  return found;
}

/// Edges rounded or chamfered; null where the kernel cannot.
TopoDS_Shape broken(const TopoDS_Shape& shape, const std::vector<TopoDS_Edge>& edges,
                    const Side& side, const std::function<bool(const TopoDS_Face&)>& is_skin) {
  if (edges.empty()) return {};
  if (side.edge == Edge::fillet) {
    BRepFilletAPI_MakeFillet make(shape);
    for (const TopoDS_Edge& edge : edges)
      make.Add(side.width, edge);
    make.Build();
    return make.IsDone() ? make.Shape() : TopoDS_Shape();
  }
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  BRepFilletAPI_MakeChamfer make(shape);
  for (const TopoDS_Edge& edge : edges)
    for (const TopoDS_Shape& face : faces.FindFromKey(edge))
      if (is_skin(TopoDS::Face(face))) {
        make.Add(side.width, side.depth, edge, TopoDS::Face(face));
        break;
      }
  make.Build();
  return make.IsDone() ? make.Shape() : TopoDS_Shape();
}

bool lies_at(const In& in, const TopoDS_Face& face, double z) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(face, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i)
    if (std::abs(in.local(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)))).Z() - z) > 1e-6)
      return false;
  return true;
}

/// The rim of an opening at a skin, rounded or chamfered.
TopoDS_Shape broken_rim(const TopoDS_Shape& shape, const In& in, const Plan& plan, double z,
                        const Side& side) {
  const auto on_rim = [&](const gp_Pnt& p) {
    const gp_XYZ at = in.local(p);
    return std::abs(at.Z() - z) < 1e-6 && std::abs(at.X() - plan.x) < plan.a + 1e-3 &&
           std::abs(at.Y() - plan.y) < plan.b + 1e-3;
  };
  const auto edges = edges_where(shape, [&](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
    return on_rim(a) && on_rim(m) && on_rim(b);
  });
  return broken(shape, edges, side, [&](const TopoDS_Face& face) { return lies_at(in, face, z); });
}

bool is_broken(const Side& side) { return side.edge == Edge::fillet || side.edge == Edge::chamfer; }

TopoDS_Shape with_window(TopoDS_Shape shape, const In& in, const Plan& plan, const Side& lower,
                         const Side& upper, double t) {
  shape = BRepAlgoAPI_Cut(shape, plan.prism(in, -1.0, t + 1.0)).Shape();
  for (const bool low : {true, false}) {
    const Side& side = low ? lower : upper;
    const auto cut = [&](double by, double depth) {
      shape = BRepAlgoAPI_Cut(
                  shape, plan.wider(by).prism(in, low ? -1.0 : t - depth, low ? depth : t + 1.0))
                  .Shape();
    };
    if (side.edge == Edge::step) cut(side.width, side.depth);
    if (side.edge == Edge::steps) {
      cut(2 * side.width, side.depth);
      cut(side.width, 2 * side.depth);
    }
    if (!is_broken(side)) continue;
    shape = broken_rim(shape, in, plan, low ? 0.0 : t, side);
    if (shape.IsNull()) return shape;
  }
  return shape;
}

TopoDS_Shape with_opening(Random& random, const TopoDS_Shape& shape, const In& in, double t,
                          Opening& opening) {
  Plan plan{static_cast<Shape>(random.below(4)), opening.x, opening.y, 0.0, 0.0, 0.0};
  plan.r = random.between(1.5, 4.0);
  plan.a = plan.b = plan.r;
  if (plan.shape == Shape::slot) plan.a += random.between(1.0, 5.0);
  if (plan.shape == Shape::rounded || plan.shape == Shape::sharp) {
    plan.a += random.between(1.0, 5.0);
    plan.b += random.between(0.5, 3.0);
  }
  if (plan.shape == Shape::sharp) plan.r = 0.0;
  opening.area = plan.area();
  opening.perimeter = plan.perimeter();
  if (plan.shape == Shape::circle && random.one_in(5))
    return BRepAlgoAPI_Cut(shape, landless(random, in, t, opening, plan.r)).Shape();
  const Side lower = random_side(random, t), upper = random_side(random, t);
  opening.depth = (lower.deep() + t - upper.deep()) / 2;
  constexpr std::array kNames{"circle", "slot", "rounded window", "window"};
  opening.how = fmt::format("{}, below {}, above {}", kNames[static_cast<int>(plan.shape)],
                            lower.text(), upper.text());
  if (plan.shape != Shape::circle) return with_window(shape, in, plan, lower, upper, t);
  Groove groove;
  const double from = lower.deep(), room = t - upper.deep() - from;
  if (random.one_in(5)) {
    groove = {from + 0.3 * room, from + 0.7 * room, random.between(0.3, 1.5)};
    opening.depth = from + 0.15 * room;
    opening.how += ", grooved";
  }
  return BRepAlgoAPI_Cut(shape, turned_tool(in, plan, lower, upper, groove, t)).Shape();
}

/// The rims of both skins of a plate.
TopoDS_Shape with_rim(Random& random, TopoDS_Shape shape, const In& in, double t,
                      std::string& how) {
  const bool fillet = random.one_in(2);
  for (const double z : {0.0, t}) {
    if (random.one_in(3)) continue;
    Side side{fillet ? Edge::fillet : Edge::chamfer, random.between(0.05, 0.45) * t, 0.0};
    side.width = fillet ? side.depth : side.depth * random.between(0.6, 1.6);
    how += fmt::format(", rim at {:.2f} {}", z, side.text());
    const auto edges = edges_where(shape, [&](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
      const auto at = [&](const gp_Pnt& p) { return std::abs(in.local(p).Z() - z) < 1e-6; };
      return at(a) && at(m) && at(b);
    });
    shape = broken(shape, edges, side,
                   [&](const TopoDS_Face& face) { return lies_at(in, face, z); });
    if (shape.IsNull()) return shape;
  }
  return shape;
}

constexpr double kCell = 34.0;

void add_plate(Random& random, Part& part) {
  const int columns = 2 + random.below(2), rows = 1 + random.below(2);
  const Plan plan{random.one_in(2) ? Shape::sharp : Shape::rounded,
                  columns * kCell / 2,
                  rows * kCell / 2,
                  columns * kCell / 2,
                  rows * kCell / 2,
                  0.0};
  Plan outline = plan;
  if (plan.shape == Shape::rounded) outline.r = random.between(2.0, 8.0);
  const In in{gp_Ax3()};
  part.how = fmt::format("plate, corners {:.2f}", outline.r);
  part.blank_area = outline.area();
  part.blank_perimeter = outline.perimeter();
  part.flanges = {{gp_Ax3(), {columns * kCell, rows * kCell}}};
  part.shape = outline.prism(in, 0.0, part.thickness);
  if (random.one_in(2)) part.shape = with_rim(random, part.shape, in, part.thickness, part.how);
}

void add_bracket(Random& random, Part& part) {
  const double t = part.thickness, r = random.between(0.5, 2.0) * t;
  const double first = kCell * (1 + random.below(2)), second = kCell, width = 2 * kCell;
  part.shape = test::bent_bracket({t, r, first, second, width});
  part.how = fmt::format("bracket, inside radius {:.2f}", r);
  const double run = first + second + (r + t / 2) * pi / 2;
  part.blank_area = width * run;
  part.blank_perimeter = 2 * (width + run);
  part.flanges = {{gp_Ax3(), {first, width}},
                  {gp_Ax3(gp_Pnt(first + r + t, 0, t + r), gp_Dir(-1, 0, 0), gp_Dir(0, 0, 1)),
                   {second, width}}};
  if (!random.one_in(3)) return;
  // Both long sides, along both skins and round the bend.
  Side side{random.one_in(2) ? Edge::fillet : Edge::chamfer, random.between(0.05, 0.4) * t, 0.0};
  side.width = side.depth;
  part.how += ", sides " + side.text();
  const auto edges = edges_where(
      part.shape, [&](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
        const auto on = [&](const gp_Pnt& p) {
          return std::abs(p.Y()) < 1e-6 || std::abs(p.Y() - width) < 1e-6;
        };
        return on(a) && on(m) && on(b) && a.Distance(b) > t + 1e-6;
      });
  part.shape = broken(part.shape, edges, side, [&](const TopoDS_Face& one) {
    return !lies_at(In(gp_Ax3(gp_Pnt(), gp_Dir(0, 1, 0))), one, 0.0) &&
           !lies_at(In(gp_Ax3(gp_Pnt(), gp_Dir(0, 1, 0))), one, width);
  });
}

}  // namespace

Part random_part(std::uint64_t seed, int index) {
  Random random(seed, index);
  Part part;
  constexpr std::array kThicknesses{1.0, 1.5, 2.0, 3.0, 5.0};
  part.thickness = kThicknesses[random.below(5)];
  if (random.one_in(2))
    add_plate(random, part);
  else
    add_bracket(random, part);
  for (int f = 0; f < static_cast<int>(part.flanges.size()); ++f) {
    const Flange& flange = part.flanges[f];
    const In in(flange.axes);
    for (double x = kCell / 2; x < flange.size[0]; x += kCell)
      for (double y = kCell / 2; y < flange.size[1]; y += kCell) {
        if (part.shape.IsNull() || random.one_in(3)) continue;
        Opening opening;
        opening.flange = f;
        opening.x = x;
        opening.y = y;
        part.shape = with_opening(random, part.shape, in, part.thickness, opening);
        part.openings.push_back(opening);
      }
  }
  if (!part.shape.IsNull() && !BRepCheck_Analyzer(part.shape).IsValid()) part.shape.Nullify();
  return part;
}

}  // namespace planish::openings
