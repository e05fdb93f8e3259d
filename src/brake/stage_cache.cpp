#include "stage_cache.hpp"

// Where the parts of the sheet are in a stage, kept from stroke to stroke (math.md#stages). Seen
// from the pressed line the sheet is a tree of bodies. The place of a body depends only on how the
// lines between it and that line are: flat, formed or pressed. So places hang in a tree of these
// states, and stages that differ elsewhere share them. Beyond a number of blocks all are forgotten,
// which costs time and changes no result.

namespace planish::brake_detail {

StageCache::StageCache(const StrokeInputs& inputs, std::shared_ptr<ToolRoom> tools,
                       std::size_t most_blocks)
    : inputs_(inputs),
      tools_(tools ? std::move(tools)
                   : std::make_shared<ToolRoom>(inputs.tools, inputs.options.clearance)),
      most_blocks_(most_blocks),
      rooms_(inputs.work.lines.size()) {}

StageCache::Room& StageCache::room(int line) {
  const Workpiece& work = inputs_.work;
  if (work.lines[line].closes) line = *work.lines[line].closes;
  if (!rooms_[line]) {
    rooms_[line] = std::make_unique<Room>(Room{PartTree(work, line)});
    Room& made = *rooms_[line];
    made.at_line.resize(made.tree.parts().size());
    made.beyond.fill(no_lines(inputs_.lines()));
    for (const PartTree::Part& part : made.tree.parts())
      if (part.before >= 0) insert(made.beyond[part.left ? 1 : 0], part.over);
  }
  return *rooms_[line];
}

/// What was forgotten is found again where it is needed.
void StageCache::forget_if_many() {
  if (blocks_known_ < most_blocks_) return;
  blocks_known_ = 0;
  for (const auto& room : rooms_) {
    if (!room) continue;
    room->known.clear();
    room->placed.clear();
    for (auto& known : room->at_line)
      known.reset();
  }
}

/// A part's place follows from that of the body it hangs on and from how the line between is.
StageCache::Known& StageCache::add_known(Room& room, int number, const Setting& stroke) {
  const PartTree::Part& part = room.tree.parts()[number];
  std::unique_ptr<Known>* known = &room.at_line[number];
  PartTree::State over = PartTree::State::flat;
  Known* before = part.before >= 0 ? room.known[part.before] : nullptr;
  if (before) {
    over = room.tree.state(part.over, *stroke.formed, stroke.pressed);
    known = &before->hanging[part.slot][static_cast<std::size_t>(over)];
  }
  if (!*known) {
    *known = std::make_unique<Known>(
        Known{room.tree.placed(number, before ? &before->placed : nullptr, over)});
    (*known)->hanging.resize(room.tree.hanging(number));
    blocks_known_ += (*known)->placed.blocks.size() + (*known)->placed.strips.size();
  }
  return **known;
}

StageCache::Room& StageCache::entered(const Setting& stroke) {
  Room& room = this->room(stroke.line);
  if (!room.known.empty() && room.formed == *stroke.formed && room.pressed == stroke.pressed)
    return room;
  forget_if_many();
  room.formed = *stroke.formed;
  room.pressed = stroke.pressed;
  room.known.clear();
  room.placed.clear();
  for (int part = 0; part < std::ssize(room.tree.parts()); ++part) {
    room.known.push_back(&add_known(room, part, stroke));
    room.placed.push_back(&room.known.back()->placed);
  }
  return room;
}

const std::vector<const PlacedPart*>& StageCache::parts(const Setting& stroke) {
  return entered(stroke).placed;
}

const SegmentSums& StageCache::segments_left(ToolKind row, int tool, SegmentSums::Chosen used) {
  const SegmentSums& all = row == ToolKind::punch ? inputs_.punch_segments[tool]
                                                  : inputs_.die_segments[tool];
  if (used == 0) return all;
  const auto known = segments_left_.find({row, tool, used});
  if (known != segments_left_.end()) return known->second;
  return segments_left_.emplace(std::tuple(row, tool, used), SegmentSums(all.segments(), used))
      .first->second;
}

LineSet StageCache::key_of(const Setting& stroke, ToolKind row) {
  LineSet key = *stroke.formed;
  key.insert(key.end(), stroke.pressed.begin(), stroke.pressed.end());
  const bool above = row == ToolKind::punch;
  key.push_back(4U * static_cast<unsigned>(above ? stroke.punch : stroke.die) + (above ? 2U : 0U) +
                (stroke.direction > 0 ? 1U : 0U));
  return key;
}

const Obstruction* StageCache::known_in_the_way(const Setting& stroke, ToolKind row) const {
  const auto found = in_the_way_.find(key_of(stroke, row));
  return found != in_the_way_.end() && found->second ? &*found->second : nullptr;
}

const BlockedWay* StageCache::blocked_way(const LineSet& formed_pressed) const {
  const auto known = blocked_ways_.find(formed_pressed);
  return known == blocked_ways_.end() ? nullptr : &known->second;
}

void StageCache::keep(LineSet formed_pressed, const BlockedWay& way) {
  blocked_ways_.emplace(std::move(formed_pressed), way);
}

}  // namespace planish::brake_detail
