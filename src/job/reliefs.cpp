#include "reliefs.hpp"

#include "units.hpp"

#include <planish/inspect/missing_relief.hpp>
#include <planish/sheet/cutout.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// Whether a place is small enough that a shop would mend it without asking: a corner, and not a
/// flange that lies on another.
Result<void> check_size(const DoubleCover& cover, const FlatPattern& pattern) {
  constexpr double kLargest = 4.0;  // area, over the square of the thickness
  const double t = pattern.thickness;
  const double area = kLargest * t * t;
  const double depth = t + largest_radius(pattern);
  if (cover.area <= area && cover.size.y() <= depth) return {};
  return fail(ErrorCode::overlap,
              fmt::format("{} overlap by {:.4g} mm², {:.4g} mm deep; corners are mended up to "
                          "{:.4g} mm² and {:.4g} mm",
                          cover.who, cover.area, cover.size.y(), area, depth));
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

/// Cuts one out, and checks the area against that of the faces within it.
Result<void> cut(Relieved& relieved, const SheetArea& area, const Cutout& cutout) {
  auto left = without_cutout(relieved.pattern, cutout);
  if (!left) return tl::unexpected(left.error());
  const double removed = relieved.pattern.area - left->area;
  const Loop outline = cutout.outline();
  // Polygons leave out or add a chord's height along each curve.
  const double slack = kContactShare * relieved.pattern.thickness * length(outline);
  const double within = area.within(outline, relieved.cutouts);
  if (!(std::abs(removed - within) <= slack))
    return fail(
        ErrorCode::pattern_wrong,
        fmt::format("a relief took {:.4g} mm² where the sheet has {:.4g} mm²", removed, within));
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
  return {
      "mended_corner",
      Severity::warning,
      fmt::format("{} overlap by {:.4g} mm² in the flat pattern; a {} of {:.3g} mm by {:.3g} mm "
                  "is cut there: draw a relief at least {:.3g} mm wide and {:.3g} mm deep",
                  cover.who, cover.area, name_of(shape), 2 * cutout.half.x(), 2 * cutout.half.y(),
                  t, t + largest_radius(pattern)),
      {cover.middle}};
}

std::vector<Segment> straight_slits(FlatPattern& pattern) {
  std::vector<Segment> slits;
  for (const Curve2& slit : pattern.slits)
    if (const auto* segment = std::get_if<Segment>(&slit)) slits.push_back(*segment);
  return slits;
}

/// How far the relief begins within the bend, mm: its end may lie on the sheet beside it. Less than
/// what contours are joined across.
constexpr double kIntoBend = 5e-6;
/// How far it goes beyond what is needed, as a share of the thickness, so that the bend is clear.
constexpr double kPastNeed = 0.1;

/// At least as long as it is wide: beside narrow bends that is what can be cut.

Cutout cutout_beside(const MissingRelief& place, double thickness, Relief shape) {
  const double half = (place.width + kIntoBend) / 2;
  const double radius = shape == Relief::round ? half : 0.0;
  const double behind = place.back + (place.on_both_sides ? place.depth : 0.0);
  const double past = std::max(kPastNeed * thickness, (place.width - place.depth - behind) / 2);
  const double top = place.depth + past + radius, bottom = -behind - past - radius;
  Cutout cutout;
  cutout.middle = place.corner + (place.width - kIntoBend) / 2 * place.beyond +
                  (top + bottom) / 2 * place.into_flange;
  cutout.along = place.beyond;
  cutout.half = {half, (top - bottom) / 2};
  cutout.corner_radius = radius;
  return cutout;
}

/// Whether one of them is at the same end of the same bend.
bool is_among(const std::vector<MissingRelief>& places, const MissingRelief& place) {
  return std::any_of(places.begin(), places.end(), [&](const MissingRelief& other) {
    return other.bend == place.bend && other.beyond.dot(place.beyond) > 0.0;
  });
}

/// Cuts them except at `left` where they can be. Bends that meet in a corner share one, so others
/// may be found missing after a first round. Returns the places.
std::vector<MissingRelief> cut_missing(Relieved& relieved, const Sheet& sheet,
                                       const SheetArea& area, Relief shape, const Rules& rules,
                                       const std::vector<MissingRelief>& left) {
  const double thickness = relieved.pattern.thickness;
  std::vector<MissingRelief> tried = left, done;
  for (bool going_on = true; going_on;) {
    going_on = false;
    for (const MissingRelief& place : missing_reliefs(sheet, relieved.pattern, rules)) {
      if (is_among(tried, place)) continue;
      tried.push_back(place);
      going_on = true;
      if (cut(relieved, area, cutout_beside(place, thickness, shape))) done.push_back(place);
    }
  }
  return done;
}

Finding cut_beside(const std::vector<MissingRelief>& places, double thickness, Relief shape) {
  std::vector<Vec2> at;
  for (const MissingRelief& place : places)
    at.push_back(place.corner);
  const Vec2 size = 2 * cutout_beside(places.front(), thickness, shape).half;
  const std::string first = fmt::format("beside bend {}", places.front().bend);
  const std::string measures = fmt::format("{:.3g} mm by {:.3g} mm", size.x(), size.y());
  const int count = static_cast<int>(places.size());
  return {"bend_relief_cut", Severity::info,
          count == 1 ? fmt::format("a {} of {} is cut {}", name_of(shape), measures, first)
                     : fmt::format("{} are cut beside bends; the first, {}, is {}",
                                   counted(count, name_of(shape)), first, measures),
          at};
}

/// A place at which none can be cut, or where it would be of no use, keeps its finding.
void cut_beside_bends(Relieved& relieved, const Sheet& sheet, const SheetArea& area, Relief shape,
                      const Rules& rules) {
  const double thickness = relieved.pattern.thickness;
  Relieved with = relieved;
  std::vector<MissingRelief> places = cut_missing(with, sheet, area, shape, rules, {});
  std::vector<MissingRelief> useless = missing_reliefs(sheet, with.pattern, rules);
  std::erase_if(useless, [&](const MissingRelief& place) { return !is_among(places, place); });
  if (!useless.empty()) {
    with = relieved;
    places = cut_missing(with, sheet, area, shape, rules, useless);
  }
  if (places.empty()) return;
  relieved = std::move(with);
  relieved.findings.push_back(cut_beside(places, thickness, shape));
}

/// A slit that cannot be given a width stays a line.
void rip_slits(Relieved& relieved, const SheetArea& area, const ReliefOptions& options) {
  std::vector<Vec2> places;
  for (const Segment& slit : straight_slits(relieved.pattern)) {
    if (!cut(relieved, area, cutout_along(slit, options))) continue;
    places.push_back((slit.a + slit.b) / 2);
  }
  if (places.empty()) return;
  const int count = static_cast<int>(places.size());
  relieved.findings.push_back(
      {"ripped_slit", Severity::info,
       fmt::format("{} cut as a rip {:.3g} mm wide",
                   counted(count, "slit") + (count == 1 ? " is" : " are"), options.width),
       places});
}

}  // namespace

Result<Relieved> with_reliefs(const Sheet& sheet, const Layout& layout, const FlatPattern& pattern,
                              const std::vector<DoubleCover>& covers, const ReliefOptions& options,
                              const Rules& rules) {
  Relieved relieved{pattern, 0.0, static_cast<int>(covers.size()), {}, {}};
  const SheetArea area(sheet, layout, pattern);
  for (const DoubleCover& cover : covers) {
    if (auto small = check_size(cover, pattern); !small) return tl::unexpected(small.error());
    const Cutout cutout = cutout_at(cover, pattern, options);
    if (auto done = cut(relieved, area, cutout); !done) return tl::unexpected(done.error());
    relieved.findings.push_back(mended(cover, cutout, pattern, options.shape));
  }
  relieved.pattern = with_slits_drawn_once(std::move(relieved.pattern));
  if (options.beside_bends != Relief::none)
    cut_beside_bends(relieved, sheet, area, options.beside_bends, rules);
  if (options.width > 0.0) rip_slits(relieved, area, options);
  return relieved;
}

}  // namespace planish::job
