#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/process/child_process.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish::cli {

/// What a command has to write and to say.
struct Outcome {
  std::vector<OutputFile> files = {};              ///< all of them are written, or none
  std::vector<std::filesystem::path> inputs = {};  ///< that no file may replace
  std::string json = {};                           ///< for --json, where `files` do not hold it
  std::string output = {}, aside = {};             ///< for standard output and standard error
  std::optional<Error> error = {};                 ///< the sentence, and the exit status
};

/// A command whose work is done in a process of its own, so that no input ends the program: there
/// it is made and worded, here it is written and printed.
class Command {
 public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  /// In the process.
  virtual Outcome make(const process::Parent& parent) = 0;

  /// In the program: what to say when the process was lost, or the files cannot be written.
  virtual Outcome failed(const Error& error) const = 0;
  /// In the program: hears notes of the process.
  virtual void hear(const process::Texts&) {}
  /// In the program: after a crash, whether to try again without what crashed.
  virtual bool leaves_out(const Error&) { return false; }
};

/// What is known of a command before it works.
struct Running {
  std::string input;  ///< of the command line
  std::string json;   ///< file of the report, or "-"; empty: none
  bool quiet = false;
  process::Limits limits;
};

/// Runs it; returns the exit status. Ctrl-C ends both processes.
int run_apart(Command& command, const Running& running);

/// Defines --time-limit and --memory-limit.
void add_limits(CLI::App& app, process::Limits& limits);

}  // namespace planish::cli
