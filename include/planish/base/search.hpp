#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace planish {

/// What a search has found and not yet looked at: the most promising comes first. `worse(a, b)`
/// orders it; of nodes of which neither is worse any may come first, the same ones in every run.
/// O(log n) to add and to take.
template <typename Node, typename Worse>
class Frontier {
 public:
  explicit Frontier(Worse worse = {}) : worse_(std::move(worse)) {}

  bool empty() const { return nodes_.empty(); }
  /// Requires that there is one; as does `take`.
  const Node& best() const { return nodes_.front(); }
  void add(Node node) {
    nodes_.push_back(std::move(node));
    std::push_heap(nodes_.begin(), nodes_.end(), worse_);
  }
  /// The best one, which is then no longer in it.
  Node take() {
    std::pop_heap(nodes_.begin(), nodes_.end(), worse_);
    Node node = std::move(nodes_.back());
    nodes_.pop_back();
    return node;
  }

 private:
  Worse worse_;
  std::vector<Node> nodes_;
};

}  // namespace planish
