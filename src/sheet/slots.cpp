// Cuts the slits of a pattern with the width of the cut and stop holes: slits, which lie in
// contours as stretches run there and back, are taken out (spurs.cpp), their slots checked against
// each other and the contours, and put back as openings or as part of the contour in which they
// end.

#include "contour.hpp"
#include "measure.hpp"
#include "refusals.hpp"
#include "slit_axis.hpp"
#include "slot_shape.hpp"
#include "spurs.hpp"
#include "trim_bend.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/sheet/slots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Slits cut as lines or slots. Stretches of contours whose two banks coincide are taken out as
// slits (spurs.cpp) and cut with the kerf; slots are opened from the last corner backwards, so that
// the remaining corners keep their indices. Before that the room between slots, holes and contours
// is checked, as a slot that runs into another has no shape.

namespace planish {
namespace {

using namespace sheet_detail;

Result<void> check_options(const SlotOptions& options) {
  const auto is_width = [](double value) { return std::isfinite(value) && value >= 0.0; };
  const Fact kerf("kerf", options.kerf, unit::mm), hole("stop_hole", options.stop_hole, unit::mm);
  if (!is_width(options.kerf))
    return fail(refuse::kerf_negative, {{"field", place::pointer("/kerf")}, kerf});
  if (!is_width(options.stop_hole))
    return fail(refuse::stop_hole_negative, {{"field", place::pointer("/stop_hole")}, hole});
  if (!(std::isfinite(options.tolerance) && options.tolerance > 0.0))
    return fail(refuse::slit_tolerance, {{"tolerance", options.tolerance, unit::mm}});
  if (options.stop_hole > 0.0 && options.stop_hole < options.kerf)
    return fail(refuse::stop_hole_below_kerf,
                {{"field", place::pointer("/stop_hole")}, hole, kerf});
  return {};
}

/// All contours, the outer one first.
template <typename Pattern>
auto contours_of(Pattern& pattern) {
  std::vector<decltype(&pattern.outer)> contours{&pattern.outer};
  for (auto& opening : pattern.openings)
    contours.push_back(&opening);
  return contours;
}

/// Takes the slits out of the contours; contours that are only slits vanish.
std::vector<Segment> taken_slits(FlatPattern& pattern, double tolerance) {
  std::vector<Segment> slits;
  const auto take = [&](Contour& contour) {
    WithoutSpurs left = without_spurs(contour, tolerance);
    slits.insert(slits.end(), left.slits.begin(), left.slits.end());
    contour = std::move(left.contour);
  };
  take(pattern.outer);
  for (Contour& opening : pattern.openings)
    take(opening);
  std::erase_if(pattern.openings, [](const Contour& contour) { return contour.loop.empty(); });
  return slits;
}

/// The straight ones of the slits that the pattern had before; taken out of it.
std::vector<Segment> straight_slits(FlatPattern& pattern) {
  std::vector<Segment> straight;
  for (const Curve2& slit : pattern.slits)
    if (const auto* segment = std::get_if<Segment>(&slit)) straight.push_back(*segment);
  std::erase_if(pattern.slits,
                [](const Curve2& slit) { return std::holds_alternative<Segment>(slit); });
  return straight;
}

std::vector<Corner> corners_at(const FlatPattern& pattern, const Vec2& p, double tolerance) {
  std::vector<Corner> corners;
  const auto contours = contours_of(pattern);
  for (std::size_t c = 0; c < contours.size(); ++c)
    for (std::size_t i = 0; i < contours[c]->loop.size(); ++i)
      if ((start_of(contours[c]->loop[i]) - p).norm() <= tolerance)
        corners.push_back({static_cast<int>(c), static_cast<int>(i)});
  return corners;
}

/// Slits run from a corner of a contour, or from inside the material.
Result<std::vector<Slot>> slots_of(const FlatPattern& pattern, const std::vector<Segment>& slits,
                                   const SlotOptions& options) {
  std::vector<Slot> slots;
  for (std::vector<Vec2> chain : chains_of(slits, options.tolerance)) {
    const auto a = corners_at(pattern, chain.front(), options.tolerance),
               b = corners_at(pattern, chain.back(), options.tolerance);
    if (a.size() + b.size() > 1)
      return fail(refuse::slit_opens_twice,
                  {{"from", place::point(chain.front())}, {"to", place::point(chain.back())}});
    if (!b.empty()) std::ranges::reverse(chain);
    Slot slot{{chain.front(), chain.back()}, 0.5 * options.kerf, 0.5 * options.stop_hole, {}, {}};
    if (chain.size() > 2) slot.curves = curves_through(chain, options.curve_tolerance);
    if (!a.empty()) slot.opens_at = a.front();
    if (!b.empty()) slot.opens_at = b.front();
    slots.push_back(std::move(slot));
  }
  return slots;
}

tl::unexpected<Error> too_wide(const Slot& slot, double room) {
  return fail(refuse::slit_too_wide,
              {{"field", place::pointer(slot.hole > slot.half_width ? "/stop_hole" : "/kerf")},
               {"from", place::point(slot.axis.a)},
               {"to", place::point(slot.axis.b)},
               {"room", room, unit::mm}});
}

/// Of two sets of chords, as far as it is below `enough`; else that.
double room_between(const std::vector<Segment>& a, const std::vector<Segment>& b, double enough) {
  double room = enough;
  const auto box_of = [](const Segment& line) {
    return Box2{line.a.cwiseMin(line.b), line.a.cwiseMax(line.b)};
  };
  for (const Segment& one : a) {
    Box2 near = box_of(one);
    near.lo.array() -= enough;
    near.hi.array() += enough;
    for (const Segment& other : b) {
      const Box2 box = box_of(other);
      if ((box.lo.array() > near.hi.array()).any() || (box.hi.array() < near.lo.array()).any())
        continue;
      room = std::min(room, distance(one, other));
    }
  }
  return room;
}

double room_between(const Vec2& hole, const std::vector<Segment>& chords) {
  double room = std::numeric_limits<double>::infinity();
  for (const Segment& chord : chords)
    room = std::min(room, distance(hole, chord));
  return room;
}

Result<void> check_room_between(const std::vector<Slot>& slots) {
  const auto chords = mapped(slots, [](const Slot& slot) { return slot.chords(); });
  for (std::size_t i = 0; i < slots.size(); ++i)
    for (std::size_t j = i + 1; j < slots.size(); ++j) {
      const Slot &a = slots[i], &b = slots[j];
      const double wide = a.half_width + b.half_width, enough = 2.0 * wide + tolerance::kTiniest;
      const double room = room_between(chords[i], chords[j], enough);
      if (!(room > wide)) return too_wide(a, room);
      for (const Vec2& hole : a.holes()) {
        if (a.hole == 0.0 && b.half_width == 0.0) continue;
        if (const double by = room_between(hole, chords[j]); !(by > a.hole + b.half_width))
          return too_wide(a, by);
        for (const Vec2& other : b.holes())
          if (!((hole - other).norm() > a.hole + b.hole)) return too_wide(a, (hole - other).norm());
      }
      for (const Vec2& hole : b.holes()) {
        if (b.hole == 0.0 && a.half_width == 0.0) continue;
        if (const double by = room_between(hole, chords[i]); !(by > b.hole + a.half_width))
          return too_wide(b, by);
      }
    }
  return {};
}

/// A bank needs arcs wider than half the kerf.
Result<void> check_curves(const std::vector<Slot>& slots) {
  for (const Slot& slot : slots)
    for (const Curve2& curve : slot.curves)
      if (const auto* arc = std::get_if<Arc>(&curve); arc && !(arc->radius > slot.half_width))
        return too_wide(slot, arc->radius);
  return {};
}

/// Where the slot opens, its neighbours on the contour are cut to fit and need no check.
Result<void> check_room_to_contours(const FlatPattern& pattern, const Slot& slot) {
  const auto contours = contours_of(pattern);
  const std::vector<Segment> chords = slot.chords();
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const Loop& loop = contours[c]->loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const bool opens_here = slot.opens_at && slot.opens_at->contour == static_cast<int>(c) &&
                              (slot.opens_at->at == static_cast<int>(i) ||
                               slot.opens_at->at == static_cast<int>((i + 1) % loop.size()));
      const std::vector<Vec2> points = chain_of(loop[i]);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Segment piece{points[k], points[k + 1]};
        const double enough = 2.0 * slot.half_width + tolerance::kTiniest;
        if (const double room = room_between(chords, {piece}, enough);
            !opens_here && !(room > slot.half_width))
          return too_wide(slot, room);
        for (const Vec2& hole : slot.holes())
          if (const double room = distance(hole, piece); !(room > slot.hole))
            return too_wide(slot, room);
      }
    }
  }
  return {};
}

/// From the back, so that the remaining corners keep their indices.
Result<void> open_slots(FlatPattern& pattern, std::vector<Slot> slots, double tolerance) {
  std::erase_if(slots, [](const Slot& slot) { return !slot.opens_at; });
  std::ranges::sort(slots, std::ranges::greater(), [](const Slot& s) { return s.opens_at->at; });
  const auto contours = contours_of(pattern);
  for (const Slot& slot : slots) {
    Contour& contour = *contours[slot.opens_at->contour];
    auto opened = with_open_slot(contour, slot, tolerance);
    if (!opened) return pass_on(opened);
    contour = std::move(*opened);
  }
  return {};
}

void add_closed_slots(FlatPattern& pattern, const std::vector<Slot>& slots) {
  for (const Slot& slot : slots)
    if (!slot.opens_at) {
      Loop loop = closed_slot(slot);
      const std::size_t count = loop.size();
      pattern.openings.push_back({std::move(loop), std::vector<std::vector<Origin>>(count)});
    }
}

/// Lines and arcs from hole to hole, and the holes.
Result<void> cut_as_lines(FlatPattern& pattern, const std::vector<Slot>& slots) {
  for (const Slot& slot : slots) {
    Loop curves = slot.whole_axis();
    if (slot.hole > 0.0) curves = without_end(std::move(curves), slot.axis.b, slot.hole);
    if (slot.hole > 0.0 && !slot.opens_at)
      curves = without_start(std::move(curves), slot.axis.a, slot.hole);
    const bool overlap = !slot.opens_at && !((slot.axis.b - slot.axis.a).norm() > 2.0 * slot.hole);
    if (curves.empty() || overlap) return too_wide(slot, length(curves));
    pattern.slits.insert(pattern.slits.end(), curves.begin(), curves.end());
    if (slot.hole > 0.0)
      for (const Vec2& hole : slot.holes())
        pattern.openings.push_back({{Arc{hole, slot.hole, 0.0, -2.0 * std::numbers::pi}}, {{}}});
  }
  return {};
}

}  // namespace

Result<FlatPattern> cut_slits(FlatPattern pattern, const SlotOptions& options) {
  if (auto sound = check_options(options); !sound) return pass_on(sound);
  for (Contour* contour : contours_of(pattern))
    contour->origins.resize(contour->loop.size());
  std::vector<Segment> slits = straight_slits(pattern);
  for (const Segment& slit : taken_slits(pattern, options.tolerance))
    slits.push_back(slit);
  if (slits.empty()) return pattern;
  auto slots = slots_of(pattern, slits, options);
  if (!slots) return pass_on(slots);
  if (auto room = check_room_between(*slots); !room) return pass_on(room);
  for (const Slot& slot : *slots)
    if (auto room = check_room_to_contours(pattern, slot); !room) return pass_on(room);
  if (options.kerf > 0.0) {
    if (auto wide = check_curves(*slots); !wide) return pass_on(wide);
    if (auto opened = open_slots(pattern, *slots, options.tolerance); !opened)
      return pass_on(opened);
    add_closed_slots(pattern, *slots);
  } else if (auto cut = cut_as_lines(pattern, *slots); !cut) {
    return pass_on(cut);
  }
  for (FlatBend& bend : pattern.bends)
    trim_bend(bend, [&](const Segment& line) { return outside(line, *slots); });
  // When a slit is a line, there is no corner where it leaves its contour.
  for (Contour* contour : contours_of(pattern))
    *contour = joined_contour(*contour, options.tolerance);
  measure(pattern);
  return pattern;
}

}  // namespace planish
