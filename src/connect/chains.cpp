#include <planish/base/tolerance.hpp>
#include <planish/connect/edge_search.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>

// An outline as chains of edges that can carry a bend. An edge's outward normal tells whether it
// faces the intersection line or is averted from it; x grows along all edges of one kind, so a
// chain ends where the kind changes and never closes a loop. Steep edges and edges that cross the
// line carry none. The tolerances are shares of the extent, with steepness as of the sides of
// reliefs, which no file draws exactly.

namespace planish {
namespace {

// Share of the outline's extent: corners closer to the intersection line lie on it, edges with
// smaller |Δx| are parallel to the y axis.
constexpr double kOnAxis = tolerance::kComputed;
// Edges this steep (Δx over Δy, 0.06°) are parallel to the y axis as well: they are the sides of
// reliefs, which no file draws exactly.
constexpr double kSteep = 1e-3;

enum class Use { none, facing, averted };

std::vector<Use> uses_of(const std::vector<Vec2>& corners, double tolerance) {
  const std::size_t n = corners.size();
  const bool counter_clockwise = ring_area(corners) > 0.0;
  std::vector<Use> uses(n, Use::none);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[(i + 1) % n];
    const double across = std::abs(b.x() - a.x()), up = std::abs(b.y() - a.y());
    if (a.y() < 0.0 || b.y() < 0.0 || across <= tolerance || across <= kSteep * up) continue;
    // The outward normal of a counter-clockwise outline is (Δy, −Δx).
    uses[i] = (b.x() > a.x()) == counter_clockwise ? Use::facing : Use::averted;
  }
  return uses;
}

Chain chain_from(const std::vector<Vec2>& corners, Use use, std::size_t start, std::size_t count) {
  const std::size_t n = corners.size();
  Chain chain;
  chain.kind = use == Use::facing ? EdgeKind::facing : EdgeKind::averted;
  chain.corners.push_back(corners[start]);
  for (std::size_t j = 0; j < count; ++j) {
    chain.edges.push_back(static_cast<int>((start + j) % n));
    chain.corners.push_back(corners[(start + j + 1) % n]);
  }
  if (chain.corners.front().x() > chain.corners.back().x()) {
    std::ranges::reverse(chain.corners);
    std::ranges::reverse(chain.edges);
  }
  return chain;
}

}  // namespace

std::vector<Chain> viable_chains(const std::vector<Vec2>& outline) {
  if (outline.size() < 3) return {};
  const double tolerance = kOnAxis * box_of(outline).size().norm();
  std::vector<Vec2> corners = outline;
  for (Vec2& p : corners)
    if (std::abs(p.y()) <= tolerance) p.y() = 0.0;
  const std::vector<Use> uses = uses_of(corners, tolerance);
  const std::size_t n = corners.size();
  // Begin where a chain begins; x cannot grow all around a polygon, so there is such a place.
  std::size_t begin = 0;
  while (begin < n && uses[begin] == uses[(begin + n - 1) % n])
    ++begin;
  if (begin == n) return {};
  std::vector<Chain> chains;
  for (std::size_t done = 0; done < n;) {
    const std::size_t start = (begin + done) % n;
    std::size_t count = 1;
    while (done + count < n && uses[(start + count) % n] == uses[start])
      ++count;
    if (uses[start] != Use::none) chains.push_back(chain_from(corners, uses[start], start, count));
    done += count;
  }
  const auto lowest = [](const Chain& chain) { return std::ranges::min(chain.edges); };
  std::ranges::sort(chains, {}, lowest);
  return chains;
}

}  // namespace planish
