// All tools as obstacles, made when first asked for. What must hold: equal keys stand for equal
// shapes, so what hits one need not be found again; a tool that is its own mirror image has one
// key for both directions of the gauge.
#include "tool_room.hpp"

#include <planish/base/assert.hpp>

namespace planish::brake_detail {
namespace {

bool hangs_below(ToolKind kind) { return kind == ToolKind::die || kind == ToolKind::lower_beam; }
constexpr double kBody = 1.0;  // mm: any clearance above 0 keeps the tool whole

}  // namespace

ToolRoom::ToolRoom(const BrakeTools& tools, double clearance)
    : tools_(tools), clearance_(clearance) {
  const auto& gauge = tools_.machine.gauge;
  if (!gauge) return;
  finger_ = obstacle_of(section_of(gauge->finger), kPenetration, 0.0);
  if (gauge->nose) nose_ = obstacle_of(section_of(gauge->nose->profile), kPenetration, 0.0);
}

/// What a part has to keep away from. The tip's wedge may be touched; what stands out beyond it
/// keeps its clearance.
Obstacle ToolRoom::kept_from(ToolKind kind, int tool, Nearness nearness) const {
  const ToolSection drawn = section(kind, tool);
  const bool is_beam = kind == ToolKind::upper_beam || kind == ToolKind::lower_beam;
  const bool keeps = clearance_ > 0.0 && (nearness == Nearness::clear || is_beam);
  if (keeps) return obstacle_of(drawn, 0.0, clearance_);
  Obstacle deep = obstacle_of(drawn, kPenetration, 0.0);
  if (kind != ToolKind::punch || clearance_ == 0.0) return deep;
  return united(std::move(deep), obstacle_beside_tip(tools_.punches[tool], clearance_));
}

Obstacle ToolRoom::body_of(ToolKind kind, int tool, Nearness nearness) const {
  if (nearness == Nearness::touching && kind == ToolKind::die) return {};
  if (nearness == Nearness::touching && kind == ToolKind::punch)
    return obstacle_beside_tip(tools_.punches[tool], kBody);
  return obstacle_of(section(kind, tool), 0.0, kBody);
}

ToolSection ToolRoom::section(ToolKind kind, int tool) const {
  if (kind == ToolKind::punch) return section_of(tools_.punches[tool]);
  if (kind == ToolKind::die) return section_of(tools_.dies[tool]);
  if (kind == ToolKind::lower_beam) return section_of(tools_.machine.lower_beam);
  return upper_beam_over(tools_.punches[tool], tools_.machine);
}

Obstacle ToolRoom::cut(Obstacle obstacle, ToolKind kind, int tool, CrossSection of) const {
  if (of == CrossSection::whole) return obstacle;
  PLANISH_ASSERT(kind == ToolKind::punch && tools_.punches[tool].ears);
  return up_to(std::move(obstacle), tools_.punches[tool].ears->height);
}

ToolRoom::Seen ToolRoom::seen(Obstacle obstacle, ToolKind kind, int tool) {
  obstacle.moves = hangs_below(kind);
  Seen seen{std::move(obstacle), {}, is_symmetric(section(kind, tool)), keys_};
  seen.mirror = mirrored(seen.plain);
  keys_ += 2;
  return seen;
}

SidedObstacle ToolRoom::sided(const Seen& seen, int direction) const {
  if (seen.symmetric) return {&seen.plain, &seen.plain, seen.key};
  if (direction > 0) return {&seen.plain, &seen.mirror, seen.key};
  return {&seen.mirror, &seen.plain, seen.key + 1};
}

SidedObstacle ToolRoom::kept(Table& table, MakeObstacle make, const ToolKey& key, int direction) {
  auto at = table.find(key);
  if (at == table.end()) {
    const auto& [kind, nearness, tool, of] = key;
    Obstacle made = cut((this->*make)(kind, tool, nearness), kind, tool, of);
    at = table.emplace(key, seen(std::move(made), kind, tool)).first;
  }
  return sided(at->second, direction);
}

SidedObstacle ToolRoom::obstacle(ToolKind kind, int tool, Nearness nearness, int direction,
                                 CrossSection of) {
  return kept(obstacles_, &ToolRoom::kept_from, {kind, nearness, tool, of}, direction);
}

SidedObstacle ToolRoom::body(ToolKind kind, int tool, Nearness nearness, int direction,
                             CrossSection of) {
  return kept(bodies_, &ToolRoom::body_of, {kind, nearness, tool, of}, direction);
}

const Obstacle& ToolRoom::deeper(ToolKind kind, int tool, double depth, CrossSection of) {
  const auto [at, added] = deeper_.try_emplace({kind, tool, depth, of});
  if (added) {
    at->second = cut(obstacle_of(section(kind, tool), depth, 0.0), kind, tool, of);
    at->second.moves = hangs_below(kind);
  }
  return at->second;
}

ToolName ToolRoom::name(ToolKind kind, int tool) const {
  if (kind == ToolKind::punch) return {kind, tools_.punches[tool].id};
  if (kind == ToolKind::die) return {kind, tools_.dies[tool].id};
  return {kind};
}

}  // namespace planish::brake_detail
