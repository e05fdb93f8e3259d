#pragma once

#include "served_work.hpp"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace planish::serve {

/// A request on its way. `progress` and `done` are called by the thread that works on it; `done`
/// once.
struct Ticket {
  WorkTask task;
  std::chrono::milliseconds time{};
  std::function<void(std::string_view stage, double share)> progress;
  std::function<void(Result<WorkDone> done)> done;
  std::atomic<bool> cancelled = false;
};

/// Processes that work on tickets, the oldest first, each with a thread that waits for it. A
/// process lasts from request to request, and is replaced when it is lost.
class Crew {
 public:
  Crew(int jobs, const process::Limits& limits);
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  /// Cancels everything.
  ~Crew();

  void add(std::shared_ptr<Ticket> ticket);
  /// Tickets that are not done yet.
  std::size_t open() const;

 private:
  void work(bool at_once);
  /// The next ticket; null at the end.
  std::shared_ptr<Ticket> next();

  const process::Limits limits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Ticket>> waiting_;
  std::size_t open_ = 0;
  std::atomic<bool> ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace planish::serve
