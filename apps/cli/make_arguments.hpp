#pragma once

#include "pattern_arguments.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace planish::cli {

/// What stands on the command line of `planish connect`, `planish transition` and `planish slit`;
/// what the options mean together is settled in `planned`.
struct MakeArguments : PatternArguments {
  std::vector<std::string> folded;  ///< -o
  std::vector<std::string> flat;    ///< --flat
  std::vector<std::string> mould;   ///< --mould, of `slit`
};

/// Defines the subcommand `connect`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_connect(CLI::App& app, MakeArguments& arguments);
/// The same for `transition`.
CLI::App* add_transition(CLI::App& app, MakeArguments& arguments);
/// The same for `slit`.
CLI::App* add_slit(CLI::App& app, MakeArguments& arguments);

}  // namespace planish::cli
