// How much is cut off where several folds or a cone end in one corner: on its inside a sheet of
// real thickness has no room there. A fold of angle φ moves into a panel by inside · tan(φ/2);
// panels that meet in a point stay clear of each other's insides. The most that anything at a
// corner asks for is cut, along rulings.

#include "tip_cuts.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {
namespace {

/// Inside radius that remains, in thicknesses.
constexpr double kInsideRadius = 0.1;
/// Largest share of a ruling that may be cut off.
constexpr double kMostOfRuling = 0.9;
/// Largest share of a panel's border that is cut off for other panels.
constexpr double kMostForOthers = 0.3;
/// Sine of the angle by which a ruling is apart from a line.
constexpr double kApart = 0.2;
/// Sine of the angle between directions that are one.
constexpr double kSameDirection = 1e-6;
/// Corners of profiles that are one, a share of the extent.
constexpr double kSameCorner = tolerance::kComputed;

/// Whether a tip or a panel's corner is where another is.
bool same_corner(const auto& a, const auto& b, double near) {
  return a.side == b.side && (a.at - b.at).norm() <= near;
}

/// A corner of a plane part, and the folds along the two borders that meet there (0: none).
struct PanelCorner {
  int side = 0;
  Vec3 at, one_way, other_way;  ///< the corner, and the next ones along both borders
  double fold = 0.0, other_fold = 0.0;
  bool on_edge = false;  ///< of the profile, the other way
  Vec3 normal = Vec3::Zero();
};

std::vector<PanelCorner> corners_of(const RuledPatch& patch, const PatchPart& part,
                                    double first_fold, double last_fold) {
  const auto [p0, q0] = patch.ruling(part.from);
  const auto [p1, q1] = patch.ruling(part.to);
  if (patch.stands(0))
    return {{0, p0, q0, q1, first_fold, last_fold},
            {1, q0, p0, q1, first_fold, 0.0},
            {1, q1, p0, q0, last_fold, 0.0}};
  if (patch.stands(1))
    return {{1, q0, p0, p1, first_fold, last_fold},
            {0, p0, q0, p1, first_fold, 0.0, true},
            {0, p1, q0, p0, last_fold, 0.0, true}};
  return {{0, p0, q0, p1, first_fold, 0.0, true},
          {0, p1, q1, p0, last_fold, 0.0, true},
          {1, q0, p0, q1, first_fold, 0.0, true},
          {1, q1, p1, q0, last_fold, 0.0, true}};
}

/// How far from a panel's corner its inside is wide enough: folds move into the panel by inside ·
/// tan(fold / 2).
double cut_of(const PanelCorner& corner, double inside, double radius) {
  const double opening = angle_between(corner.one_way - corner.at, corner.other_way - corner.at);
  const double moved = inside * (std::tan(0.5 * corner.fold) + std::tan(0.5 * corner.other_fold));
  const double wanted = 0.5 * (radius - inside) * (corner.fold + corner.other_fold);
  return (moved * std::cos(0.5 * opening) + wanted) / (2.0 * std::sin(0.5 * opening));
}

/// How far from its corner a panel clears another one that ends there. Their planes meet in a line
/// through the corner, from which the insides of both stay away by inside · tan(turn / 2). Where
/// that is a ruling or near one, it is the business of folds and cones.
double cut_beside(const PanelCorner& own, const PanelCorner& other, double inside, double room) {
  const Vec3 line = own.normal.cross(other.normal);
  if (line.norm() <= kSameDirection) return 0.0;
  const Vec3 across = line.cross(own.normal).normalized();
  const double wanted = inside * std::tan(0.5 * angle_between(own.normal, other.normal)) + room;
  double cut = 0.0;
  for (const Vec3& end : {own.one_way, own.other_way}) {
    const Vec3 border = end - own.at;
    const double away = std::abs(across.dot(border)) / border.norm();
    const bool edge = own.on_edge && end == own.other_way;
    if (!edge && away <= kSameDirection) return 0.0;  // the fold between them, which has a mitre
    if (edge && away <= kSameDirection) continue;     // a ridge, in which their planes meet
    if (!edge && away < kApart) continue;
    const double most = kMostForOthers * border.norm();
    cut = std::max(cut, away * most > wanted ? wanted / away : most);
  }
  return cut;
}

}  // namespace

TipCuts::TipCuts(const Ring& ring, const PieceParts& pieces, const TransitionSpec& spec)
    : near_(kSameCorner * ring.size), thickness_(spec.thickness) {
  const double inside = spec.k_factor * spec.thickness,
               radius = inside + kInsideRadius * spec.thickness;
  add_cones(ring, radius);
  add_fans(ring, pieces, inside, radius);
}

void TipCuts::add_cones(const Ring& ring, double radius) {
  for (const RuledPatch& patch : ring.patches)
    for (int side = 0; side < 2; ++side)
      if (!patch.plane() && patch.stands(side))
        tips_.push_back({side, patch.ruling(0.0)[side], patch.distance_of_radius(radius)});
}

/// Panels at corners in which more than one fold or also a cone ends: there the mitres of all would
/// have to meet in one point, which offset planes do not.
void TipCuts::add_fans(const Ring& ring, const PieceParts& pieces, double inside, double radius) {
  std::vector<PanelCorner> corners;
  std::vector<Tip> folds;
  for (const auto& parts : pieces)
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const RuledPatch& patch = ring.patch(parts[i].patch);
      const double first = i == 0 ? 0.0 : fold_between(ring, parts[i - 1], parts[i]);
      const double last = i + 1 == parts.size() ? 0.0 : fold_between(ring, parts[i], parts[i + 1]);
      if (first > 0.0)
        for (int side = 0; side < 2; ++side)
          folds.push_back({side, patch.ruling(parts[i].from)[side], 0.0});
      if (!patch.plane()) continue;
      for (PanelCorner corner : corners_of(patch, parts[i], first, last)) {
        corner.normal = patch.normal(0.5 * (parts[i].from + parts[i].to));
        corners.push_back(corner);
      }
    }
  const std::vector<Tip> cones = tips_;
  for (const PanelCorner& corner : corners) {
    const auto here = [&](const Tip& tip) { return same_corner(tip, corner, near_); };
    const auto ending = std::ranges::count_if(folds, here) + std::ranges::count_if(cones, here);
    if (ending > 1) tips_.push_back({corner.side, corner.at, cut_of(corner, inside, radius)});
  }
  for (const PanelCorner& corner : corners)
    for (const PanelCorner& other : corners)
      if (same_corner(other, corner, near_))
        if (const double cut = cut_beside(corner, other, inside, radius - inside); cut > 0.0)
          tips_.push_back({corner.side, corner.at, cut});
}

double TipCuts::at(int side, const Vec3& p) const {
  double cut = 0.0;
  for (const Tip& tip : tips_)
    if (tip.side == side && (tip.at - p).norm() <= near_) cut = std::max(cut, tip.cut);
  return cut;
}

RuledPatch::Tips TipCuts::of(const RuledPatch& patch, double from, double to) const {
  const auto first = patch.ruling(from), last = patch.ruling(to);
  RuledPatch::Tips tips;
  for (std::size_t side = 0; side < 2; ++side) {
    tips.at_from[side] = at(static_cast<int>(side), first[side]);
    tips.at_to[side] = at(static_cast<int>(side), last[side]);
  }
  return tips;
}

Result<void> TipCuts::leave_room(const RuledPatch& patch, double from, double to) const {
  const RuledPatch::Tips tips = of(patch, from, to);
  const auto check = [&](const std::array<double, 2>& cuts, double ruling) -> Result<void> {
    const auto [p, q] = patch.ruling(ruling);
    const double length = (q - p).norm();
    if (cuts[0] + cuts[1] <= kMostOfRuling * length) return {};
    return fail(refuse::no_room_at_corner, {{"thickness", thickness_, unit::mm},
                                            {"at", place::point(cuts[0] >= cuts[1] ? p : q)},
                                            {"needed", cuts[0] + cuts[1], unit::mm},
                                            {"length", length, unit::mm},
                                            {"field", place::pointer("/thickness")}});
  };
  if (auto room = check(tips.at_from, from); !room) return room;
  return check(tips.at_to, to);
}

}  // namespace planish::transition_detail
