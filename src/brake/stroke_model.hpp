#pragma once

#include "fits.hpp"
#include "segments.hpp"
#include "stage_pose.hpp"
#include "sweep.hpp"
#include "tool_room.hpp"

#include <planish/brake/order.hpp>
#include <planish/brake/stroke_search.hpp>

#include <chrono>
#include <memory>
#include <unordered_map>

namespace planish::brake_detail {

using Clock = std::chrono::steady_clock;
inline constexpr Clock::time_point kNoEnd = Clock::time_point::max();

/// Answers which strokes can be made in a stage. What a part of the workpiece hits depends on the
/// lines between it and the pressed one only: it is computed once for each of their states.
class StrokeModel {
 public:
  /// `obstacles`: of these tools and this clearance, if they are there already.
  StrokeModel(Workpiece work, const BrakeTools& tools, const PlanOptions& options,
              std::shared_ptr<ToolRoom> obstacles = nullptr);

  const Workpiece& work() const { return work_; }
  const FittingTools& fitting(int line) const { return fitting_[line]; }

  /// All strokes that may be made: the lines that lie on one line pressed together, and each of
  /// them alone. Gauged wherever an edge reaches the gauge.
  std::vector<StrokeChoice> choices(const LineSet& formed);
  StrokeVerdict check(const LineSet& formed, const StrokeChoice& choice);
  std::vector<StrokeChoice> possible() const;
  /// Whether everything on one side of what is pressed is formed: bending from the outside in.
  bool is_outermost(const LineSet& formed, const StrokeChoice& choice);
  /// What is to be done in a stroke. Of one that cannot be made segments and clearance are missing.
  Stroke stroke(const LineSet& formed, const StrokeChoice& choice);
  /// Why a line cannot be pressed in a stage, by the tools that come nearest to it; of those looked
  /// at until a time, the first at least.
  BlockedBend blocked(const LineSet& formed, int line, Clock::time_point until = kNoEnd);
  /// The same for lines pressed together, with the way in which it comes nearest.
  struct BlockedWay {
    BlockedBend bend;
    StrokeChoice choice;
  };
  BlockedWay blocked_way(const LineSet& formed, const LineSet& pressed,
                         Clock::time_point until = kNoEnd);
  /// The stroke in space, whether it can be made or not.
  StrokeScene scene(const LineSet& formed, const StrokeChoice& choice);

 private:
  /// What a part hits, and what hangs on it: by slot and by how the line between them is.
  struct Known {
    PlacedPart placed;
    std::vector<std::pair<int, std::vector<Interval>>> blocked = {};  ///< by the obstacle's key
    /// By the state of the line between.
    std::vector<std::array<std::unique_ptr<Known>, PartTree::kStates>> hanging = {};
  };
  /// All that is known about strokes on one line.
  struct LineRoom {
    PartTree tree;
    std::array<LineSet, 2> beyond = {};                ///< the lines on its right and on its left
    std::vector<std::unique_ptr<Known>> at_line = {};  ///< of the parts that hang on no other
    /// By side: how far the plane sides go, by the lines that end them and those pressed.
    std::array<std::unordered_map<LineSet, double, LineSetHash>, 2> reaches = {};
    /// The parts in the stage that was asked for last.
    LineSet formed = {}, pressed = {};
    std::vector<Known*> parts = {};
  };
  /// A stroke in a stage.
  struct Setting {
    const LineSet* formed = nullptr;
    LineSet pressed;
    int line = 0;  ///< the first of those pressed
    int punch = 0, die = 0;
    int direction = 1;  ///< +1: the gauge is on the left of the line
  };
  /// Why a stroke cannot be made.
  struct Obstruction {
    LineSet because;
    std::optional<ToolKind> hits = {};
    int part = -1;  ///< that hits, of the line's tree
    std::string why = {};
  };
  struct Rows {
    std::vector<ToolRow> punch, die;
  };

  Setting setting(const LineSet& formed, const StrokeChoice& choice) const;
  LineRoom& room(int line);
  void forget_if_many();
  const std::vector<Known*>& parts_in(const Setting& stroke);
  PressMotion motion(const Setting& stroke) const;
  double most_turn(int line) const;
  Nearness nearness(int part, ToolKind kind, const Setting& stroke);
  const std::vector<Interval>& blocked_by(ToolKind kind, int part, const Setting& stroke,
                                          const PressMotion& motion);
  std::vector<int> together(int line, const LineSet& formed);
  std::vector<Interval> pressed_pieces(const Setting& stroke);
  double shortfall() const;

  std::optional<Obstruction> too_short(const Setting& stroke);
  double reach(const Setting& stroke, bool left);
  double measured_reach(const Setting& stroke, bool left);
  LineSet limits_of(const Setting& stroke, bool left);
  std::optional<Obstruction> obstructed(const Setting& stroke, Rows* rows);
  std::optional<Obstruction> rows_missing(const Setting& stroke,
                                          const std::array<std::vector<Interval>, 2>& walls,
                                          const std::array<LineSet, 2>& because, Rows* rows);
  std::optional<Obstruction> cannot_close(const Setting& stroke, Rows* rows);
  Rows rows_wanted(const Setting& stroke);
  void add_bending(const Setting& stroke, StrokeScene& scene);
  void add_closing(const Setting& stroke, StrokeScene& scene);
  std::optional<GaugeStop> gauge(const Setting& stroke);
  double clearance(const Setting& stroke, const Rows& rows);
  Interval contact_range(int line, int die);
  std::vector<Obstruction> collisions(const Setting& stroke);
  BlockedBend deepest_of_all(const Setting& stroke, double most);
  BlockedWay nearest_way(const LineSet& formed, const LineSet& pressed, Clock::time_point until);
  BlockedBend deepest(const Setting& stroke, const Obstruction& obstruction, const Interval& told);
  std::optional<FlangeId> flange_of(int line, int part);
  int direction_number(const Vec2& direction) const;

  Workpiece work_;
  const BrakeTools& tools_;
  PlanOptions options_;
  std::shared_ptr<ToolRoom> room_of_tools_;
  std::vector<FittingTools> fitting_;
  std::vector<SegmentSums> punch_segments_, die_segments_;
  std::vector<Vec2> directions_;  ///< of the pattern, by the numbers of `StrokeChoice`
  std::vector<std::unique_ptr<LineRoom>> rooms_;
  std::size_t blocks_known_ = 0;
  std::vector<std::vector<int>> on_one_line_;  ///< by line: those that continue it in the pattern
  std::unordered_map<int, Interval> contact_ranges_;
  std::unordered_map<LineSet, BlockedWay, LineSetHash> blocked_ways_;
};

}  // namespace planish::brake_detail
