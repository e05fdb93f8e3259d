#pragma once

#include <planish/job/artifact.hpp>
#include <planish/job/options.hpp>
#include <planish/process/child_process.hpp>

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace planish::cli {

/// The command line of a maker's command, each value checked by itself; `planned` works out what
/// they mean together.
struct Arguments {
  const job::Maker* maker = nullptr;
  std::string input;
  std::string json;    ///< file, or "-"; empty: none
  bool check = false;  ///< only the report is written
  bool quiet = false;
  bool all = false;                  ///< every body, for makers that take one of several
  std::vector<std::string> formats;  ///< of the files written into a folder, separated by commas
  std::map<job::Role, std::vector<std::string>> outputs;
  job::OptionValues options;
  process::Limits limits;
};

/// The words of `--format`, one by one.
std::vector<std::string> formats_asked(const Arguments& arguments);

/// The option that asks for files of a role: "-o" for the folded part; for makers that take one of
/// several bodies, for the flat pattern.
std::string_view output_option(const job::Maker& maker, job::Role role);

/// Defines the subcommand of a maker; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_maker(CLI::App& app, const job::Catalogue& catalogue, const job::Maker& maker,
                    Arguments& arguments);

}  // namespace planish::cli
