#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <queue>

namespace planish::job {

/// A thread that lives as long as the process, for what ends with the thread that began it: the
/// system ends a child with the thread that started it (PR_SET_PDEATHSIG).
class LastingThread {
 public:
  static LastingThread& of_process();

  /// What `work` returns, once that thread has done it.
  int run(std::function<int()> work);

 private:
  LastingThread();
  void work_on();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<std::packaged_task<int()>> tasks_;
};

}  // namespace planish::job
