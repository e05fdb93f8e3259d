#include "face_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planish::brep {
namespace {

std::vector<int> in_order_of_x(const std::vector<Outline>& outlines) {
  std::vector<int> order(outlines.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int f) { return outlines[f].space.min().x(); });
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
      if (outlines[*b].space.min().x() > outlines[*a].space.max().x() + reach) break;
      if (!outlines[*b].flat.empty() &&
          enlarged(outlines[*a].space, reach).intersects(outlines[*b].space))
        try_pair(*a, *b);
    }
  }
  return pairs;
}

}  // namespace planish::brep
