#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/base/union_find.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/sheet/builder.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

// Folded strips and panels as a Sheet. Plane regions are listed with the borders they share, half a
// sheet first and then its mirror image; regions in one plane become one flange (a union of sets),
// the others are joined by a bend or a fold of their angle. The panels come before the strips,
// since the mesh takes a shared corner from the region that comes first.

namespace planish {
namespace {

constexpr double kFolds = tolerance::kComputed;  // radians; less is rounding

/// A plane region in flat coordinates, counter-clockwise, and where it lies in space.
struct PlaneRegion {
  Frame frame;
  std::vector<Vec2> corners;
  int border_count() const { return static_cast<int>(corners.size()); }
};

/// The mirror image in x = 0 of a region, which lies beyond the symmetry line of the flat sheet.
/// Its border n − 1 − i is the image of border i.
PlaneRegion mirrored(const PlaneRegion& region, double symmetry_line) {
  const auto in_space = [](Vec3 v) -> Vec3 { return {-v.x(), v.y(), v.z()}; };
  PlaneRegion image;
  image.frame.origin = in_space(region.frame.origin + 2.0 * symmetry_line * region.frame.x);
  image.frame.x = -in_space(region.frame.x);
  image.frame.y = in_space(region.frame.y);
  image.frame.z = in_space(region.frame.z);
  for (const Vec2& corner : region.corners)
    image.corners.emplace_back(2.0 * symmetry_line - corner.x(), corner.y());
  std::reverse(image.corners.begin() + 1, image.corners.end());
  return image;
}

/// Two regions that share a border.
struct SharedBorder {
  int a = 0, border_a = 0, b = 0, border_b = 0;
};

/// The sheet's regions and how they are joined.
struct JoinedRegions {
  std::vector<PlaneRegion> all;
  std::vector<SharedBorder> shared;
};

/// Borders of a facet: the parts of its sides that touch neighbours, and its top.
struct FacetBorders {
  int left = 0, top = 0, right = 0;
};

/// A quad of a strip, from the left end of its near ridge, with the corners of its edges.
PlaneRegion quad_region(const FoldedStrip& strip, std::size_t quad) {
  const SlitRidge &near = strip.ridges[quad], &far = strip.ridges[quad + 1];
  PlaneRegion region{strip.quads[quad], {near.flat[0], far.flat[0], far.flat[1], near.flat[1]}};
  if (strip.borders.empty()) return region;
  const auto& [left, right] = strip.borders[quad];
  region.corners.insert(region.corners.end() - 1, right.rbegin(), right.rend());
  region.corners.insert(region.corners.begin() + 1, left.begin(), left.end());
  return region;
}

/// Borders of a quad.
int far_ridge(const FoldedStrip& strip, std::size_t quad) {
  return 1 + (strip.borders.empty() ? 0 : static_cast<int>(strip.borders[quad][0].size()));
}
int near_ridge(const PlaneRegion& region) { return region.border_count() - 1; }

/// A facet of the panel. If a neighbour is lower, its corner divides the side.
std::pair<PlaneRegion, FacetBorders> facet_region(const std::vector<PanelFacet>& panel,
                                                  std::size_t i) {
  const auto& [bottom_left, top_left, top_right, bottom_right] = panel[i].corners;
  const auto height = [&](const Vec2& corner) { return std::abs(corner.x() - bottom_left.x()); };
  PlaneRegion region{panel[i].frame, {bottom_left}};
  FacetBorders borders;
  if (i > 0 && panel[i].joined && height(panel[i - 1].corners[2]) < height(top_left))
    region.corners.push_back(panel[i - 1].corners[2]);
  region.corners.push_back(top_left);
  borders.top = region.border_count() - 1;
  region.corners.push_back(top_right);
  if (i + 1 < panel.size() && panel[i + 1].joined &&
      height(panel[i + 1].corners[1]) < height(top_right))
    region.corners.push_back(panel[i + 1].corners[1]);
  borders.right = region.border_count() - 1;
  region.corners.push_back(bottom_right);
  return {std::move(region), borders};
}

/// A facet of the second panel, whose top faces the strips. Seen from its free edge the sheet's
/// left is on the right: it is listed as the flat sheet turned by 180° shows it.
std::vector<PanelFacet> turned_about(const std::vector<PanelFacet>& panel) {
  std::vector<PanelFacet> turned;
  for (auto facet = panel.rbegin(); facet != panel.rend(); ++facet) {
    const auto& c = facet->corners;
    const bool joined = facet != panel.rbegin() && std::prev(facet)->joined;
    turned.push_back({{c[3], c[2], c[1], c[0]}, facet->frame, facet->strip, joined});
  }
  return turned;
}

/// A region and one of its borders.
struct RegionBorder {
  int region = 0, border = 0;
};

/// The quads of a strip, from the border where it leaves the panel. Returns the end of the last.
RegionBorder add_strip(JoinedRegions& half, const FoldedStrip& strip, int facet, int top) {
  RegionBorder end{facet, top};
  for (std::size_t i = 0; i < strip.quads.size(); ++i) {
    PlaneRegion region = quad_region(strip, i);
    const int number = static_cast<int>(half.all.size());
    half.shared.push_back({end.region, end.border, number, near_ridge(region)});
    half.all.push_back(std::move(region));
    end = {number, far_ridge(strip, i)};
  }
  return end;
}

/// Both halves, joined at the far ridges of the strips' last quads.
JoinedRegions with_mirror_image(JoinedRegions half, double symmetry_line,
                                const std::vector<RegionBorder>& ends) {
  JoinedRegions whole = half;
  const int count = static_cast<int>(half.all.size());
  for (const PlaneRegion& region : half.all)
    whole.all.push_back(mirrored(region, symmetry_line));
  const auto image = [&](int region, int border) {
    return half.all[region].border_count() - 1 - border;
  };
  for (const SharedBorder& border : half.shared)
    whole.shared.push_back({count + border.a, image(border.a, border.border_a), count + border.b,
                            image(border.b, border.border_b)});
  for (const auto& [quad, ridge] : ends)
    whole.shared.push_back({quad, ridge, count + quad, image(quad, ridge)});
  return whole;
}

/// The facets of a panel, joined side by side. Returns their borders.
std::vector<FacetBorders> add_panel(JoinedRegions& half, const std::vector<PanelFacet>& panel) {
  const int first = static_cast<int>(half.all.size());
  std::vector<FacetBorders> borders;
  for (std::size_t i = 0; i < panel.size(); ++i) {
    auto [region, its] = facet_region(panel, i);
    const int facet = first + static_cast<int>(i);
    if (i > 0 && panel[i].joined)
      half.shared.push_back({facet - 1, borders.back().right, facet, its.left});
    half.all.push_back(std::move(region));
    borders.push_back(its);
  }
  return borders;
}

/// A second panel's facet, its top and its bottom, by strip; no region: none.
struct FarFacet {
  int region = -1, top = 0, bottom = 0;
};
using FarFacets = std::vector<FarFacet>;

/// The second panel; it comes before the strips, as regions that share corners with several others
/// must.
FarFacets add_second_panel(JoinedRegions& sheet, const std::vector<PanelFacet>& second,
                           std::size_t strips) {
  const std::vector<PanelFacet> panel = turned_about(second);
  const int first = static_cast<int>(sheet.all.size());
  const auto borders = add_panel(sheet, panel);
  FarFacets facets(strips);
  for (std::size_t i = 0; i < panel.size(); ++i)
    if (const int strip = panel[i].strip; strip >= 0)
      facets[strip] = {first + static_cast<int>(i), borders[i].top,
                       sheet.all[first + static_cast<int>(i)].border_count() - 1};
  return facets;
}

/// The panel, the second panel, then the strips, then the mirror image of it all.
JoinedRegions regions_of(const FoldedSlitSheet& folded) {
  JoinedRegions half;
  const std::vector<FacetBorders> borders = add_panel(half, folded.panel);
  const FarFacets far = add_second_panel(half, folded.second_panel, folded.strips.size());
  std::vector<RegionBorder> ends;
  for (std::size_t i = 0; i < folded.panel.size(); ++i) {
    const int strip = folded.panel[i].strip;
    if (strip < 0) continue;
    ends.push_back(add_strip(half, folded.strips[strip], static_cast<int>(i), borders[i].top));
    if (const auto [facet, top, bottom] = far[strip]; facet >= 0) {
      half.shared.push_back({facet, top, ends.back().region, ends.back().border});
      ends.back() = {facet, bottom};
    }
  }
  return folded.symmetric ? with_mirror_image(std::move(half), folded.reach, ends) : half;
}

/// Angle by which the sheet is folded where two regions meet; positive away from its front.
double fold_between(const PlaneRegion& a, int border, const PlaneRegion& b) {
  const std::size_t i = static_cast<std::size_t>(border), n = a.corners.size();
  // The region lies left of its border, so the other one's normal leans outwards where the front is
  // convex.
  const Vec3 along = (a.frame.point(a.corners[(i + 1) % n]) - a.frame.point(a.corners[i]))
                         .normalized();
  return std::atan2(along.dot(a.frame.z.cross(b.frame.z)), a.frame.z.dot(b.frame.z));
}

/// Regions that lie in one plane.
UnionFind planes_of(std::size_t count, const std::vector<SharedBorder>& shared,
                    const std::vector<double>& folds) {
  UnionFind planes(static_cast<int>(count));
  for (std::size_t s = 0; s < shared.size(); ++s)
    if (std::abs(folds[s]) <= kFolds) planes.unite(shared[s].a, shared[s].b);
  return planes;
}

Face face_of(const PlaneRegion& region, FlangeId flange) {
  Face face;
  face.surface = region.frame;
  face.part_of = flange;
  BorderLoop& loop = face.loops.emplace_back();
  for (const Segment& side : sides_of(region.corners))
    loop.push_back(
        {.curve = side,
         .edge_length = (region.frame.point(side.b) - region.frame.point(side.a)).norm()});
  return face;
}

void add_faces(SheetBuilder& builder, const JoinedRegions& joined, UnionFind& planes) {
  std::vector<std::optional<FlangeId>> flanges(joined.all.size());
  for (std::size_t i = 0; i < joined.all.size(); ++i) {
    auto& flange = flanges[planes.root(static_cast<int>(i))];
    if (!flange) flange = builder.add_flange();
    builder.add_face(face_of(joined.all[i], *flange));
  }
}

void add_joints(SheetBuilder& builder, const JoinedRegions& joined,
                const std::vector<double>& folds, UnionFind& planes) {
  for (std::size_t s = 0; s < joined.shared.size(); ++s) {
    const SharedBorder& border = joined.shared[s];
    std::optional<BendId> sharp;
    if (!planes.same(border.a, border.b)) sharp = builder.add_bend(sharp_bend(folds[s]));
    builder.join({static_cast<FaceId>(border.a), 0, border.border_a},
                 {static_cast<FaceId>(border.b), 0, border.border_b}, sharp);
  }
}

/// The number of each strip as messages count, from 1, on the panel below it, where there are no
/// ridges.
void add_labels(SheetBuilder& builder, const FoldedSlitSheet& folded) {
  for (std::size_t facet = 0; facet < folded.panel.size(); ++facet) {
    const auto& corners = folded.panel[facet].corners;
    const int strip = folded.panel[facet].strip;
    if (strip < 0) continue;
    const Vec2 top = 0.5 * (corners[1] + corners[2]), bottom = 0.5 * (corners[0] + corners[3]);
    constexpr double kBelow = 0.1;  // of the panel
    builder.add_label(
        {static_cast<FaceId>(facet), top + kBelow * (bottom - top), std::to_string(strip + 1)});
  }
}

}  // namespace

Sheet sheet_of(const FoldedSlitSheet& folded) {
  require_valid(folded);
  const JoinedRegions joined = regions_of(folded);
  const auto folds = mapped(joined.shared, [&](const SharedBorder& border) {
    return fold_between(joined.all[border.a], border.border_a, joined.all[border.b]);
  });
  UnionFind planes = planes_of(joined.all.size(), joined.shared, folds);
  SheetBuilder builder(folded.thickness, 0.5 * folded.thickness);
  add_faces(builder, joined, planes);
  add_joints(builder, joined, folds, planes);
  builder.number_edges();
  add_labels(builder, folded);
  auto sheet = std::move(builder).build();
  PLANISH_ASSERT(sheet);
  return std::move(*sheet);
}

namespace {

/// Triangles of a convex region, none of them flat although corners may lie on its sides: those
/// beside such corners are cut off first.
std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<Vec2>& corners) {
  std::vector<std::size_t> rest(corners.size());
  std::iota(rest.begin(), rest.end(), 0);
  const auto at = [&](std::size_t i) { return rest[i % rest.size()]; };
  const auto is_flat = [&](std::size_t i) {
    const Vec2 u = corners[at(i)] - corners[at(i + rest.size() - 1)],
               v = corners[at(i + 1)] - corners[at(i)];
    return std::abs(cross(u, v)) <= tolerance::kComputed * u.norm() * v.norm();
  };
  std::vector<std::array<std::size_t, 3>> triangles;
  while (rest.size() > 3) {
    std::size_t ear = 1;
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (!is_flat(i) && (is_flat(i + 1) || is_flat(i + rest.size() - 1))) ear = i;
    triangles.push_back({at(ear + rest.size() - 1), at(ear), at(ear + 1)});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({rest[0], rest[1], rest[2]});
  return triangles;
}

}  // namespace

Mesh mesh_of(const FoldedSlitSheet& folded) {
  require_valid(folded);
  const JoinedRegions joined = regions_of(folded);
  std::vector<std::vector<int>> shared_by(joined.all.size());  // by their first region
  for (std::size_t s = 0; s < joined.shared.size(); ++s)
    shared_by[joined.shared[s].a].push_back(static_cast<int>(s));
  Mesh mesh;
  std::vector<std::vector<int>> corner(joined.all.size());
  for (std::size_t i = 0; i < joined.all.size(); ++i)
    corner[i].assign(joined.all[i].corners.size(), -1);
  for (std::size_t i = 0; i < joined.all.size(); ++i) {
    const PlaneRegion& region = joined.all[i];
    for (std::size_t c = 0; c < region.corners.size(); ++c) {
      if (corner[i][c] >= 0) continue;
      corner[i][c] = static_cast<int>(mesh.points.size());
      mesh.points.push_back(region.frame.point(region.corners[c]));
    }
    // Shared borders are listed from the region that comes first, so its corners are known.
    for (const int s : shared_by[i]) {
      const SharedBorder& border = joined.shared[s];
      auto& other = corner[border.b];
      const std::size_t n = region.corners.size(), m = other.size();
      const std::size_t a = border.border_a, b = border.border_b;
      if (other[b] < 0) other[b] = corner[i][(a + 1) % n];
      if (other[(b + 1) % m] < 0) other[(b + 1) % m] = corner[i][a];
    }
    for (const auto& t : triangles_of(region.corners))
      mesh.triangles.push_back({corner[i][t[0]], corner[i][t[1]], corner[i][t[2]]});
  }
  return mesh;
}

IdVector<FaceId, SlitPart> parts_of(const FoldedSlitSheet& folded) {
  require_valid(folded);
  IdVector<FaceId, SlitPart> parts(folded.panel.size());
  for (std::size_t facet = 0; facet < folded.second_panel.size(); ++facet)
    parts.push_back({SlitPart::kSecondPanel, false});
  for (const PanelFacet& facet : folded.panel)
    if (facet.strip >= 0)
      for (std::size_t quad = 0; quad < folded.strips[facet.strip].quads.size(); ++quad)
        parts.push_back({facet.strip, false});
  if (!folded.symmetric) return parts;
  const IdVector<FaceId, SlitPart> half = parts;
  for (SlitPart part : half) {
    part.mirrored = true;
    parts.push_back(part);
  }
  return parts;
}

}  // namespace planish
