#pragma once

#include "tool_shape.hpp"

#include <array>
#include <map>
#include <string>
#include <tuple>

namespace planish::brake_detail {

enum class ToolKind { punch, upper_beam, die, lower_beam };
inline constexpr std::array kToolKinds = {ToolKind::upper_beam, ToolKind::lower_beam,
                                          ToolKind::punch, ToolKind::die};

/// How strictly a part keeps away: sides that are being bent touch the tools that bend them.
enum class Nearness { touching, clear };

/// A tool as both sides of the workpiece see it, each as if it were the left one.
struct SidedObstacle {
  const Obstacle* left = nullptr;
  const Obstacle* right = nullptr;
  int key = 0;  ///< equal for the same shapes
};

/// All tools of a shop as obstacles. A direction of +1 has the gauge on the left of the bend line,
/// −1 on its right.
class ToolRoom {
 public:
  ToolRoom(const BrakeTools& tools, double clearance);

  const BrakeTools& tools() const { return tools_; }
  /// `tool` is a punch for a punch and the upper beam, else a die.
  SidedObstacle obstacle(ToolKind kind, int tool, Nearness nearness, int direction) const;
  /// The tool itself, whatever is kept away from it; for sides being bent without the wedge of the
  /// punch's tip, and without the die.
  SidedObstacle body(ToolKind kind, int tool, Nearness nearness, int direction) const;
  /// What of a tool is deeper than `depth` below its surface. Kept: each is made once.
  const Obstacle& deeper(ToolKind kind, int tool, double depth);
  /// Of the back gauge, where it touches at the origin.
  const Obstacle& finger() const { return finger_; }
  std::string name(ToolKind kind, int tool) const;

 private:
  struct Seen {
    Obstacle plain, mirror;
    bool symmetric = false;
    int key = 0;
  };
  ToolSection section(ToolKind kind, int tool) const;
  Seen seen(Obstacle obstacle, bool symmetric);
  SidedObstacle sided(const Seen& seen, int direction) const;
  int count(ToolKind kind) const;

  const BrakeTools& tools_;
  int keys_ = 0;
  Obstacle finger_;
  std::map<std::tuple<ToolKind, int, double>, Obstacle> deeper_;
  std::array<std::array<std::vector<Seen>, 2>, 4> obstacles_, bodies_;
};

}  // namespace planish::brake_detail
