#include "stroke_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::brake_detail {
namespace {

bool is_row(ToolKind kind) { return kind == ToolKind::punch || kind == ToolKind::die; }

/// What a row must cover of a piece of the bend line.
Interval covered(const Interval& piece, double shortfall) {
  const double middle = 0.5 * (piece.lo + piece.hi);
  return {std::min(piece.lo + shortfall, middle), std::max(piece.hi - shortfall, middle)};
}

bool stands_in(const std::vector<Interval>& blocked, const std::vector<Interval>& pieces,
               double shortfall) {
  for (const Interval& piece : pieces) {
    const Interval row = covered(piece, shortfall);
    for (const Interval& wall : blocked)
      if (wall.lo + kPenetration < row.hi && wall.hi - kPenetration > row.lo) return true;
  }
  return false;
}

}  // namespace

/// Sides that are bent touch punch and die; what lies on the die may touch it.
Nearness StrokeModel::nearness(int number, ToolKind kind, const Setting& stroke) {
  if (!is_row(kind)) return Nearness::clear;
  const std::vector<Known*>& parts = parts_in(stroke);
  if (parts[number]->placed.flat) return Nearness::touching;
  const PartTree::Part& part = room(stroke.line).tree.parts()[number];
  const bool lies_on_die = kind == ToolKind::die && part.is_zone && part.before >= 0 &&
                           parts[part.before]->placed.flat;
  return lies_on_die ? Nearness::touching : Nearness::clear;
}

const std::vector<Interval>& StrokeModel::blocked_by(ToolKind kind, int part, const Setting& stroke,
                                                     const PressMotion& motion) {
  const int tool = kind == ToolKind::punch || kind == ToolKind::upper_beam ? stroke.punch
                                                                           : stroke.die;
  const SidedObstacle obstacle = room_of_tools_->obstacle(kind, tool, nearness(part, kind, stroke),
                                                          stroke.direction);
  Known& known = *parts_in(stroke)[part];
  for (const auto& [key, blocked] : known.blocked)
    if (key == obstacle.key) return blocked;
  known.blocked.emplace_back(obstacle.key, blocked_along(motion, known.placed, *obstacle.left,
                                                         *obstacle.right, most_turn(stroke.line)));
  return known.blocked.back().second;
}

/// All parts that are in the way of tools which cannot stand elsewhere.
std::vector<StrokeModel::Obstruction> StrokeModel::collisions(const Setting& stroke) {
  const PartTree& tree = room(stroke.line).tree;
  const std::vector<Interval> pieces = pressed_pieces(stroke);
  const PressMotion motion = this->motion(stroke);
  std::vector<Obstruction> all;
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    for (const ToolKind kind : kToolKinds) {
      const std::vector<Interval>& blocked = blocked_by(kind, part, stroke, motion);
      if (!blocked.empty() && (!is_row(kind) || stands_in(blocked, pieces, shortfall())))
        all.push_back({tree.parts()[part].path, kind, part, {}});
    }
  return all;
}

/// What is in the way of the tools, or where the rows of tools stand.
std::optional<StrokeModel::Obstruction> StrokeModel::obstructed(const Setting& stroke, Rows* rows) {
  const PartTree& tree = room(stroke.line).tree;
  const std::vector<Interval> pieces = pressed_pieces(stroke);
  const PressMotion motion = this->motion(stroke);
  const LineSet none = no_lines(static_cast<int>(work_.lines.size()));
  std::array<std::vector<Interval>, 2> walls;  // in the way of the punch, of the die
  std::array<LineSet, 2> because = {none, none};
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    for (const ToolKind kind : kToolKinds) {
      const std::vector<Interval>& blocked = blocked_by(kind, part, stroke, motion);
      if (blocked.empty()) continue;
      const LineSet& path = tree.parts()[part].path;
      if (!is_row(kind) || stands_in(blocked, pieces, shortfall()))
        return Obstruction{path, kind, part, {}};
      const size_t row = kind == ToolKind::punch ? 0 : 1;
      walls[row].insert(walls[row].end(), blocked.begin(), blocked.end());
      because[row] = joined(because[row], path);
    }
  return rows_missing(stroke, walls, because, rows);
}

/// Whether rows of punch and die can be made of their segments.
std::optional<StrokeModel::Obstruction> StrokeModel::rows_missing(
    const Setting& stroke, const std::array<std::vector<Interval>, 2>& walls,
    const std::array<LineSet, 2>& because, Rows* rows) {
  const std::vector<Interval> pieces = pressed_pieces(stroke);
  for (const size_t row : {size_t{0}, size_t{1}}) {
    const ToolKind kind = row == 0 ? ToolKind::punch : ToolKind::die;
    const int tool = row == 0 ? stroke.punch : stroke.die;
    const SegmentSums& segments = row == 0 ? punch_segments_[tool] : die_segments_[tool];
    const RowRequest request{pieces, shortfall(), joined(walls[row], 0.0), tools_.machine.length};
    std::vector<ToolRow> standing = tool_rows(segments, request);
    if (standing.empty())
      return Obstruction{
          because[row], kind, -1,
          fmt::format("no segments of {} press the line, {:.4g} mm long, and stand "
                      "between what is beside it",
                      room_of_tools_->name(kind, tool), pieces.back().hi - pieces.front().lo)};
    if (rows) (row == 0 ? rows->punch : rows->die) = std::move(standing);
  }
  return std::nullopt;
}

}  // namespace planish::brake_detail
