#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

namespace planish::python {

/// Throws the exception of the package that stands for the error. Requires the GIL.
[[noreturn]] void raise(const Error& error);

/// One piece of long work called from Python: it runs without the GIL, tells `listener` its stages,
/// and ends early when the listener raises or returns False, or a signal (Ctrl-C) raises.
class Call {
 public:
  /// `listener`: a callable (stage, share), or None. Requires the GIL, as do all other functions.
  explicit Call(pybind11::object listener);

  template <typename Work>
  auto run(Work work) {
    auto result = [&] {
      const pybind11::gil_scoped_release released;
      return work(progress());
    }();
    finish();
    if (!result) raise(result.error());
    return std::move(*result);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kBetween{50};  // calls back into Python

  Progress progress();
  void finish();
  void tell(std::string_view stage, double share);
  bool should_stop();
  /// Runs `call` with the GIL; what it raises ends the work and is raised by `finish`.
  template <typename Called>
  void into_python(Called call);

  pybind11::object listener_;
  std::mutex calling_;  ///< taken before the GIL is
  std::optional<pybind11::error_already_set> raised_;
  std::string stage_;
  Clock::time_point told_{}, asked_{};
  std::atomic<bool> stopped_ = false;
};

}  // namespace planish::python
