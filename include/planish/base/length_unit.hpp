#pragma once

namespace planish {

enum class LengthUnit { mm, inch, m };
/// Millimetres in one unit.
double millimetres_in(LengthUnit unit);

}  // namespace planish
