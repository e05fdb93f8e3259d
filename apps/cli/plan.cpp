#include "plan.hpp"

#include "contradictions.hpp"
#include "output_files.hpp"
#include "refusals.hpp"

#include <planish/job/part_materials.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using job::Artifact;
using job::Role;

constexpr Role kOrder[] = {Role::folded, Role::mould, Role::flat};

/// One command line against a catalogue.
struct Planning {
  const job::Catalogue& catalogue;
  const Arguments& arguments;

  std::vector<const Artifact*> written(Role role) const {
    return catalogue.written_by(*arguments.maker, role);
  }
  bool is_asked(Role role) const {
    const auto found = arguments.outputs.find(role);
    return found != arguments.outputs.end() && !found->second.empty();
  }
  fs::path beside_input(const Artifact& artifact) const {
    const fs::path input(arguments.input);
    return input.parent_path() / (stem_of(input) + std::string(artifact.file_end));
  }
};

tl::unexpected<Error> says_nothing(std::string_view option, const std::string& name,
                                   const std::vector<const Artifact*>& known, const char* more) {
  std::string suffixes;
  for (const Artifact* artifact : known)
    suffixes += fmt::format("{}{}", suffixes.empty() ? "" : ", ", artifact->suffix);
  return fail(refuse::output_unclear,
              {{"option", option}, {"file", name}, {"suffixes", suffixes + more}});
}

/// Refuses a name that no option of this role writes: another one may.
tl::unexpected<Error> not_written(const Planning& planning, Role role, const std::string& name,
                                  const char* more) {
  const job::Maker& maker = *planning.arguments.maker;
  const std::string_view option = output_option(maker, role);
  for (const Role other : kOrder)
    if (const Artifact* artifact = by_suffix(planning.written(other), name); artifact)
      return fail(refuse::output_of_other_option, {{"option", option},
                                                   {"suffix", artifact->suffix},
                                                   {"other", output_option(maker, other)},
                                                   {"file", name}});
  return says_nothing(option, name, planning.written(role), more);
}

std::vector<const Artifact*> formats_of(const Planning& planning) {
  const auto written = planning.written(Role::flat);
  std::vector<const Artifact*> formats;
  for (const std::string& word : formats_asked(planning.arguments))
    for (const Artifact* artifact : written)
      if (artifact->suffix == "." + word) formats.push_back(artifact);
  if (formats.empty()) formats.push_back(written.front());
  return formats;
}

Result<std::vector<Target>> default_targets(const Planning& planning) {
  const job::Maker& maker = *planning.arguments.maker;
  const Role first = maker.makes(job::Source::folded_solid) ? Role::folded : Role::flat;
  if (planning.arguments.input == "-")
    return fail(refuse::outputs_unnamed, {{"option", output_option(maker, first)}});
  std::vector<Target> targets;
  if (maker.makes(job::Source::folded_solid)) {
    const Artifact* folded = planning.written(Role::folded).front();
    targets.push_back({planning.beside_input(*folded), folded});
  }
  for (const Artifact* flat : formats_of(planning))
    targets.push_back({planning.beside_input(*flat), flat});
  return targets;
}

/// The files for one value of an output option; a folder gets those of --format.
Result<std::vector<Target>> targets_of(const Planning& planning, Role role,
                                       const std::string& name) {
  const bool folders = planning.arguments.maker->takes("body");
  const auto written = planning.written(role);
  std::vector<Target> targets;
  if (folders && is_folder(name)) {
    for (const Artifact* artifact : formats_of(planning))
      targets.push_back({fs::path(name) / planning.beside_input(*artifact).filename(), artifact});
  } else if (const Artifact* artifact = by_suffix(written, name)) {
    targets.push_back({name, artifact});
  } else {
    return not_written(planning, role, name, folders ? ", or in / for a folder" : "");
  }
  return targets;
}

Result<std::vector<Target>> all_targets(const Planning& planning) {
  const bool any = std::any_of(std::begin(kOrder), std::end(kOrder),
                               [&](Role role) { return planning.is_asked(role); });
  if (!any) return default_targets(planning);
  std::vector<Target> targets;
  for (const Role role : kOrder) {
    if (!planning.is_asked(role)) continue;
    for (const std::string& name : planning.arguments.outputs.at(role)) {
      auto some = targets_of(planning, role, name);
      if (!some) return some;
      std::move(some->begin(), some->end(), std::back_inserter(targets));
    }
  }
  return targets;
}

/// What is no input of the command at all would not be lost: that is what is wrong then.
Result<void> check_input(const Arguments& arguments) {
  if (arguments.input == "-") return {};
  job::Request request;
  request.input = arguments.input;
  const auto opened = job::open_input(*arguments.maker, request, {});
  return opened ? Result<void>() : pass_on(opened);
}

/// Said before the work rather than after it.
Result<void> check_all_writable(const Arguments& arguments, const Plan& plan,
                                const std::vector<fs::path>& files) {
  for (const fs::path& file : files)
    if (folder_exists(file))
      if (auto writable = check_writable(file); !writable) return writable;
  std::vector<fs::path> folders;
  if (!plan.folder.empty()) folders.push_back(plan.folder);
  for (const auto& [role, names] : arguments.outputs)
    for (const std::string& name : names)
      if (arguments.maker->takes("body") && is_folder(name)) folders.emplace_back(name);
  for (const fs::path& folder : folders)
    if (auto fine = check_folder(folder); !fine) return fine;
  return {};
}

Result<void> check_files(const Arguments& arguments, const Plan& plan) {
  std::vector<fs::path> files = files_named({arguments.json});
  // Before all else, because what fails has a report too.
  for (const fs::path& file : files)
    if (auto spared = spare_inputs(file, plan.inputs); !spared) return spared;
  for (const fs::path& file : files)
    if (auto exists = folder_exists(file); !exists) return exists;
  for (const auto& [role, names] : arguments.outputs)
    for (const std::string& name : names)
      // A folder to write into is created when needed.
      if (!(arguments.maker->takes("body") && is_folder(name)) && !arguments.all)
        if (auto exists = folder_exists(name); !exists) return exists;
  for (const Target& target : plan.targets)
    files.push_back(target.path);
  for (const fs::path& file : files)
    if (auto spared = spare_inputs(file, plan.inputs); !spared) {
      if (auto sound = check_input(arguments); !sound) return sound;
      return spared;
    }
  if (auto different = all_different(files); !different) return different;
  return check_all_writable(arguments, plan, files);
}

std::vector<fs::path> inputs_of(const Arguments& arguments) {
  std::vector<std::string> names{arguments.input};
  for (const job::OptionUse& use : arguments.maker->options)
    if (use.entry().kind == job::OptionKind::file)
      names.push_back(arguments.options.text(use.name));
  std::vector<fs::path> inputs = files_named(names);
  if (!arguments.maker->named_files || arguments.input == "-") return inputs;
  // If a file cannot be read, the maker will report it.
  if (const auto input = job::read_input_file(arguments.input, arguments.maker->input_kind()))
    for (const job::NamedFile& named : arguments.maker->named_files(input->content))
      inputs.push_back(*input->folder / named.file);
  return inputs;
}

}  // namespace

Result<Plan> planned(const job::Catalogue& catalogue, const Arguments& arguments) {
  if (const auto contradiction = contradiction_in(catalogue, arguments))
    return tl::unexpected(*contradiction);
  if (auto fine = arguments.options.check_together(); !fine) return pass_on(fine);
  const Planning planning{catalogue, arguments};
  Plan plan;
  plan.inputs = inputs_of(arguments);
  plan.formats = formats_of(planning);
  if (arguments.all && !arguments.check) plan.folder = arguments.outputs.at(Role::flat).front();
  if (!arguments.all && !arguments.check) {
    auto targets = all_targets(planning);
    if (!targets) return pass_on(targets);
    plan.targets = std::move(*targets);
  }
  if (auto fine = check_files(arguments, plan); !fine) return pass_on(fine);
  plan.request.input = arguments.input;
  if (auto entered = arguments.options.enter(plan.request); !entered) return pass_on(entered);
  if (arguments.all)
    if (auto wrong = job::unstocked(plan.request)) return tl::unexpected(std::move(*wrong));
  return plan;
}

}  // namespace planish::cli
