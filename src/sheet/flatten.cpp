#include "bend_lines.hpp"
#include "contour.hpp"
#include "measure.hpp"
#include "set_back.hpp"
#include "unfolding_tree.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

void add_face_outlines(UnfoldingTree& tree, FlatPattern& pattern) {
  for (std::vector<Loop>& images : tree.images) {
    pattern.face_outlines.push_back(std::move(images.front()));
    pattern.face_openings.emplace_back(std::make_move_iterator(images.begin() + 1),
                                       std::make_move_iterator(images.end()));
  }
}

void add_features(const Sheet& sheet, const UnfoldingTree& tree, const Contours& contours,
                  double tolerance, FlatPattern& pattern) {
  for (size_t i = 0; i < sheet.features.size(); ++i) {
    const FormedFeature& feature = sheet.features[i];
    FlatFeature flat{feature.kind, {}};
    for (const auto& [index, outline] : contours.formed)
      if (index == static_cast<int>(i)) flat.outlines.push_back(outline);
    for (const BorderLoop& outline : feature.outlines) {
      Loop loop;
      for (const Border& border : outline)
        loop.push_back(transformed(border.curve, tree.placement[index_of(feature.face)]));
      flat.outlines.push_back(merged(loop, tolerance).loop);
    }
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
  for (Isometry2& placement : pattern.placement)
    placement = motion * placement;
  for (Loop& outline : pattern.face_outlines)
    outline = transformed(outline, motion);
  for (auto& openings : pattern.face_openings)
    for (Loop& opening : openings)
      opening = transformed(opening, motion);
}

bool other_side_up(const FlatPattern& pattern, UpSide up) {
  if (up != UpSide::automatic) return up == UpSide::other;
  const auto ups = std::count_if(
      pattern.bends.begin(), pattern.bends.end(),
      [](const FlatBend& bend) { return bend.direction == BendDirection::up; });
  return 2 * ups < static_cast<std::ptrdiff_t>(pattern.bends.size());
}

/// Direction that shall lie along x: the longest bend line, else the longest straight cut.
Vec2 leading_direction(const FlatPattern& pattern) {
  Vec2 best = Vec2::Zero();
  const auto consider = [&](const Segment& line) {
    constexpr double kClearlyLonger = 1.0 +
                                      1e-9;  // equal lengths must not be told apart by rounding
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

/// Lays the pattern along the axes, the longer extent along x, its lower left corner at the origin.
void align(FlatPattern& pattern) {
  const Vec2 lead = leading_direction(pattern);
  transform(pattern, turn(lead.x(), -lead.y()));
  if (const Vec2 size = bounds(pattern.outer.loop).size(); size.y() > size.x() * (1.0 + 1e-9))
    transform(pattern, turn(0.0, 1.0));
  Isometry2 shift = Isometry2::Identity();
  shift.translation() = -bounds(pattern.outer.loop).lo;
  transform(pattern, shift);
}

Result<FlatPattern> flatten_set_back(const Sheet& sheet, const FlattenOptions& options) {
  auto tree = grow_unfolding_tree(sheet, options);
  if (!tree) return tl::unexpected(tree.error());
  auto contours = chain_contours(sheet, *tree, options);
  if (!contours) return tl::unexpected(contours.error());

  FlatPattern pattern;
  pattern.thickness = sheet.thickness;
  pattern.outer = std::move(contours->outer);
  pattern.openings = std::move(contours->openings);
  pattern.bends = flat_bends(sheet, *tree);
  pattern.placement = tree->placement;
  pattern.neutral_offset = tree->neutral_offset;
  pattern.closure = tree->closure;
  add_features(sheet, *tree, *contours, options.merge_tolerance, pattern);
  for (const PointLabel& label : sheet.labels)
    pattern.labels.push_back({tree->image(sheet, label.face, label.at), label.text});
  add_face_outlines(*tree, pattern);
  if (other_side_up(pattern, options.up)) {
    Isometry2 mirror = Isometry2::Identity();
    mirror.linear()(0, 0) = -1.0;
    transform(pattern, mirror);
  }
  if (!options.keep_root) align(pattern);
  measure(pattern);
  return pattern;
}

}  // namespace

Result<FlatPattern> flatten(const Sheet& made, const FlattenOptions& options) {
  if (needs_setback(made)) {
    auto moved = with_setback(made);
    if (!moved) {
      // Corners that leave no room are mostly corners closed all round: that is the better answer.
      const auto tree = grow_unfolding_tree(made, options);
      return tl::unexpected(!tree && tree.error().code == ErrorCode::closed_loop ? tree.error()
                                                                                 : moved.error());
    }
    return flatten_set_back(*moved, options);
  }
  return flatten_set_back(made, options);
}

}  // namespace planish
