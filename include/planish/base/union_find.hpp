#pragma once

#include <numeric>
#include <vector>

namespace planish {

/// Disjoint sets of the numbers 0 … count − 1. Nearly constant time per operation.
class UnionFind {
 public:
  explicit UnionFind(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The smallest number of the set that holds i.
  int root(int i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool same(int i, int j) { return root(i) == root(j); }
  /// False if both were already in one set.
  bool unite(int i, int j) {
    i = root(i);
    j = root(j);
    if (i == j) return false;
    if (i < j)
      parent_[j] = i;
    else
      parent_[i] = j;
    return true;
  }
  /// The number of sets.
  int count() {
    int sets = 0;
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i)
      sets += root(i) == i;
    return sets;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace planish
