// Whether slits part the material: contours and slits that touch are united, point by point; a slit
// that joins two that are united already closes a ring, and what is inside falls out. Each place
// where several slits end counts once.

#include <planish/base/union_find.hpp>
#include <planish/sheet/one_piece.hpp>

#include <algorithm>
#include <vector>

namespace planish {
namespace {

bool is_near(const Curve2& curve, const Vec2& p, double tolerance) {
  const Box2 box = bounds(curve);
  if (((p.array() < box.lo.array() - tolerance) || (p.array() > box.hi.array() + tolerance)).any())
    return false;
  return nearest(curve, p).distance <= tolerance;
}

bool is_near(const Loop& loop, const Vec2& p, double tolerance) {
  return std::ranges::any_of(loop,
                             [&](const Curve2& curve) { return is_near(curve, p, tolerance); });
}

}  // namespace

bool is_one_piece(const FlatPattern& pattern, double tolerance) {
  std::vector<const Loop*> contours{&pattern.outer.loop};
  for (const Contour& opening : pattern.openings)
    contours.push_back(&opening.loop);
  // Contours, then slits.
  UnionFind joined(static_cast<int>(contours.size() + pattern.slits.size()));
  std::vector<Vec2> seen;
  for (const Curve2& slit : pattern.slits)
    for (const Vec2& end : {start_of(slit), end_of(slit)}) {
      const bool again = std::ranges::any_of(
          seen, [&](const Vec2& p) { return (p - end).norm() <= tolerance; });
      if (again) continue;
      seen.push_back(end);
      std::vector<int> here;
      for (std::size_t i = 0; i < contours.size(); ++i)
        if (is_near(*contours[i], end, tolerance)) here.push_back(static_cast<int>(i));
      for (std::size_t i = 0; i < pattern.slits.size(); ++i)
        if (is_near(pattern.slits[i], end, tolerance))
          here.push_back(static_cast<int>(contours.size() + i));
      for (std::size_t i = 1; i < here.size(); ++i)
        if (!joined.unite(here[0], here[i])) return false;
    }
  return true;
}

}  // namespace planish
