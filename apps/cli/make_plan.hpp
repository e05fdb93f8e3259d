#pragma once

#include "make_arguments.hpp"
#include "unfold_plan.hpp"

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/connect.hpp>

#include <filesystem>
#include <vector>

namespace planish::cli {

/// What a command line means, options checked against each other and side files read.
struct MakePlan {
  job::MakeRequest request;
  DxfOptions dxf;
  SvgOptions svg;
  std::vector<std::filesystem::path> folded;  ///< files of the folded part
  std::vector<Target> flat;
  std::vector<std::filesystem::path> mould;   ///< files of the mould
  std::vector<std::filesystem::path> inputs;  ///< files read: no output may replace them
};

/// Errors: as of `planned` for `unfold`.
Result<MakePlan> planned(const MakeArguments& arguments);

}  // namespace planish::cli
