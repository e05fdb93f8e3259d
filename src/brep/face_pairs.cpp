#include "face_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planish::brep {
namespace {

bool boxes_near(const Outline& a, const Outline& b, double reach) {
  return ((a.lo.array() - reach) <= b.hi.array()).all() &&
         ((b.lo.array() - reach) <= a.hi.array()).all();
}

std::vector<int> in_order_of_x(const std::vector<Outline>& outlines) {
  std::vector<int> order(outlines.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) { return outlines[a].lo.x() < outlines[b].lo.x(); });
  return order;
}

}  // namespace

FacePairs pair_faces(const SolidModel& model, const std::vector<Outline>& outlines,
                     double thickness, double slack) {
  FacePairs pairs;
  pairs.partners.resize(outlines.size());
  pairs.covered.resize(outlines.size());
  const auto try_pair = [&](int a, int b) {
    const auto seen = opposite(model, outlines, a, b);
    if (!seen || std::abs(seen->depth - thickness) > slack || seen->spread > slack) return;
    const auto back = opposite(model, outlines, b, a);
    if (!back) return;
    pairs.partners[a].push_back(b);
    pairs.partners[b].push_back(a);
    pairs.covered[a] += seen->overlap / outlines[a].area;
    pairs.covered[b] += back->overlap / outlines[b].area;
    pairs.rows.push_back({a, b, *seen});
  };
  // Sweeps faces along x, so that only near ones are compared.
  const std::vector<int> order = in_order_of_x(outlines);
  const double reach = thickness + slack;
  for (auto a = order.begin(); a != order.end(); ++a) {
    if (outlines[*a].flat.empty()) continue;
    for (auto b = a + 1; b != order.end(); ++b) {
      if (outlines[*b].lo.x() > outlines[*a].hi.x() + reach) break;
      if (!outlines[*b].flat.empty() && boxes_near(outlines[*a], outlines[*b], reach))
        try_pair(*a, *b);
    }
  }
  return pairs;
}

}  // namespace planish::brep
