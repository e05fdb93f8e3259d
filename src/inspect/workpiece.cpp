// What the rules look at, found once: the two limits of each bend zone with the direction away from
// it, openings with their sizes and the bends that they end or reach into, rings for rays. A limit
// is on the side on which it lies of the bend line, not of the order in which lines are written.

#include "workpiece.hpp"

#include "observation.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/box_tree.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/cutout.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

// A pattern prepared for the rules: contours and openings with boxes, bend zones with their tangent
// lines, indexed by place. A pattern without tangent lines gets them half the allowance beside its
// bend lines. Whether two points are joined by material is asked of polygons fine enough for
// flanges and bends; other openings only block rays, and may be coarse.

namespace planish::inspect_detail {
namespace {

/// Chord errors, as shares of the thickness, of the polygons at which rays are cast. Flanges and
/// bends are measured to the fine ones; other openings only block rays.
constexpr double kMeasuredShare = 1e-3;
constexpr double kCoarseShare = 2e-2;

double chord_of(const FlatPattern& pattern, double share) {
  return std::max(share * pattern.thickness, FlattenOptions{}.curve_tolerance);
}

std::vector<std::vector<Vec2>> contour_rings(const FlatPattern& pattern,
                                             const std::vector<Opening>& openings) {
  const double fine = chord_of(pattern, kMeasuredShare);
  const double coarse = chord_of(pattern, kCoarseShare);
  std::vector<std::vector<Vec2>> rings{sampled(pattern.outer.loop, fine)};
  for (const Opening& opening : openings)
    rings.push_back(sampled(*opening.loop, opening.bounds.empty() ? coarse : fine));
  return rings;
}

/// The farthest ends of collinear segments, along the first.
BendSpan span_of(const std::vector<Segment>& segments) {
  const Vec2 direction = (segments.front().b - segments.front().a).stableNormalized();
  BendSpan span{segments.front().a, segments.front().b};
  for (const Segment& segment : segments) {
    for (const Vec2& p : {segment.a, segment.b}) {
      if ((p - span.start).dot(direction) < 0.0) span.start = p;
      if ((p - span.end).dot(direction) > 0.0) span.end = p;
    }
  }
  return span;
}

/// Vector from the bend line to p.
Vec2 offset_from_line(const FlatBend& bend, const Vec2& p) {
  Gap best;
  for (const Segment& line : bend.lines) {
    const Nearest found = nearest(line, p);
    if (found.distance < best.distance) best = {found.distance, point_at(line, found.t), p};
  }
  return best.b - best.a;
}

/// Tangent lines for a pattern without them: half the allowance on either side.
std::vector<Segment> supposed_tangent_lines(const FlatBend& bend) {
  std::vector<Segment> lines;
  for (const double side : {-0.5, 0.5}) {
    for (const Segment& line : bend.lines) {
      const Vec2 shift = side * bend.allowance.allowance *
                         perpendicular((line.b - line.a).stableNormalized());
      lines.push_back({line.a + shift, line.b + shift});
    }
  }
  return lines;
}

/// The two limits of a bend zone, as far as they exist.
std::vector<BendSide> limits_of(const FlatBend& bend, size_t id) {
  if (bend.lines.empty()) return {};
  std::vector<Segment> lines = bend.tangent_lines;
  if (lines.empty()) lines = supposed_tangent_lines(bend);
  const Vec2 across = perpendicular(
      (bend.lines.front().b - bend.lines.front().a).stableNormalized());
  std::vector<Segment> left, right;
  for (const Segment& line : lines) {
    const double offset = offset_from_line(bend, 0.5 * (line.a + line.b)).dot(across);
    // Both limits of a bend without allowance are one line.
    if (offset > -kDrawn) left.push_back(line);
    if (offset < kDrawn) right.push_back(line);
  }
  std::vector<BendSide> sides;
  const auto add = [&](std::vector<Segment>& segments, const Vec2& away) {
    if (segments.empty()) return;
    const BendSpan span = span_of(segments);
    Vec2 outward = perpendicular((span.end - span.start).stableNormalized());
    if (outward.dot(away) < 0.0) outward = -outward;
    sides.push_back({id, std::move(segments), span.start, span.end, outward});
  };
  add(left, across);
  add(right, -across);
  return sides;
}

/// Sizes in words, computed once for all openings of one shape (equal in number of curves, length
/// and area).
class SizeTeller {
 public:
  Told operator()(const Loop& loop) {
    if (const Arc* arc = loop.size() == 1 ? std::get_if<Arc>(&loop.front()) : nullptr;
        arc && std::abs(arc->sweep) > std::numbers::pi * 1.999)
      return tell(say::diameter, {{"across", 2.0 * arc->radius, unit::mm}});
    const auto rounded = [](double value) { return std::llround(value / kDrawn); };
    Told& words = known_[{loop.size(), rounded(length(loop)), rounded(signed_area(loop))}];
    if (words.sentence.empty()) {
      const Vec2 size = smallest_rectangle(sampled(loop, 0.1 * kDrawn)).size;
      words = tell(say::size, {{"long", size.x(), unit::mm}, {"wide", size.y(), unit::mm}});
    }
    return words;
  }

 private:
  std::map<std::tuple<size_t, long long, long long>, Told> known_;
};

bool at_loop(const Opening& opening, const Vec2& p) {
  if (box_distance({p, p}, opening.boxed.box) > kDrawn) return false;
  return std::ranges::any_of(
      *opening.loop, [&](const Curve2& curve) { return nearest(curve, p).distance <= kDrawn; });
}

/// Bends from whose faces the opening was cut.
std::set<BendId> bends_cut(const Sheet& sheet, const Contour& contour) {
  std::set<BendId> result;
  for (const auto& origins : contour.origins) {
    for (const Origin& origin : origins) {
      if (origin.gap || !sheet.faces.has(origin.border.face)) continue;
      if (const auto* bend = std::get_if<BendId>(&sheet[origin.border.face].part_of))
        result.insert(*bend);
    }
  }
  return result;
}

Opening opening_of(const Contour& contour, SizeTeller& size) {
  Opening opening{
      &contour.loop, BoxedLoop(contour.loop), Vec2::Zero(), size(contour.loop), false, {}, {}};
  opening.center = 0.5 * (opening.boxed.box.lo + opening.boxed.box.hi);
  // Twice the area by half the length is the mean width.
  opening.is_cut = 2.0 * std::abs(signed_area(contour.loop)) <= kDrawnOnce * length(contour.loop);
  return opening;
}

/// Finds which bends end at an opening, and into which it reaches. A bend has an outermost end at a
/// relief or a window; other openings lie between its ends.
void relate(Opening& opening, const Sheet& sheet, const Contour& contour,
            const Workpiece& workpiece) {
  const std::set<BendId> cut = bends_cut(sheet, contour);
  workpiece.zone_index.visit(widened(opening.boxed.box, kDrawn), [&](size_t b) {
    const FlatBend& bend = workpiece.pattern.bends[b];
    if (!workpiece.spans[b] || box_distance(workpiece.zones[b], opening.boxed.box) > kDrawn) return;
    if (at_loop(opening, workpiece.spans[b]->start) || at_loop(opening, workpiece.spans[b]->end)) {
      opening.bounds.insert(b);
      return;
    }
    const auto ends_there = [&](const Segment& s) {
      return at_loop(opening, s.a) || at_loop(opening, s.b);
    };
    if (cut.contains(bend.bend) || std::ranges::any_of(bend.lines, ends_there) ||
        std::ranges::any_of(bend.tangent_lines, ends_there))
      opening.reaches_in.insert(b);
  });
}

std::vector<std::vector<Vec2>> slit_rings(const FlatPattern& pattern) {
  return mapped(pattern.slits, [&](const Curve2& slit) { return sampled(slit, 0.1 * kDrawn); });
}

}  // namespace

Place Workpiece::place_of(size_t bend) const {
  const Place place = place::bend(pattern.bends[bend].id);
  if (!spans[bend]) return place;
  return place::at(place, Vec2(0.5 * (spans[bend]->start + spans[bend]->end)));
}

Workpiece::Workpiece(const Sheet& made, const FlatPattern& flat)
    : sheet(made),
      pattern(flat),
      thickness(flat.thickness),
      contours({}),
      slits(slit_rings(flat)),
      tangent_index({}),
      zone_index({}) {
  for (size_t b = 0; b < flat.bends.size(); ++b) {
    const FlatBend& bend = flat.bends[b];
    Box2& zone = zones.emplace_back();
    for (const auto* lines : {&bend.lines, &bend.tangent_lines})
      for (const Segment& line : *lines)
        zone.add(bounds(line));
    spans.push_back(bend.lines.empty() ? std::nullopt : std::optional(span_of(bend.lines)));
    for (BendSide& side : limits_of(bend, b))
      sides.push_back(std::move(side));
  }
  std::vector<Box2> boxes;
  for (const BendSide& side : sides) {
    for (const Segment& line : side.segments) {
      tangent_lines.push_back({line, side.bend});
      boxes.push_back(bounds(line));
    }
  }
  tangent_index = BoxTree2(std::move(boxes));
  zone_index = BoxTree2(zones);
  SizeTeller size;
  for (const Contour& contour : flat.openings) {
    openings.push_back(opening_of(contour, size));
    relate(openings.back(), sheet, contour, *this);
  }
  contours = RingIndex(contour_rings(flat, openings));
}

std::span<const BendSide> Workpiece::sides_of(size_t bend) const {
  const auto [first, last] = std::ranges::equal_range(sides, bend, {}, &BendSide::bend);
  return {first, last};
}

bool Workpiece::joined_by_material(const Vec2& a, const Vec2& b) const {
  const double distance = (b - a).norm();
  const double skipped = 2.0 * (kDrawn + chord_of(pattern, kCoarseShare));  // the contours at the
                                                                            // ends themselves
  if (distance <= 2.0 * skipped) return true;
  const Vec2 direction = (b - a) / distance;
  const double reach = distance - 2.0 * skipped;
  const auto any = [](size_t) { return true; };
  return material(0.5 * (a + b)) &&
         !std::isfinite(contours.first_hit(a + skipped * direction, direction, reach, any));
}

bool is_rolled(const FlatBend& bend, double thickness) {
  constexpr double kRolled = 10.0;  // inside radius in thicknesses
  return bend.inside_radius > kRolled * thickness;
}

bool is_hem(const FlatBend& bend) {
  constexpr double kHem = 170.0;  // degrees
  return bend.angle.degrees() >= kHem * (1.0 - tolerance::kWrittenDigits);
}

}  // namespace planish::inspect_detail
