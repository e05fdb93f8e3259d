#include <planish/sheet/one_piece.hpp>

#include <algorithm>
#include <numeric>
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
  return std::any_of(loop.begin(), loop.end(),
                     [&](const Curve2& curve) { return is_near(curve, p, tolerance); });
}

/// Contours and slits that hang together.
class Joined {
 public:
  explicit Joined(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// False if they were joined already.
  bool join(std::size_t a, std::size_t b) {
    a = root(a), b = root(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::size_t root(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  std::vector<std::size_t> parent_;
};

}  // namespace

bool is_one_piece(const FlatPattern& pattern, double tolerance) {
  std::vector<const Loop*> contours{&pattern.outer.loop};
  for (const Contour& opening : pattern.openings)
    contours.push_back(&opening.loop);
  Joined joined(contours.size() + pattern.slits.size());
  std::vector<Vec2> seen;
  for (const Curve2& slit : pattern.slits)
    for (const Vec2& end : {start_of(slit), end_of(slit)}) {
      const bool again = std::any_of(seen.begin(), seen.end(),
                                     [&](const Vec2& p) { return (p - end).norm() <= tolerance; });
      if (again) continue;
      seen.push_back(end);
      std::vector<std::size_t> here;
      for (std::size_t i = 0; i < contours.size(); ++i)
        if (is_near(*contours[i], end, tolerance)) here.push_back(i);
      for (std::size_t i = 0; i < pattern.slits.size(); ++i)
        if (is_near(pattern.slits[i], end, tolerance)) here.push_back(contours.size() + i);
      for (std::size_t i = 1; i < here.size(); ++i)
        if (!joined.join(here[0], here[i])) return false;
    }
  return true;
}

}  // namespace planish
