#include <planish/base/length_unit.hpp>

namespace planish {

double millimetres_in(LengthUnit unit) {
  return unit == LengthUnit::mm ? 1.0 : unit == LengthUnit::inch ? 25.4 : 1000.0;
}

}  // namespace planish
