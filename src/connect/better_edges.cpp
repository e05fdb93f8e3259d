#include "better_edges.hpp"

#include "drawn_edges.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

// What a shop would choose in place of the search's optimum. The search weighs width against length
// alone (math.md#widest-bend), and so prefers edges round the back, beside each other, or in a
// recess, where these are a little wider. Each rule searches again among fewer chains: in front,
// opposite each other, drawn up to the bend. Edges in front replace those at the back unless the
// ratio of span to width is worse there; without a bend among the fewer chains the choice stays.

namespace planish::connect_detail {
namespace {

// Round the back only where that is shorter for its width than what is in front: of a toothed edge
// the search sees one tooth at a time, all of which a bend then joins.
PairChoice as_facing(PairChoice choice, const EdgeSearchOptions& wanted) {
  if (choice.search.best.kind == EdgeKind::facing || choice.frame.parallel()) return choice;
  PairChoice front{choice.frame, {}, {}};
  for (std::size_t i = 0; i < 2; ++i)
    front.chains[i] = of_kind(choice.chains[i], EdgeKind::facing);
  if (!search(front, wanted)) return choice;
  const Nearness back = nearness_of(choice), near = nearness_of(front);
  return near.span * back.width < back.span * near.width ? front : choice;
}

// The chains that pass a part of the line together with one of the other side.
std::array<std::vector<Chain>, 2> opposite(const std::array<std::vector<Chain>, 2>& chains) {
  std::array<std::vector<Chain>, 2> result;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Chain& chain : chains[i])
      if (std::ranges::any_of(chains[1 - i], [&](const Chain& other) {
            return chain.kind == other.kind && common_width(chain.corners, other.corners) > 0.0;
          }))
        result[i].push_back(chain);
  return result;
}

// The best choice of edges opposite each other, where the best of all lie beside each other: the
// ends of a long edge are far from those of a short wall, and those of a stub beside it near.
PairChoice as_opposite(PairChoice choice, const EdgeSearchOptions& wanted) {
  const auto corners = choice.corners(choice.search.best);
  if (wanted.edges[0] || wanted.edges[1] || common_width(corners[0], corners[1]) > 0.0)
    return choice;
  PairChoice facing{choice.frame, opposite(choice.chains), {}};
  return search(facing, wanted) ? facing : choice;
}

// Whether points lie on a tangent line.
bool is_on(const TangentLine& line, const std::vector<Vec2>& corners) {
  return std::ranges::all_of(
      corners, [&](const Vec2& p) { return std::abs(p.y() - line.at(p.x())) <= kDrawn; });
}

// On how much of a tangent line both sides have an edge.
double drawn_width(const PairChoice& choice, const TangentLine& line) {
  std::array<std::vector<std::pair<double, double>>, 2> drawn;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Chain& chain : choice.chains[i])
      for (std::size_t j = 0; j < chain.edges.size(); ++j)
        if (is_on(line, {chain.corners[j], chain.corners[j + 1]}))
          drawn[i].emplace_back(chain.corners[j].x(), chain.corners[j + 1].x());
  double width = 0.0;
  for (const auto& [low, high] : drawn[0])
    for (const auto& [from, to] : drawn[1])
      width += std::max(0.0, std::min(high, to) - std::max(low, from));
  return width;
}

// What is drawn up to the bend, where the best choice is a little wider but has to be extended: the
// teeth of an edge in place of a recess between them, an edge without the chamfers beside it.
PairChoice as_teeth(PairChoice choice, EdgeSearchOptions wanted) {
  const auto corners = choice.corners(choice.search.best);
  const TangentLine& line = choice.search.best.line;
  if (wanted.edges[0] || wanted.edges[1] || (is_on(line, corners[0]) && is_on(line, corners[1])))
    return choice;
  PairChoice shortest = choice;
  wanted.trade_off = 0.0;
  if (!search(shortest, wanted)) return choice;
  const double width = drawn_width(shortest, shortest.search.best.line);
  constexpr double kLittle = 0.8;  // of the width, which a chamfer or relief adds a little to
  return width > kLittle * common_width(corners[0], corners[1]) ? shortest : choice;
}

// Whether the edge of a run of one is parallel to the intersection line.
bool is_level(const std::vector<Vec2>& corners) {
  return corners.size() == 2 && std::abs(corners[0].y() - corners[1].y()) <= kDrawn;
}

// A straight edge that goes on far past the other plate's, parallel to it, and has to be extended
// to the bend, is used as far as they lie opposite each other: the rest of it stays where it is,
// for other bends.
PairChoice as_part(PairChoice choice, const FitTask& task, EdgeSearchOptions wanted) {
  const EdgeChoice& best = choice.search.best;
  const auto corners = choice.corners(best);
  if (!is_level(corners[0]) || !is_level(corners[1])) return choice;
  const double low = std::max(corners[0].front().x(), corners[1].front().x());
  const double high = std::min(corners[0].back().x(), corners[1].back().x());
  if (high - low <= task.thickness) return choice;
  PairChoice part{choice.frame, {}, {}};
  bool shorter = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 &a = corners[i].front(), &b = corners[i].back();
    const bool drawn = std::abs(a.y() - best.line.at(a.x())) <= kDrawn;
    const bool far = std::max(low - a.x(), b.x() - high) > high - low;
    const double least = drawn || !(far || task.shares_edges) ? HUGE_VAL : task.thickness;
    const double from = low - a.x() > least ? low : a.x();
    const double to = b.x() - high > least ? high : b.x();
    shorter |= from > a.x() || to < b.x();
    part.chains[i] = {{best.kind, {{from, a.y()}, {to, b.y()}}, choice.edges(best)[i]}};
  }
  if (!shorter || !search(part, wanted)) return choice;
  choice.search.best = part.search.best;
  for (std::size_t i = 0; i < 2; ++i) {
    choice.search.best.runs[i].chain = static_cast<int>(choice.chains[i].size());
    choice.chains[i].push_back(part.chains[i].front());
  }
  return choice;
}

// The choice with the edges that are drawn up to the bend, if it has such.
PairChoice as_drawn(PairChoice choice, const FitTask& task, EdgeSearchOptions wanted) {
  if (task.request.edges[0] || task.request.edges[1] || wanted.trade_off == 0.0) return choice;
  const auto edges = drawn_edges(choice);
  if (!edges) return choice;
  wanted.edges = {(*edges)[0], (*edges)[1]};
  const auto found = search_edges(choice.chains, choice.frame.beta, wanted);
  if (found) choice.search.best = found->best;
  return choice;
}

}  // namespace

std::vector<Chain> of_kind(std::vector<Chain> chains, EdgeKind kind) {
  std::erase_if(chains, [&](const Chain& chain) { return chain.kind != kind; });
  return chains;
}

Result<void> search(PairChoice& choice, const EdgeSearchOptions& wanted) {
  auto found = search_edges(choice.chains, choice.frame.beta, wanted);
  if (!found) return pass_on(found);
  choice.search = std::move(*found);
  return {};
}

PairChoice with_better_edges(PairChoice choice, const EdgeSearchOptions& wanted) {
  return as_teeth(as_opposite(as_facing(std::move(choice), wanted), wanted), wanted);
}

PairChoice with_used_parts(PairChoice choice, const FitTask& task,
                           const EdgeSearchOptions& wanted) {
  return as_part(as_drawn(std::move(choice), task, wanted), task, wanted);
}

}  // namespace planish::connect_detail
