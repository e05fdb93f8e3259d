#pragma once

#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// How far a border of a face is from the ruling, or on a plane the line, between its ends, mm.
double off_ruling(const Face& face, const Curve2& border);

/// That ruling or line.
Segment as_ruling(const Face& face, const Curve2& border);

}  // namespace planish::brep
