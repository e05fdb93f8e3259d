#pragma once

#include "pattern_arguments.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace planish::cli {

/// What stands on the command line of `planish unfold`; what the options mean together is settled
/// in `planned`.
struct UnfoldArguments : PatternArguments {
  std::string body;
  bool all = false;

  std::vector<std::string> outputs;
  std::vector<std::string> formats;  ///< "dxf", "svg", "step"

  std::string root = "largest";
  std::string up = "auto";
};

/// Defines the subcommand `unfold`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_unfold(CLI::App& app, UnfoldArguments& arguments);

}  // namespace planish::cli
