#include "chain_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace planish {
namespace {

using namespace connect_detail;

using Sides = std::array<std::vector<Chain>, 2>;

/// The place of given edges: the chain, and the positions of the first and the last.
struct Place {
  int chain = 0;
  std::pair<int, int> run;
};

std::optional<Place> place_of(const std::vector<Chain>& chains, const std::vector<int>& edges) {
  const std::set<int> wanted(edges.begin(), edges.end());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    int first = -1, last = -1, found = 0;
    for (std::size_t j = 0; j < chains[c].edges.size(); ++j) {
      if (wanted.count(chains[c].edges[j]) == 0) continue;
      if (first < 0) first = static_cast<int>(j);
      last = static_cast<int>(j);
      ++found;
    }
    if (found == static_cast<int>(wanted.size()) && last - first + 1 == found)
      return Place{static_cast<int>(c), {first, last}};
  }
  return std::nullopt;
}

std::string listed(const std::vector<int>& edges) {
  std::string text;
  for (const int e : edges)
    text += (text.empty() ? "" : ", ") + std::to_string(e);
  return text;
}

using Places = std::array<std::optional<Place>, 2>;

/// The places of the given edges.
Result<Places> places_of(const Sides& sides, const EdgeSearchOptions& options) {
  Places places;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!options.edges[i]) continue;
    places[i] = place_of(sides[i], *options.edges[i]);
    if (!places[i])
      return fail(ErrorCode::unknown_edge,
                  fmt::format("edges {} cannot carry one bend: they must follow each other, look "
                              "the same way, towards the line where the plates' planes meet or "
                              "away from it, lie on one side of it and be free",
                              listed(*options.edges[i])));
  }
  return places;
}

using Envelopes = std::array<std::vector<RunEnvelope>, 2>;

Envelopes envelopes_of(const Sides& sides) {
  Envelopes envelopes;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Chain& chain : sides[i])
      envelopes[i].emplace_back(chain.corners);
  return envelopes;
}

/// The pair of two chains, one per side, given by their indices.
ChainPair pair_of(const Sides& sides, const Envelopes& envelopes,
                  const std::array<std::size_t, 2>& rows, const Places& places) {
  ChainPair pair;
  std::array<CornerRange, 2> whole;
  for (std::size_t i = 0; i < 2; ++i) {
    pair.chains[i] = static_cast<int>(rows[i]);
    pair.sides[i] = &sides[i][rows[i]];
    pair.envelopes[i] = &envelopes[i][rows[i]];
    if (places[i]) pair.fixed[i] = places[i]->run;
    whole[i] = {pair.envelopes[i], 0, static_cast<int>(pair.sides[i]->corners.size()) - 1};
  }
  pair.kind = pair.sides[0]->kind;
  pair.size = size_of(whole);
  return pair;
}

/// All pairs of chains of one kind that contain the given edges.
std::vector<ChainPair> pairs_of(const Sides& sides, const Envelopes& envelopes,
                                const Places& places, Angle beta, const GivenLine& line) {
  std::vector<ChainPair> pairs;
  for (std::size_t a = 0; a < sides[0].size(); ++a)
    for (std::size_t b = 0; b < sides[1].size(); ++b) {
      const bool chosen = (!places[0] || places[0]->chain == static_cast<int>(a)) &&
                          (!places[1] || places[1]->chain == static_cast<int>(b));
      if (!chosen || sides[0][a].kind != sides[1][b].kind) continue;
      ChainPair& pair = pairs.emplace_back(pair_of(sides, envelopes, {a, b}, places));
      pair.factor = arc_factor(beta, pair.kind, kLinearisedSlope);
      pair.line = line;
    }
  return pairs;
}

bool faces(const std::vector<Chain>& chains, EdgeKind kind) {
  return std::any_of(chains.begin(), chains.end(),
                     [&](const Chain& chain) { return chain.kind == kind; });
}

Error nothing_fits(const Sides& sides) {
  for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted})
    if (faces(sides[0], kind) && faces(sides[1], kind))
      return {ErrorCode::no_bend_fits,
              "no tangent line that leaves both plates whole fits between any of their edges, with "
              "what is given",
              {}};
  return {ErrorCode::no_bend_fits,
          fmt::format("no edges look the same way on both plates (of {} and {} chains of edges): "
                      "turn a plate over or move it to the other side",
                      sides[0].size(), sides[1].size()),
          {}};
}

/// The next best choices: the best of each other pair of chains, nearest pairs first.
std::vector<EdgeChoice> alternatives(const std::vector<ChainPair>& pairs, const EdgeSearch& found,
                                     const EdgeSearchOptions& options) {
  std::vector<std::pair<const ChainPair*, ReferenceBend>> others;
  for (const ChainPair& pair : pairs) {
    const bool same = pair.chains[0] == found.best.runs[0].chain &&
                      pair.chains[1] == found.best.runs[1].chain;
    if (same) continue;
    if (const auto reference = reference_bend(pair, std::numeric_limits<double>::infinity()))
      others.emplace_back(&pair, *reference);
  }
  std::stable_sort(others.begin(), others.end(),
                   [](const auto& a, const auto& b) { return a.second.length < b.second.length; });
  if (static_cast<int>(others.size()) > options.alternatives)
    others.resize(static_cast<std::size_t>(std::max(0, options.alternatives)));
  std::vector<EdgeChoice> choices;
  for (const auto& [pair, reference] : others)
    if (auto best = widest_bend(*pair, reference.choice, options.trade_off, std::nullopt))
      choices.push_back(std::move(*best));
  std::stable_sort(choices.begin(), choices.end(),
                   [](const EdgeChoice& a, const EdgeChoice& b) { return a.width > b.width; });
  return choices;
}

}  // namespace

Result<EdgeSearch> search_edges(const Sides& sides, Angle beta, const EdgeSearchOptions& options) {
  const auto places = places_of(sides, options);
  if (!places) return tl::unexpected(places.error());
  const Envelopes envelopes = envelopes_of(sides);
  const std::vector<ChainPair> pairs = pairs_of(sides, envelopes, *places, beta, options.line);
  EdgeSearch found;
  found.reference_length = std::numeric_limits<double>::infinity();
  for (const ChainPair& pair : pairs)
    if (const auto reference = reference_bend(pair, found.reference_length)) {
      found.reference = reference->choice;
      found.reference_length = reference->length;
    }
  if (!std::isfinite(found.reference_length)) return tl::unexpected(nothing_fits(sides));
  std::optional<EdgeChoice> best;
  for (const ChainPair& pair : pairs)
    if (auto wider = widest_bend(pair, found.reference, options.trade_off, best))
      best = std::move(*wider);
  found.best = best.value_or(found.reference);
  if (options.alternatives > 0) found.alternatives = alternatives(pairs, found, options);
  return found;
}

}  // namespace planish
