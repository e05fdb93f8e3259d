#include "terminal.hpp"

#include "option_parts.hpp"

#include <planish/job/options.hpp>
#include <planish/schema/printable.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

namespace planish::cli {
namespace {

constexpr int kRefusedStatus = 4;
constexpr std::chrono::seconds kPatience(1);
constexpr auto kClearLine = "\r\033[K";

// A signal handler can only use a global.
std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void ask_to_stop(int) { stop_asked = true; }

/// A place within an option is that option on the command line.
std::string spelled_place(const std::string& where) {
  const job::Option* option = job::option_at(where);
  return option ? flag_of(option->name) : where;
}

std::string sentence(const Error& error) {
  std::string text = "planish: ";
  if (exit_status(error.code) == kRefusedStatus) text += "refused: ";
  if (error.code == ErrorCode::internal) text += "internal error, please report it: ";
  text += spelled(error.message);
  if (text.back() == '.') text.pop_back();  // the sentence continues
  if (error.code == ErrorCode::cancelled) return text;
  text += fmt::format(" [{}]", code_name(error.code));
  // Most messages name the place themselves.
  const std::string where = spelled_place(error.where);
  if (!where.empty() && text.find(where) == std::string::npos) text += fmt::format(" ({})", where);
  return text;
}

}  // namespace

int complain(const Error& error) {
  fmt::print(stderr, "{}\n", schema::printable(sentence(error)));
  return exit_status(error.code);
}

void stop_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return stop_asked; }

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted && isatty(STDERR_FILENO)), start_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(kClearLine, stderr);
}

Progress ProgressLine::progress() {
  Progress progress;
  progress.cancelled = interrupted;
  if (wanted_) {
    progress.report = [this](std::string_view stage, double share) { show(stage, share); };
  }
  return progress;
}

void ProgressLine::show(std::string_view stage, double share) {
  if (std::chrono::steady_clock::now() - start_ < kPatience) return;
  fmt::print(stderr, "{}{:3.0f} %  {}", kClearLine, 100.0 * share, schema::printable(stage));
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace planish::cli
