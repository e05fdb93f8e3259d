#include "exchange_lock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace planish::brep {
namespace {

TEST(ExchangeLock, IsHeldByOneThreadAtATime) {
  std::atomic<int> inside = 0, most = 0, passes = 0;
  const auto work = [&] {
    for (int i = 0; i < 5; ++i) {
      const auto lock = exchange_lock();
      EXPECT_TRUE(lock.owns_lock());
      most = std::max(most.load(), ++inside);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --inside;
      ++passes;
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back(work);
  threads.clear();
  EXPECT_EQ(passes, 20);
  EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace planish::brep
