#include <planish/base/assert.hpp>
#include <planish/base/length_unit.hpp>

namespace planish {

double millimetres_in(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::mm:
      return 1.0;
    case LengthUnit::inch:
      return 25.4;
    case LengthUnit::m:
      return 1000.0;
  }
  PLANISH_ASSERT(!"a unit of the list");
  return 1.0;
}

}  // namespace planish
