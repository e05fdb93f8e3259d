#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/base/union_find.hpp>
#include <planish/sheet/builder.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace planish {
namespace {

constexpr double kFolds = tolerance::kComputed;  // radians; less is rounding

/// A plane piece in flat coordinates, counter-clockwise, and where it lies in space.
struct Piece {
  Frame frame;
  std::vector<Vec2> corners;
  int border_count() const { return static_cast<int>(corners.size()); }
};

/// The mirror image in x = 0 of a piece, which lies beyond the symmetry line of the flat sheet. Its
/// border n − 1 − i is the image of border i.
Piece mirrored(const Piece& piece, double symmetry_line) {
  const auto in_space = [](Vec3 v) -> Vec3 { return {-v.x(), v.y(), v.z()}; };
  Piece image;
  image.frame.origin = in_space(piece.frame.origin + 2.0 * symmetry_line * piece.frame.x);
  image.frame.x = -in_space(piece.frame.x);
  image.frame.y = in_space(piece.frame.y);
  image.frame.z = in_space(piece.frame.z);
  for (const Vec2& corner : piece.corners)
    image.corners.emplace_back(2.0 * symmetry_line - corner.x(), corner.y());
  std::reverse(image.corners.begin() + 1, image.corners.end());
  return image;
}

/// Two pieces that share a border.
struct Seam {
  int a = 0, border_a = 0, b = 0, border_b = 0;
};

/// The sheet's pieces and how they hang together.
struct Pieces {
  std::vector<Piece> pieces;
  std::vector<Seam> seams;
};

/// Borders of a facet: of the parts of its sides that touch neighbours, and of its top.
struct FacetBorders {
  int left = 0, top = 0, right = 0;
};

/// Borders of a quad.
constexpr int kFarRidge = 1, kNearRidge = 3;

/// A facet of the panel. Where a neighbour is lower, its corner divides the side.
std::pair<Piece, FacetBorders> facet_piece(const std::vector<PanelFacet>& panel, std::size_t i) {
  const auto& [bottom_left, top_left, top_right, bottom_right] = panel[i].corners;
  Piece piece{panel[i].frame, {bottom_left}};
  FacetBorders borders;
  if (i > 0 && panel[i - 1].corners[2].x() < top_left.x())
    piece.corners.push_back(panel[i - 1].corners[2]);
  piece.corners.push_back(top_left);
  borders.top = piece.border_count() - 1;
  piece.corners.push_back(top_right);
  if (i + 1 < panel.size() && panel[i + 1].corners[1].x() < top_right.x())
    piece.corners.push_back(panel[i + 1].corners[1]);
  borders.right = piece.border_count() - 1;
  piece.corners.push_back(bottom_right);
  return {std::move(piece), borders};
}

/// The quads of a strip, from the border where it leaves the panel. Returns the last of them.
int add_strip(Pieces& half, const FoldedStrip& strip, int facet, int top) {
  Seam seam{facet, top, 0, kNearRidge};
  for (std::size_t i = 0; i < strip.quads.size(); ++i) {
    const SlitRidge &near = strip.ridges[i], &far = strip.ridges[i + 1];
    seam.b = static_cast<int>(half.pieces.size());
    half.seams.push_back(seam);
    half.pieces.push_back({strip.quads[i], {near.flat[0], far.flat[0], far.flat[1], near.flat[1]}});
    seam = {seam.b, kFarRidge, 0, kNearRidge};
  }
  return seam.a;
}

/// Both halves, joined at the far ridges of the strips' last quads.
Pieces with_mirror_image(Pieces half, double symmetry_line, const std::vector<int>& last_quads) {
  Pieces whole = half;
  const int count = static_cast<int>(half.pieces.size());
  for (const Piece& piece : half.pieces)
    whole.pieces.push_back(mirrored(piece, symmetry_line));
  const auto image = [&](int piece, int border) {
    return half.pieces[piece].border_count() - 1 - border;
  };
  for (const Seam& seam : half.seams)
    whole.seams.push_back({count + seam.a, image(seam.a, seam.border_a), count + seam.b,
                           image(seam.b, seam.border_b)});
  for (const int quad : last_quads)
    whole.seams.push_back({quad, kFarRidge, count + quad, image(quad, kFarRidge)});
  return whole;
}

/// The panel, then the strips, then their mirror images.
Pieces pieces_of(const FoldedSlitSheet& folded) {
  Pieces half;
  std::vector<FacetBorders> borders;
  for (std::size_t i = 0; i < folded.panel.size(); ++i) {
    auto [piece, its] = facet_piece(folded.panel, i);
    const int facet = static_cast<int>(i);
    if (i > 0) half.seams.push_back({facet - 1, borders.back().right, facet, its.left});
    half.pieces.push_back(std::move(piece));
    borders.push_back(its);
  }
  std::vector<int> last_quads;
  for (std::size_t i = 0; i < folded.panel.size(); ++i)
    if (const int strip = folded.panel[i].strip; strip >= 0)
      last_quads.push_back(
          add_strip(half, folded.strips[strip], static_cast<int>(i), borders[i].top));
  return folded.symmetric ? with_mirror_image(std::move(half), folded.reach, last_quads) : half;
}

/// Angle by which the sheet is folded where two pieces meet; positive away from its front.
double fold_between(const Piece& a, int border, const Piece& b) {
  const std::size_t i = static_cast<std::size_t>(border), n = a.corners.size();
  // The piece lies left of its border, so the other one's normal leans outwards where the front is
  // convex.
  const Vec3 along = (a.frame.point(a.corners[(i + 1) % n]) - a.frame.point(a.corners[i]))
                         .normalized();
  return std::atan2(along.dot(a.frame.z.cross(b.frame.z)), a.frame.z.dot(b.frame.z));
}

/// Pieces that are one plane.
UnionFind planes_of(std::size_t count, const std::vector<Seam>& seams,
                    const std::vector<double>& folds) {
  UnionFind planes(static_cast<int>(count));
  for (std::size_t s = 0; s < seams.size(); ++s)
    if (std::abs(folds[s]) <= kFolds) planes.unite(seams[s].a, seams[s].b);
  return planes;
}

Face face_of(const Piece& piece, FlangeId flange) {
  Face face;
  face.surface = piece.frame;
  face.part_of = flange;
  BorderLoop& loop = face.loops.emplace_back();
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const Vec2 &from = piece.corners[i], &to = piece.corners[(i + 1) % piece.corners.size()];
    Border border{Segment{from, to}};
    border.edge_length = (piece.frame.point(to) - piece.frame.point(from)).norm();
    loop.push_back(border);
  }
  return face;
}

void add_faces(SheetBuilder& builder, const Pieces& pieces, UnionFind& planes) {
  std::vector<std::optional<FlangeId>> flanges(pieces.pieces.size());
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    auto& flange = flanges[planes.root(static_cast<int>(i))];
    if (!flange) flange = builder.add_flange();
    builder.add_face(face_of(pieces.pieces[i], *flange));
  }
}

void add_joints(SheetBuilder& builder, const Pieces& pieces, const std::vector<double>& folds,
                UnionFind& planes) {
  for (std::size_t s = 0; s < pieces.seams.size(); ++s) {
    const Seam& seam = pieces.seams[s];
    std::optional<BendId> sharp;
    if (!planes.same(seam.a, seam.b)) {
      Bend bend;
      bend.kind = BendKind::sharp;
      bend.angle = Angle::radians(std::abs(folds[s]));
      bend.reference_inside = folds[s] < 0.0;
      sharp = builder.add_bend(std::move(bend));
    }
    builder.join({static_cast<FaceId>(seam.a), 0, seam.border_a},
                 {static_cast<FaceId>(seam.b), 0, seam.border_b}, sharp);
  }
}

/// The number of each strip, on the panel below it, where no ridges are.
void add_labels(SheetBuilder& builder, const FoldedSlitSheet& folded) {
  for (std::size_t facet = 0; facet < folded.panel.size(); ++facet) {
    const auto& [corners, frame, strip] = folded.panel[facet];
    if (strip < 0) continue;
    const Vec2 top = 0.5 * (corners[1] + corners[2]), bottom = 0.5 * (corners[0] + corners[3]);
    constexpr double kBelow = 0.1;  // of the panel
    builder.add_label(
        {static_cast<FaceId>(facet), top + kBelow * (bottom - top), std::to_string(strip)});
  }
}

}  // namespace

Sheet sheet_of(const FoldedSlitSheet& folded) {
  const Pieces pieces = pieces_of(folded);
  std::vector<double> folds;
  for (const Seam& seam : pieces.seams)
    folds.push_back(fold_between(pieces.pieces[seam.a], seam.border_a, pieces.pieces[seam.b]));
  UnionFind planes = planes_of(pieces.pieces.size(), pieces.seams, folds);
  SheetBuilder builder(folded.thickness, 0.5 * folded.thickness);
  add_faces(builder, pieces, planes);
  add_joints(builder, pieces, folds, planes);
  builder.number_edges();
  add_labels(builder, folded);
  auto sheet = std::move(builder).build();
  PLANISH_ASSERT(sheet);
  return std::move(*sheet);
}

Mesh mesh_of(const FoldedSlitSheet& folded) {
  const Pieces pieces = pieces_of(folded);
  std::vector<std::vector<int>> seams_of(pieces.pieces.size());  // by their first piece
  for (std::size_t s = 0; s < pieces.seams.size(); ++s)
    seams_of[pieces.seams[s].a].push_back(static_cast<int>(s));
  Mesh mesh;
  std::vector<std::vector<int>> corner(pieces.pieces.size());
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i)
    corner[i].assign(pieces.pieces[i].corners.size(), -1);
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    const Piece& piece = pieces.pieces[i];
    for (std::size_t c = 0; c < piece.corners.size(); ++c) {
      if (corner[i][c] >= 0) continue;
      corner[i][c] = static_cast<int>(mesh.points.size());
      mesh.points.push_back(piece.frame.point(piece.corners[c]));
    }
    // Seams are listed from the piece that comes first, so its corners are known.
    for (const int s : seams_of[i]) {
      const Seam& seam = pieces.seams[s];
      auto& other = corner[seam.b];
      const std::size_t n = piece.corners.size(), m = other.size();
      const std::size_t a = seam.border_a, b = seam.border_b;
      if (other[b] < 0) other[b] = corner[i][(a + 1) % n];
      if (other[(b + 1) % m] < 0) other[(b + 1) % m] = corner[i][a];
    }
    for (std::size_t c = 1; c + 1 < piece.corners.size(); ++c)
      mesh.triangles.push_back({corner[i][0], corner[i][c], corner[i][c + 1]});
  }
  return mesh;
}

}  // namespace planish
