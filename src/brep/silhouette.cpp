#include "silhouette.hpp"

#include "borders.hpp"
#include "divided_skin.hpp"
#include "form_volume.hpp"
#include "plane_opening.hpp"
#include "projection.hpp"
#include "skin_outlines.hpp"
#include "threads.hpp"
#include "united_regions.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>
#include <set>

// Seen along the normal of a flange, the solid covers what its faces cover that look this way: the
// skin, and between the skins ledges, chamfers, countersinks and the floors of pockets. Their union
// is the blank, whatever overlaps what: its openings are what is seen through, its outline the
// widest. Upright walls are seen as lines and add nothing.

namespace planish::brep {
namespace {

/// Sine: walls that lean less stand upright, to the digits of a STEP file.
constexpr double kUpright = 1e-4;
/// The same of walls from skin to skin that have a draft and are no slanted cuts: 3°.
constexpr double kDraft = 0.05;

enum class Look { up, down, upright, both };

Vec3 torus_normal(const Torus& torus, int sense, const Vec3& point) {
  const Vec3 local = torus.frame.local(point);
  const Vec2 out = local.head<2>().normalized();
  const Vec3 middle = torus.frame.origin +
                      torus.major * (out.x() * torus.frame.x + out.y() * torus.frame.y);
  return sense * (point - middle).normalized();
}

/// Sines by which a face looks along a normal: the least, not above 0, and the most, not below.
struct Leans {
  double least = 0.0, most = 0.0;
};
std::optional<Leans> leans_of(const Recognition& of, int f, const Vec3& normal) {
  const SolidFace& face = of.model.faces[f];
  const auto* curved = std::get_if<DoublyCurved>(&face.surface);
  if (curved && !curved->torus) return {};
  double least = 0.0, most = 0.0;
  for (const auto& ring : of.outlines[f].rings)
    for (const Vec3& point : ring) {
      const Vec3 outwards = curved ? torus_normal(*curved->torus, face.sense, point)
                                   : outward_normal_at(face, point);
      least = std::min(least, outwards.dot(normal));
      most = std::max(most, outwards.dot(normal));
    }
  return Leans{least, most};
}

/// Which way a face looks, seen along a normal.
Look look_of(const Recognition& of, int f, const Vec3& normal) {
  const auto leans = leans_of(of, f, normal);
  if (!leans) return Look::both;
  if (leans->least < -kUpright) return leans->most > kUpright ? Look::both : Look::down;
  return leans->most > kUpright ? Look::up : Look::upright;
}

/// The flange round a plane face of the reference skin: the faces of the rim that lie between the
/// skins here, reached from the face over each other; over walls beside it that go on along a bend,
/// what lies below the face.
class Slab {
 public:
  Slab(const Recognition& recognition, int skin_face, const Frame& frame)
      : of(recognition), face(skin_face), plane(frame) {
    std::vector<int> open{face};
    while (!open.empty()) {
      const int from = open.back();
      open.pop_back();
      for (const int f : faces_beside(of.model, from)) {
        if (f < 0 || of.rim.part_of[f] < 0) continue;
        if (lies_here(f)) {
          if (held_.insert(f).second) open.push_back(f);
        } else if (from == face) {
          for (const int below : faces_beside(of.model, f))
            if (below >= 0 && of.rim.part_of[below] >= 0 && lies_below(below) && lies_here(below) &&
                held_.insert(below).second)
              open.push_back(below);
        }
      }
    }
  }

  bool holds(int f) const { return held_.contains(f); }

  const Recognition& of;
  const int face;
  const Frame& plane;

 private:
  /// Whether a face lies between the skins, and beside no bend or other flange.
  bool lies_here(int f) const {
    const bool beside_other = std::ranges::any_of(faces_along(of, f, plane), [&](int other) {
      return other >= 0 && other != face && of.skins.skin_of[other] == of.skin;
    });
    if (beside_other) return false;
    const double slack = of.skins.spread + of.tolerance;
    for (const auto& ring : of.outlines[f].rings)
      for (const Vec3& point : ring)
        if (const double depth = -plane.local(point).z();
            depth < -slack || depth > of.skins.thickness + slack)
          return false;
    return true;
  }

  /// Whether a face lies within the extents of the face, seen along its normal.
  bool lies_below(int f) const {
    const Box3& box = of.outlines[face].space;
    return enlarged(box, of.skins.thickness + of.tolerance).contains(of.outlines[f].space);
  }

  std::set<int> held_;
};

/// Whether a part is cut on its own, with the tangent line that it crosses left whole.
bool is_beside_bend(const Recognition& of, const RimPart& part) {
  const auto at = &part - of.rim.parts.data();
  return std::ranges::count(of.tangent_openings, at, &TangentOpening::part) > 0;
}

/// Whether a face leads from one skin to the other.
bool spans(const Recognition& of, const std::set<int>& beside) {
  bool first = false, second = false;
  for (const int f : beside) {
    if (f < 0) continue;
    first |= of.skins.skin_of[f] == Skin::first;
    second |= of.skins.skin_of[f] == Skin::second;
  }
  return first && second;
}

bool has_draft(const Recognition& of, int f, const Vec3& normal) {
  const auto leans = leans_of(of, f, normal);
  return leans && std::max(leans->most, -leans->least) <= kDraft;
}

/// Faces of the rim within a flange that stand not upright.
struct Leaning {
  std::vector<int> up, down;
};

/// Those of a part; nothing where they do not tell what is covered.
std::optional<Leaning> leaning_faces(const Slab& slab, const RimPart& part) {
  const Recognition& of = slab.of;
  Leaning found;
  bool stepped = false;
  std::set<int> leaning, away;  // beyond the flange
  for (const int f : part.faces) {
    const Look look = look_of(of, f, slab.plane.z);
    if (look == Look::upright) continue;
    (slab.holds(f) ? leaning : away).insert(f);
    if (away.contains(f)) continue;
    if (look == Look::both) return std::nullopt;
    const bool through = spans(of, faces_along(of, f, slab.plane));
    if (through && !has_draft(of, f, slab.plane.z)) return std::nullopt;
    (look == Look::up ? found.up : found.down).push_back(f);
    stepped |= !through;
  }
  // A draft alone is cut along the skin, where that is the wider one.
  if (!stepped && found.up.empty()) return std::nullopt;
  for (const int f : leaning)
    if (std::ranges::any_of(faces_beside(of.model, f),
                            [&](int other) { return away.contains(other); }))
      return std::nullopt;
  return found;
}

/// Loops of the face along which a part lies.
std::vector<int> loops_along(const Recognition& of, const RimPart& part, int face) {
  std::vector<int> loops;
  for (const LoopRef& ref : loops_here(of, part))
    if (ref.face == face) loops.push_back(ref.loop);
  return loops;
}

/// Whether the cut of an opening leaves open what no face covers that looks this way: otherwise
/// ledges overlap, or blind bores lie beside it. Ledges of threads overlap as well.
bool is_covered_otherwise(const Slab& slab, const RimPart& part, const std::vector<int>& seen) {
  const Recognition& of = slab.of;
  const LoopRef &here = loops_here(of, part).front(), &there = loops_there(of, part).front();
  if (!goes_round(of, part, here) || !goes_round(of, part, there)) return false;
  const PlaneOpening opening = opening_between(of, part, here, there, slab.plane);
  const BorderLoop cut = narrower_cut(of, opening, slab.plane).value_or(opening.mine);
  if (thread_about(of, part, slab.plane, cut)) return false;
  constexpr double kOff = 1e-5;  // mm all round: more than files round
  const double covered = sum_of(seen,
                                [&](int f) { return projected_area(of.model, f, slab.plane); });
  return std::abs(loop_area(opening.mine) - covered - loop_area(cut)) > kOff * perimeter(cut);
}

/// How a part lies along the outline of a face and along that of the other skin: along both, or
/// along neither and only here; or inside it here, as in other flanges, and on the other skin alone
/// over bends.
enum class OnSkins { alike, over_bend, apart };

OnSkins on_skins(const Slab& slab, const RimPart& part, bool outer) {
  const Recognition& of = slab.of;
  const auto& partners = of.skins.partners[slab.face];
  if (partners.empty()) return OnSkins::apart;
  const int opposite = *std::ranges::max_element(partners, {},
                                                 [&](int f) { return of.outlines[f].area; });
  bool outer_there = false, elsewhere = false;
  for (const LoopRef& ref : loops_there(of, part)) {
    outer_there |= ref.face == opposite && ref.loop == of.outlines[opposite].outer;
    elsewhere |= !lies_opposite(of, slab.face, ref.face);
  }
  if (outer) return outer_there ? OnSkins::alike : OnSkins::apart;
  for (const LoopRef& ref : loops_here(of, part))
    if (ref.face != slab.face && !goes_round(of, part, ref)) return OnSkins::apart;
  if (outer_there && elsewhere && of.skins.sharp.empty()) return OnSkins::over_bend;
  return outer_there || elsewhere ? OnSkins::apart : OnSkins::alike;
}

/// Whether an opening needs more than its narrowest section, or an outline than its own edges.
bool asks(const Slab& slab, const RimPart& part, const std::vector<int>& loops,
          const std::vector<int>& seen) {
  const int outer = slab.of.outlines[slab.face].outer;
  const bool alone = loops_here(slab.of, part).size() == 1 &&
                     loops_there(slab.of, part).size() == 1;
  return !alone || std::ranges::count(loops, outer) > 0 || is_covered_otherwise(slab, part, seen);
}

/// A loop without the seams of its face: what runs between them is closed by itself.
std::vector<std::vector<CoEdge>> without_seams(const std::vector<CoEdge>& loop) {
  const auto is_seam = [&](const CoEdge& use) {
    return std::ranges::count(loop, use.edge, &CoEdge::edge) > 1;
  };
  const auto first = std::ranges::find_if(loop, is_seam);
  if (first == loop.end()) return {loop};
  std::vector<CoEdge> turned(first, loop.end());
  turned.insert(turned.end(), loop.begin(), first);
  std::vector<std::vector<CoEdge>> loops(1);
  for (const CoEdge& use : turned)
    if (!is_seam(use))
      loops.back().push_back(use);
    else if (!loops.back().empty())
      loops.emplace_back();
  std::erase_if(loops, [](const auto& one) { return one.empty(); });
  return loops;
}

/// Borders of an edge loop as seen along the normal of the plane, those that stand upright left
/// out.
BorderLoop seen_borders(const Slab& slab, const std::vector<CoEdge>& uses) {
  const Recognition& of = slab.of;
  BorderLoop loop;
  for (Border& border : read_borders(of.model, uses, slab.plane, 0.0, of.tolerance)) {
    if (length(border.curve) <= of.tolerance) continue;
    const SpaceCurve& edge = of.model.edges[*border.edge - 1].curve;
    if (const auto depth = level_depth(edge, slab.plane, of.tolerance)) {
      border.edge_depth = *depth;
    } else {
      border.edge.reset();
      border.edge_length.reset();
    }
    loop.push_back(std::move(border));
  }
  return loop;
}

/// Borders of a face as they are seen along the normal of the plane, the outer loop first; empty
/// where they do not enclose one region.
PlaneRegion region_of(const Slab& slab, int f) {
  PlaneRegion region;
  for (const auto& uses : slab.of.model.faces[f].loops)
    for (const auto& closed : without_seams(uses))
      region.push_back(seen_borders(slab, closed));
  const auto outer = std::ranges::max_element(region, {}, signed_loop_area);
  if (outer == region.end() || signed_loop_area(*outer) <= 0.0) return {};
  std::iter_swap(region.begin(), outer);
  const bool whole = std::all_of(region.begin() + 1, region.end(), [&](const BorderLoop& loop) {
    return signed_loop_area(loop) < 0.0;
  });
  return whole ? region : PlaneRegion{};
}

/// The parts of the rim that a silhouette accounts for.
struct Seen {
  std::vector<int> parts;
  bool over_bend = false;
  Leaning faces;
  std::set<int> loops;  ///< of the skin face
};
Seen seen_of(const Slab& slab) {
  const Recognition& of = slab.of;
  Seen seen;
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    const RimPart& part = of.rim.parts[p];
    const std::vector<int> loops = loops_along(of, part, slab.face);
    if (loops.empty() || !part.within || loops_there(of, part).empty() || is_beside_bend(of, part))
      continue;
    const auto faces = leaning_faces(slab, part);
    // At sharp bends outlines of the skins differ by more than what the rim takes off.
    const bool plain = faces && faces->up.empty() && !of.skins.sharp.empty();
    const bool outer = std::ranges::count(loops, of.outlines[slab.face].outer) > 0;
    const OnSkins lies = on_skins(slab, part, outer);
    if (!faces || plain || lies == OnSkins::apart || !asks(slab, part, loops, faces->up)) continue;
    seen.parts.push_back(p);
    seen.over_bend |= lies == OnSkins::over_bend;
    std::ranges::copy(faces->up, std::back_inserter(seen.faces.up));
    std::ranges::copy(faces->down, std::back_inserter(seen.faces.down));
    seen.loops.insert(loops.begin(), loops.end());
  }
  return seen;
}

/// The skin with the loops that are seen anew, and what of the rim looks this way.
std::vector<PlaneRegion> regions_of(const Slab& slab, const Seen& seen) {
  const Recognition& of = slab.of;
  const auto& loops = of.model.faces[slab.face].loops;
  const int outer = of.outlines[slab.face].outer;
  std::vector<PlaneRegion> regions(1);
  const auto add = [&](int l) {
    regions.front().push_back(read_borders(of.model, loops[l], slab.plane, 0.0, of.tolerance));
  };
  add(outer);
  for (const int l : seen.loops)
    if (l != outer) add(l);
  for (const int f : seen.faces.up)
    regions.push_back(region_of(slab, f));
  return regions;
}

/// Whether each joint of the skin's outline is left whole.
bool keeps_joints(const Recognition& of, int face, const Silhouette& silhouette) {
  const int outer = of.outlines[face].outer;
  const auto& uses = of.model.faces[face].loops[outer];
  for (int i = 0; i < std::ssize(uses); ++i) {
    const int across = face_across(of.model.edges[uses[i].edge], face);
    const bool wall = across >= 0 && of.rim.part_of[across] >= 0 &&
                      std::ranges::count(silhouette.parts, of.rim.part_of[across]) > 0;
    if (!wall && !silhouette.places.contains({outer, i})) return false;
  }
  return true;
}

}  // namespace

std::vector<int> ledges_of(const Recognition& of, int face) {
  const Slab slab(of, face, std::get<Frame>(of.model.faces[face].surface));
  const int outer = of.outlines[face].outer;
  std::vector<int> ledges;
  for (const RimPart& part : of.rim.parts) {
    const std::vector<int> loops = loops_along(of, part, face);
    if (!part.within || std::ranges::count(loops, outer) == 0 || is_beside_bend(of, part)) continue;
    for (const int f : part.faces)
      if (const Look look = look_of(of, f, slab.plane.z);
          (look == Look::up || look == Look::both) && slab.holds(f) &&
          !spans(of, faces_along(of, f, slab.plane)))
        ledges.push_back(f);
  }
  return ledges;
}

std::optional<Silhouette> silhouette_of(const Recognition& of, int face, int leader) {
  const auto* plane = std::get_if<Frame>(&of.model.faces[leader].surface);
  if (!plane) return {};
  const Slab slab(of, face, *plane);
  const Seen seen = seen_of(slab);
  if (seen.parts.empty()) return {};
  const std::vector<PlaneRegion> regions = regions_of(slab, seen);
  if (std::ranges::any_of(regions, [](const PlaneRegion& region) { return region.empty(); }))
    return {};
  const auto united = united_regions(regions);
  if (!united) return {};
  const int outer = of.outlines[face].outer;
  std::vector<int> numbers{outer};  // of the skin's loops, by those of the first region
  std::ranges::copy_if(seen.loops, std::back_inserter(numbers), [&](int l) { return l != outer; });
  Silhouette silhouette;
  silhouette.parts = seen.parts;
  silhouette.over_bend = seen.over_bend;
  silhouette.leaning = seen.faces.up;
  std::ranges::copy(seen.faces.down, std::back_inserter(silhouette.leaning));
  silhouette.skin_loops.assign(seen.loops.begin(), seen.loops.end());
  silhouette.outer_kept = !seen.loops.contains(outer);
  for (const auto& pieces : *united) {
    const int at = static_cast<int>(silhouette.loops.size());
    BorderLoop& loop = silhouette.loops.emplace_back();
    for (const BorderPiece& piece : pieces) {
      if (piece.region == 0 && piece.whole)
        silhouette.places[{numbers[piece.loop], piece.place}] = {at, static_cast<int>(loop.size())};
      loop.push_back(piece.border);
    }
  }
  if (!silhouette.outer_kept && !keeps_joints(of, face, silhouette)) return {};
  return silhouette;
}

}  // namespace planish::brep
