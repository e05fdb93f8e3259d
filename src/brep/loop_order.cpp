#include "loop_order.hpp"

#include <algorithm>

namespace planish::brep {
namespace {

int vertex_of(const SolidEdge& edge, const CoEdge& use, bool last) {
  return edge.vertices[use.forward == last ? 1 : 0];
}

const Vec3& start_of(const SolidEdge& edge, const CoEdge& use) {
  return use.forward ? edge.curve.start : edge.curve.end;
}

const Vec3& end_of(const SolidEdge& edge, const CoEdge& use) {
  return use.forward ? edge.curve.end : edge.curve.start;
}

}  // namespace

bool in_order(const std::vector<SolidEdge>& edges, const std::vector<CoEdge>& loop) {
  for (size_t i = 0; i < loop.size(); ++i) {
    const CoEdge& next = loop[(i + 1) % loop.size()];
    if (vertex_of(edges[loop[i].edge], loop[i], true) != vertex_of(edges[next.edge], next, false))
      return false;
  }
  return true;
}

std::vector<CoEdge> chained(const std::vector<SolidEdge>& edges, std::vector<CoEdge> uses) {
  for (auto at = uses.begin(); at != uses.end() && at + 1 != uses.end(); ++at) {
    const Vec3 end = end_of(edges[at->edge], *at);
    const auto distance = [&](const CoEdge& use) {
      return (start_of(edges[use.edge], use) - end).squaredNorm();
    };
    const auto next = std::ranges::min_element(at + 1, uses.end(), {}, distance);
    // The others keep their order, so that of two equally near the first is taken.
    std::rotate(at + 1, next, next + 1);
  }
  return uses;
}

}  // namespace planish::brep
