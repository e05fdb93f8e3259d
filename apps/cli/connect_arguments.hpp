#pragma once

#include "pattern_arguments.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace planish::cli {

/// What stands on the command line of `planish connect`; what the options mean together is settled
/// in `planned`.
struct ConnectArguments : PatternArguments {
  std::vector<std::string> folded;  ///< -o
  std::vector<std::string> flat;    ///< --flat
};

/// Defines the subcommand `connect`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_connect(CLI::App& app, ConnectArguments& arguments);

}  // namespace planish::cli
