#pragma once

#include <chrono>
#include <mutex>

namespace planish::studio {

/// Knows whether a page is open: each browser holds one request while it shows the page.
/// Thread-safe.
class Presence {
 public:
  using Clock = std::chrono::steady_clock;

  void arrive();
  void leave();
  /// For how long no page has been open: since the last one left, or since the beginning; zero
  /// while there is one.
  Clock::duration absence() const;

 private:
  mutable std::mutex mutex_;
  int open_ = 0;
  Clock::time_point since_ = Clock::now();
};

}  // namespace planish::studio
