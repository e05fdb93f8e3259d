#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <functional>
#include <vector>

namespace planish::sheet_detail {

/// Leaves of a bend's lines and tangent lines the parts that `left_of` gives for each; the bend's
/// length shrinks with its lines.
void trim_bend(FlatBend& bend, const std::function<std::vector<Segment>(const Segment&)>& left_of);

}  // namespace planish::sheet_detail
