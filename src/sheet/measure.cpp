#include "measure.hpp"

namespace planish::sheet_detail {

void measure(FlatPattern& pattern) {
  pattern.area = signed_area(pattern.outer.loop);
  pattern.perimeter = length(pattern.outer.loop);
  for (const Contour& opening : pattern.openings) {
    pattern.area += signed_area(opening.loop);
    pattern.perimeter += length(opening.loop);
  }
  pattern.perimeter += length(pattern.slits);
}

}  // namespace planish::sheet_detail
