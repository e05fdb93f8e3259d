#pragma once

#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// Largest distance of a border from the ruling, or on a plane from the line, between its ends, mm.
double off_ruling(const Face& face, const Curve2& border);

/// That ruling or line.
Segment as_ruling(const Face& face, const Curve2& border);

}  // namespace planish::brep
