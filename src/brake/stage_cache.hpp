#pragma once

#include "blocked_way.hpp"
#include "obstruction.hpp"
#include "stage_pose.hpp"
#include "stroke_inputs.hpp"
#include "tool_room.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <tuple>
#include <unordered_map>

namespace planish::brake_detail {

/// What was found out about stages, kept for the questions that follow: the only state between
/// them. Invariant: an entry is what its function gives for the inputs and the entry's key,
/// whatever was asked before. So a cache that is new, full or has forgotten gives the same answers.
///
/// What a part of the workpiece hits depends on the lines between it and the pressed one only
/// (math.md#stroke-clearance), so it is kept once for each of their states.
class StageCache {
 public:
  static constexpr std::size_t kMostBlocks = 1'500'000;  ///< of parts that are known: 1 GB

  /// The inputs must outlive the cache. `tools`: obstacles of the same tools and clearance, if they
  /// are there already. With more than `most_blocks` it forgets the parts.
  explicit StageCache(const StrokeInputs& inputs, std::shared_ptr<ToolRoom> tools = nullptr,
                      std::size_t most_blocks = kMostBlocks);

  const StrokeInputs& inputs() const { return inputs_; }
  ToolRoom& tools() { return *tools_; }

  /// The parts as a line sees them. A hem is closed where it was bent, so both lines have one tree.
  const PartTree& tree(int line) { return room(line).tree; }
  /// The lines on the right of a line and on its left.
  const std::array<LineSet, 2>& beyond(int line) { return room(line).beyond; }
  /// Where each part of the line's tree is. Valid until parts of another stage are asked for.
  const std::vector<const PlacedPart*>& parts(const Setting& stroke);

  /// Where a part is in the way of an obstacle of that key, within a range; `make` finds it out.
  /// The key stands for all that `make` uses of the tools: their shapes, and of the die its
  /// shoulder if it moves.
  template <typename Make>
  const std::vector<Interval>& blocked(const Setting& stroke, int part, int obstacle,
                                       const Interval& within, const Make& make) {
    Known& known = this->known(stroke, part);
    for (const Blocked& one : known.blocked)
      if (one.obstacle == obstacle && is_same(one.within, within)) return one.along;
    known.blocked.push_back({obstacle, within, make(known.placed)});
    return known.blocked.back().along;
  }

  /// Whether a part is in the way of an obstacle somewhere in these ranges of x.
  template <typename Make>
  bool stands_in(const Setting& stroke, int part, int obstacle, const std::vector<Interval>& ranges,
                 const Make& make) {
    Known& known = this->known(stroke, part);
    for (const Stands& one : known.standing)
      if (one.obstacle == obstacle && std::ranges::equal(one.ranges, ranges, is_same))
        return one.hit;
    known.standing.push_back({obstacle, ranges, make(known.placed)});
    return known.standing.back().hit;
  }

  /// How far a plane side goes from a line, ended by those formed lines.
  template <typename Make>
  double reach(int line, bool left, LineSet limits, const Make& make) {
    return kept(room(line).reaches[left ? 1 : 0], std::move(limits), make);
  }

  /// Where the shoulder of a die touches the sides of a line.
  template <typename Make>
  Interval contact(int line, int die, const Make& make) {
    return kept(contacts_, line * static_cast<int>(inputs_.tools.dies.size()) + die, make);
  }

  /// What the segments of a tool add up to without those that are used.
  const SegmentSums& segments_left(ToolKind row, int tool, SegmentSums::Chosen used);

  /// How often it was found out whether a tool stands: what the work of a search is counted in.
  std::int64_t checks() const { return checks_; }

  /// What is in the way of one tool of a stroke, whichever the other is; nothing: it stands.
  template <typename Make>
  const std::optional<Obstruction>& in_the_way(const Setting& stroke, ToolKind row,
                                               const Make& make) {
    LineSet key = key_of(stroke, row);
    if (in_the_way_.size() >= kMostKept) in_the_way_.clear();
    const auto found = in_the_way_.find(key);
    if (found != in_the_way_.end()) return found->second;
    ++checks_;
    return in_the_way_.emplace(std::move(key), make()).first->second;
  }

  /// The same, as far as it was found out: null if not, or if nothing is in the way.
  const Obstruction* known_in_the_way(const Setting& stroke, ToolKind row) const;

  /// The way that comes nearest in a stage, if it is known: `formed` followed by `pressed`.
  const BlockedWay* blocked_way(const LineSet& formed_pressed) const;
  /// Keeps one for which all ways were looked at.
  void keep(LineSet formed_pressed, const BlockedWay& way);

 private:
  static bool is_same(const Interval& a, const Interval& b) { return a.lo == b.lo && a.hi == b.hi; }

  struct Blocked {
    int obstacle = 0;
    Interval within;
    std::vector<Interval> along;
  };
  struct Stands {
    int obstacle = 0;
    std::vector<Interval> ranges;
    bool hit = false;
  };
  /// A part, what it hits, and what hangs on it: by slot and by how the line between them is.
  struct Known {
    PlacedPart placed;
    std::vector<Blocked> blocked = {};
    std::vector<Stands> standing = {};
    std::vector<std::array<std::unique_ptr<Known>, PartTree::kStates>> hanging = {};
  };
  /// All that is known about strokes on one line.
  struct Room {
    PartTree tree;
    std::array<LineSet, 2> beyond = {};
    std::vector<std::unique_ptr<Known>> at_line = {};  ///< of the parts that hang on no other
    std::array<std::unordered_map<LineSet, double, LineSetHash>, 2> reaches = {};  ///< by side
    /// The parts in the stage that was asked for last.
    LineSet formed = {}, pressed = {};
    std::vector<Known*> known = {};
    std::vector<const PlacedPart*> placed = {};
  };

  template <typename Map, typename Make>
  static typename Map::mapped_type kept(Map& map, typename Map::key_type key, const Make& make) {
    const auto found = map.find(key);
    return found != map.end() ? found->second : map.emplace(std::move(key), make()).first->second;
  }
  /// Of a tool in a stroke, whichever the other is.
  static LineSet key_of(const Setting& stroke, ToolKind row);
  static constexpr std::size_t kMostKept = 500'000;  // answers: 100 MB

  Room& room(int line);
  Room& entered(const Setting& stroke);
  Known& known(const Setting& stroke, int part) { return *entered(stroke).known[part]; }
  Known& add_known(Room& room, int part, const Setting& stroke);
  void forget_if_many();

  const StrokeInputs& inputs_;
  std::shared_ptr<ToolRoom> tools_;
  std::size_t most_blocks_, blocks_known_ = 0;
  std::int64_t checks_ = 0;
  std::vector<std::unique_ptr<Room>> rooms_;
  std::unordered_map<int, Interval> contacts_;
  std::map<std::tuple<ToolKind, int, SegmentSums::Chosen>, SegmentSums> segments_left_;
  std::unordered_map<LineSet, BlockedWay, LineSetHash> blocked_ways_;
  std::unordered_map<LineSet, std::optional<Obstruction>, LineSetHash> in_the_way_;
};

}  // namespace planish::brake_detail
