#pragma once

#include <planish/connect/edge_search.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace planish::test {

/// An outline in (x, y) of a side: `edges` edges towards the intersection line, as many away from
/// it.
struct OutlineStyle {
  int edges = 4;
  double roughness = 30.0;  ///< mm that the corners' heights vary
  double lean = 0.0;        ///< slope of the whole
  bool convex = false;
  bool equal = false;  ///< edges of one length, heights in steps: many ties
};

inline std::vector<Vec2> random_outline(std::mt19937& random, const OutlineStyle& style) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto row = [&](double base, double sign) {
    std::vector<double> xs{0.0, 200.0};
    for (int i = 1; i < style.edges; ++i)
      xs.push_back(style.equal ? 200.0 * i / style.edges : 200.0 * unit(random));
    std::ranges::sort(xs);
    std::vector<Vec2> corners;
    for (const double x : xs) {
      const double bulge = (x - 100.0) * (x - 100.0) / 10000.0;
      double rough = style.convex ? style.roughness * bulge : style.roughness * unit(random);
      if (style.equal) rough = std::round(rough / 10.0) * 10.0;
      corners.emplace_back(x, base + sign * rough + style.lean * x);
    }
    return corners;
  };
  const double shift = 60.0 * unit(random) - 30.0;
  const double away = 20.0 + 40.0 * unit(random) + std::max(0.0, -200.0 * style.lean);
  std::vector<Vec2> outline = row(away, 1.0);
  std::vector<Vec2> back = row(away + 2.5 * style.roughness + 60.0, -1.0);
  outline.insert(outline.end(), back.rbegin(), back.rend());
  for (Vec2& p : outline)
    p.x() += shift;
  return outline;
}

inline std::vector<Chain> only(std::vector<Chain> chains, EdgeKind kind) {
  std::erase_if(chains, [&](const Chain& chain) { return chain.kind != kind; });
  return chains;
}

}  // namespace planish::test
