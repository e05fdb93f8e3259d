#include "make_plan.hpp"

#include "option_rules.hpp"
#include "output_files.hpp"
#include "side_files.hpp"

#include <fmt/format.h>

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using job::OutputFormat;

tl::unexpected<Error> not_a_name(const std::string& option, const std::string& name,
                                 const std::string& suffixes) {
  return tl::unexpected(bad_option(fmt::format(
      "{} \"{}\" does not say what to write: the name must end in {}", option, name, suffixes)));
}

Result<void> plan_defaults(const MakeArguments& arguments, MakePlan& plan) {
  const fs::path input(arguments.input);
  if (input == "-") {
    return tl::unexpected(
        bad_option("standard input has no name to call the outputs by: say where with "
                   "-o FILE.step or --flat FILE.dxf, or --check for no output"));
  }
  const fs::path stem = input.parent_path() / stem_of(input);
  plan.folded.emplace_back(stem.string() + ".step");
  plan.flat.push_back({stem.string() + ".dxf", OutputFormat::dxf});
  return {};
}

Result<void> plan_outputs(const MakeArguments& arguments, MakePlan& plan) {
  if (arguments.check) return {};
  for (const std::string& name : arguments.mould) {
    const bool known = format_by_suffix(name) == OutputFormat::step || is_mesh_name(name);
    if (!known) return not_a_name("--mould", name, ".step, .stl or .obj");
    plan.mould.emplace_back(name);
  }
  if (arguments.folded.empty() && arguments.flat.empty() && arguments.mould.empty())
    return plan_defaults(arguments, plan);
  for (const std::string& name : arguments.folded) {
    const bool known = format_by_suffix(name) == OutputFormat::step || is_mesh_name(name);
    if (!known) return not_a_name("-o", name, ".step, .stl or .obj");
    plan.folded.emplace_back(name);
  }
  for (const std::string& name : arguments.flat) {
    const auto format = format_by_suffix(name);
    if (!format) return not_a_name("--flat", name, ".dxf, .svg or .step");
    plan.flat.push_back({name, *format});
  }
  return {};
}

Result<void> check_files(const MakeArguments& arguments, const MakePlan& plan) {
  std::vector<fs::path> files = files_named({arguments.json});
  files.insert(files.end(), plan.folded.begin(), plan.folded.end());
  files.insert(files.end(), plan.mould.begin(), plan.mould.end());
  for (const Target& target : plan.flat)
    files.push_back(target.path);
  for (const fs::path& file : files) {
    if (auto spared = spare_inputs(file, plan.inputs); !spared) return spared;
    if (auto exists = folder_exists(file); !exists) return exists;
  }
  return all_different(files);
}

}  // namespace

Result<MakePlan> planned(const MakeArguments& arguments) {
  if (const auto contradiction = contradiction_in(arguments))
    return tl::unexpected(bad_option(*contradiction));
  MakePlan plan;
  plan.inputs = files_named({arguments.input, arguments.k_table, arguments.rules});
  plan.dxf = dxf_of(arguments);
  if (auto made = plan_outputs(arguments, plan); !made) return tl::unexpected(made.error());
  if (auto fine = check_files(arguments, plan); !fine) return tl::unexpected(fine.error());
  auto request = request_of(arguments);
  if (!request) return tl::unexpected(request.error());
  plan.request = std::move(*request);
  return plan;
}

}  // namespace planish::cli
