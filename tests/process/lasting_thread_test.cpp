#include "lasting_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

namespace planish::process {
namespace {

TEST(LastingThread, IsOneThreadForAll) {
  std::thread::id first, second;
  std::thread([&] {
    LastingThread::of_process().run([&] { return first = std::this_thread::get_id(), 0; });
  }).join();
  std::thread([&] {
    LastingThread::of_process().run([&] { return second = std::this_thread::get_id(), 0; });
  }).join();
  EXPECT_EQ(first, second) << "it outlives those who asked";
  EXPECT_NE(first, std::this_thread::get_id());
}

TEST(LastingThread, GivesEachWhatItsWorkGave) {
  std::vector<int> results(8);
  std::vector<std::thread> threads;
  std::atomic<int> at_work = 0, most = 0;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      results[i] = LastingThread::of_process().run([&, i] {
        most = std::max(most.load(), ++at_work);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        --at_work;
        return i * i;
      });
    });
  for (std::thread& thread : threads)
    thread.join();
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(results[i], i * i);
  EXPECT_EQ(most, 1) << "one after the other";
}

TEST(LastingThread, HandsOnAnExceptionAndGoesOn) {
  EXPECT_THROW(LastingThread::of_process().run([]() -> int { throw std::runtime_error("x"); }),
               std::runtime_error);
  EXPECT_EQ(LastingThread::of_process().run([] { return 7; }), 7);
}

TEST(LastingThread, LeavesSignalsToOthers) {
  const int blocked = LastingThread::of_process().run([] {
    sigset_t now;
    pthread_sigmask(SIG_SETMASK, nullptr, &now);
    return sigismember(&now, SIGTERM) + sigismember(&now, SIGINT);
  });
  EXPECT_EQ(blocked, 2);
}

}  // namespace
}  // namespace planish::process
