#include "apart.hpp"

#include "output_files.hpp"
#include "terminal.hpp"

#include <planish/base/packed_error.hpp>
#include <planish/job/options.hpp>
#include <planish/process/worker.hpp>

#include <fmt/format.h>

#include <memory>

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

/// Writes all files, in folders that are made for them; the reason why not.
std::optional<Error> write_products(const Outcome& outcome) {
  for (const OutputFile& file : outcome.files)
    if (file.path.has_parent_path())
      if (auto made = make_folder(file.path.parent_path()); !made) return made.error();
  return write_all(outcome.files, outcome.inputs);
}

/// A command's process, and what is asked of it.
class Apart {
 public:
  Apart(Command& command, const Running& running)
      : command_(command),
        running_(running),
        line_(!running.quiet),
        worker_([this] { return begun(); }, outcome_in) {}

  Outcome run() {
    const auto until = steady_clock::now() + running_.limits.time;
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - steady_clock::now());
      auto made = asked(left);
      if (made) return written(std::move(*made));
      const bool crashed = made.error().code == code::crashed;
      if (!crashed || !command_.leaves_out(made.error())) return command_.failed(made.error());
    }
  }

 private:
  Result<std::unique_ptr<process::ChildProcess>> begun() {
    const auto answering = [this](const Texts&, const process::Parent& parent) {
      return texts_of(command_.make(parent));
    };
    return process::ChildProcess::copy(answering, running_.limits.memory);
  }

  Result<Outcome> asked(std::chrono::milliseconds time) {
    if (const auto begun = worker_.begin(); !begun) return pass_on(begun);
    const auto hear = [this](const Texts& note) { command_.hear(note); };
    auto outcome = worker_.work_on({}, {.time = time, .parent = {line_.progress(), hear}});
    worker_.kill();
    if (!outcome) return tl::unexpected(error_of(outcome.error()));
    return std::move(*outcome);
  }

  Outcome written(Outcome outcome) {
    if (interrupted()) return command_.failed(error_of({process::ChildEnd::Cause::cancelled}));
    if (const auto unwritten = write_products(outcome)) return command_.failed(*unwritten);
    return outcome;
  }

  Error error_of(const process::ChildEnd& end) const {
    return process::error_of(end, name_of(running_.input), running_.limits);
  }

  Command& command_;
  const Running& running_;
  ProgressLine line_;
  // Waited for when its files are written: the system takes a while to clear up after it.
  process::Worker<process::AsAgreed, Outcome> worker_;
};

int said(const Outcome& outcome, const Running& running) {
  const auto& error = outcome.error;
  const int status = error ? complain(*error) : 0;
  if (error && error->code == code::cancelled) return status;
  const bool of_report = error && error->code == code::cannot_write && error->where == running.json;
  if (!outcome.json.empty() && !of_report)
    if (const auto unwritten = write_report(running.json, outcome.json)) {
      const int other = complain(*unwritten);
      return error ? status : other;
    }
  fmt::print("{}", outcome.output);
  fmt::print(stderr, "{}", outcome.aside);
  return status;
}

}  // namespace

int run_apart(Command& command, const Running& running) {
  // The line of progress is gone before anything is said.
  const Outcome outcome = Apart(command, running).run();
  return said(outcome, running);
}

void add_limits(CLI::App& app, process::Limits& limits) {
  constexpr double kLeast = 0.001, kDay = 86400.0, kLeastMiB = 64.0, kMostMiB = 1U << 24U;
  constexpr double kMilli = 1000.0, kMebi = 1U << 20U;
  const auto set_time = [&limits](double seconds) {
    limits.time = std::chrono::milliseconds(static_cast<std::int64_t>(seconds * kMilli));
  };
  app.add_option_function<double>("--time-limit", set_time, "time limit for each part; default 120")
      ->check(CLI::Range(kLeast, kDay))
      ->type_name("SECONDS")
      ->group("Limits");
  const auto set_memory = [&limits](double mebibytes) {
    limits.memory = static_cast<std::uint64_t>(mebibytes * kMebi);
  };
  app.add_option_function<double>("--memory-limit", set_memory, "memory limit; default 4096")
      ->check(CLI::Range(kLeastMiB, kMostMiB))
      ->type_name("MIB")
      ->group("Limits");
}

}  // namespace planish::cli
