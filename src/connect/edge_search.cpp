#include "chain_pair.hpp"
#include "refusals.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

// The widest bend that is little longer than the shortest (math.md#widest-bend), exactly. The
// reference bend of all pairs of chains is found first, and its length bounds what each pair is
// worth; pairs come nearest first, so most are left out at one look. Within a pair runs are
// searched by branch and bound (widest_bend.cpp). The result is that of the mixed-integer programs
// [thesis 99, 114], but for their linearised arcs.

namespace planish {
namespace {

using namespace connect_detail;

using Sides = std::array<std::vector<Chain>, 2>;

/// The place of given edges: the chain, and the positions of the first and the last.
struct Spot {
  int chain = 0;
  std::pair<int, int> run;
};

/// Several where bends have left parts of an edge.
std::vector<Spot> places_in(const std::vector<Chain>& chains, const std::vector<int>& edges) {
  const std::set<int> wanted(edges.begin(), edges.end());
  std::vector<Spot> places;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    int first = -1, last = -1, found = 0;
    for (std::size_t j = 0; j < chains[c].edges.size(); ++j) {
      if (wanted.count(chains[c].edges[j]) == 0) continue;
      if (first < 0) first = static_cast<int>(j);
      last = static_cast<int>(j);
      ++found;
    }
    if (found == static_cast<int>(wanted.size()) && last - first + 1 == found)
      places.push_back({static_cast<int>(c), {first, last}});
  }
  return places;
}

tl::unexpected<Error> no_bend_on(const std::vector<int>& edges) {
  Facts facts{{"noun", edges.size() == 1 ? "edge" : "edges"}};
  for (const int edge : edges)
    facts.emplace_back("edge", edge);
  return fail(refuse::edges_of_no_bend, facts);
}

using Places = std::array<std::optional<std::vector<Spot>>, 2>;

/// The places of the given edges.
Result<Places> places_of(const Sides& sides, const EdgeSearchOptions& options) {
  Places places;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!options.edges[i]) continue;
    places[i] = places_in(sides[i], *options.edges[i]);
    if (places[i]->empty()) return no_bend_on(*options.edges[i]);
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

const Spot* place_in(const std::optional<std::vector<Spot>>& places, std::size_t chain) {
  for (const Spot& place : *places)
    if (place.chain == static_cast<int>(chain)) return &place;
  return nullptr;
}

/// Two chains of one kind, one per side, that contain the given edges. Plates with many openings
/// have many such pairs: what no bend between them can be shorter or wider than takes one look.
struct Candidate {
  std::array<std::size_t, 2> rows{};
  double shortest = 0.0;  ///< no bend between them is shorter, nor has it a smaller span
  double widest = 0.0;
};

/// What `search_edges` searches.
struct Search {
  const Sides& sides;
  const Places& places;
  Angle beta;
  const EdgeSearchOptions& options;
  Envelopes envelopes = envelopes_of(sides);
  std::vector<Candidate> candidates = {};

  ChainPair pair(const Candidate& candidate) const {
    ChainPair pair;
    std::array<CornerRange, 2> whole;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t row = candidate.rows[i];
      pair.chains[i] = static_cast<int>(row);
      pair.sides[i] = &sides[i][row];
      pair.envelopes[i] = &envelopes[i][row];
      if (places[i]) pair.fixed[i] = place_in(places[i], row)->run;
      whole[i] = {pair.envelopes[i], 0, static_cast<int>(pair.sides[i]->corners.size()) - 1};
    }
    pair.kind = pair.sides[0]->kind;
    pair.size = size_of(whole);
    pair.factor = arc_factor(beta, pair.kind, kLinearisedSlope);
    pair.line = options.line;
    return pair;
  }
};

std::vector<Candidate> candidates_of(const Search& search) {
  std::array<std::vector<double>, 2> heights;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Chain& chain : search.sides[i])
      heights[i].push_back(box_of(chain.corners).lo.y());
  const auto of_height = [&](EdgeKind kind) {
    const auto& chains = search.sides[0];
    if (std::ranges::none_of(chains, [&](const Chain& c) { return c.kind == kind; })) return 0.0;
    const double half = 0.5 * arc_factor(search.beta, kind, kLinearisedSlope);
    return kind == EdgeKind::facing ? std::min(half, 1.0) : half;
  };
  const double facing = of_height(EdgeKind::facing), averted = of_height(EdgeKind::averted);
  const auto width = [](const Chain& c) { return c.corners.back().x() - c.corners.front().x(); };
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < search.sides[0].size(); ++a) {
    if (search.places[0] && !place_in(search.places[0], a)) continue;
    const Chain& first = search.sides[0][a];
    for (std::size_t b = 0; b < search.sides[1].size(); ++b) {
      const Chain& second = search.sides[1][b];
      if (first.kind != second.kind || (search.places[1] && !place_in(search.places[1], b)))
        continue;
      const double share = first.kind == EdgeKind::facing ? facing : averted;
      candidates.push_back(
          {{a, b}, share * (heights[0][a] + heights[1][b]), 0.5 * (width(first) + width(second))});
    }
  }
  return candidates;
}

std::vector<Candidate> nearest_first(std::vector<Candidate> candidates) {
  std::ranges::stable_sort(candidates, {}, &Candidate::shortest);
  return candidates;
}

double noise_of(const Search& search) {
  double size = 0.0;
  for (const auto& chains : search.sides)
    for (const Chain& chain : chains)
      for (const Vec2& p : chain.corners)
        size = std::max(size, p.cwiseAbs().maxCoeff());
  return kEqualWidths * size;
}

/// The length of the reference bend; infinite if there is none.
double shortest_length(const Search& search, double noise) {
  double length = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : nearest_first(search.candidates)) {
    if (candidate.shortest > length + noise) break;
    if (const auto bend = reference_bend(search.pair(candidate), length)) length = bend->length;
  }
  return length;
}

bool faces(const std::vector<Chain>& chains, EdgeKind kind) {
  return std::ranges::any_of(chains, [&](const Chain& chain) { return chain.kind == kind; });
}

tl::unexpected<Error> nothing_fits(const Sides& sides) {
  for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted})
    if (faces(sides[0], kind) && faces(sides[1], kind)) return fail(refuse::no_line);
  return fail(refuse::no_edges_alike, {{"chains", sides[0].size()}, {"chains", sides[1].size()}});
}

/// The next best choices: the best of each other pair of chains, nearest pairs first.
std::vector<EdgeChoice> alternatives(const Search& search, const EdgeSearch& found, double noise) {
  const auto count = static_cast<std::size_t>(std::max(0, search.options.alternatives));
  std::vector<std::pair<Candidate, ReferenceBend>> others;
  for (const Candidate& candidate : nearest_first(search.candidates)) {
    const bool same = static_cast<int>(candidate.rows[0]) == found.best.runs[0].chain &&
                      static_cast<int>(candidate.rows[1]) == found.best.runs[1].chain;
    if (same) continue;
    if (others.size() == count && candidate.shortest > others.back().second.length + noise) break;
    const auto reference = reference_bend(search.pair(candidate),
                                          std::numeric_limits<double>::infinity());
    if (!reference) continue;
    const auto later = std::ranges::upper_bound(
        others, reference->length, {}, [](const auto& other) { return other.second.length; });
    others.insert(later, {candidate, *reference});
    if (others.size() > count) others.pop_back();
  }
  std::vector<EdgeChoice> choices;
  for (const auto& [candidate, reference] : others)
    if (auto best = widest_bend(search.pair(candidate), reference.choice, search.options.trade_off,
                                std::nullopt))
      choices.push_back(std::move(*best));
  std::ranges::stable_sort(choices, std::ranges::greater(), &EdgeChoice::width);
  return choices;
}

/// The widest bend of all pairs of chains whose span is at most `budget`.
std::optional<EdgeChoice> widest_within(const Search& search, double budget, double noise) {
  EdgeChoice limit;
  limit.span = budget;
  std::optional<EdgeChoice> best;
  for (const Candidate& candidate : search.candidates) {
    if (candidate.shortest > budget + noise || (best && candidate.widest < best->width - noise))
      continue;
    if (auto wider = widest_bend(search.pair(candidate), limit, 0.0, best))
      best = std::move(*wider);
  }
  return best;
}

/// The widest bend of those whose span is smallest.
std::optional<EdgeChoice> shortest_bend(const Search& search, double noise) {
  std::optional<EdgeChoice> shortest;
  for (const Candidate& candidate : nearest_first(search.candidates)) {
    if (shortest && candidate.shortest > shortest->span + noise) break;
    if (auto shorter = least_span(search.pair(candidate), shortest)) shortest = *shorter;
  }
  if (!shortest) return std::nullopt;
  return widest_within(search, shortest->span, noise);
}

}  // namespace

std::vector<EdgeChoice> efficient_edges(const Sides& sides, Angle beta,
                                        const EdgeSearchOptions& options, int most) {
  const auto places = places_of(sides, options);
  if (!places) return {};
  Search search{sides, *places, beta, options};
  search.candidates = candidates_of(search);
  const double noise = noise_of(search);
  const auto shortest = shortest_bend(search, noise);
  if (!shortest) return {};
  std::vector<EdgeChoice> efficient;
  double budget = std::numeric_limits<double>::infinity();
  while (std::ssize(efficient) + 1 < most) {
    constexpr double kShorter = 4.0;  // times the noise that every search allows
    auto next = widest_within(search, budget, noise);
    if (!next || next->span <= shortest->span + kShorter * noise) break;
    budget = next->span - kShorter * noise;
    efficient.push_back(std::move(*next));
  }
  efficient.push_back(*shortest);
  return efficient;
}

Result<EdgeSearch> search_edges(const Sides& sides, Angle beta, const EdgeSearchOptions& options) {
  const auto places = places_of(sides, options);
  if (!places) return pass_on(places);
  Search search{sides, *places, beta, options};
  search.candidates = candidates_of(search);
  const double noise = noise_of(search), length = shortest_length(search, noise);
  if (!std::isfinite(length)) return nothing_fits(sides);
  EdgeSearch found;
  found.reference_length = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : search.candidates) {
    if (candidate.shortest > length + noise) continue;
    if (const auto bend = reference_bend(search.pair(candidate), found.reference_length)) {
      found.reference = bend->choice;
      found.reference_length = bend->length;
    }
  }
  std::optional<EdgeChoice> best;
  const double budget = found.reference.span - options.trade_off * found.reference.width + noise;
  for (const Candidate& candidate : search.candidates) {
    const bool hopeless = candidate.shortest - options.trade_off * candidate.widest > budget ||
                          (best && candidate.widest < best->width - noise);
    if (hopeless) continue;
    if (auto wider = widest_bend(search.pair(candidate), found.reference, options.trade_off, best))
      best = std::move(*wider);
  }
  found.best = best.value_or(found.reference);
  if (options.alternatives > 0) found.alternatives = alternatives(search, found, noise);
  return found;
}

}  // namespace planish
