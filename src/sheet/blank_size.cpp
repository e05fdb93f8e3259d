#include <planish/base/assert.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/flat_pattern.hpp>

namespace planish {

Vec2 blank_size(const FlatPattern& pattern) {
  if (pattern.outer.loop.empty()) return Vec2::Zero();
  PLANISH_ASSERT(is_regular(pattern.outer.loop));
  return smallest_rectangle(sampled(pattern.outer.loop, kImageTolerance)).size;
}

}  // namespace planish
