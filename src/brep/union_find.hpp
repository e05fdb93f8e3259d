#pragma once

#include <numeric>
#include <vector>

namespace planish::brep {

/// Sets of 0 … count − 1 that are joined step by step.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// The member that stands for the set of i; the same for all its members.
  int root(int i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The root of b stands for both sets.
  void join(int a, int b) { parent_[root(a)] = root(b); }

 private:
  std::vector<int> parent_;
};

}  // namespace planish::brep
