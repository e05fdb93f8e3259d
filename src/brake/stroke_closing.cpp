#include "closed_hem.hpp"
#include "stroke_model.hpp"

#include <fmt/format.h>

namespace planish::brake_detail {

/// Closing a hem: it lies on the flat die, the middle of its return below the middle of the flat
/// punch, which has come down as far as it goes. What is then in the way is so before or later.
std::optional<StrokeModel::Obstruction> StrokeModel::cannot_close(const Setting& stroke,
                                                                  Rows* rows) {
  const PartTree& tree = room(stroke.line).tree;
  const Setting open{stroke.formed, no_lines(static_cast<int>(work_.lines.size())), stroke.line};
  std::vector<const PlacedPart*> lying;
  for (const Known* known : parts_in(open))
    lying.push_back(&known->placed);
  const ClosedHem hem = closed_hem(work_, tree, work_.lines[stroke.line], lying);
  const std::vector<PlacedPart>& parts = hem.parts;
  const PressMotion still = motion(stroke);
  const LineSet none = no_lines(static_cast<int>(work_.lines.size()));
  std::array<std::vector<Interval>, 2> walls;
  std::array<LineSet, 2> because = {none, none};
  for (const ToolKind kind : kToolKinds) {
    const bool above = kind == ToolKind::punch || kind == ToolKind::upper_beam;
    const Vec2 at(hem.middle, above ? hem.top : -work_.thickness);
    for (int part = 0; part < std::ssize(parts); ++part) {
      const Nearness nearness = parts[part].flat &&
                                        (kind == ToolKind::punch || kind == ToolKind::die)
                                    ? Nearness::touching
                                    : Nearness::clear;
      Obstacle tool = moved(
          *room_of_tools_
               ->obstacle(kind, above ? stroke.punch : stroke.die, nearness, stroke.direction)
               .left,
          at);
      tool.moves = false;
      const std::vector<Interval> blocked = blocked_along(still, parts[part], tool, tool, 0.0);
      if (blocked.empty()) continue;
      const LineSet& path = tree.parts()[part].path;
      if (kind == ToolKind::upper_beam || kind == ToolKind::lower_beam)
        return Obstruction{
            path, kind, -1,
            fmt::format("the {} is in the way of closing the hem", room_of_tools_->name(kind, 0))};
      const size_t row = kind == ToolKind::punch ? 0 : 1;
      walls[row].insert(walls[row].end(), blocked.begin(), blocked.end());
      because[row] = joined(because[row], path);
    }
  }
  return rows_missing(stroke, walls, because, rows);
}

}  // namespace planish::brake_detail
