#include "outline_run.hpp"

#include "bend_frame.hpp"
#include "tolerances.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

// Runs of edges, and what bends leave of them. An edge is used in shares of its length, so that a
// bend narrower than its edge leaves the rest to others; a rest shorter than the thickness goes
// with the run. Chains are broken where an edge is taken and keep the numbers of their edges.

namespace planish::connect_detail {
namespace {

// An end within this share of an edge of its corner is the corner.
constexpr double kAtCorner = tolerance::kComputed;

std::pair<Vec2, Vec2> ends_of(const PlacedPlate& plate, int ring, int corner) {
  const std::vector<Vec2>& corners = plate.ring(ring);
  const std::size_t n = corners.size(), k = static_cast<std::size_t>(corner) % n;
  return {corners[k], corners[(k + 1) % n]};
}

double share_of(const std::pair<Vec2, Vec2>& edge, const Vec2& p) {
  const Vec2 along = edge.second - edge.first;
  const double share = (p - edge.first).dot(along) / along.squaredNorm();
  if (share < kAtCorner) return 0.0;
  return share > 1.0 - kAtCorner ? 1.0 : share;
}

Vec2 at_share(const std::pair<Vec2, Vec2>& edge, double share) {
  if (share == 0.0) return edge.first;
  if (share == 1.0) return edge.second;
  return edge.first + share * (edge.second - edge.first);
}

}  // namespace

void ChainParts::add(const Vec2& from, const Vec2& to, int edge) {
  if (part_.corners.empty()) part_.corners.push_back(from);
  part_.corners.push_back(to);
  part_.edges.push_back(edge);
}

void ChainParts::end() {
  if (!part_.edges.empty()) parts_.push_back(part_);
  part_ = Chain{part_.kind, {}, {}};
}

std::vector<Vec2> run_points(const PlacedPlate& plate, const OutlineRun& run) {
  std::vector<Vec2> points{at_share(ends_of(plate, run.ring, run.first), run.start)};
  for (int j = 1; j < run.count; ++j)
    points.push_back(ends_of(plate, run.ring, run.first + j).first);
  points.push_back(at_share(ends_of(plate, run.ring, run.first + run.count - 1), run.end));
  return points;
}

OutlineRun outline_run(const PlacedPlate& plate, const std::vector<int>& edges,
                       const std::pair<Vec3, Vec3>& ends) {
  const EdgePlace front = plate.place_of(edges.front()), back = plate.place_of(edges.back());
  const int n = static_cast<int>(plate.ring(front.ring).size());
  const bool ascending = edges.size() == 1 ||
                         (front.corner + 1) % n == plate.place_of(edges[1]).corner;
  const EdgePlace &first = ascending ? front : back, &last = ascending ? back : front;
  OutlineRun run{first.corner, static_cast<int>(edges.size()), first.ring};
  Vec2 from = plate.frame.local2(ends.first), to = plate.frame.local2(ends.second);
  if (!ascending) std::swap(from, to);
  run.start = share_of(ends_of(plate, first.ring, first.corner), from);
  run.end = share_of(ends_of(plate, last.ring, last.corner), to);
  if (edges.size() == 1 && run.start > run.end) std::swap(run.start, run.end);
  return run;
}

OutlineRun trimmed(const OutlineRun& run, const PlacedPlate& plate, const BendSurface& surface,
                   const Boundaries& boundaries, int side, double thickness) {
  if (run.count != 1) return run;
  const std::vector<Vec2> ends = run_points(plate, run);
  const Vec2 from = surface.local(side, plate.frame.point(ends.front()));
  const Vec2 to = surface.local(side, plate.frame.point(ends.back()));
  if (std::max(std::abs(from.y()), std::abs(to.y())) > kDrawn) return run;
  double low = boundaries.low.v[side], high = boundaries.high.v[side];
  const double length = to.x() - from.x(), per_length = (run.end - run.start) / length;
  if (length < 0.0) std::swap(low, high);
  OutlineRun rest = run;
  if (std::copysign(1.0, length) * (low - from.x()) > thickness)
    rest.start = run.start + (low - from.x()) * per_length;
  if (std::copysign(1.0, length) * (to.x() - high) > thickness)
    rest.end = run.end - (to.x() - high) * per_length;
  return rest;
}

void take(const PlacedPlate& plate, const OutlineRun& run, UsedEdges& used) {
  const int n = static_cast<int>(plate.ring(run.ring).size());
  for (int j = 0; j < run.count; ++j) {
    const int edge = plate.edge_number({run.ring, (run.first + j) % n});
    const double from = j == 0 ? run.start : 0.0, to = j + 1 == run.count ? run.end : 1.0;
    if (from > 0.0 || to < 1.0)
      used.parts[edge].emplace_back(from, to);
    else
      used.whole.insert(edge);
  }
}

std::vector<Chain> free_chains(const std::vector<Chain>& chains,
                               const std::map<int, EdgeParts>& taken, const PlacedPlate& plate,
                               const BendFrame& frame, int side, double least) {
  if (taken.empty()) return chains;
  std::vector<Chain> all;
  for (const Chain& chain : chains) {
    ChainParts parts(chain.kind, all);
    for (std::size_t j = 0; j < chain.edges.size(); ++j) {
      const Vec2 &a = chain.corners[j], &b = chain.corners[j + 1];
      const auto used = taken.find(chain.edges[j]);
      if (used == taken.end()) {
        parts.add(a, b, chain.edges[j]);
        continue;
      }
      const EdgePlace place = plate.place_of(chain.edges[j]);
      const Vec2 first = frame.local(
          side, plate.frame.point(ends_of(plate, place.ring, place.corner).first));
      EdgeParts free = left_free(used->second, 0.0, 1.0);
      if ((first - a).norm() > (first - b).norm()) {
        for (auto& [low, high] : free)
          std::tie(low, high) = std::pair{1.0 - high, 1.0 - low};
        std::ranges::reverse(free);
      }
      if (free.empty() || free.front().first > 0.0) parts.end();
      for (const auto& [low, high] : free) {
        if ((high - low) * (b - a).norm() >= least)
          parts.add(a + low * (b - a), a + high * (b - a), chain.edges[j]);
        if (high < 1.0) parts.end();
      }
    }
    parts.end();
  }
  return all;
}

std::vector<std::vector<Vec2>> local_rings(const PlacedPlate& plate, const BendSurface& surface,
                                           int side) {
  std::vector<std::vector<Vec2>> rings;
  for (int r = 0; r < plate.ring_count(); ++r)
    rings.push_back(mapped(
        plate.ring(r), [&](const Vec2& p) { return surface.local(side, plate.frame.point(p)); }));
  return rings;
}

}  // namespace planish::connect_detail
