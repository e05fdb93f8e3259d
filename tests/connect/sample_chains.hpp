#pragma once

#include "chain_pair.hpp"

#include <array>
#include <utility>
#include <vector>

namespace planish::test {

/// A pair of chains given by their corners, x growing, edges numbered from 0.
struct SamplePair {
  std::array<Chain, 2> chains;
  std::array<connect_detail::RunEnvelope, 2> envelopes;
  connect_detail::ChainPair pair;

  SamplePair(std::vector<Vec2> a, std::vector<Vec2> b, double factor,
             EdgeKind kind = EdgeKind::facing)
      : chains{chain(std::move(a), kind), chain(std::move(b), kind)},
        envelopes{connect_detail::RunEnvelope(chains[0].corners),
                  connect_detail::RunEnvelope(chains[1].corners)} {
    std::array<connect_detail::CornerRange, 2> whole;
    for (std::size_t i = 0; i < 2; ++i) {
      pair.sides[i] = &chains[i];
      pair.envelopes[i] = &envelopes[i];
      whole[i] = {&envelopes[i], 0, static_cast<int>(chains[i].corners.size()) - 1};
    }
    pair.kind = kind;
    pair.factor = factor;
    pair.size = connect_detail::size_of(whole);
  }
  SamplePair(const SamplePair&) = delete;
  SamplePair& operator=(const SamplePair&) = delete;

  static Chain chain(std::vector<Vec2> corners, EdgeKind kind) {
    Chain made{kind, std::move(corners), {}};
    for (int i = 0; i + 1 < static_cast<int>(made.corners.size()); ++i)
      made.edges.push_back(i);
    return made;
  }
};

}  // namespace planish::test
