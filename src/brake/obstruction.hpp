#pragma once

#include "segments.hpp"
#include "stage_cache.hpp"

#include <optional>
#include <string>

namespace planish::brake_detail {

/// Why a stroke cannot be made.
struct Obstruction {
  LineSet because;  ///< the lines by whose states this is so
  std::optional<ToolKind> hits = {};
  int part = -1;  ///< that hits, of the line's tree
  std::string why = {};
};

/// Segments of punch and die, where they stand along the bend line.
struct PressRows {
  std::vector<ToolRow> punch, die;
};

/// The rows that make a stroke, or why there are none.
using Standing = tl::expected<PressRows, Obstruction>;

/// Whether a tool is a row of segments; beams are as long as the machine.
inline bool is_row(ToolKind kind) { return kind == ToolKind::punch || kind == ToolKind::die; }

inline bool is_above(ToolKind kind) {
  return kind == ToolKind::punch || kind == ToolKind::upper_beam;
}

/// The tool of a stroke that a kind belongs to.
inline int tool_of(ToolKind kind, const Setting& stroke) {
  return is_above(kind) ? stroke.punch : stroke.die;
}

}  // namespace planish::brake_detail
