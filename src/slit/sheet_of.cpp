#include <planish/base/tolerance.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>

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

/// The pieces of the modelled half and how they hang together.
class Pieces {
 public:
  explicit Pieces(const FoldedSlitSheet& folded) {
    for (std::size_t i = 0; i < folded.panel.size(); ++i)
      add_facet(folded.panel, i);
    for (const PanelFacet& facet : folded.panel)
      if (facet.strip >= 0) add_strip(folded.strips[facet.strip], facet_index(folded.panel, facet));
    if (folded.symmetric) add_mirror_image(folded.reach);
  }

  std::vector<Piece> pieces;
  std::vector<Seam> seams;

 private:
  struct FacetBorders {
    int left = 0, top = 0,
        right = 0;  ///< of the parts of its sides that touch neighbours, and of its top
  };

  static int facet_index(const std::vector<PanelFacet>& panel, const PanelFacet& facet) {
    return static_cast<int>(&facet - panel.data());
  }

  /// Where a neighbour is lower, its corner divides the side.
  void add_facet(const std::vector<PanelFacet>& panel, std::size_t i) {
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
    if (i > 0)
      seams.push_back(
          {static_cast<int>(i) - 1, facets_.back().right, static_cast<int>(i), borders.left});
    pieces.push_back(std::move(piece));
    facets_.push_back(borders);
  }

  void add_strip(const FoldedStrip& strip, int facet) {
    Seam seam{facet, facets_[facet].top, 0, kNearRidge};
    for (std::size_t i = 0; i < strip.quads.size(); ++i) {
      const SlitRidge &near = strip.ridges[i], &far = strip.ridges[i + 1];
      seam.b = static_cast<int>(pieces.size());
      seams.push_back(seam);
      pieces.push_back({strip.quads[i], {near.flat[0], far.flat[0], far.flat[1], near.flat[1]}});
      seam = {seam.b, kFarRidge, 0, kNearRidge};
    }
    last_quads_.push_back(seam.a);
  }

  void add_mirror_image(double symmetry_line) {
    const int half = static_cast<int>(pieces.size());
    const std::vector<Seam> half_seams = seams;
    for (int i = 0; i < half; ++i)
      pieces.push_back(mirrored(pieces[i], symmetry_line));
    const auto image = [&](int piece, int border) {
      return pieces[piece].border_count() - 1 - border;
    };
    for (const Seam& seam : half_seams)
      seams.push_back({half + seam.a, image(seam.a, seam.border_a), half + seam.b,
                       image(seam.b, seam.border_b)});
    for (const int quad : last_quads_)
      seams.push_back({quad, kFarRidge, half + quad, image(quad, kFarRidge)});
  }

  static constexpr int kFarRidge = 1, kNearRidge = 3;
  std::vector<FacetBorders> facets_;
  std::vector<int> last_quads_;
};

/// Angle by which the sheet is folded where two pieces meet; positive away from its front.
double fold_between(const Piece& a, int border, const Piece& b) {
  const std::size_t i = static_cast<std::size_t>(border), n = a.corners.size();
  // The piece lies left of its border, so the other one's normal leans outwards where the front is
  // convex.
  const Vec3 along = (a.frame.point(a.corners[(i + 1) % n]) - a.frame.point(a.corners[i]))
                         .normalized();
  return std::atan2(along.dot(a.frame.z.cross(b.frame.z)), a.frame.z.dot(b.frame.z));
}

/// Which pieces are one plane: the smallest piece of each.
std::vector<int> planes_of(std::size_t count, const std::vector<Seam>& seams,
                           const std::vector<double>& folds) {
  std::vector<int> plane(count);
  std::iota(plane.begin(), plane.end(), 0);
  const auto root = [&](int i) {
    while (plane[i] != i)
      i = plane[i];
    return i;
  };
  for (std::size_t s = 0; s < seams.size(); ++s)
    if (std::abs(folds[s]) <= kFolds) {
      const int a = root(seams[s].a), b = root(seams[s].b);
      plane[std::max(a, b)] = std::min(a, b);
    }
  for (std::size_t i = 0; i < count; ++i)
    plane[i] = root(static_cast<int>(i));
  return plane;
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

Border& border_of(Sheet& sheet, const BorderRef& ref) { return sheet[ref]; }

void add_faces(Sheet& sheet, const Pieces& pieces, const std::vector<int>& planes) {
  std::vector<std::optional<FlangeId>> flanges(planes.size());
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    auto& flange = flanges[planes[i]];
    if (!flange) {
      flange = static_cast<FlangeId>(sheet.flanges.size());
      sheet.flanges.emplace_back();
    }
    sheet.flanges[*flange].faces.push_back(static_cast<FaceId>(i));
    sheet.faces.push_back(face_of(pieces.pieces[i], *flange));
  }
}

void add_joints(Sheet& sheet, const Pieces& pieces, const std::vector<double>& folds,
                const std::vector<int>& planes) {
  for (std::size_t s = 0; s < pieces.seams.size(); ++s) {
    const Seam& seam = pieces.seams[s];
    Joint joint{{static_cast<FaceId>(seam.a), 0, seam.border_a},
                {static_cast<FaceId>(seam.b), 0, seam.border_b},
                std::nullopt};
    if (planes[seam.a] != planes[seam.b]) {
      joint.sharp = static_cast<BendId>(sheet.bends.size());
      Bend bend;
      bend.kind = BendKind::sharp;
      bend.angle = Angle::radians(std::abs(folds[s]));
      bend.reference_inside = folds[s] < 0.0;
      sheet.bends.push_back(std::move(bend));
    }
    sheet.joints.push_back(joint);
  }
}

/// The number of each strip, on the panel below it, where no ridges are.
void add_labels(Sheet& sheet, const FoldedSlitSheet& folded) {
  for (std::size_t facet = 0; facet < folded.panel.size(); ++facet) {
    const auto& [corners, frame, strip] = folded.panel[facet];
    if (strip < 0) continue;
    const Vec2 top = 0.5 * (corners[1] + corners[2]), bottom = 0.5 * (corners[0] + corners[3]);
    constexpr double kBelow = 0.1;  // of the panel
    sheet.labels.push_back(
        {static_cast<FaceId>(facet), top + kBelow * (bottom - top), std::to_string(strip)});
  }
}

void number_edges(Sheet& sheet) {
  int edge = 0;
  for (Face& face : sheet.faces)
    for (Border& border : face.loops.front())
      border.edge = ++edge;
  for (const Joint& joint : sheet.joints)
    border_of(sheet, joint.b).edge = border_of(sheet, joint.a).edge;
}

}  // namespace

Sheet sheet_of(const FoldedSlitSheet& folded) {
  const Pieces pieces(folded);
  std::vector<double> folds;
  for (const Seam& seam : pieces.seams)
    folds.push_back(fold_between(pieces.pieces[seam.a], seam.border_a, pieces.pieces[seam.b]));
  const std::vector<int> planes = planes_of(pieces.pieces.size(), pieces.seams, folds);
  Sheet sheet;
  sheet.thickness = folded.thickness;
  sheet.reference_depth = 0.5 * folded.thickness;
  add_faces(sheet, pieces, planes);
  add_joints(sheet, pieces, folds, planes);
  number_edges(sheet);
  add_labels(sheet, folded);
  return sheet;
}

Mesh mesh_of(const FoldedSlitSheet& folded) {
  const Pieces pieces(folded);
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
    for (const Seam& seam : pieces.seams) {
      if (seam.a != static_cast<int>(i)) continue;
      auto& other = corner[seam.b];
      const std::size_t n = piece.corners.size(), m = other.size();
      const auto a = static_cast<std::size_t>(seam.border_a),
                 b = static_cast<std::size_t>(seam.border_b);
      if (other[b] < 0) other[b] = corner[i][(a + 1) % n];
      if (other[(b + 1) % m] < 0) other[(b + 1) % m] = corner[i][a];
    }
    for (std::size_t c = 1; c + 1 < piece.corners.size(); ++c)
      mesh.triangles.push_back({corner[i][0], corner[i][c], corner[i][c + 1]});
  }
  return mesh;
}

}  // namespace planish
