// From sheet to flat pattern: set back sharp corners, lay out (math.md#unfolding), chain contours,
// add bend lines and features, then turn the whole so that the longest bend line lies along x and
// the chosen side faces up. The pattern and the layout move together: whatever reads either finds
// them in the same place.

#include "bend_lines.hpp"
#include "contour.hpp"
#include "feature_borders.hpp"
#include "measure.hpp"
#include "set_back.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/fit.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/moved_pattern.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace planish {
namespace {

using namespace sheet_detail;

Contour as_opening(Loop loop) {
  const size_t count = loop.size();
  return {std::move(loop), std::vector<std::vector<Origin>>(count)};
}

/// Whether the pilot hole is another than the hole that is drawn out of it.
bool is_smaller(const FormedOpening& opening) {
  constexpr double kSmaller = 1.0 - tolerance::kAside;
  const auto area = [](const BorderLoop& borders) {
    return std::abs(
        sum_of(borders, [&](const Border& border) { return green_area(border.curve); }));
  };
  return area(opening.pilot) < kSmaller * area(opening.through);
}

/// Whether a line goes on as another one, as files write them.
bool goes_on(const Segment& line, const Segment& next) {
  constexpr double kSame = tolerance::kWrittenDigits;
  const Vec2 along = next.b - line.a;
  return (next.a - line.b).norm() <= kSame && along.dot(next.b - next.a) > 0.0 &&
         along.dot(line.b - line.a) > 0.0 &&
         std::abs(cross(along, next.a - line.a)) <= kSame * along.norm();
}

/// A chain of curves whose lines that go on straight are one: a cutter pierces once for each.
Loop with_lines_joined(const Loop& chain) {
  Loop joined;
  for (const Curve2& curve : chain) {
    const auto* next = std::get_if<Segment>(&curve);
    auto* last = joined.empty() ? nullptr : std::get_if<Segment>(&joined.back());
    if (next && last && goes_on(*last, *next))
      last->b = next->b;
    else
      joined.push_back(curve);
  }
  return joined;
}

/// What is cut within a feature, entered in the pattern.
void cut_feature(FlatPattern& pattern, FlatFeature& flat, const FormedFeature& feature,
                 const Isometry2& placement, const FlattenOptions& options) {
  flat.uncut_openings = feature.own_openings;
  for (const FormedOpening& opening : feature.openings) {
    const Loop through = merged(placed(opening.through, placement), options.merge_tolerance).loop;
    switch (options.extruded) {
      case ExtrudedHoles::outline:
        flat.outlines.push_back(through);
        ++flat.uncut_openings;
        break;
      case ExtrudedHoles::through:
        pattern.openings.push_back(as_opening(through));
        break;
      case ExtrudedHoles::pilot:
        if (is_smaller(opening)) {
          const Box2 box = bounds(through);
          flat.pilots.emplace_back((box.lo + box.hi) / 2);
        }
        pattern.openings.push_back(
            as_opening(merged(placed(opening.pilot, placement), options.merge_tolerance).loop));
        break;
    }
  }
  for (const BorderLoop& slit : feature.slits) {
    const Loop chain = with_lines_joined(placed(slit, placement));
    if (options.extruded == ExtrudedHoles::outline)
      ++flat.uncut_openings;
    else
      pattern.slits.insert(pattern.slits.end(), chain.begin(), chain.end());
  }
}

/// The features with their outlines, and what is cut within them.
void add_features(FlatPattern& pattern, const Sheet& sheet, const Layout& layout,
                  const Contours& contours, const FlattenOptions& options) {
  IdVector<FeatureId, std::vector<Loop>> formed(sheet.features.size());
  for (const auto& [id, outline] : contours.formed)
    formed[id].push_back(outline);
  for (const FeatureId id : sheet.features.ids()) {
    const FormedFeature& feature = sheet[id];
    const Isometry2& placement = layout.placement[feature.face];
    FlatFeature flat{feature.kind, feature.side, std::move(formed[id])};
    for (const BorderLoop& outline : feature.outlines)
      flat.outlines.push_back(merged(placed(outline, placement), options.merge_tolerance).loop);
    for (const BorderRef& ref : feature.along)
      flat.along.push_back(point_at(layout.image(ref), 0.5));
    flat.beyond_cut = feature.beyond_cut;
    cut_feature(pattern, flat, feature, placement, options);
    pattern.features.push_back(std::move(flat));
  }
}

void transform(Segment& segment, const Isometry2& motion) {
  segment = {motion * segment.a, motion * segment.b};
}

void transform(Contour& contour, const Isometry2& motion) {
  contour.loop = transformed(contour.loop, motion);
  for (auto& origins : contour.origins)
    for (Origin& origin : origins)
      origin.image = transformed(origin.image, motion);
  if (motion.linear().determinant() > 0) return;
  contour.loop = reversed(contour.loop);
  std::ranges::reverse(contour.origins);
}

/// Moves the whole pattern; a reflection shows the sheet from its other side.
void transform(FlatPattern& pattern, const Isometry2& motion) {
  transform(pattern.outer, motion);
  for (Contour& opening : pattern.openings)
    transform(opening, motion);
  pattern.slits = transformed(pattern.slits, motion);
  for (FlatBend& bend : pattern.bends) {
    for (Segment& line : bend.lines)
      transform(line, motion);
    for (Segment& line : bend.tangent_lines)
      transform(line, motion);
    if (motion.linear().determinant() < 0)
      bend.direction = bend.direction == BendDirection::up ? BendDirection::down
                                                           : BendDirection::up;
  }
  for (FlatFeature& feature : pattern.features) {
    if (motion.linear().determinant() < 0) feature.side = other_side(feature.side);
    for (Loop& outline : feature.outlines)
      outline = transformed(outline, motion);
    for (std::vector<Vec2>* places : {&feature.pilots, &feature.along})
      for (Vec2& place : *places)
        place = motion * place;
  }
  for (FlatLabel& label : pattern.labels)
    label.at = motion * label.at;
  pattern.root_placement = motion * pattern.root_placement;
}

void move(FlatSheet& flat, const Isometry2& motion) {
  flat.layout.move(motion);
  transform(flat.pattern, motion);
}

bool other_side_up(const FlatPattern& pattern, UpSide up) {
  if (up != UpSide::automatic) return up == UpSide::other;
  const auto ups = std::ranges::count(pattern.bends, BendDirection::up, &FlatBend::direction);
  return 2 * ups < static_cast<std::ptrdiff_t>(pattern.bends.size());
}

/// The direction to lay along x: the longest bend line, else the longest straight cut.
Vec2 leading_direction(const FlatPattern& pattern) {
  Vec2 best = Vec2::Zero();
  const auto consider = [&](const Segment& line) {
    // Rounding must not distinguish equal lengths.
    constexpr double kClearlyLonger = 1.0 + tolerance::kComputed;
    if ((line.b - line.a).norm() > best.norm() * kClearlyLonger) best = line.b - line.a;
  };
  for (const FlatBend& bend : pattern.bends)
    for (const Segment& line : bend.lines)
      consider(line);
  if (best.norm() == 0.0)
    for (const Curve2& curve : pattern.outer.loop)
      if (const auto* line = std::get_if<Segment>(&curve)) consider(*line);
  return best.norm() == 0.0 ? Vec2(Vec2::UnitX()) : Vec2(best.normalized());
}

Isometry2 turn(double cosine, double sine) {
  Isometry2 motion = Isometry2::Identity();
  motion.linear() << cosine, -sine, sine, cosine;
  return motion;
}

/// Lays the whole along the axes, the longer extent along x, its lower left corner at the origin.
void align(FlatSheet& flat) {
  const FlatPattern& pattern = flat.pattern;
  const Vec2 lead = leading_direction(pattern);
  move(flat, turn(lead.x(), -lead.y()));
  constexpr double kClearlyHigher = 1.0 + tolerance::kComputed;
  if (const Vec2 size = bounds(pattern.outer.loop).size(); size.y() > size.x() * kClearlyHigher)
    move(flat, turn(0.0, 1.0));
  move(flat, Isometry2(Eigen::Translation2d(-bounds(pattern.outer.loop).lo)));
}

/// The pattern in the coordinates of the layout's root.
Result<FlatPattern> pattern_of(const Sheet& sheet, const Layout& layout,
                               const FlattenOptions& options) {
  auto contours = chain_contours(sheet, layout, options);
  if (!contours) return pass_on(contours);
  FlatPattern pattern;
  pattern.thickness = sheet.thickness;
  add_features(pattern, sheet, layout, *contours, options);
  pattern.outer = std::move(contours->outer);
  pattern.openings.insert(pattern.openings.begin(),
                          std::make_move_iterator(contours->openings.begin()),
                          std::make_move_iterator(contours->openings.end()));
  pattern.bends = flat_bends(sheet, layout);
  for (const PointLabel& label : sheet.labels)
    pattern.labels.push_back({layout.develop(sheet, label.face, label.at), label.text});
  pattern.closure = layout.closure;
  pattern.root = layout.root;
  pattern.root_placement = layout.placement[layout.root];
  return pattern;
}

Result<FlatSheet> flat_set_back(const Sheet& sheet, const FlattenOptions& options) {
  auto layout = lay_out(sheet, options);
  if (!layout) return pass_on(layout);
  auto pattern = pattern_of(sheet, *layout, options);
  if (!pattern) return pass_on(pattern);
  FlatSheet flat{std::move(*layout), std::move(*pattern)};
  if (other_side_up(flat.pattern, options.up)) {
    Isometry2 mirror = Isometry2::Identity();
    mirror.linear()(0, 0) = -1.0;
    move(flat, mirror);
  }
  if (!options.keep_root) align(flat);
  measure(flat.pattern);
  return flat;
}

}  // namespace

Result<FlatSheet> flat_sheet(const Sheet& made, const FlattenOptions& options) {
  if (auto right = check(made); !right) return pass_on(right);
  if (!needs_setback(made)) return flat_set_back(made, options);
  const auto moved = with_setback(made);
  if (moved) return flat_set_back(*moved, options);
  // Corners without room are mostly closed all around: that is the better answer.
  const auto layout = lay_out(made, options);
  const bool closed = !layout && layout.error().code == code::closed_loop;
  return tl::unexpected(closed ? layout.error() : moved.error());
}

Result<FlatPattern> flatten(const Sheet& sheet, const FlattenOptions& options) {
  auto flat = flat_sheet(sheet, options);
  if (!flat) return pass_on(flat);
  return std::move(flat->pattern);
}

FlatPattern transformed(FlatPattern pattern, const Isometry2& motion) {
  transform(pattern, motion);
  return pattern;
}

}  // namespace planish
