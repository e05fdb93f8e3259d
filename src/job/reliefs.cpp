#include "reliefs.hpp"

#include "refusals.hpp"
#include "sentences.hpp"

#include <planish/inspect/missing_relief.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/cutout.hpp>
#include <planish/sheet/one_piece.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// Reliefs in a pattern (math.md#reliefs, shop-floor.md#bend-relief): at corners that overlap,
// beside bends, and slits that get a width. After each cut the area that went is that of the faces
// within it, and the sheet is one piece; else it is not made. One cut changes what its neighbours
// lack, so these are found again each round. If a relief turns out useless, all are made anew
// without it.

namespace planish::job {
namespace {

/// The narrowest gap that is left where corners are mended, mm: the kerf of a laser.
constexpr double kNarrowestGap = 0.2;

double largest_radius(const FlatPattern& pattern) {
  double radius = 0.0;
  for (const FlatBend& bend : pattern.bends)
    radius = std::max(radius, bend.inside_radius);
  return radius;
}

/// The parts that cover each other, each where they do.
Facts parts_of(const DoubleCover& cover) {
  return mapped(cover.parts,
                [&](const Place& part) { return Fact("part", place::at(part, cover.middle)); });
}

/// Whether a place is small enough that a shop would mend it without asking: no deeper than the
/// kerf, or a corner, and not a flange that lies on another.
Result<void> check_size(const DoubleCover& cover, const FlatPattern& pattern) {
  constexpr double kLargest = 4.0;  // area, over the square of the thickness
  const double t = pattern.thickness;
  const double area = kLargest * t * t;
  const double depth = t + largest_radius(pattern);
  if (cover.size.y() <= kNarrowestGap || (cover.area <= area && cover.size.y() <= depth)) return {};
  Facts facts = parts_of(cover);
  facts.insert(facts.end(), {{"area", cover.area, unit::mm2},
                             {"depth", cover.size.y(), unit::mm},
                             {"most_area", area, unit::mm2},
                             {"most_depth", depth, unit::mm}});
  return fail(refuse::overlap_too_large, facts);
}

/// Half of the shorter side: the gap, or a relief as wide as the sheet is thick.
Cutout cutout_at(const DoubleCover& cover, const FlatPattern& pattern,
                 const ReliefOptions& options) {
  const double gap = std::max(options.width, kNarrowestGap);
  Cutout cutout;
  cutout.middle = cover.middle;
  cutout.along = cover.along;
  cutout.half = (cover.size + Vec2::Constant(gap)) / 2;
  if (options.shape == Relief::rip) return cutout;
  cutout.half.y() = std::max(cutout.half.y(), pattern.thickness / 2);
  cutout.half.x() = std::max(cutout.half.x(), cutout.half.y());
  if (options.shape == Relief::round) {
    // The whole place lies between the rounded ends.
    cutout.half.x() = std::max(cutout.half.x(), cover.size.x() / 2 + cutout.half.y());
    cutout.corner_radius = cutout.half.y();
  }
  return cutout;
}

Cutout cutout_along(const Segment& slit, const ReliefOptions& options) {
  const Vec2 way = slit.b - slit.a;
  Cutout cutout;
  cutout.middle = (slit.a + slit.b) / 2;
  cutout.along = way.normalized();
  cutout.half = {(way.norm() + options.width) / 2, options.width / 2};
  if (options.shape == Relief::round) cutout.corner_radius = options.width / 2;
  return cutout;
}

/// How near slits end to what they lead to: cutouts join what they meet across `kDrawnOnce`.
constexpr double kMeets = 10.0 * kDrawnOnce;

/// Whether the cutout has parted what was one piece, across slits that have no width.
bool parts(const FlatPattern& before, const FlatPattern& after, const Cutout& cutout) {
  const auto ends_here = [&](const Vec2& p) { return std::abs(cutout.distance(p)) <= kMeets; };
  const int ends = sum_of(after.slits, [&](const Curve2& slit) {
    return ends_here(start_of(slit)) + ends_here(end_of(slit));
  });
  const bool apart = after.openings.size() == before.openings.size() + 1;  // from all contours
  if (ends == 0 || (ends == 1 && apart)) return false;
  return !is_one_piece(after, kMeets) && is_one_piece(before, kMeets);
}

/// A bend that loses its whole line: it could not be bent any more, nor would a report have it.
const FlatBend* lost_bend(const FlatPattern& before, const FlatPattern& after) {
  for (std::size_t i = 0; i < before.bends.size(); ++i)
    if (!before.bends[i].lines.empty() && after.bends[i].lines.empty()) return &before.bends[i];
  return nullptr;
}

/// Cuts one out, and checks the area against that of the faces within it.
Result<void> cut(Relieved& relieved, const SheetArea& area, const Cutout& cutout) {
  auto left = without_cutout(relieved.pattern, cutout);
  if (!left) return pass_on(left);
  const double removed = relieved.pattern.area - left->area;
  const Loop outline = cutout.outline();
  // Polygons leave out or add a chord's height along each curve.
  const double slack = kContactShare * relieved.pattern.thickness * length(outline);
  const double within = area.within(outline, relieved.cutouts);
  if (!(std::abs(removed - within) <= slack))
    return fail(refuse::relief_took_other, {{"removed", removed, unit::mm2},
                                            {"within", within, unit::mm2},
                                            {"at", place::point(cutout.middle)}});
  if (parts(relieved.pattern, *left, cutout))
    return fail(refuse::relief_parts_sheet, {{"at", place::point(cutout.middle)}});
  if (const FlatBend* lost = lost_bend(relieved.pattern, *left))
    return fail(refuse::relief_takes_bend,
                {{"at", place::point(cutout.middle)},
                 {"bend", place::bend(lost->id)},
                 {"width", 2 * cutout.half.y(), unit::mm}},
                "rip_width");
  relieved.pattern = std::move(*left);
  relieved.removed += removed;
  relieved.cutouts.push_back(outline);
  return {};
}

const char* name_of(Relief shape) {
  return shape == Relief::round ? "round relief" : shape == Relief::square ? "relief" : "rip";
}

Finding mended(const DoubleCover& cover, const Cutout& cutout, const FlatPattern& pattern,
               Relief shape) {
  const double t = pattern.thickness;
  Facts facts = parts_of(cover);
  facts.insert(facts.end(), {{"area", cover.area, unit::mm2},
                             {"shape", name_of(shape)},
                             {"length", 2 * cutout.half.x(), unit::mm},
                             {"width", 2 * cutout.half.y(), unit::mm},
                             {"least_width", t, unit::mm},
                             {"least_depth", t + largest_radius(pattern), unit::mm}});
  Finding finding = finding_of("mended_corner", Severity::warning, say::mended_corner, facts,
                               {cover.middle});
  finding.remedies = {{"relief", "rip", "Cut a rip"},
                      {"relief", "square", "Cut a square relief"},
                      {"relief", "round", "Cut a round relief"},
                      {"relief", "none", "Leave it as drawn"}};
  return finding;
}

std::vector<Segment> straight_slits(FlatPattern& pattern) {
  std::vector<Segment> slits;
  for (const Curve2& slit : pattern.slits)
    if (const auto* segment = std::get_if<Segment>(&slit)) slits.push_back(*segment);
  return slits;
}

/// How far a relief reaches into the bend, and beyond its width: its sides may lie on edges. Less
/// than what contours are joined across, mm.
constexpr double kOverEdge = kDrawnOnce / 2;
/// How far it goes beyond what is needed, as a share of the thickness, so that the bend is clear.
constexpr double kPastNeed = 0.1;

/// At least as long as it is wide: beside narrow bends that is what can be cut. Round ones end in
/// half circles, but for the corner at which the side of a tab, or the slit along it, enters.
Cutout cutout_beside(const MissingRelief& place, double web, double thickness, Relief shape) {
  const double half = place.width / 2 + kOverEdge;
  const double radius = shape == Relief::round ? half : 0.0;
  const double behind = place.zone + web + (place.on_both_sides ? place.depth : 0.0);
  const double past = std::max(kPastNeed * thickness, (place.width - place.depth - behind) / 2) +
                      kOverEdge;
  const double top = place.depth + past + radius, bottom = -behind - past - radius;
  Cutout cutout;
  cutout.middle = place.corner + place.width / 2 * place.beyond +
                  (top + bottom) / 2 * place.into_flange;
  cutout.along = place.beyond;
  cutout.half = {half, (top - bottom) / 2};
  cutout.corner_radius = radius;
  const Vec2 across = perpendicular(place.beyond);
  if (!place.on_both_sides) cutout.sharp_corner = across.dot(place.into_flange) > 0.0 ? 2 : 1;
  return cutout;
}

/// Out at the edge behind it, if that is near, else with a web left before it.
std::optional<Cutout> cut_at(Relieved& relieved, const SheetArea& area, const MissingRelief& place,
                             Relief shape) {
  for (const double web : {place.web, 0.0}) {
    const Cutout cutout = cutout_beside(place, web, relieved.pattern.thickness, shape);
    if (cut(relieved, area, cutout)) return cutout;
    if (place.web == 0.0) break;
  }
  return std::nullopt;
}

struct PlacedRelief {
  MissingRelief place;
  Cutout cutout;
};

/// Whether one of them is at the same end of the same bend.
bool is_among(const std::vector<MissingRelief>& places, const MissingRelief& place) {
  return std::ranges::any_of(places, [&](const MissingRelief& other) {
    return other.bend == place.bend && other.beyond.dot(place.beyond) > 0.0;
  });
}

/// Cuts them except at `left` where they can be. One cut may change what is missing beside it, as
/// where bends meet in a corner: what is near to a cut waits for the next round.
std::vector<PlacedRelief> cut_missing(Relieved& relieved, const Sheet& sheet, const SheetArea& area,
                                      Relief shape, const Rules& rules,
                                      const std::vector<MissingRelief>& left) {
  std::vector<MissingRelief> tried = left;
  std::vector<PlacedRelief> done;
  for (bool going_on = true; going_on;) {
    going_on = false;
    std::vector<Box2> cut_now;
    for (const MissingRelief& place : missing_reliefs(sheet, relieved.pattern, rules)) {
      if (is_among(tried, place)) continue;
      going_on = true;
      const Cutout wanted = cutout_beside(place, place.web, relieved.pattern.thickness, shape);
      const Box2 box = bounds(wanted.outline());
      if (std::ranges::any_of(cut_now, [&](const Box2& other) { return other.overlaps(box); }))
        continue;
      tried.push_back(place);
      if (const auto cutout = cut_at(relieved, area, place, shape)) {
        done.push_back({place, *cutout});
        cut_now.push_back(box);
      }
    }
  }
  return done;
}

Finding cut_beside(const std::vector<PlacedRelief>& reliefs, Relief shape) {
  auto at = mapped(reliefs, [&](const PlacedRelief& relief) { return relief.place.corner; });
  const Vec2 size = 2 * reliefs.front().cutout.half;
  const int count = static_cast<int>(reliefs.size());
  Facts facts{{"shape", name_of(shape)},
              {"count", counted(count, name_of(shape))},
              {"length", size.x(), unit::mm},
              {"width", size.y(), unit::mm},
              {"bend", place::at(place::bend(reliefs.front().place.bend), at.front())}};
  for (std::size_t i = 1; i < reliefs.size(); ++i)
    facts.emplace_back("other", place::at(place::bend(reliefs[i].place.bend), at[i]));
  Finding finding = finding_of("bend_relief_cut", Severity::info,
                               count == 1 ? say::relief_cut_beside : say::reliefs_cut_beside, facts,
                               std::move(at));
  finding.remedies = {{"bend_relief", "none", "Leave it as drawn"}};
  return finding;
}

/// A place at which none can be cut, or where it would be of no use, keeps its finding.
void cut_beside_bends(Relieved& relieved, const Sheet& sheet, const SheetArea& area, Relief shape,
                      const Rules& rules) {
  Relieved with = relieved;
  std::vector<PlacedRelief> reliefs = cut_missing(with, sheet, area, shape, rules, {});
  std::vector<MissingRelief> useless = missing_reliefs(sheet, with.pattern, rules);
  std::erase_if(useless, [&](const MissingRelief& place) {
    return std::ranges::none_of(
        reliefs, [&](const PlacedRelief& relief) { return is_among({relief.place}, place); });
  });
  if (!useless.empty()) {
    with = relieved;
    reliefs = cut_missing(with, sheet, area, shape, rules, useless);
  }
  if (reliefs.empty()) return;
  relieved = std::move(with);
  relieved.findings.push_back(cut_beside(reliefs, shape));
}

/// A slit that cannot be given a width stays a line. Rips that take a whole bend are refused.
Result<void> rip_slits(Relieved& relieved, const SheetArea& area, const ReliefOptions& options) {
  std::vector<Vec2> places;
  const std::vector<Segment> slits = straight_slits(relieved.pattern);
  for (const Segment& slit : slits) {
    const auto done = cut(relieved, area, cutout_along(slit, options));
    if (!done && done.error().code == code::bad_option) return done;
    if (done) places.push_back((slit.a + slit.b) / 2);
  }
  if (slits.empty()) return {};
  const int ripped = static_cast<int>(places.size()),
            left = static_cast<int>(slits.size()) - ripped;
  if (places.empty()) places.push_back((slits.front().a + slits.front().b) / 2);
  relieved.findings.push_back(finding_of(
      "ripped_slit", Severity::info,
      ripped == 0 ? say::no_rips_cut
      : left > 0  ? say::rips_left_out
                  : say::rips_cut,
      {{"ripped", ripped}, {"left", left}, {"width", options.width, unit::mm}}, std::move(places)));
  return {};
}

}  // namespace

Result<Relieved> with_reliefs(const Sheet& sheet, const Layout& layout, const FlatPattern& pattern,
                              const std::vector<DoubleCover>& covers, const ReliefOptions& options,
                              const Rules& rules) {
  Relieved relieved{pattern, 0.0, static_cast<int>(covers.size()), {}, {}};
  if (covers.empty() && options.beside_bends == Relief::none && options.width <= 0.0) {
    relieved.pattern = with_slits_drawn_once(std::move(relieved.pattern));
    return relieved;  // most parts: nothing is cut, so no areas are compared
  }
  const SheetArea area(sheet, layout, pattern);
  for (const DoubleCover& cover : covers) {
    if (auto small = check_size(cover, pattern); !small) return pass_on(small);
    const Cutout cutout = cutout_at(cover, pattern, options);
    if (auto done = cut(relieved, area, cutout); !done) return pass_on(done);
    relieved.findings.push_back(mended(cover, cutout, pattern, options.shape));
  }
  relieved.pattern = with_slits_drawn_once(std::move(relieved.pattern));
  if (options.beside_bends != Relief::none)
    cut_beside_bends(relieved, sheet, area, options.beside_bends, rules);
  if (options.width > 0.0)
    if (auto done = rip_slits(relieved, area, options); !done) return pass_on(done);
  return relieved;
}

}  // namespace planish::job
