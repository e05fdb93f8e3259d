#pragma once

#include "tool_shape.hpp"

#include <array>
#include <map>
#include <tuple>

namespace planish::brake_detail {

inline constexpr std::array kToolKinds = {ToolKind::upper_beam, ToolKind::lower_beam,
                                          ToolKind::punch, ToolKind::die};

/// How strictly a part keeps away: sides that are being bent touch the tools that bend them.
enum class Nearness { touching, clear };

/// A section of a tool: the whole, or of a punch with ears what reaches to their outer ends.
enum class CrossSection { whole, foot };

/// A tool as both sides of the workpiece see it, each as if it were the left one.
struct SidedObstacle {
  const Obstacle* left = nullptr;
  const Obstacle* right = nullptr;
  int key = 0;  ///< equal for the same shapes
};

/// All tools of a shop as obstacles, each made when it is first asked for. A direction of +1 has
/// the gauge on the left of the bend line, −1 on its right.
class ToolRoom {
 public:
  ToolRoom(const BrakeTools& tools, double clearance);

  const BrakeTools& tools() const { return tools_; }
  /// `tool` is a punch for a punch and the upper beam, else a die.
  SidedObstacle obstacle(ToolKind kind, int tool, Nearness nearness, int direction,
                         CrossSection of = CrossSection::whole);
  /// The tool itself, whatever is kept away from it; for sides being bent without the wedge of the
  /// punch's tip, and without the die.
  SidedObstacle body(ToolKind kind, int tool, Nearness nearness, int direction,
                     CrossSection of = CrossSection::whole);
  /// What of a tool is deeper than `depth` below its surface. Kept: each is made once.
  const Obstacle& deeper(ToolKind kind, int tool, double depth,
                         CrossSection of = CrossSection::whole);
  /// Of the back gauge, where it touches at the origin.
  const Obstacle& finger() const { return finger_; }
  /// Of its nose; empty if it has none.
  const Obstacle& nose() const { return nose_; }
  ToolName name(ToolKind kind, int tool) const;

 private:
  struct Seen {
    Obstacle plain, mirror;
    bool symmetric = false;
    int key = 0;
  };
  using ToolKey = std::tuple<ToolKind, Nearness, int, CrossSection>;
  using Table = std::map<ToolKey, Seen>;
  using MakeObstacle = Obstacle (ToolRoom::*)(ToolKind kind, int tool, Nearness nearness) const;
  ToolSection section(ToolKind kind, int tool) const;
  Obstacle kept_from(ToolKind kind, int tool, Nearness nearness) const;
  Obstacle body_of(ToolKind kind, int tool, Nearness nearness) const;
  Obstacle cut(Obstacle obstacle, ToolKind kind, int tool, CrossSection of) const;
  Seen seen(Obstacle obstacle, ToolKind kind, int tool);
  SidedObstacle sided(const Seen& seen, int direction) const;
  /// From a table, where it is made when it is missing.
  SidedObstacle kept(Table& table, MakeObstacle make, const ToolKey& key, int direction);

  const BrakeTools& tools_;
  double clearance_;
  int keys_ = 0;
  Obstacle finger_, nose_;
  std::map<std::tuple<ToolKind, int, double, CrossSection>, Obstacle> deeper_;
  Table obstacles_, bodies_;
};

}  // namespace planish::brake_detail
