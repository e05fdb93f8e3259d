// How far openings lie from bends, edges and each other. A distance counts only if the line between
// the nearest points is all material: what is behind another cut is no web. Each opening is
// compared with its nearest neighbour, and a pair is named once.

#include "rule_checks.hpp"

// Openings by bends, by edges and by each other. Distances are measured through material only,
// since what lies beyond a gap is no web; candidates come from trees of boxes. Of an opening the
// nearest neighbour counts, as a perforation would have too many pairs, and of each bend the
// nearest tangent line. A cut from flange to flange through a bend is deliberate; an edge within
// its zone is not.

namespace planish::inspect_detail {
namespace {

Facts facts_of(const Opening& opening, double measured, double wanted, double factor) {
  return {{"opening", place::point(opening.center)},
          {"size", opening.size},
          {"measured", measured, unit::mm},
          {"wanted", wanted, unit::mm},
          {"rule", factors_text(factor)}};
}

Observation in_bend(const Workpiece& workpiece, const Opening& opening, size_t b) {
  int limits_cut = 0;
  for (const BendSide& side : workpiece.sides_of(b)) {
    const auto ends_at_opening = [&](const Segment& s) {
      return gap_between(opening.boxed, Segment{s.a, s.a}, 2.0 * kDrawn).distance <= kDrawn ||
             gap_between(opening.boxed, Segment{s.b, s.b}, 2.0 * kDrawn).distance <= kDrawn;
    };
    if (std::ranges::any_of(side.segments, ends_at_opening)) ++limits_cut;
  }
  // A cut from flange to flange is deliberate; an edge within the zone tears open.
  const bool through = limits_cut == 2;
  const Facts facts{{"bend", workpiece.place_of(b)},
                    {"opening", place::point(opening.center)},
                    {"size", opening.size}};
  return {"opening_in_bend", breach(through ? Severity::info : Severity::warning,
                                    through ? say::opening_through_bend : say::opening_in_bend,
                                    facts, {opening.center})};
}

/// An opening too near to a tangent line.
struct NearBend {
  Gap gap;
  size_t bend;
};

/// The nearest tangent line of each bend that is nearer than `limit` through material.
std::vector<NearBend> near_bends(const Workpiece& workpiece, const Opening& opening, double limit) {
  std::vector<NearBend> found;
  workpiece.tangent_index.visit(widened(opening.boxed.box, limit), [&](size_t i) {
    const auto& [line, bend] = workpiece.tangent_lines[i];
    if (opening.bounds.contains(bend) || opening.reaches_in.contains(bend)) return;
    const Gap gap = gap_between(opening.boxed, line, limit);
    if (gap.distance >= limit - kDrawn || !workpiece.joined_by_material(gap.a, gap.b)) return;
    const auto same = std::ranges::find(found, bend, &NearBend::bend);
    if (same == found.end()) {
      found.push_back({gap, bend});
    } else if (gap.distance < same->gap.distance) {
      same->gap = gap;
    }
  });
  std::ranges::sort(found, {}, &NearBend::bend);
  return found;
}

}  // namespace

std::vector<Observation> observe_openings_by_bends(const Workpiece& workpiece, const Rules& rules) {
  const double limit = rules.opening_to_bend_t * workpiece.thickness;
  std::vector<Observation> result;
  for (const Opening& opening : workpiece.openings) {
    for (const size_t b : opening.reaches_in)
      if (!is_rolled(workpiece.pattern.bends[b], workpiece.thickness))
        result.push_back(in_bend(workpiece, opening, b));
    for (const auto& [gap, bend] : near_bends(workpiece, opening, limit)) {
      Facts facts = facts_of(opening, gap.distance, limit, rules.opening_to_bend_t);
      facts.emplace(facts.begin(), "bend", workpiece.place_of(bend));
      result.push_back({"opening_to_bend",
                        breach(severity_of(gap.distance, limit, kQuarter, rules),
                               say::opening_near_bend, facts, {gap.a}),
                        gap.distance - limit});
    }
  }
  return result;
}

std::vector<Observation> observe_openings_by_edges(const Workpiece& workpiece, const Rules& rules) {
  const double limit = rules.opening_to_edge_t * workpiece.thickness;
  const Loop& outer = workpiece.pattern.outer.loop;
  const BoxTree2 edges(BoxedLoop(outer).boxes);
  std::vector<Observation> result;
  for (const Opening& opening : workpiece.openings) {
    Gap nearest;
    nearest.distance = limit;
    edges.visit(widened(opening.boxed.box, limit), [&](size_t i) {
      const Gap gap = gap_between(opening.boxed, outer[i], nearest.distance);
      if (gap.distance < nearest.distance) nearest = gap;
    });
    if (nearest.distance >= limit - kDrawn) continue;
    result.push_back(
        {"opening_to_edge",
         breach(severity_of(nearest.distance, limit, kHalf, rules), say::opening_near_edge,
                facts_of(opening, nearest.distance, limit, rules.opening_to_edge_t), {nearest.a}),
         nearest.distance - limit});
  }
  return result;
}

namespace {

/// An opening's nearest neighbour: a perforation would have too many pairs within reach.
struct Neighbour {
  Gap gap;
  size_t other = 0;
};

/// The neighbour of each opening that is nearer than `limit` through material.
std::vector<Neighbour> nearest_neighbours(const Workpiece& workpiece, double limit) {
  const auto& openings = workpiece.openings;
  auto boxes = mapped(openings, [&](const Opening& opening) { return opening.boxed.box; });
  const BoxTree2 index(std::move(boxes));
  std::vector<Neighbour> nearest(openings.size());
  for (size_t i = 0; i < openings.size(); ++i) {
    index.visit(widened(openings[i].boxed.box, limit), [&](size_t k) {
      if (k <= i) return;
      const double reach = std::min(limit,
                                    std::max(nearest[i].gap.distance, nearest[k].gap.distance));
      const Gap gap = gap_between(openings[i].boxed, openings[k].boxed, reach);
      if (gap.distance >= reach - kDrawn || !workpiece.joined_by_material(gap.a, gap.b)) return;
      if (gap.distance < nearest[i].gap.distance) nearest[i] = {gap, k};
      if (gap.distance < nearest[k].gap.distance) nearest[k] = {{gap.distance, gap.b, gap.a}, i};
    });
  }
  return nearest;
}

}  // namespace

std::vector<Observation> observe_openings_by_openings(const Workpiece& workpiece,
                                                      const Rules& rules) {
  const double by_thickness = rules.opening_to_opening_t * workpiece.thickness;
  const bool is_thin = by_thickness < rules.opening_to_opening_mm && by_thickness > 0.0;
  const double limit = is_thin ? rules.opening_to_opening_mm : by_thickness;
  const auto& openings = workpiece.openings;
  const std::vector<Neighbour> nearest = nearest_neighbours(workpiece, limit);
  std::vector<Observation> result;
  for (size_t i = 0; i < openings.size(); ++i) {
    const Neighbour& n = nearest[i];
    if (!(n.gap.distance < limit)) continue;
    if (n.other < i && nearest[n.other].other == i) continue;  // reported with the other
    Facts facts = facts_of(openings[i], n.gap.distance, limit, rules.opening_to_opening_t);
    facts.emplace_back("other", place::point(openings[n.other].center));
    facts.emplace_back("other_size", openings[n.other].size);
    result.push_back({"opening_to_opening",
                      breach(severity_of(n.gap.distance, limit, kHalf, rules),
                             is_thin ? say::openings_near_in_thin_sheet : say::openings_near, facts,
                             {n.gap.a, n.gap.b}),
                      n.gap.distance - limit});
  }
  return result;
}

}  // namespace planish::inspect_detail
