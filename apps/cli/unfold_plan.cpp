#include "unfold_plan.hpp"

#include "option_rules.hpp"
#include "side_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using job::OutputFormat;

Error bad(std::string message) { return {ErrorCode::bad_option, std::move(message), {}}; }

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

std::optional<OutputFormat> format_by_suffix(const fs::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".dxf") return OutputFormat::dxf;
  if (suffix == ".svg") return OutputFormat::svg;
  if (suffix == ".step" || suffix == ".stp") return OutputFormat::step;
  return std::nullopt;
}

// "part" for part.step; what comes from standard input has no name of its own.
std::string stem_of(const fs::path& input) {
  return input == "-" ? "stdin" : input.stem().string();
}

Result<std::vector<Target>> default_targets(const UnfoldArguments& arguments) {
  const fs::path input(arguments.input);
  if (input == "-") {
    return tl::unexpected(
        bad("standard input has no name to call the output by: say where with "
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
          bad(fmt::format("the name \"{}\" does not say what to write: it must end "
                          "in .dxf, .svg, .step, or in / for a folder",
                          output)));
    }
  }
  if (!any_folder && !arguments.formats.empty()) {
    return tl::unexpected(
        bad("--format goes with a folder or without -o: a file's name says its "
            "format itself"));
  }
  return targets;
}

// Two outputs under one name would leave only the last.
Result<void> all_different(const std::vector<Target>& targets, const std::string& json) {
  std::vector<fs::path> paths;
  for (const Target& target : targets)
    paths.push_back(target.path);
  if (!json.empty() && json != "-") paths.emplace_back(json);
  std::set<fs::path> taken;
  for (const fs::path& path : paths) {
    std::error_code ignored;
    if (!taken.insert(fs::weakly_canonical(fs::absolute(path, ignored), ignored)).second) {
      return tl::unexpected(bad(fmt::format("two outputs are to be written to {}", path.string())));
    }
  }
  return {};
}

// Said before the work rather than after it. A folder to write into is made when needed.
Result<void> folder_exists(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return {};
  return fail(ErrorCode::cannot_write,
              fmt::format("cannot write {}: there is no folder {}", file.string(), folder.string()),
              file.string());
}

Result<void> check_files(const UnfoldArguments& arguments, const UnfoldPlan& plan) {
  std::vector<fs::path> files;
  for (const Target& target : plan.targets)
    files.push_back(target.path);
  if (!arguments.json.empty() && arguments.json != "-") files.emplace_back(arguments.json);
  for (const fs::path& file : files) {
    if (auto spared = spare_inputs(file, plan.inputs); !spared) return spared;
  }
  for (const std::string& output : arguments.outputs) {
    if (is_folder(output)) continue;
    if (auto exists = folder_exists(output); !exists) return exists;
  }
  if (!arguments.json.empty() && arguments.json != "-") {
    if (auto exists = folder_exists(arguments.json); !exists) return exists;
  }
  return all_different(plan.targets, arguments.json);
}

DxfOptions dxf_of(const UnfoldArguments& arguments) {
  DxfOptions dxf;
  dxf.profile = arguments.profile;
  dxf.version = arguments.r12 ? DxfVersion::r12 : DxfVersion::r2000;
  dxf.splines = arguments.splines.value_or(dxf.splines);
  dxf.arc_tolerance = arguments.arc_tolerance.value_or(dxf.arc_tolerance);
  dxf.units = arguments.units;
  dxf.bend_marks = arguments.bend_marks;
  dxf.tick_length = arguments.tick_length.value_or(dxf.tick_length);
  dxf.tangent_lines = arguments.tangent_lines;
  return dxf;
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
  return !is_folder(output) && (format_by_suffix(output).has_value() || fs::exists(output, ignored));
}

Result<void> spare_inputs(const fs::path& output, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs) {
    std::error_code absent;
    if (fs::equivalent(output, input, absent) && !absent) {
      return tl::unexpected(bad(fmt::format("the output {} is the input {}, which would be lost",
                                            output.string(), input.string())));
    }
  }
  return {};
}

Result<UnfoldPlan> planned(const UnfoldArguments& arguments) {
  if (const auto contradiction = contradiction_in(arguments))
    return tl::unexpected(bad(*contradiction));
  UnfoldPlan plan;
  for (const std::string& file : {arguments.input, arguments.k_table, arguments.rules}) {
    if (!file.empty() && file != "-") plan.inputs.emplace_back(file);
  }
  if (auto made = plan_outputs(arguments, plan); !made) return tl::unexpected(made.error());
  auto request = request_of(arguments);
  if (!request) return tl::unexpected(request.error());
  plan.request = std::move(*request);
  return plan;
}

}  // namespace planish::cli
