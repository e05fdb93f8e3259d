#include "unfold_plan.hpp"

#include "option_rules.hpp"
#include "output_files.hpp"
#include "side_files.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using job::OutputFormat;

std::vector<OutputFormat> formats_of(const UnfoldArguments& arguments) {
  std::vector<OutputFormat> formats;
  for (const std::string& word : arguments.formats) {
    const OutputFormat format = word == "dxf"   ? OutputFormat::dxf
                                : word == "svg" ? OutputFormat::svg
                                                : OutputFormat::step;
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
      formats.push_back(format);
    }
  }
  if (formats.empty()) formats.push_back(OutputFormat::dxf);
  return formats;
}

Result<std::vector<Target>> default_targets(const UnfoldArguments& arguments) {
  const fs::path input(arguments.input);
  if (input == "-") {
    return tl::unexpected(
        bad_option("standard input has no name to call the output by: say where with "
                   "-o FILE.dxf, or --check for no output"));
  }
  std::vector<Target> targets;
  for (const OutputFormat format : formats_of(arguments)) {
    targets.push_back({input.parent_path() / job::file_name(stem_of(input), format), format});
  }
  return targets;
}

Result<std::vector<Target>> targets_of(const UnfoldArguments& arguments) {
  if (arguments.outputs.empty()) return default_targets(arguments);
  std::vector<Target> targets;
  bool any_folder = false;
  for (const std::string& output : arguments.outputs) {
    if (is_folder(output)) {
      any_folder = true;
      for (const OutputFormat format : formats_of(arguments)) {
        targets.push_back(
            {fs::path(output) / job::file_name(stem_of(arguments.input), format), format});
      }
    } else if (const auto format = format_by_suffix(output)) {
      targets.push_back({output, *format});
    } else {
      return tl::unexpected(
          bad_option(fmt::format("the name \"{}\" does not say what to write: it must end "
                                 "in .dxf, .svg, .step, or in / for a folder",
                                 output)));
    }
  }
  if (!any_folder && !arguments.formats.empty()) {
    return tl::unexpected(
        bad_option("--format goes with a folder or without -o: a file's name says its "
                   "format itself"));
  }
  return targets;
}

Result<void> check_files(const UnfoldArguments& arguments, const UnfoldPlan& plan) {
  const std::vector<fs::path> json = files_named({arguments.json});
  std::vector<fs::path> files;
  for (const Target& target : plan.targets)
    files.push_back(target.path);
  files.insert(files.end(), json.begin(), json.end());
  for (const fs::path& file : files) {
    if (auto spared = spare_inputs(file, plan.inputs); !spared) return spared;
  }
  // A folder to write into is made when needed.
  for (const std::string& output : arguments.outputs) {
    if (is_folder(output)) continue;
    if (auto exists = folder_exists(output); !exists) return exists;
  }
  for (const fs::path& file : json) {
    if (auto exists = folder_exists(file); !exists) return exists;
  }
  return all_different(files);
}

Result<void> plan_outputs(const UnfoldArguments& arguments, UnfoldPlan& plan) {
  plan.dxf = dxf_of(arguments);
  plan.formats = formats_of(arguments);
  if (arguments.check) return check_files(arguments, plan);
  if (arguments.all) {
    plan.folder = arguments.outputs.front();
    return check_files(arguments, plan);
  }
  auto targets = targets_of(arguments);
  if (!targets) return tl::unexpected(targets.error());
  plan.targets = std::move(*targets);
  return check_files(arguments, plan);
}

}  // namespace

bool is_folder(const std::string& output) {
  std::error_code ignored;
  return output.back() == '/' || fs::is_directory(output, ignored);
}

bool names_a_file(const std::string& output) {
  std::error_code ignored;
  return !is_folder(output) &&
         (format_by_suffix(output).has_value() || fs::exists(output, ignored));
}

Result<UnfoldPlan> planned(const UnfoldArguments& arguments) {
  if (const auto contradiction = contradiction_in(arguments))
    return tl::unexpected(bad_option(*contradiction));
  UnfoldPlan plan;
  plan.inputs = files_named({arguments.input, arguments.k_table, arguments.rules});
  if (auto made = plan_outputs(arguments, plan); !made) return tl::unexpected(made.error());
  auto request = request_of(arguments);
  if (!request) return tl::unexpected(request.error());
  plan.request = std::move(*request);
  return plan;
}

}  // namespace planish::cli
