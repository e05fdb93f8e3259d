#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <string>

namespace planish::io_detail {

/// What is written at a bend: "B1 UP 90° R2.5", "B2 DOWN 8 × 11.25°". Where the order of strokes is
/// known, the number of its first one comes before it: "3: B1 UP 90° R2.5".
std::string bend_text(const FlatBend& bend);

}  // namespace planish::io_detail
