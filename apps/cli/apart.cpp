#include "apart.hpp"

#include "option_parts.hpp"
#include "output_files.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/base/packed_error.hpp>
#include <planish/job/options.hpp>
#include <planish/process/worker.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace planish::cli {
namespace {

using process::Texts;
using std::chrono::steady_clock;

constexpr auto kOutcome = "outcome";

Texts texts_of(const Outcome& outcome) {
  Texts texts{kOutcome,
              outcome.json,
              outcome.output,
              outcome.aside,
              std::to_string(outcome.inputs.size()),
              std::to_string(outcome.files.size())};
  for (const auto& input : outcome.inputs)
    texts.push_back(input.string());
  for (const OutputFile& file : outcome.files)
    texts.insert(texts.end(), {file.path.string(), file.content});
  if (!outcome.error) return texts;
  const Texts error = packed(*outcome.error);
  texts.insert(texts.end(), error.begin(), error.end());
  return texts;
}

std::optional<Outcome> outcome_in(const Texts& texts) {
  constexpr std::size_t kOwn = 6;
  if (texts.size() < kOwn || texts[0] != kOutcome) return std::nullopt;
  Outcome outcome{.json = texts[1], .output = texts[2], .aside = texts[3]};
  const auto inputs = job::parse_number(texts[4]), files = job::parse_number(texts[5]);
  const auto rest = static_cast<double>(texts.size() - kOwn);
  if (!inputs || !files || *inputs < 0 || *files < 0 || *inputs + 2 * *files > rest)
    return std::nullopt;
  auto text = texts.begin() + kOwn;
  for (int i = 0; i < *inputs; ++i)
    outcome.inputs.emplace_back(*text++);
  for (int i = 0; i < *files; ++i, text += 2)
    outcome.files.push_back({*text, *(text + 1)});
  if (text == texts.end()) return outcome;
  outcome.error = unpacked({text, texts.end()});
  return outcome.error ? std::optional(std::move(outcome)) : std::nullopt;
}

std::string name_of(const std::string& input) {
  return input == "-" ? "standard input" : std::filesystem::path(input).filename().string();
}

/// Prints a text; the reason why not. A reader that has gone wants no more, which is no failure.
Result<void> printed(const std::string& text) {
  auto* const before = std::signal(SIGPIPE, SIG_IGN);
  errno = 0;
  std::fwrite(text.data(), 1, text.size(), stdout);
  const bool done = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  const bool unread = errno == EPIPE;
  std::signal(SIGPIPE, before);
  if (unread) std::clearerr(stdout);  // what is left of the text ends the program, as elsewhere
  if (done || unread) return {};
  return fail(refuse::no_standard_output, {});
}

/// Writes and prints what a command has made.
class Delivery {
 public:
  Delivery(const Outcome& outcome, const Running& running, bool with_report)
      : outcome_(outcome), files_(outcome.files) {
    if (!with_report || outcome.json.empty() || running.json.empty()) return;
    if (running.json == "-")
      text_ = outcome.json;
    else
      files_.push_back({running.json, outcome.json});
  }

  /// All files are written and all is printed, or no file appears; the reason why not.
  std::optional<Error> deliver() {
    for (const OutputFile& file : outcome_.files)
      if (file.path.has_parent_path())
        if (auto made = make_folder(file.path.parent_path()); !made) return made.error();
    return write_all(files_, outcome_.inputs, [this] { return print(); });
  }

  /// Prints what is to be printed, once.
  Result<void> print() {
    if (std::exchange(printed_, true)) return {};
    auto done = printed(text_ + outcome_.output);
    if (done) fmt::print(stderr, "{}", outcome_.aside);
    return done;
  }
  bool has_printed() const { return printed_; }

 private:
  const Outcome& outcome_;
  std::vector<OutputFile> files_;
  std::string text_;
  bool printed_ = false;
};

/// A command's process, and what is asked of it.
class Apart {
 public:
  Apart(Command& command, const Running& running)
      : command_(command),
        running_(running),
        line_(std::in_place, !running.quiet),
        worker_([this] { return begun(); }, outcome_in) {}

  int run() { return finished(made()); }

 private:
  /// What the command makes.
  Outcome made() {
    const auto until = steady_clock::now() + running_.limits.time;
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - steady_clock::now());
      auto made = asked(left);
      if (made)
        return interrupted() ? command_.failed(error_of({process::ChildEnd::Cause::cancelled}))
                             : std::move(*made);
      const bool crashed = made.error().code == code::crashed;
      if (!crashed || !command_.leaves_out(made.error())) return command_.failed(made.error());
    }
  }

  Result<std::unique_ptr<process::ChildProcess>> begun() {
    const auto answering = [this](const Texts&, const process::Parent& parent) {
      return texts_of(command_.make(parent));
    };
    return process::ChildProcess::copy(answering, running_.limits.memory);
  }

  Result<Outcome> asked(std::chrono::milliseconds time) {
    if (const auto begun = worker_.begin(); !begun) return pass_on(begun);
    const auto hear = [this](const Texts& note) { command_.hear(note); };
    auto outcome = worker_.work_on({}, {.time = time, .parent = {line_->progress(), hear}});
    worker_.kill();
    if (!outcome) return tl::unexpected(error_of(outcome.error()));
    return std::move(*outcome);
  }

  /// Says and writes what was made; the exit status.
  int finished(Outcome outcome) {
    line_.reset();
    const auto& error = outcome.error;
    const int status = error ? complain(*error) : 0;
    if (error && error->code == code::cancelled) return status;
    const bool of_report = error && error->code == code::cannot_write &&
                           error->where == running_.json;
    Delivery delivery(outcome, running_, !of_report);
    const auto unwritten = delivery.deliver();
    if (!unwritten) return status;
    // Of standard output the program says itself that it cannot be written.
    if (delivery.has_printed()) return std::ferror(stdout) != 0 ? status : complain(*unwritten);
    if (!outcome.files.empty()) return finished(command_.failed(*unwritten));
    const int other = complain(*unwritten);
    (void)delivery.print();
    return error ? status : other;
  }

  Error error_of(const process::ChildEnd& end) const {
    return process::error_of(end, name_of(running_.input), running_.limits);
  }

  Command& command_;
  const Running& running_;
  std::optional<ProgressLine> line_;  // gone before anything is said
  // Waited for when its files are written: the system takes a while to clear up after it.
  process::Worker<process::AsAgreed, Outcome> worker_;
};

}  // namespace

int run_apart(Command& command, const Running& running) { return Apart(command, running).run(); }

void add_limits(CLI::App& app, process::Limits& limits) {
  constexpr double kMilli = 1000.0, kMebi = 1U << 20U;
  const auto set_time = [&limits](double seconds) {
    limits.time = std::chrono::milliseconds(static_cast<std::int64_t>(seconds * kMilli));
  };
  app.add_option_function<double>("--time-limit", set_time, "time limit for each part; default 120")
      ->check(check_of(kTimeLimit))
      ->type_name("SECONDS")
      ->group("Limits");
  const auto set_memory = [&limits](double mebibytes) {
    limits.memory = static_cast<std::uint64_t>(mebibytes * kMebi);
  };
  app.add_option_function<double>("--memory-limit", set_memory, "memory limit; default 4096")
      ->check(check_of({.name = "memory_limit",
                        .kind = job::OptionKind::number,
                        .description = {},
                        .range = {"a number from 64 to 16777216", 64.0, 16777216.0}}))
      ->type_name("MIB")
      ->group("Limits");
}

}  // namespace planish::cli
