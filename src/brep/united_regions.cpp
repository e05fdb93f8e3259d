#include "united_regions.hpp"

#include "reference_shell.hpp"

#include <planish/sheet/builder.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <numeric>

// The kernel divides the regions where they cross and joins the cells; its edges are then told
// apart by where they lie, and each is cut anew out of the border that it came from, so that curves
// stay as exact as they were read and keep what is known of them.

namespace planish::brep {
namespace {

/// mm: borders of one edge agree to the digits of a STEP file.
constexpr double kSame = 1e-5;

/// An edge of the union, as its loop runs.
struct UnionEdge {
  Vec2 start, middle, end;
};

std::optional<TopoDS_Shape> faces_of(const std::vector<PlaneRegion>& regions) {
  SheetBuilder builder(1.0);
  const FlangeId flange = builder.add_flange();
  for (const PlaneRegion& region : regions) {
    Face face;
    face.surface = Frame{};
    face.loops = region;
    face.part_of = flange;
    builder.add_face(std::move(face));
  }
  const auto sheet = std::move(builder).build();
  if (!sheet) return {};
  const auto shape = reference_shell(*sheet);
  if (!shape) return {};
  return *shape;
}

std::optional<TopoDS_Face> union_of(const TopoDS_Shape& faces) {
  TopTools_ListOfShape arguments;
  for (TopExp_Explorer at(faces, TopAbs_FACE); at.More(); at.Next())
    arguments.Append(at.Current());
  BRepAlgoAPI_BuilderAlgo divided;
  divided.SetArguments(arguments);
  divided.SetFuzzyValue(kSame);
  divided.Build();
  if (divided.HasErrors()) return {};
  ShapeUpgrade_UnifySameDomain unite(divided.Shape(), false, true, false);
  unite.Build();
  TopExp_Explorer at(unite.Shape(), TopAbs_FACE);
  if (!at.More()) return {};
  const TopoDS_Face face = TopoDS::Face(at.Current());
  at.Next();
  if (at.More()) return {};
  return face;
}

std::vector<UnionEdge> edges_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  const auto flat = [](const gp_Pnt& p) { return Vec2(p.X(), p.Y()); };
  std::vector<UnionEdge> edges;
  for (BRepTools_WireExplorer at(wire, face); at.More(); at.Next()) {
    const BRepAdaptor_Curve curve(at.Current());
    const double from = curve.FirstParameter(), to = curve.LastParameter();
    UnionEdge edge{flat(curve.Value(from)), flat(curve.Value(std::midpoint(from, to))),
                   flat(curve.Value(to))};
    if (at.Current().Orientation() == TopAbs_REVERSED) std::swap(edge.start, edge.end);
    edges.push_back(edge);
  }
  return edges;
}

/// A loop without what it runs there and back: the seam of a face, left when cells were joined.
std::vector<UnionEdge> without_seams(const std::vector<UnionEdge>& loop) {
  std::vector<UnionEdge> kept;
  std::ranges::copy_if(loop, std::back_inserter(kept), [&](const UnionEdge& edge) {
    return std::ranges::none_of(loop, [&](const UnionEdge& other) {
      return (other.start - edge.end).norm() <= kSame && (other.end - edge.start).norm() <= kSame &&
             (other.middle - edge.middle).norm() <= kSame && &other != &edge;
    });
  });
  return kept;
}

/// Twice the area inside a loop, for its sense: chords over the middles of edges.
double turned(const std::vector<UnionEdge>& loop) {
  double sum = 0.0;
  const auto add = [&](const Vec2& a, const Vec2& b) { sum += a.x() * b.y() - a.y() * b.x(); };
  for (const UnionEdge& edge : loop) {
    add(edge.start, edge.middle);
    add(edge.middle, edge.end);
  }
  return sum;
}

/// The loop run so that what it encloses is on its left, or on its right.
std::vector<UnionEdge> run(std::vector<UnionEdge> loop, bool left) {
  if ((turned(loop) > 0.0) == left) return loop;
  std::ranges::reverse(loop);
  for (UnionEdge& edge : loop)
    std::swap(edge.start, edge.end);
  return loop;
}

/// A border of a region, with the box round what is near to it.
struct Source {
  const Border& border;
  int region = 0, loop = 0, place = 0;
  Box2 box;
};

std::vector<Source> sources_of(const std::vector<PlaneRegion>& regions) {
  std::vector<Source> sources;
  for (int r = 0; r < std::ssize(regions); ++r)
    for (int l = 0; l < std::ssize(regions[r]); ++l)
      for (int i = 0; i < std::ssize(regions[r][l]); ++i) {
        const Border& border = regions[r][l][i];
        Box2 box = bounds(border.curve);
        box.lo -= Vec2::Constant(2 * kSame);
        box.hi += Vec2::Constant(2 * kSame);
        sources.push_back({border, r, l, i, box});
      }
  return sources;
}

bool holds(const Box2& box, const Vec2& p) {
  return (p - box.lo).minCoeff() >= 0.0 && (box.hi - p).minCoeff() >= 0.0;
}

/// The part of a border that an edge of the union is; empty if it lies elsewhere.
std::optional<BorderPiece> piece_of(const Source& source, const UnionEdge& edge) {
  constexpr double kNear = 2 * kSame;
  for (const Vec2& p : {edge.start, edge.middle, edge.end})
    if (!holds(source.box, p)) return {};
  const Curve2& curve = source.border.curve;
  const Nearest start = nearest(curve, edge.start), middle = nearest(curve, edge.middle),
                end = nearest(curve, edge.end);
  if (std::max({start.distance, middle.distance, end.distance}) > kNear) return {};
  // Where a closed curve ends it starts.
  const bool closed = (end_of(curve) - start_of(curve)).norm() <= kNear;
  const bool at_seam = closed && (edge.end - edge.start).norm() <= kNear;
  double from = at_seam ? 0.0 : start.t, to = at_seam ? 1.0 : end.t;
  const auto is_end = [&](const Vec2& p) { return (p - start_of(curve)).norm() <= kNear; };
  if (closed && !at_seam && is_end(edge.start)) from = middle.t < to ? 0.0 : 1.0;
  if (closed && !at_seam && is_end(edge.end)) to = middle.t > from ? 1.0 : 0.0;
  BorderPiece piece{source.border, source.region, source.loop, source.place};
  const bool forward = at_seam || from < to;
  const double low = std::min(from, to), high = std::max(from, to);
  if (!at_seam && (middle.t < low || middle.t > high)) return {};  // it runs over the border's ends
  piece.whole = (point_at(curve, low) - start_of(curve)).norm() <= kNear &&
                (point_at(curve, high) - end_of(curve)).norm() <= kNear;
  if (!piece.whole) {
    piece.border.curve = trimmed(curve, low, high);
    piece.border.edge_length.reset();
  }
  if (!forward) piece.border.curve = reversed(piece.border.curve);
  return piece;
}

std::optional<std::vector<BorderPiece>> pieces_of(const std::vector<Source>& sources,
                                                  const std::vector<UnionEdge>& loop) {
  std::vector<BorderPiece> pieces;
  for (const UnionEdge& edge : loop) {
    std::optional<BorderPiece> best;
    for (const Source& source : sources)
      if (auto piece = piece_of(source, edge); piece && (!best || (piece->whole && !best->whole)))
        best = std::move(piece);
    if (!best) return {};
    pieces.push_back(std::move(*best));
  }
  return pieces;
}

/// A region alone is its own union.
std::vector<std::vector<BorderPiece>> borders_of(const PlaneRegion& region) {
  std::vector<std::vector<BorderPiece>> loops;
  for (int l = 0; l < std::ssize(region); ++l) {
    std::vector<BorderPiece>& pieces = loops.emplace_back();
    for (int i = 0; i < std::ssize(region[l]); ++i)
      pieces.push_back({region[l][i], 0, l, i, true});
  }
  return loops;
}

}  // namespace

std::optional<std::vector<std::vector<BorderPiece>>> united_regions(
    const std::vector<PlaneRegion>& regions) {
  if (regions.size() == 1) return borders_of(regions.front());
  const auto faces = faces_of(regions);
  const auto face = faces ? union_of(*faces) : std::nullopt;
  if (!face) return {};
  std::vector<std::vector<UnionEdge>> loops;
  for (TopExp_Explorer at(*face, TopAbs_WIRE); at.More(); at.Next())
    if (auto loop = without_seams(edges_of(TopoDS::Wire(at.Current()), *face)); !loop.empty())
      loops.push_back(std::move(loop));
  const auto area = [](const auto& loop) { return std::abs(turned(loop)); };
  const auto outer = std::ranges::max_element(loops, {}, area);
  if (outer == loops.end()) return {};
  std::iter_swap(loops.begin(), outer);
  const std::vector<Source> sources = sources_of(regions);
  std::vector<std::vector<BorderPiece>> result;
  for (auto& loop : loops) {
    auto pieces = pieces_of(sources, run(std::move(loop), result.empty()));
    if (!pieces) return {};
    result.push_back(std::move(*pieces));
  }
  return result;
}

}  // namespace planish::brep
