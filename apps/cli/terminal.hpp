#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>

#include <chrono>
#include <string_view>

namespace planish::cli {

/// One line on standard error: "planish: <message> [code] (<where>)". Returns the exit status that
/// belongs to the error.
int complain(const Error& error);

/// The first Ctrl-C (or SIGTERM) asks running work to stop; the second ends the program.
void stop_on_interrupt();
bool interrupted();

/// Progress of long work on a line of standard error that is erased at the end; only on a terminal,
/// and only after the work has taken a second.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// To be passed to the work: reports to this line, cancelled by Ctrl-C.
  Progress progress();

 private:
  void show(std::string_view stage, double share);

  bool shown_ = false;
  bool wanted_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace planish::cli
