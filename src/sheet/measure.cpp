#include "measure.hpp"

namespace planish::sheet_detail {

void measure(FlatPattern& pattern) {
  pattern.area = signed_area(pattern.outer.loop);
  pattern.perimeter = length(pattern.outer.loop);
  for (const Contour& opening : pattern.openings) {
    pattern.area += signed_area(opening.loop);
    pattern.perimeter += length(opening.loop);
  }
  for (const Segment& slit : pattern.slits)
    pattern.perimeter += length(Curve2(slit));
}

}  // namespace planish::sheet_detail
