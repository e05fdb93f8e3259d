// The flat length beside a bend, by rays across it at nine stations: to an edge, a window at which
// the bend ends, or another bend's tangent line. The least counts. A die needs as much flat at any
// angle, so the height from the outside that guidelines give at 90° is turned into a flat length
// (shop-floor.md#rules-of-manufacture).

#include "rule_checks.hpp"

#include <planish/geometry/plane.hpp>

#include <cmath>

namespace planish::inspect_detail {
namespace {

constexpr int kStations = 9;

/// Distance along a ray to a tangent line of another bend.
std::pair<double, size_t> first_other_bend(const Workpiece& workpiece, size_t bend,
                                           const Vec2& origin, const Vec2& direction,
                                           double reach) {
  double nearest = std::numeric_limits<double>::infinity();
  size_t which = bend;
  workpiece.tangent_index.visit(box_of({origin, origin + reach * direction}), [&](size_t i) {
    const TangentSegment& other = workpiece.tangent_lines[i];
    if (other.bend == bend) return;
    for (const double t : crossings(other.line, origin, direction)) {
      const double s = (point_at(other.line, t) - origin).dot(direction);
      if (s < 0.0 || s > reach || s >= nearest) continue;
      nearest = s;
      which = other.bend;
    }
  });
  return {nearest, which};
}

/// The flanges that a bend joins.
std::set<FlangeId> flanges_at(const Sheet& sheet, BendId bend) {
  std::set<FlangeId> flanges;
  const auto part = [&](const BorderRef& ref) { return sheet[ref.face].part_of; };
  for (const Joint& joint : sheet.joints) {
    if (joint.sharp != bend && part(joint.a) != PartId(bend) && part(joint.b) != PartId(bend))
      continue;
    for (const BorderRef& ref : {joint.a, joint.b})
      if (const PartId found = part(ref); std::holds_alternative<FlangeId>(found))
        flanges.insert(std::get<FlangeId>(found));
  }
  return flanges;
}

/// The flange beside a bend, if the sheet tells: of those at the bend, or at both of a web, the one
/// whose border is nearest to where the flat length ends.
std::optional<FlangeId> flange_beside(const Workpiece& workpiece, const BendSide& side,
                                      const FlatLength& flat) {
  const auto& bends = workpiece.pattern.bends;
  std::set<FlangeId> flanges = flanges_at(workpiece.sheet, bends[side.bend].bend);
  if (flat.other_bend) {
    const auto others = flanges_at(workpiece.sheet, bends[*flat.other_bend].bend);
    std::erase_if(flanges, [&](FlangeId flange) { return !others.contains(flange); });
    return flanges.size() == 1 ? std::optional(*flanges.begin()) : std::nullopt;
  }
  const Vec2 end = flat.at + flat.length * side.outward;
  std::optional<FlangeId> best;
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](const Contour& contour) {
    for (const auto& origins : contour.origins)
      for (const Origin& origin : origins) {
        if (origin.gap || !workpiece.sheet.faces.has(origin.border.face)) continue;
        const auto* flange = std::get_if<FlangeId>(&workpiece.sheet[origin.border.face].part_of);
        if (!flange || !flanges.contains(*flange)) continue;
        const double distance = nearest(origin.image, end).distance;
        if (distance >= least) continue;
        least = distance;
        best = *flange;
      }
  };
  take(workpiece.pattern.outer);
  for (const Contour& opening : workpiece.pattern.openings)
    take(opening);
  return best;
}

bool on_material(const BendSide& side, const Vec2& p) {
  return std::ranges::any_of(side.segments,
                             [&](const Segment& s) { return nearest(s, p).distance <= kDrawn; });
}

}  // namespace

double measured_setback(const FlatBend& bend, double thickness) {
  const double half = 0.5 * std::min(bend.angle.radians(), Angle::degrees(90).radians());
  return (bend.inside_radius + thickness) * std::tan(half);
}

FlatLength shortest_flat(const Workpiece& workpiece, const BendSide& side, double reach,
                         double margin) {
  // An opening ends a flange only if the bend ends at it too: the window of a tab.
  const auto ends_flange = [&](size_t ring) {
    return ring == 0 || workpiece.openings[ring - 1].bounds.contains(side.bend);
  };
  FlatLength shortest{std::numeric_limits<double>::infinity(), Vec2::Zero(), std::nullopt};
  const double share = side.length() > 0.0 ? std::min(0.25, margin / side.length()) : 0.25;
  for (int i = 0; i < kStations; ++i) {
    const double t = share + (1.0 - 2.0 * share) * i / (kStations - 1);
    const Vec2 station = side.start + t * (side.end - side.start);
    if (!on_material(side, station)) continue;
    // From slightly inside the bend, so that an edge on the tangent line is met.
    const Vec2 origin = station - kDrawn * side.outward;
    const double edge = workpiece.contours.first_hit(origin, side.outward, reach + kDrawn,
                                                     ends_flange);
    const auto [bend, which] = first_other_bend(workpiece, side.bend, origin, side.outward,
                                                reach + kDrawn);
    const double length = std::max(0.0, std::min(edge, bend) - kDrawn);
    if (length >= shortest.length) continue;
    shortest = {length, station, bend < edge ? std::optional(which) : std::nullopt};
  }
  return shortest;
}

std::vector<Observation> observe_flange_heights(const Workpiece& workpiece, const Rules& rules) {
  std::vector<Observation> result;
  std::set<std::pair<size_t, size_t>> webs;  // between two bends: reported once
  for (const BendSide& side : workpiece.sides) {
    const FlatBend& bend = workpiece.pattern.bends[side.bend];
    if (is_hem(bend)) continue;
    // At 90° the outside of the bend lies R + T from the tangent line; the flat length that the die
    // needs beyond the bend does not depend on the angle.
    const double limit = rules.flange_height_t * workpiece.thickness +
                         rules.flange_height_r * bend.inside_radius;
    const double wanted = limit - (bend.inside_radius + workpiece.thickness);
    if (wanted <= kDrawn) continue;
    const FlatLength flat = shortest_flat(workpiece, side, wanted, limit);
    if (flat.length >= wanted - kDrawn) continue;
    const bool nothing_flat = flat.length <= kDrawn;
    // A bend that runs into the next, or a rolled one that ends at the edge, has no flange there.
    if (nothing_flat && (flat.other_bend || is_rolled(bend, workpiece.thickness))) continue;
    if (flat.other_bend && !webs.insert(std::minmax(side.bend, *flat.other_bend)).second) continue;
    const double setback = measured_setback(bend, workpiece.thickness);
    Facts facts{{"bend", workpiece.place_of(side.bend)},
                {"measured", flat.length + setback, unit::mm},
                {"wanted", wanted + setback, unit::mm},
                {"rule", factors_text(rules.flange_height_t, rules.flange_height_r)}};
    if (flat.other_bend) facts.emplace_back("bend", workpiece.place_of(*flat.other_bend));
    if (const auto flange = flange_beside(workpiece, side, flat))
      facts.emplace_back("flange", place::flange(index_of(*flange) + 1));
    result.push_back({"flange_height",
                      breach(Severity::warning, flat.other_bend ? say::low_web : say::low_flange,
                             facts, {flat.at}),
                      flat.length - wanted});
  }
  return result;
}

}  // namespace planish::inspect_detail
