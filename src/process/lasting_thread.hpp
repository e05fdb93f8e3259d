#pragma once

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <queue>

namespace planish::process {

/// A thread that lives as long as the process. Children are started from it, because the system
/// ends a child with the thread that started it (PR_SET_PDEATHSIG).
class LastingThread {
 public:
  static LastingThread& of_process();

  /// Runs `work` on that thread and returns its result.
  int run(std::function<int()> work);

 private:
  LastingThread();
  void work_on();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<std::packaged_task<int()>> tasks_;
};

}  // namespace planish::process
