#pragma once

#include <planish/job/artifact.hpp>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace planish::cli {

/// An option or an input of a command, as the help has it.
struct TableOption {
  std::vector<std::string> names;  ///< "-o", "--output"; of an input its name
  std::string type;                ///< what stands for the value: "PATH"; empty: it takes none
  std::string group, description;
  bool required = false, repeats = false;
  std::vector<std::string> words;  ///< values that can be named: "mm", "inch", "m"
  bool commas = false;             ///< several of the words may be given, separated by commas
  bool file = false, folder = false;
  std::vector<std::string> suffixes;  ///< of files that fit, ".csv"; empty: any
};

struct TableCommand {
  std::string name, description, footer;
  std::vector<TableOption> options, inputs;
};

/// All that a command line may hold, from the commands as they are defined: the program itself and
/// then its commands, in the order of the help.
std::vector<TableCommand> command_table(const CLI::App& app, const job::Catalogue& catalogue);

}  // namespace planish::cli
