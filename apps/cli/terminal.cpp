#include "terminal.hpp"

#include "option_parts.hpp"

#include <planish/base/text.hpp>
#include <planish/job/options.hpp>
#include <planish/schema/printable.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace planish::cli {
namespace {

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
  if (error.code.status == ExitStatus::refused) text += "refused: ";
  if (error.code == code::internal) text += "internal error, please report it: ";
  text += continued(spelled(error));
  if (text.back() == '.') text.pop_back();  // the sentence continues
  if (error.code == code::cancelled) return text;
  text += fmt::format(" [{}]", code_name(error.code));
  // Most messages name the place themselves.
  const std::string where = spelled_place(error.where);
  if (!where.empty() && text.find(where) == std::string::npos) text += fmt::format(" ({})", where);
  return text;
}

/// A word as a shell reads it back.
std::string quoted(const std::string& word) {
  constexpr auto
      kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  return "'" + replaced(word, {{'\'', "'\\''"}}) + "'";
}

/// The words that this program was called with, as the system keeps them.
std::vector<std::string> own_command() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');)
    words.push_back(word);
  if (!words.empty()) words.front() = "planish";
  return words;
}

/// The command once more, with the option that helps in place of its value so far.
std::string command_with(const Remedy& remedy) {
  const job::Option* option = job::option_at(remedy.option);
  const std::string flag = flag_of(remedy.option);
  const bool is_flag = option && option->kind == job::OptionKind::flag;
  std::vector<std::string> words = own_command();
  for (std::size_t i = 0; i < words.size();) {
    const bool both = words[i] == flag && !is_flag && i + 1 < words.size();
    if (words[i] != flag && !words[i].starts_with(flag + "=")) {
      ++i;
      continue;
    }
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                words.begin() + static_cast<std::ptrdiff_t>(i + (both ? 2 : 1)));
  }
  words.push_back(flag);
  if (!is_flag) words.push_back(remedy.value);
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}

}  // namespace

int complain(const Error& error) {
  fmt::print(stderr, "{}\n", schema::printable(sentence(error)));
  for (const Remedy& remedy : error.remedies)
    if (!remedy.option.empty())
      fmt::print(stderr, "try: {}\n", schema::printable(command_with(remedy)));
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
