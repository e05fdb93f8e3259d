#include "contradictions.hpp"

#include "output_files.hpp"
#include "refusals.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace planish::cli {
namespace {

// A condition under which the command line makes no sense, and the error for it.
struct Contradiction {
  bool holds;
  const Refusal& refusal;
  Facts facts = {};
};

int inputs_from_stdin(const Arguments& a) {
  int count = a.input == "-";
  for (const job::OptionUse& use : a.maker->options)
    count += use.entry().kind == job::OptionKind::file && a.options.text(use.name) == "-";
  return count;
}

std::vector<Contradiction> of_outputs(const Arguments& a) {
  std::vector<Contradiction> all{{inputs_from_stdin(a) > 1, refuse::one_standard_input},
                                 {a.check && !a.formats.empty(), refuse::check_writes_no_pattern}};
  for (const auto& [role, names] : a.outputs)
    all.push_back({a.check && !names.empty(),
                   refuse::check_writes_no_file,
                   {{"option", output_option(*a.maker, role)}}});
  return all;
}

/// Whether the value of `-o` is a file: an existing one, or a name with the suffix of a pattern.
/// With --all any other name is a folder to be created.
bool names_a_file(const job::Catalogue& catalogue, const Arguments& a, const std::string& output) {
  if (is_folder(output)) return false;
  std::error_code ignored;
  return by_suffix(catalogue.written_by(*a.maker, job::Role::flat), output) ||
         std::filesystem::exists(output, ignored);
}

std::vector<Contradiction> of_formats(const Arguments& a) {
  std::vector<Contradiction> all;
  std::set<std::string> seen;
  for (const std::string& format : formats_asked(a))
    all.push_back({!seen.insert(format).second, refuse::format_twice, {{"format", format}}});
  return all;
}

std::vector<Contradiction> of_several_bodies(const job::Catalogue& catalogue, const Arguments& a) {
  const auto& outputs = a.outputs.at(job::Role::flat);
  if (!a.all) {
    const bool folder = outputs.empty() || std::ranges::any_of(outputs, is_folder);
    return {{!folder && !a.formats.empty(), refuse::format_of_file}};
  }
  const std::string up = a.options.text("up"), root = a.options.text("root");
  const bool faces = (!root.empty() && root != "largest") ||
                     (!up.empty() && up != "auto" && up != "reference" && up != "other");
  return {
      {a.options.given("body"), refuse::all_and_body},
      {faces, refuse::faces_of_all},
      {outputs.empty() && !a.check, refuse::all_without_folder},
      {std::ranges::any_of(outputs,
                           [&](const auto& name) { return names_a_file(catalogue, a, name); }),
       refuse::all_into_file},
      {outputs.size() > 1, refuse::all_into_folders},
  };
}

}  // namespace

std::optional<Error> contradiction_in(const job::Catalogue& catalogue, const Arguments& arguments) {
  std::vector<Contradiction> all = of_outputs(arguments);
  for (Contradiction& one : of_formats(arguments))
    all.push_back(std::move(one));
  if (arguments.maker->takes("body"))
    for (Contradiction& one : of_several_bodies(catalogue, arguments))
      all.push_back(std::move(one));
  for (const Contradiction& one : all)
    if (one.holds) return error_of(one.refusal, one.facts);
  return std::nullopt;
}

}  // namespace planish::cli
