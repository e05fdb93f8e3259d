#include "wide_cuts.hpp"

#include "contacts.hpp"
#include "skin_outlines.hpp"
#include "windows.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

// Seen along the normal of the skin, no wall may lie where the blank is cut away. Points along the
// edges of an opening's walls are laid on the faces of the sheet as they were built: over a bend
// where they lie in its turn, else over a flange.

namespace planish::brep {
namespace {

/// How far a point lies off what is left of the sheet, and the nearest border.
struct Off {
  double distance = 0.0;  ///< 0: on it
  BorderRef border;
  Vec2 at = Vec2::Zero();  ///< (u, v) on its face
};

/// Whether a loop is that of a feature, which is not cut.
bool is_outlined_only(const BorderLoop& loop) {
  return std::ranges::all_of(loop, [](const Border& border) { return border.feature.has_value(); });
}

/// A flange or a bend of the sheet as it is cut, with the borders along an opening: those of its
/// walls' edges, or of no edge. Without edges, with all of its borders.
class CutGroup {
 public:
  CutGroup(const Recognition& of, const SheetBuilder& builder, const SheetMap& map, int group,
           const std::optional<std::set<int>>& edges)
      : of_(of),
        faces_(of.groups.rows[group].faces),
        leader_(of.groups.rows[group].leader),
        whole_(!edges) {
    const double scale = of.outlines[leader_].u_scale;
    for (const int f : faces_) {
      const FaceId id = map.face_id.at(f);
      const auto& loops = builder.sheet()[id].loops;
      for (int l = 0; l < std::ssize(loops); ++l) {
        if (is_outlined_only(loops[l])) continue;
        box_.add(bounds(mapped(loops[l], &Border::curve)));
        std::vector<Vec2>& ring = rings_.emplace_back();
        for (int b = 0; b < std::ssize(loops[l]); ++b) {
          const auto& edge = loops[l][b].edge;
          const bool own = !edge || !edges || edges->contains(*edge - 1);
          for (const Vec2& p : sampled(loops[l][b].curve, kChord)) {
            ring.emplace_back(scale * p.x(), p.y());
            if (own) own_.push_back({ring.back(), {id, l, b}});
            if (own) own_box_.add(ring.back());
          }
        }
      }
    }
  }

  bool is_flange() const { return std::holds_alternative<Frame>(surface()); }
  /// Empty of a point that does not lie between the skins here, or beside the opening of a flange:
  /// those of a gentle bend run through each other.
  std::optional<Off> off(const Vec3& point) const {
    const double depth = depth_below(of_.model.faces[leader_], of_.outlines[leader_], point);
    const double slack = kTouching * of_.skins.thickness + of_.skins.spread;
    if (depth < -slack || depth > of_.skins.thickness + slack) return {};
    const auto* plane = std::get_if<Frame>(&surface());
    const Vec2 at = plane ? plane->local2(point)
                          : parameters_of(std::get<Developable>(surface()), point,
                                          (box_.lo.x() + box_.hi.x()) / 2);
    if (!plane && !turns_at(point)) return {};
    const Vec2 foot(of_.outlines[leader_].u_scale * at.x(), at.y());
    const bool beside = (foot - own_box_.lo).minCoeff() < 0.0 ||
                        (own_box_.hi - foot).minCoeff() < 0.0;
    if (beside && plane) return {};
    if ((beside && !whole_) || inside(rings_, foot)) return Off{};
    Off nearest{std::numeric_limits<double>::infinity(), {}, at};
    for (size_t i = 1; i < own_.size(); ++i) {
      if (!(own_[i].border == own_[i - 1].border)) continue;
      const double away = distance(foot, Segment{own_[i - 1].at, own_[i].at});
      if (away < nearest.distance) nearest = {away, own_[i].border, at};
    }
    return nearest;
  }

 private:
  static constexpr double kChord = 1e-5;      // mm
  static constexpr double kTouching = 0.005;  // of the thickness: edges of fillets are fitted
  struct Corner {
    Vec2 at;
    BorderRef border;
  };
  /// Whether a point lies in the turn of the bend: what is cut of it may reach beyond.
  bool turns_at(const Vec3& point) const {
    return std::ranges::any_of(faces_, [&](int f) {
      const Outline& own = of_.outlines[f];
      const double u = parameters_of(std::get<Developable>(surface()), point, own.u_middle).x();
      return u * own.u_scale >= own.box.lo.x() && u * own.u_scale <= own.box.hi.x();
    });
  }
  const SolidSurface& surface() const { return of_.model.faces[leader_].surface; }

  const Recognition& of_;
  const std::vector<int>& faces_;
  int leader_;
  bool whole_;                            ///< with all of its borders
  Box2 box_;                              // in (u, v)
  std::vector<std::vector<Vec2>> rings_;  // u scaled to mm
  std::vector<Corner> own_;
  Box2 own_box_;
};

/// The flanges and bends that an opening touches, on either skin.
std::vector<CutGroup> groups_at(const Recognition& of, const SheetBuilder& builder,
                                const SheetMap& map, const RimPart& part,
                                const std::optional<std::set<int>>& edges) {
  std::set<int> groups;
  for (const LoopRef& ref : loops_here(of, part))
    groups.insert(of.groups.of_face[ref.face]);
  for (const LoopRef& ref : loops_there(of, part))
    for (const int partner : of.skins.partners[ref.face])
      if (of.skins.skin_of[partner] == of.skin) groups.insert(of.groups.of_face[partner]);
  std::vector<CutGroup> found;
  for (const int group : groups)
    if (group >= 0) found.emplace_back(of, builder, map, group, edges);
  return found;
}

/// How far a point of a wall lies within what is cut: over the bend that it lies in, else over the
/// nearest flange.
Off off(const std::vector<CutGroup>& groups, const Vec3& point) {
  std::optional<Off> least;
  for (const bool flange : {false, true})
    for (const CutGroup& group : groups) {
      if (group.is_flange() != flange) continue;
      const auto away = group.off(point);
      if (away && !flange) return *away;
      if (away && (!least || away->distance < least->distance)) least = away;
    }
  return least.value_or(Off{});
}

/// Whether a face leads not from skin to skin.
bool is_machined(const Recognition& of, int wall) {
  return !reaches(of, wall, Skin::first) || !reaches(of, wall, Skin::second);
}

/// Whether a part is an opening at a bend that is machined, or cut across a tangent line, or joins
/// several openings. What is drilled only is a slanted cut, and walls may touch others.
bool is_measured(const Recognition& of, int p) {
  const RimPart& part = of.rim.parts[p];
  if (!part.within || part.openings < 1 || part.first.empty() || part.second.empty()) return false;
  if (part.openings > 1 && part.openings > contours_on(of, part, of.skin)) return false;
  const auto bent = [&](const LoopRef& ref) {
    return !std::holds_alternative<Frame>(of.model.faces[ref.face].surface);
  };
  if (part.openings == 1 && std::ranges::none_of(part.first, bent) &&
      std::ranges::none_of(part.second, bent))
    return false;
  return std::ranges::count(of.tangent_openings, p, &TangentOpening::part) > 0 ||
         std::ranges::any_of(part.faces, [&](int wall) { return is_machined(of, wall); });
}

/// Whether an edge is the far end of a cut from skin to skin, which may be slanted.
bool is_far_end(const Recognition& of, const RimPart& part, int edge) {
  const auto& faces = of.model.edges[edge].faces;
  const auto is_far = [&](int f) { return f >= 0 && of.skins.skin_of[f] == other_skin(of.skin); };
  return std::ranges::any_of(faces, is_far) && std::ranges::any_of(faces, [&](int f) {
           return std::ranges::count(part.faces, f) > 0 && reaches(of, f, of.skin);
         });
}

/// Whether an edge is one of what is machined beside the outline.
bool is_of_ledge(const Recognition& of, const RimPart& part, int edge) {
  return std::ranges::any_of(of.model.edges[edge].faces, [&](int f) {
    return f >= 0 && std::ranges::count(part.faces, f) > 0 && is_machined(of, f);
  });
}

/// What lies deepest within the cut, of points along those of the walls' edges that are asked for.
template <typename Wanted>
Off deepest(const Recognition& of, const RimPart& part, const std::vector<CutGroup>& groups,
            const Wanted& wanted) {
  constexpr int kPoints = 64;
  Off worst;
  for (const int edge : wall_edges(of, part)) {
    if (!wanted(edge)) continue;
    const SpaceCurve& curve = of.model.edges[edge].curve;
    for (int i = 0; i <= kPoints; ++i) {
      const Off at = off(groups, curve.point(std::lerp(curve.t0, curve.t1, double(i) / kPoints)));
      if (at.distance > worst.distance) worst = at;
    }
  }
  return worst;
}

/// How far what is machined beside the outline of a bent sheet lies beyond what is cut.
void measure_rim(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                 const RimPart& part) {
  const bool flat = builder.sheet().bends.empty();
  if (flat || !part.within || part.first.empty() || part.second.empty() || !of.skins.sharp.empty())
    return;
  const auto groups = groups_at(of, builder, map, part, {});
  const Off worst = deepest(of, part, groups, [&](int edge) {
    return is_of_ledge(of, part, edge) && !is_far_end(of, part, edge);
  });
  if (worst.distance > of.tolerance)
    builder.add_outline({worst.border.face, worst.at, worst.distance, 0.0});
}

}  // namespace

void measure_wide_cuts(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  if (of.rim.parts.empty()) return;
  const int outer = outermost(of);
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    if (p == outer || !is_measured(of, p)) continue;
    const RimPart& part = of.rim.parts[p];
    const bool across = std::ranges::count(of.tangent_openings, p, &TangentOpening::part) > 0;
    const Off worst = deepest(of, part, groups_at(of, builder, map, part, wall_edges(of, part)),
                              [&](int edge) { return across || !is_far_end(of, part, edge); });
    if (worst.distance <= of.tolerance) continue;
    MeasuredOpening measured;
    measured.face = worst.border.face;
    measured.loop = worst.border.loop;
    measured.border = worst.border.border;
    measured.intrusion = worst.distance;
    builder.add_opening(measured);
  }
  measure_rim(builder, map, of, of.rim.parts[outer]);
}

}  // namespace planish::brep
