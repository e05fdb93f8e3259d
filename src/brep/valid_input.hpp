#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// Whether a sheet that is to be made a solid breaks no rule: what a caller gives is an input, not
/// a defect of a maker.
inline Result<void> valid_input(const Sheet& sheet) {
  auto right = check(sheet);
  if (!right) right.error().code = code::invalid_input;
  return right;
}

}  // namespace planish::brep
