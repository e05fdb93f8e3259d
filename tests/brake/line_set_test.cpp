#include "line_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr int kLines = 150;  // more than two words

struct Both {
  LineSet bits = no_lines(kLines);
  std::set<int> names = {};
};

Both random_set(std::mt19937& random) {
  Both both;
  for (int i = 0; i < 20; ++i) {
    const int line = static_cast<int>(random() % kLines);
    insert(both.bits, line);
    both.names.insert(line);
  }
  return both;
}

/// As sets of numbers do.
TEST(LineSet, BehavesLikeASet) {
  std::mt19937 random(4);
  for (int run = 0; run < 200; ++run) {
    const Both a = random_set(random), b = random_set(random);
    EXPECT_EQ(members(a.bits), std::vector<int>(a.names.begin(), a.names.end()));
    EXPECT_EQ(count(a.bits), static_cast<int>(a.names.size()));
    EXPECT_EQ(first_line(a.bits), *a.names.begin());
    std::set<int> either = a.names, shared;
    either.insert(b.names.begin(), b.names.end());
    std::ranges::set_intersection(a.names, b.names, std::inserter(shared, shared.end()));
    EXPECT_EQ(members(joined(a.bits, b.bits)), std::vector<int>(either.begin(), either.end()));
    EXPECT_EQ(members(common(a.bits, b.bits)), std::vector<int>(shared.begin(), shared.end()));
    EXPECT_EQ(disjoint(a.bits, b.bits), shared.empty());
    EXPECT_TRUE(within(a.bits, joined(a.bits, b.bits)));
    EXPECT_EQ(within(a.bits, b.bits), std::ranges::includes(b.names, a.names));
    for (int line = 0; line < kLines; ++line)
      EXPECT_EQ(holds(a.bits, line), a.names.contains(line));
  }
}

TEST(LineSet, HoldsNoneOneOrAllOfTheLines) {
  for (const int lines : {1, 63, 64, 65, 128, 130}) {
    EXPECT_EQ(count(no_lines(lines)), 0);
    EXPECT_EQ(count(all_lines(lines)), lines);
    EXPECT_EQ(all_lines(lines).size(), no_lines(lines).size());
    EXPECT_EQ(members(only(lines, lines - 1)), std::vector<int>{lines - 1});
  }
}

}  // namespace
}  // namespace planish::test
