#pragma once

#include "segments.hpp"
#include "stroke_inputs.hpp"
#include "tool_room.hpp"

namespace planish::brake_detail {

/// What a stroke lacks without hitting a tool. Lengths in mm.
struct Lack {
  enum class Kind {
    nothing,
    segments,     ///< of the tool, to press a line as long as `is`, where there is `room`
    bed,          ///< for a row that presses a line as long as `is`: it takes rows of `needs`
    no_room,      ///< for segments of the tool of any length, to press a line as long as `is`
    plane_sides,  ///< where the shoulders of the die touch: the bend is as wide as `is`
    reach,        ///< of a side, which ends so far from the bend line: the die `needs` more
    room,         ///< of the tool, to close a hem
  };
  Kind kind = Kind::nothing;
  double is = 0.0, needs = 0.0;
  std::optional<double> room = {};  ///< empty: something is beside the line on one side at most
};

/// Why a stroke cannot be made.
struct Obstruction {
  LineSet because;  ///< the lines by whose states this is so
  ToolKind tool = ToolKind::punch;
  int part = -1;   ///< of the line's tree: that hits the tool, or is short; −1: none
  Lack lack = {};  ///< unless a part hits the tool
};

/// Segments of punch and die, where they stand along the bend line.
struct PressRows {
  std::vector<ToolRow> punch, die;
};

/// The rows that make a stroke, or why there are none.
using Standing = tl::expected<PressRows, Obstruction>;
using StandingRow = tl::expected<std::vector<ToolRow>, Obstruction>;

/// Whether a tool is a row of segments; beams are as long as the machine.
inline bool is_row(ToolKind kind) { return kind == ToolKind::punch || kind == ToolKind::die; }

inline bool is_above(ToolKind kind) {
  return kind == ToolKind::punch || kind == ToolKind::upper_beam;
}

/// How the sheet moves in a stroke, as that tool or beam sees it.
inline PressMotion motion_at(const StrokeInputs& inputs, const Setting& stroke, ToolKind kind) {
  return is_above(kind) ? motion_at_punch(inputs, stroke) : motion(inputs, stroke);
}

/// The beam that bears a row.
inline ToolKind beam_of(ToolKind row) {
  return row == ToolKind::punch ? ToolKind::upper_beam : ToolKind::lower_beam;
}

/// The tool of a stroke that a kind belongs to.
inline int tool_of(ToolKind kind, const Setting& stroke) {
  return is_above(kind) ? stroke.punch : stroke.die;
}

}  // namespace planish::brake_detail
