#pragma once

#include "unfold_arguments.hpp"

#include <planish/base/result.hpp>
#include <planish/job/outputs.hpp>
#include <planish/job/unfold.hpp>

#include <filesystem>
#include <vector>

namespace planish::cli {

/// A pattern file to write.
struct Target {
  std::filesystem::path path;
  job::OutputFormat format;
};

/// What a command line means, options checked against each other and side files read.
struct UnfoldPlan {
  job::UnfoldRequest request;
  DxfOptions dxf;
  std::vector<Target> targets;                ///< of one body
  std::filesystem::path folder;               ///< of `--all`; empty: none
  std::vector<job::OutputFormat> formats;     ///< into `folder`
  std::vector<std::filesystem::path> inputs;  ///< files read: no output may replace them
};

/// Errors: `bad_option` for options that contradict each other and outputs that would replace an
/// input, `cannot_read` and `invalid_input` for bend tables and rules files, `cannot_write` where
/// an output's folder does not exist.
Result<UnfoldPlan> planned(const UnfoldArguments& arguments);

/// Whether the value of `-o` means a folder: an existing one, or a name that ends in "/".
bool is_folder(const std::string& output);

/// Whether it means a file: an existing one, or a name that ends in .dxf, .svg or .step. With --all
/// any other name is that of a folder to make.
bool names_a_file(const std::string& output);

}  // namespace planish::cli
