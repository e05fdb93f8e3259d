// Where the flat pattern covers itself (math.md#overlap). Regions of faces and sharp bends are
// intersected in pairs, shrunk by the contact depth so that touching is none; then contours that
// cross themselves, where a probe that is deeper than the contact depth is enclosed twice or the
// wrong way round.

#include "observation.hpp"
#include "regions.hpp"
#include "ring_index.hpp"

#include <planish/base/assert.hpp>
#include <planish/geometry/box_tree.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>
#include <planish/inspect/double_cover.hpp>
#include <planish/inspect/findings.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

// Where a pattern covers itself (math.md#overlap). Regions of different parts are shrunk by the
// clearance and intersected, and what a sharp bend lets its faces share is taken off. A contour
// that crosses itself is an overlap only if a place between the edges that cross is enclosed twice
// or from the wrong side; at a small angle that place is far away, so circles grow until one is
// clear.

namespace planish {

using namespace inspect_detail;

namespace {

/// The area that two parts share, all places together.
struct SharedArea {
  double area = 0.0;
  int places = 0;
  std::vector<Vec2> outline;
};
using SharedByParts = std::map<std::pair<PartId, PartId>, SharedArea>;

SharedByParts shared_by_parts(const Regions& regions, double clearance) {
  SharedByParts result;
  for (const Shared& one : shared_areas(regions, clearance)) {
    SharedArea& shared = result[{one.first, one.second}];
    shared.area += one.area;
    shared.places += static_cast<int>(one.overlap.outline.size());
    for (const auto& ring : one.overlap.outline)
      shared.outline.insert(shared.outline.end(), ring.begin(), ring.end());
  }
  return result;
}

Finding overlap_told(say::Sentence sentence, const Facts& facts, std::vector<Vec2> at) {
  Told text = told(sentence, facts);
  return {"overlap",
          Severity::error,
          std::move(text.sentence),
          std::move(at),
          {},
          std::move(text.places),
          std::move(text.numbers),
          {{"write_overlapping", "true", "Write it anyway"}},
          std::move(text.named)};
}

Finding overlap_finding(const FlatPattern& pattern, const std::pair<PartId, PartId>& parts,
                        const SharedArea& shared) {
  const Vec2& at = shared.outline.front();
  Facts facts{{"area", shared.area, unit::mm2},
              {"part", place::at(part_place(pattern, parts.first), at)}};
  const bool itself = parts.first == parts.second, often = shared.places > 1;
  if (!itself) facts.emplace_back("part", place::at(part_place(pattern, parts.second), at));
  if (often) facts.emplace_back("count", shared.places);
  if (itself)
    return overlap_told(often ? say::overlaps_itself_often : say::overlaps_itself, facts,
                        shared.outline);
  return overlap_told(often ? say::overlap_often : say::overlap, facts, shared.outline);
}

// ---- contours that cross themselves

/// Whether the ring overlaps itself near p rather than merely touching itself: then a place between
/// the edges that cross there is enclosed twice, or from the wrong side, and is deeper than the
/// clearance. If the edges cross at a small angle, that place is narrow and farther away.
bool runs_over_itself(const RingIndex& ring, double orientation, const Vec2& p, double clearance,
                      double extent) {
  constexpr int kDirections = 96;
  for (double radius = 2.0 * clearance; radius < extent; radius *= 4.0) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5) / kDirections;
      const Vec2 probe = p + radius * Vec2(std::cos(angle), std::sin(angle));
      const int turns = ring.winding(probe);
      const bool proper = turns == 0 || turns == (orientation > 0.0 ? 1 : -1);
      if (!proper && ring.clear(probe, clearance)) return true;
    }
  }
  return false;
}

std::vector<Vec2> true_crossings(const Loop& loop, double clearance, double chord) {
  if (loop.size() == 1 && std::holds_alternative<Arc>(loop.front())) return {};  // a circle
  const std::vector<Vec2> ring = sampled(loop, chord);
  std::vector<Vec2> found = self_crossings(ring);
  if (found.empty()) return found;
  const RingIndex index({ring});
  const double orientation = ring_area(ring);
  const double extent = bounds(loop).size().maxCoeff();
  std::erase_if(found, [&](const Vec2& p) {
    return !runs_over_itself(index, orientation, p, clearance, extent);
  });
  return found;
}

/// An opening is named by its middle. Skips crossings within an overlap that was already found.
void add_crossing(const Loop& loop, const std::optional<Vec2>& opening, double clearance,
                  double chord, std::vector<Finding>& findings) {
  std::vector<Vec2> crossings = true_crossings(loop, clearance, chord);
  std::erase_if(crossings, [&](const Vec2& p) {
    return std::ranges::any_of(findings, [&](const Finding& finding) {
      return widened({p, p}, 2.0 * clearance + chord).overlaps(box_of(finding.at));
    });
  });
  if (crossings.empty()) return;
  Facts facts{{"at", place::point(crossings.front())}};
  const bool often = crossings.size() > 1;
  if (often) facts.emplace_back("more", crossings.size() - 1);
  if (opening) facts.emplace_back("opening", place::point(*opening));
  const say::Sentence once = opening ? say::opening_crosses : say::outer_crosses;
  const say::Sentence several = opening ? say::opening_crosses_often : say::outer_crosses_often;
  findings.push_back(overlap_told(often ? several : once, facts, std::move(crossings)));
}

void add_crossings(const FlatPattern& pattern, double clearance, double chord,
                   std::vector<Finding>& findings) {
  add_crossing(pattern.outer.loop, std::nullopt, clearance, chord, findings);
  for (const Contour& opening : pattern.openings) {
    const Box2 box = bounds(opening.loop);
    add_crossing(opening.loop, 0.5 * (box.lo + box.hi), clearance, chord, findings);
  }
}

}  // namespace

std::vector<Finding> find_overlaps(const Sheet& sheet, const Layout& layout,
                                   const FlatPattern& pattern) {
  require_valid(pattern);
  PLANISH_ASSERT(layout.images.size() == sheet.faces.size());
  const double clearance = contact_clearance(pattern);
  const double chord = 0.25 *
                       clearance;  // polygons of one curve from its two sides still only touch
  const Regions regions = regions_of(sheet, layout, chord);

  const SharedByParts by_parts = shared_by_parts(regions, clearance);
  std::vector<SharedByParts::const_iterator> order;
  for (auto it = by_parts.begin(); it != by_parts.end(); ++it)
    order.push_back(it);
  std::ranges::stable_sort(order, [](auto a, auto b) { return a->second.area > b->second.area; });
  auto findings = mapped(
      order, [&](const auto& it) { return overlap_finding(pattern, it->first, it->second); });

  add_crossings(pattern, clearance, chord, findings);
  return findings;
}

std::vector<Finding> contour_crossings(const FlatPattern& pattern) {
  const double clearance = contact_clearance(pattern);
  std::vector<Finding> findings;
  add_crossings(pattern, clearance, 0.25 * clearance, findings);
  return findings;
}

}  // namespace planish
