#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

namespace planish::studio {

/// Admits a number of callers at once; the others wait.
class Turns {
 public:
  explicit Turns(int most) : free_(most) {}

  /// A place, given back on destruction; holds none if `given_up` became true while waiting.
  class Turn {
   public:
    explicit Turn(Turns* of) : of_(of) {}
    Turn(Turn&& other) noexcept : of_(std::exchange(other.of_, nullptr)) {}
    Turn& operator=(Turn&&) = delete;
    ~Turn() {
      if (of_) of_->give_back();
    }
    explicit operator bool() const { return of_ != nullptr; }

   private:
    Turns* of_;
  };

  Turn take(const std::function<bool()>& given_up) {
    std::unique_lock lock(mutex_);
    while (free_ == 0) {
      if (given_up()) return Turn(nullptr);
      changed_.wait_for(lock, kPace);
    }
    --free_;
    return Turn(this);
  }

 private:
  static constexpr std::chrono::milliseconds kPace{50};

  void give_back() {
    {
      const std::lock_guard lock(mutex_);
      ++free_;
    }
    changed_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  int free_;
};

}  // namespace planish::studio
