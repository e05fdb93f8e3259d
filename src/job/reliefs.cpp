#include "reliefs.hpp"

#include "units.hpp"

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
Result<void> cut(Relieved& relieved, const Sheet& sheet, const Layout& layout,
                 const Cutout& cutout) {
  auto left = without_cutout(relieved.pattern, cutout);
  if (!left) return tl::unexpected(left.error());
  const double removed = relieved.pattern.area - left->area;
  const double within = area_within(sheet, layout, relieved.pattern, cutout.outline());
  // Polygons leave out or add a chord's height along each curve.
  const double slack = kContactShare * relieved.pattern.thickness * length(cutout.outline());
  if (!(std::abs(removed - within) <= slack))
    return fail(
        ErrorCode::pattern_wrong,
        fmt::format("a relief took {:.4g} mm² where the sheet has {:.4g} mm²", removed, within));
  relieved.pattern = std::move(*left);
  relieved.removed += removed;
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

/// A slit that cannot be given a width stays a line.
void rip_slits(Relieved& relieved, const Sheet& sheet, const Layout& layout,
               const ReliefOptions& options) {
  std::vector<Vec2> places;
  for (const Segment& slit : straight_slits(relieved.pattern)) {
    if (!cut(relieved, sheet, layout, cutout_along(slit, options))) continue;
    std::erase_if(relieved.pattern.slits, [&](const Curve2& other) {
      const auto* line = std::get_if<Segment>(&other);
      return line && line->a == slit.a && line->b == slit.b;
    });
    relieved.pattern.perimeter -= (slit.b - slit.a).norm();
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
                              const std::vector<DoubleCover>& covers,
                              const ReliefOptions& options) {
  Relieved relieved{pattern, 0.0, static_cast<int>(covers.size()), {}};
  for (const DoubleCover& cover : covers) {
    if (auto small = check_size(cover, pattern); !small) return tl::unexpected(small.error());
    const Cutout cutout = cutout_at(cover, pattern, options);
    if (auto done = cut(relieved, sheet, layout, cutout); !done)
      return tl::unexpected(done.error());
    relieved.findings.push_back(mended(cover, cutout, pattern, options.shape));
  }
  relieved.pattern = with_slits_drawn_once(std::move(relieved.pattern));
  if (options.width > 0.0) rip_slits(relieved, sheet, layout, options);
  return relieved;
}

}  // namespace planish::job
