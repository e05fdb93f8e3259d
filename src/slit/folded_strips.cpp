// Strips folded once: a sheet has as many pairs as the square of its strips, nearly all of them far
// apart, which their boxes tell.
#include "folded_strips.hpp"

#include "crossing.hpp"

namespace planish::slit_detail {

bool FoldedStrips::cross(int left, int right, double within) const {
  return boxes[left].intersects(boxes[right]) &&
         slit_detail::cross(strips[left], strips[right], within);
}

FoldedStrips folded_strips(const StripSystem& system, const Shapes& shapes) {
  FoldedStrips all;
  for (int strip = 0; strip < system.count(); ++strip) {
    all.strips.push_back(folded_strip(system.strips[strip].base, shapes[strip]));
    Eigen::AlignedBox3d& box = all.boxes.emplace_back();
    for (const SlitRidge& ridge : all.strips.back().ridges)
      for (const Vec3& end : ridge.folded)
        box.extend(end);
  }
  return all;
}

}  // namespace planish::slit_detail
