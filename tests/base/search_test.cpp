#include <planish/base/search.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <random>
#include <set>

namespace planish {
namespace {

/// Whatever is added between, what comes next is the best of all that is left.
TEST(Frontier, GivesTheBestOfWhatIsLeft) {
  std::mt19937 random(3);
  Frontier<int, std::less<>> frontier;
  std::multiset<int> left;
  for (int step = 0; step < 2000; ++step) {
    if (left.empty() || random() % 5 < 3) {
      const int node = static_cast<int>(random() % 100);
      frontier.add(node);
      left.insert(node);
    } else {
      EXPECT_EQ(frontier.best(), *left.rbegin());
      EXPECT_EQ(frontier.take(), *left.rbegin());
      left.erase(std::prev(left.end()));
    }
    EXPECT_EQ(frontier.empty(), left.empty());
  }
}

TEST(Frontier, TakesNodesThatCannotBeCopied) {
  const auto worse = [](const std::unique_ptr<int>& a, const std::unique_ptr<int>& b) {
    return *a > *b;
  };
  Frontier<std::unique_ptr<int>, decltype(worse)> frontier(worse);
  for (const int node : {3, 1, 2})
    frontier.add(std::make_unique<int>(node));
  for (const int node : {1, 2, 3})
    EXPECT_EQ(*frontier.take(), node);
  EXPECT_TRUE(frontier.empty());
}

}  // namespace
}  // namespace planish
