#include "tool_room.hpp"

#include <fmt/format.h>

namespace planish::brake_detail {
namespace {

bool hangs_below(ToolKind kind) { return kind == ToolKind::die || kind == ToolKind::lower_beam; }
size_t row(ToolKind kind) { return static_cast<size_t>(kind); }
size_t row(Nearness nearness) { return static_cast<size_t>(nearness); }

}  // namespace

ToolRoom::ToolRoom(const BrakeTools& tools, double clearance) : tools_(tools) {
  if (tools_.machine.gauge)
    finger_ = obstacle_of(section_of(tools_.machine.gauge->finger), kPenetration, 0.0);
  constexpr double kBody = 1.0;  // any clearance above 0 keeps the tool whole
  for (const ToolKind kind : kToolKinds)
    for (int i = 0; i < count(kind); ++i) {
      const ToolSection drawn = section(kind, i);
      const bool symmetric = is_symmetric(drawn);
      const auto add = [&](auto& table, Nearness nearness, Obstacle obstacle) {
        obstacle.moves = hangs_below(kind);
        table[row(kind)][row(nearness)].push_back(seen(std::move(obstacle), symmetric));
      };
      const bool is_beam = kind == ToolKind::upper_beam || kind == ToolKind::lower_beam;
      const Obstacle deep = obstacle_of(drawn, kPenetration, 0.0);
      const Obstacle far = clearance > 0.0 ? obstacle_of(drawn, 0.0, clearance) : deep;
      add(obstacles_, Nearness::clear, far);
      Obstacle near = is_beam ? far : deep;
      if (kind == ToolKind::punch && clearance > 0.0) {
        // The tip's wedge may be touched; what stands out beyond it keeps its clearance.
        add(obstacles_, Nearness::touching,
            united(deep, obstacle_beside_tip(tools_.punches[i], clearance)));
      } else {
        add(obstacles_, Nearness::touching, near);
      }
      const Obstacle whole = obstacle_of(drawn, 0.0, kBody);
      add(bodies_, Nearness::clear, whole);
      Obstacle body = whole;
      if (kind == ToolKind::punch) body = obstacle_beside_tip(tools_.punches[i], kBody);
      if (kind == ToolKind::die) body = Obstacle();
      add(bodies_, Nearness::touching, std::move(body));
    }
}

int ToolRoom::count(ToolKind kind) const {
  return static_cast<int>(hangs_below(kind) ? tools_.dies.size() : tools_.punches.size());
}

ToolSection ToolRoom::section(ToolKind kind, int tool) const {
  if (kind == ToolKind::punch) return section_of(tools_.punches[tool]);
  if (kind == ToolKind::die) return section_of(tools_.dies[tool]);
  if (kind == ToolKind::lower_beam) return section_of(tools_.machine.lower_beam);
  return section_of(tools_.machine.upper_beam, lowered(tools_.punches[tool]));
}

ToolRoom::Seen ToolRoom::seen(Obstacle obstacle, bool symmetric) {
  Seen seen{std::move(obstacle), {}, symmetric, keys_};
  seen.mirror = mirrored(seen.plain);
  keys_ += 2;
  return seen;
}

SidedObstacle ToolRoom::sided(const Seen& seen, int direction) const {
  if (seen.symmetric) return {&seen.plain, &seen.plain, seen.key};
  if (direction > 0) return {&seen.plain, &seen.mirror, seen.key};
  return {&seen.mirror, &seen.plain, seen.key + 1};
}

SidedObstacle ToolRoom::obstacle(ToolKind kind, int tool, Nearness nearness, int direction) const {
  return sided(obstacles_[row(kind)][row(nearness)][tool], direction);
}

SidedObstacle ToolRoom::body(ToolKind kind, int tool, Nearness nearness, int direction) const {
  return sided(bodies_[row(kind)][row(nearness)][tool], direction);
}

const Obstacle& ToolRoom::deeper(ToolKind kind, int tool, double depth) {
  const auto [at, added] = deeper_.try_emplace({kind, tool, depth});
  if (added) {
    at->second = obstacle_of(section(kind, tool), depth, 0.0);
    at->second.moves = hangs_below(kind);
  }
  return at->second;
}

std::string ToolRoom::name(ToolKind kind, int tool) const {
  if (kind == ToolKind::punch) return fmt::format("punch {}", tools_.punches[tool].id);
  if (kind == ToolKind::die) return fmt::format("die {}", tools_.dies[tool].id);
  return kind == ToolKind::upper_beam ? "upper beam" : "lower beam";
}

}  // namespace planish::brake_detail
