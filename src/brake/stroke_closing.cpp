#include "stroke_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::brake_detail {
namespace {

/// In the line's frame, both sides as they are.
Block3 in_line_frame(Block3 block, bool left, const Eigen::Isometry3d& motion) {
  for (auto* ring : {&block.lower, &block.upper})
    for (Vec3& p : *ring) {
      if (!left) p.y() = -p.y();
      p = motion * p;
    }
  return block;
}

/// The smaller side of a hem is its return.
bool is_left_smaller(const Workpiece& work, const PartTree& tree) {
  double left = 0.0, right = 0.0;
  for (const PartTree::Part& part : tree.parts())
    if (!part.is_zone)
      for (const Convex& piece : work.bodies[part.index].pieces)
        (part.left ? left : right) += ring_area(piece);
  return left <= right;
}

/// Ranges of y and z.
Box2 section_box(const PlacedPart& part) {
  Box2 box;
  for (const Vec2& p : part.hull)
    box.add(p);
  return box;
}

}  // namespace

/// Each part where it is once the hem is closed: the larger side lies, the return is above it.
std::vector<PlacedPart> StrokeModel::closed_parts(const Setting& stroke, bool left_folds) {
  const PartTree& tree = room(stroke.line).tree;
  const BrakeLine& line = work_.lines[stroke.line];
  const Eigen::Isometry3d bent = bent_side(line, line.closed);
  const Eigen::Isometry3d stays = Eigen::Isometry3d::Identity(),
                          folds = left_folds ? bent : bent.inverse();
  const Setting open{stroke.formed, no_lines(static_cast<int>(work_.lines.size())), stroke.line};
  std::vector<PlacedPart> parts;
  for (int i = 0; i < std::ssize(tree.parts()); ++i) {
    const PlacedPart& flat = parts_in(open)[i]->placed;
    PlacedPart part;
    part.left = true;
    part.flat = flat.flat;
    for (const Block3& block : flat.blocks)
      part.blocks.push_back(
          in_line_frame(block, flat.left, flat.left == left_folds ? folds : stays));
    if (tree.parts()[i].is_zone && tree.parts()[i].before < 0)
      for (const Block3& block : tree.closed_zone())
        part.blocks.push_back(in_line_frame(block, true, left_folds ? stays : folds));
    summarise(part);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Closing a hem: it lies on the flat die, the middle of its return below the middle of the flat
/// punch, which has come down as far as it goes. What is then in the way is so before or later.
std::optional<StrokeModel::Obstruction> StrokeModel::cannot_close(const Setting& stroke,
                                                                  Rows* rows) {
  const PartTree& tree = room(stroke.line).tree;
  const bool left_folds = is_left_smaller(work_, tree);
  const std::vector<PlacedPart> parts = closed_parts(stroke, left_folds);
  const int part_of_return = tree.part_of_body(work_.lines[stroke.line].bodies[left_folds ? 1 : 0]);
  const Box2 folded = section_box(parts[part_of_return]);
  const double middle = 0.5 * (folded.lo.x() + folded.hi.x());
  const PressMotion still = motion(stroke);
  const LineSet none = no_lines(static_cast<int>(work_.lines.size()));
  std::array<std::vector<Interval>, 2> walls;
  std::array<LineSet, 2> because = {none, none};
  for (const ToolKind kind : kToolKinds) {
    const bool above = kind == ToolKind::punch || kind == ToolKind::upper_beam;
    const Vec2 at(middle, above ? folded.hi.y() : -work_.thickness);
    for (int part = 0; part < std::ssize(parts); ++part) {
      const Nearness nearness = parts[part].flat &&
                                        (kind == ToolKind::punch || kind == ToolKind::die)
                                    ? Nearness::touching
                                    : Nearness::clear;
      Obstacle tool = moved(
          *room_of_tools_
               .obstacle(kind, above ? stroke.punch : stroke.die, nearness, stroke.direction)
               .left,
          at);
      tool.moves = false;
      const std::vector<Interval> blocked = blocked_along(still, parts[part], tool, tool, 0.0);
      if (blocked.empty()) continue;
      const LineSet& path = tree.parts()[part].path;
      if (kind == ToolKind::upper_beam || kind == ToolKind::lower_beam)
        return Obstruction{
            path, kind, -1,
            fmt::format("the {} is in the way of closing the hem", room_of_tools_.name(kind, 0))};
      const size_t row = kind == ToolKind::punch ? 0 : 1;
      walls[row].insert(walls[row].end(), blocked.begin(), blocked.end());
      because[row] = joined(because[row], path);
    }
  }
  return rows_missing(stroke, walls, because, rows);
}

}  // namespace planish::brake_detail
