// Gives Planish damaged inputs, each in a process of its own that goes on until one ends it, and
// holds every answer to its form. CONTRIBUTING.md, "Damaged inputs", says how it is run.
#include "fuzz/mutation.hpp"
#include "fuzz/readers.hpp"

#include <planish/base/packed_error.hpp>
#include <planish/job/codes.hpp>
#include <planish/process/child_process.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace planish::fuzz {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

struct Options {
  std::string kind = "all";
  std::uint64_t seed = 1;
  long count = 1000;
  std::chrono::milliseconds limit = std::chrono::seconds(20);
  fs::path keep;                  ///< where inputs that broke something are kept; empty: nowhere
  std::vector<fs::path> seeds;    ///< files and folders
  std::size_t largest = 200'000;  ///< bytes of a seed
};

/// What an input is read as.
enum class Kind { step, json, table };

struct Seed {
  Kind kind;
  std::string name, text;
};

/// What came of one input.
struct Outcome {
  std::string word;    ///< "ok", the code of the error, or how its process ended
  std::string broken;  ///< what is wrong about it; empty: nothing
};

std::optional<Kind> kind_of(const fs::path& file) {
  const std::string suffix = file.extension().string();
  if (suffix == ".step" || suffix == ".stp" || suffix == ".STEP") return Kind::step;
  if (suffix == ".json") return Kind::json;
  if (suffix == ".csv" || suffix == ".xyz") return Kind::table;
  return std::nullopt;
}

bool is_wanted(Kind kind, const std::string& word) {
  if (word == "all") return true;
  return word == (kind == Kind::step ? "step" : kind == Kind::json ? "json" : "table");
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Seed> seeds_of(const Options& options) {
  std::vector<fs::path> files;
  for (const fs::path& place : options.seeds) {
    std::error_code absent;
    if (fs::is_regular_file(place, absent)) files.push_back(place);
    for (fs::recursive_directory_iterator entry(place, absent), end; entry != end; ++entry)
      if (entry->is_regular_file()) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  std::vector<Seed> seeds;
  for (const fs::path& file : files) {
    const auto kind = kind_of(file);
    if (!kind || !is_wanted(*kind, options.kind) || fs::file_size(file) > options.largest) continue;
    seeds.push_back({*kind, file.filename().string(), bytes_of(file)});
  }
  return seeds;
}

process::Texts answered(const process::Texts& question, const process::Parent& parent) {
  const std::string& what = question[0];
  const std::string& text = question[1];
  std::optional<Error> error;
  if (what == "step") error = read_step_and_unfold(text, parent.progress);
  if (what == "json") error = read_json(text, parent.progress);
  if (what == "make") error = make_json(text, parent.progress);
  if (what == "table") error = read_table(text);
  return error ? packed(*error) : process::Texts{"ok"};
}

/// One sentence, and an exit status that an input may bring about.
std::string broken_form(const Error& error) {
  const int status = exit_status(error.code);
  const bool chosen = error.code == code::no_such_body || error.code == code::bad_option;
  if (status != 3 && status != 4 && !chosen)
    return fmt::format("exit status {}: {}", status, error.message);
  if (error.message.empty()) return "no sentence";
  if (error.message.size() > 2000) return "a sentence of more than 2000 bytes";
  return {};
}

/// Whose code a sanitizer's report is about: the first line of the stack that is of a library of
/// the kernel, or of ours.
bool is_kernels(const std::string& report) {
  const std::size_t stack = report.find("    #0 ");
  if (stack == std::string::npos) return true;  // a signal without a report
  const std::size_t kernel = report.find("libTK", stack), ours = report.find("planish::", stack);
  return kernel < ours;
}

class Target {
 public:
  explicit Target(const Options& options) : options_(options) {}

  Outcome give(const std::string& what, const std::string& text) {
    if (!child_) {
      auto child = process::ChildProcess::copy(answered, process::default_memory_limit());
      if (!child) return {"not started", child.error().message};
      child_ = std::move(*child);
    }
    const auto answer = child_->ask({what, text}, options_.limit);
    if (!answer) return ended(answer.error(), what);
    const auto error = unpacked(*answer);
    if (!error) return {"ok", {}};
    return {std::string(code_name(error->code)), broken_form(*error)};
  }

 private:
  Outcome ended(const process::ChildEnd& end, const std::string& what) {
    child_.reset();
    using Cause = process::ChildEnd::Cause;
    if (end.cause == Cause::out_of_time) return {"[out of time]", what == "step" ? "" : "hangs"};
    if (end.cause == Cause::out_of_memory) return {"[out of memory]", {}};
    const std::string said = fmt::format("{}\n{}", end.reason, end.said);
    if (end.reason.starts_with("assertion")) return {"[assertion]", said};
    if (what == "step" && is_kernels(end.said)) return {"[kernel crashed]", {}};
    return {"[crash of ours]", said};
  }

  const Options& options_;
  std::unique_ptr<process::ChildProcess> child_;
};

int run(const Options& options) {
  const std::vector<Seed> seeds = seeds_of(options);
  if (seeds.empty()) {
    fmt::print(stderr, "there are no files to damage\n");
    return 2;
  }
  Target target(options);
  std::map<std::string, long> outcomes;
  long broken = 0;
  const auto begun = steady_clock::now();
  for (long i = 0; i < options.count; ++i) {
    // Each input has a seed of its own, so that one can be made again alone.
    const std::uint64_t own = options.seed + static_cast<std::uint64_t>(i);
    Mutator mutator(own);
    const Seed& seed = seeds[mutator.below(seeds.size())];
    const Seed& other = seeds[mutator.below(seeds.size())];
    const std::string text = mutator.damaged(seed.text, other.text);
    constexpr std::size_t kMadeOf = 20;  // one of so many is not only read
    const bool made = seed.kind == Kind::json && mutator.below(kMadeOf) == 0;
    const std::string what = seed.kind == Kind::step   ? "step"
                             : seed.kind == Kind::json ? (made ? "make" : "json")
                                                       : "table";
    const Outcome outcome = target.give(what, text);
    ++outcomes[outcome.word];
    if (outcome.broken.empty()) continue;
    ++broken;
    fmt::print("BROKEN --seed {} --count 1 ({}, {}): {} {}\n", own, seed.name, what, outcome.word,
               outcome.broken);
    std::fflush(stdout);
    if (!options.keep.empty())
      std::ofstream(options.keep / fmt::format("{}-{}-{}", own, what, seed.name), std::ios::binary)
          << text;
  }
  const std::chrono::duration<double> taken = steady_clock::now() - begun;
  fmt::print("{} damaged inputs of {} files in {:.1f} s ({:.0f} a second), {} broke something\n",
             options.count, seeds.size(), taken.count(),
             static_cast<double>(options.count) / taken.count(), broken);
  for (const auto& [word, number] : outcomes)
    fmt::print("  {:<24} {}\n", word, number);
  return broken == 0 ? 0 : 1;
}

/// Empty where an option is unknown.
std::optional<Options> options_of(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      options.seeds.emplace_back(words[i]);
      continue;
    }
    if (i + 1 == words.size()) return std::nullopt;
    const std::string &name = words[i], &value = words[++i];
    if (name == "--kind")
      options.kind = value;
    else if (name == "--seed")
      options.seed = std::strtoull(value.c_str(), nullptr, 10);
    else if (name == "--count")
      options.count = std::atol(value.c_str());
    else if (name == "--time-limit")
      options.limit = std::chrono::milliseconds(static_cast<long>(1000 * std::atof(value.c_str())));
    else if (name == "--largest")
      options.largest = std::strtoull(value.c_str(), nullptr, 10);
    else if (name == "--keep")
      options.keep = value;
    else
      return std::nullopt;
  }
  if (options.seeds.empty())
    options.seeds = {PLANISH_SOURCE_DIR "/examples", PLANISH_SOURCE_DIR "/tests/fuzz/seeds"};
  return options;
}

}  // namespace
}  // namespace planish::fuzz

int main(int argc, char** argv) {
  const auto options = planish::fuzz::options_of({argv + 1, argv + argc});
  if (options) return planish::fuzz::run(*options);
  fmt::print(stderr,
             "fuzz_inputs [--kind all|step|json|table] [--seed N] [--count N] [--time-limit S]\n"
             "            [--largest BYTES] [--keep FOLDER] [FILE|FOLDER...]\n");
  return 2;
}
