#pragma once

#include <planish/geometry/mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace planish::test {

/// How often each side is run from its first corner to its second.
inline std::map<std::pair<int, int>, int> sides_of(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> runs;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++runs[{t[i], t[(i + 1) % 3]}];
  return runs;
}

/// Whether every side is run once in each direction.
inline bool is_closed(const Mesh& mesh) {
  std::vector<std::pair<int, int>> runs, back;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      runs.emplace_back(t[i], t[(i + 1) % 3]);
      back.emplace_back(runs.back().second, runs.back().first);
    }
  std::ranges::sort(runs);
  std::ranges::sort(back);
  return !runs.empty() && std::ranges::adjacent_find(runs) == runs.end() && runs == back;
}

/// Every side is run once in each direction: no hole, no flap, no triangle turned inside out.
inline void expect_closed(const Mesh& mesh) {
  const auto runs = sides_of(mesh);
  ASSERT_FALSE(runs.empty());
  for (const auto& [side, times] : runs) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(runs.count({side.second, side.first}), 1U);
  }
}

/// Of the space inside: the divergence theorem, triangle by triangle.
inline double volume_in(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6.0;
  return sum;
}

}  // namespace planish::test
