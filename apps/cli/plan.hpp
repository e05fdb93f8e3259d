#pragma once

#include "arguments.hpp"

#include <planish/base/result.hpp>

#include <filesystem>
#include <vector>

namespace planish::cli {

/// A file to write.
struct Target {
  std::filesystem::path path;
  const job::Artifact* artifact;
};

/// What a command line means: options checked against each other, side files read.
struct Plan {
  job::Request request;
  std::vector<Target> targets;
  std::filesystem::path folder;               ///< of `--all`; empty: none
  std::vector<const job::Artifact*> formats;  ///< into `folder`
  std::vector<std::filesystem::path> inputs;  ///< files read: no output may replace them
};

/// Errors: `bad_option` for options that contradict each other and outputs that would replace an
/// input, `cannot_read` and `invalid_input` for side files, `cannot_write` where an output's folder
/// does not exist.
Result<Plan> planned(const job::Catalogue& catalogue, const Arguments& arguments);

}  // namespace planish::cli
