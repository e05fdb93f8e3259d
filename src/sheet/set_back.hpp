#pragma once

#include <planish/sheet/sheet.hpp>

namespace planish::sheet_detail {

/// The sheet with the borders of its sharp bends whose reference skin is outside moved back to
/// where the bend begins, the outside setback t·tan(α/2) from the corner (math.md#setback with r =
/// 0), and their neighbours cut there. Borders keep their indices in their loops; a border wholly
/// within the setback shrinks to a point. Cut borders lose their edge length. Errors:
/// `unsupported_shape` if a face is too narrow for its setback.
Result<Sheet> with_setback(const Sheet& sheet);

/// Whether there is anything to set back.
bool needs_setback(const Sheet& sheet);

}  // namespace planish::sheet_detail
