#pragma once

#include <planish/brake/plan.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace planish {

/// What is pressed at once in an order that is given.
struct OrderedStroke {
  std::vector<BendId> bends;
  std::optional<int> press_line = {};  ///< of a bend with several: which, from 0
  bool flattening = false;             ///< closes a hem that was bent before
};
OrderedStroke ordered(const Stroke& stroke);

/// Where sheet and tools are at a turn, in the machine frame (math.md#machine-frame), mm. The body
/// that is held is turned by `slope` about the x axis, from where it lies, and then moved by `by`.
struct StrokeMoment {
  Angle turn;
  Angle slope;
  Vec2 by = Vec2::Zero();  ///< in y and z
  double punch = 0.0;      ///< height of its lowest point
  double die = 0.0;        ///< height of its top
};

/// A segment of a tool, along x.
struct StandingSegment {
  double from = 0.0, length = 0.0;
};

/// A stroke in space: what is needed to show the sheet in the machine.
struct StrokeScene {
  Vec2 origin = Vec2::Zero(), along = Vec2::UnitX();  ///< of the x axis, in the flat pattern
  bool pattern_up = true;    ///< the pattern's viewer sees the side that faces up
  Vec2 held = Vec2::Zero();  ///< in the pattern, on the body that `moments` move
  /// From the lying sheet to the last turn, springback included; of a hem that is closed from
  /// where it was bent to.
  std::vector<StrokeMoment> moments;
  double across = 0.0;  ///< y of the middle of punch and die
  /// Where segments stand; of a stroke that cannot be made, where they would have to.
  std::vector<StandingSegment> punch, die;
  std::vector<StandingSegment> feet;  ///< of ears, beside the bodies of their segments
};

struct CheckedStroke {
  Stroke stroke;
  std::optional<BlockedBend> blocked = {};  ///< empty: it can be made
  StrokeScene scene;
};

/// An order of strokes, each made in the way that makes the whole cheapest.
struct CheckedOrder {
  std::vector<CheckedStroke> strokes;
  std::vector<Station> stations = {};  ///< of the strokes that can be made, by set-up from the left
  double cost = 0.0;                   ///< of all, as if those that are blocked could be made
  int turn_overs = 0, rotations = 0, tool_changes = 0, ungauged = 0;
  int v_away = 0;  ///< sizes from the wanted V, of all strokes together
  bool feasible() const;
};

/// Checks orders of the strokes of one sheet. What was found out for one order is used for the
/// next.
class OrderChecker {
 public:
  /// Errors: those of `plan_bending`. `options.begin_with` is not used.
  static Result<OrderChecker> make(const Sheet& sheet, const Layout& layout,
                                   const BrakeTools& tools, const PlanOptions& options = {});
  OrderChecker(OrderChecker&&) noexcept;
  OrderChecker& operator=(OrderChecker&&) noexcept;
  ~OrderChecker();

  /// The strokes of an order. A stroke that cannot be made is shown in the way that comes nearest,
  /// and the order goes on as if it had been made. Bends that are given together and do not lie on
  /// one line in their stage are pressed one after the other. What the order leaves out follows,
  /// first what can be made, from the outside in. Errors: `bad_option` for bends that take no such
  /// stroke or take it twice, `cancelled`.
  Result<CheckedOrder> check(const std::vector<OrderedStroke>& order,
                             const Progress& progress = {});

 private:
  struct State;
  explicit OrderChecker(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Sections of tools with their corners rounded, in the order of the tools.
struct ToolSections {
  std::vector<ToolProfile> punches;      ///< lowest point at height 0
  std::vector<ToolProfile> feet;         ///< of the ears of each punch; empty if it has none
  std::vector<ToolProfile> upper_beams;  ///< above each punch; empty if the machine has none
  std::vector<ToolProfile> dies;         ///< top at height 0
  ToolProfile lower_beam;
};
ToolSections tool_sections(const BrakeTools& tools);

}  // namespace planish
