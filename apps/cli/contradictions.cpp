#include "contradictions.hpp"

#include "output_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace planish::cli {
namespace {

// A condition under which the command line makes no sense, and the message for it.
struct Contradiction {
  bool holds;
  std::string sentence;
};

int inputs_from_stdin(const Arguments& a) {
  int count = a.input == "-";
  for (const job::OptionUse& use : a.maker->options)
    count += use.entry().kind == job::OptionKind::file && a.options.text(use.name) == "-";
  return count;
}

std::vector<Contradiction> of_outputs(const Arguments& a) {
  std::vector<Contradiction> all{
      {inputs_from_stdin(a) > 1, "only one of the inputs can be standard input (-)"},
      {a.check && !a.formats.empty(), "--check writes no pattern: leave --format out"}};
  for (const auto& [role, names] : a.outputs)
    all.push_back({a.check && !names.empty(), fmt::format("--check writes no file: leave {} out",
                                                          output_option(*a.maker, role))});
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
    all.push_back({!seen.insert(format).second,
                   fmt::format("--format names {} twice: leave one of them out", format)});
  return all;
}

std::vector<Contradiction> of_several_bodies(const job::Catalogue& catalogue, const Arguments& a) {
  const auto& outputs = a.outputs.at(job::Role::flat);
  if (!a.all) {
    const bool folder = outputs.empty() || std::ranges::any_of(outputs, is_folder);
    return {
        {!folder && !a.formats.empty(),
         "--format goes with a folder or without -o: the name of a file already sets its format"}};
  }
  const std::string up = a.options.text("up"), root = a.options.text("root");
  const bool faces = (!root.empty() && root != "largest") ||
                     (!up.empty() && up != "auto" && up != "reference" && up != "other");
  return {
      {a.options.given("body"), "--all and --body contradict each other"},
      {faces, "--root and --up cannot name a face with --all: every body numbers its own faces"},
      {outputs.empty() && !a.check,
       "--all writes several files: name their folder with -o FOLDER/"},
      {std::ranges::any_of(outputs,
                           [&](const auto& name) { return names_a_file(catalogue, a, name); }),
       "--all writes several files: -o must be a folder, not a file"},
      {outputs.size() > 1, "--all writes into one folder: give -o once"},
  };
}

}  // namespace

std::optional<std::string> contradiction_in(const job::Catalogue& catalogue,
                                            const Arguments& arguments) {
  std::vector<Contradiction> all = of_outputs(arguments);
  for (Contradiction& one : of_formats(arguments))
    all.push_back(std::move(one));
  if (arguments.maker->takes("body"))
    for (Contradiction& one : of_several_bodies(catalogue, arguments))
      all.push_back(std::move(one));
  for (const Contradiction& one : all)
    if (one.holds) return one.sentence;
  return std::nullopt;
}

}  // namespace planish::cli
