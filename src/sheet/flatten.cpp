#include "bend_lines.hpp"
#include "contour.hpp"
#include "measure.hpp"
#include "set_back.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/fit.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

using namespace sheet_detail;

std::vector<FlatFeature> flat_features(const Sheet& sheet, const Layout& layout,
                                       const Contours& contours, double tolerance) {
  std::vector<FlatFeature> features;
  for (const FeatureId id : sheet.features.ids()) {
    const FormedFeature& feature = sheet[id];
    FlatFeature& flat = features.emplace_back(FlatFeature{feature.kind, {}});
    for (const auto& [formed, outline] : contours.formed)
      if (formed == id) flat.outlines.push_back(outline);
    for (const BorderLoop& outline : feature.outlines) {
      Loop loop;
      for (const Border& border : outline)
        loop.push_back(transformed(border.curve, layout.placement[feature.face]));
      flat.outlines.push_back(merged(loop, tolerance).loop);
    }
  }
  return features;
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
  std::reverse(contour.origins.begin(), contour.origins.end());
}

/// Moves the whole pattern; a reflection shows the sheet from its other side.
void transform(FlatPattern& pattern, const Isometry2& motion) {
  transform(pattern.outer, motion);
  for (Contour& opening : pattern.openings)
    transform(opening, motion);
  for (Segment& slit : pattern.slits)
    transform(slit, motion);
  for (FlatBend& bend : pattern.bends) {
    for (Segment& line : bend.lines)
      transform(line, motion);
    for (Segment& line : bend.tangent_lines)
      transform(line, motion);
    if (motion.linear().determinant() < 0)
      bend.direction = bend.direction == BendDirection::up ? BendDirection::down
                                                           : BendDirection::up;
  }
  for (FlatFeature& feature : pattern.features)
    for (Loop& outline : feature.outlines)
      outline = transformed(outline, motion);
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
  const auto ups = std::count_if(
      pattern.bends.begin(), pattern.bends.end(),
      [](const FlatBend& bend) { return bend.direction == BendDirection::up; });
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
  Isometry2 shift = Isometry2::Identity();
  shift.translation() = -bounds(pattern.outer.loop).lo;
  move(flat, shift);
}

/// The pattern in the coordinates of the layout's root.
Result<FlatPattern> pattern_of(const Sheet& sheet, const Layout& layout,
                               const FlattenOptions& options) {
  auto contours = chain_contours(sheet, layout, options);
  if (!contours) return tl::unexpected(contours.error());
  FlatPattern pattern;
  pattern.thickness = sheet.thickness;
  pattern.features = flat_features(sheet, layout, *contours, options.merge_tolerance);
  pattern.outer = std::move(contours->outer);
  pattern.openings = std::move(contours->openings);
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
  if (!layout) return tl::unexpected(layout.error());
  auto pattern = pattern_of(sheet, *layout, options);
  if (!pattern) return tl::unexpected(pattern.error());
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
  if (auto right = check(made); !right) return tl::unexpected(right.error());
  if (!needs_setback(made)) return flat_set_back(made, options);
  const auto moved = with_setback(made);
  if (moved) return flat_set_back(*moved, options);
  // Corners without room are mostly closed all around: that is the better answer.
  const auto layout = lay_out(made, options);
  const bool closed = !layout && layout.error().code == ErrorCode::closed_loop;
  return tl::unexpected(closed ? layout.error() : moved.error());
}

Result<FlatPattern> flatten(const Sheet& sheet, const FlattenOptions& options) {
  auto flat = flat_sheet(sheet, options);
  if (!flat) return tl::unexpected(flat.error());
  return std::move(flat->pattern);
}

}  // namespace planish
