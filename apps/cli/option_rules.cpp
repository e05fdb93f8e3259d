#include "option_rules.hpp"

#include "unfold_plan.hpp"

#include <algorithm>
#include <vector>

namespace planish::cli {
namespace {

// A condition under which the command line makes no sense, and what to say then.
struct Contradiction {
  bool holds;
  const char* sentence;
};

int inputs_from_stdin(const PatternArguments& a) {
  return (a.input == "-") + (a.k_table == "-") + (a.rules == "-");
}

std::vector<Contradiction> of_bends_and_dxf(const PatternArguments& a) {
  const int k_rules = a.k.has_value() + !a.k_table.empty() + a.din6935;
  return {
      {k_rules > 1,
       "--k, --k-table and --din6935 each say where K comes from: give only one of them"},
      {a.no_rules && !a.rules.empty(), "--rules and --no-rules contradict each other"},
      {a.r12 && a.splines == Splines::keep,
       "--splines keep cannot go with --r12, which has no splines"},
      {a.tick_length && a.bend_marks != BendMarks::ticks,
       "--tick-length goes with --bend-marks ticks"},
      {inputs_from_stdin(a) > 1, "only one of the inputs can be standard input (-)"},
  };
}

std::vector<Contradiction> of_several_bodies(const UnfoldArguments& a) {
  if (!a.all) return {};
  const bool faces = a.root != "largest" ||
                     (a.up != "auto" && a.up != "reference" && a.up != "other");
  const bool files = std::any_of(a.outputs.begin(), a.outputs.end(), names_a_file);
  return {
      {!a.body.empty(), "--all and --body contradict each other"},
      {faces, "--root and --up cannot name a face with --all: every body counts its own faces"},
      {a.outputs.empty() && !a.check,
       "--all writes several files: say into which folder with -o FOLDER/"},
      {files, "--all writes several files: -o must be a folder, not a file"},
      {a.outputs.size() > 1, "--all writes into one folder: give -o once"},
  };
}

std::vector<Contradiction> of_outputs(const UnfoldArguments& a) {
  return {
      {a.check && !a.outputs.empty(), "--check writes no pattern: leave -o out"},
      {a.check && !a.formats.empty(), "--check writes no pattern: leave --format out"},
  };
}

std::vector<Contradiction> of_outputs(const MakeArguments& a) {
  return {
      {a.check && !a.folded.empty(), "--check writes no part: leave -o out"},
      {a.check && !a.flat.empty(), "--check writes no pattern: leave --flat out"},
      {a.check && !a.mould.empty(), "--check writes no mould: leave --mould out"},
  };
}

std::optional<std::string> first_of(const std::vector<std::vector<Contradiction>>& groups) {
  for (const auto& group : groups) {
    for (const Contradiction& one : group) {
      if (one.holds) return one.sentence;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> contradiction_in(const UnfoldArguments& arguments) {
  return first_of(
      {of_bends_and_dxf(arguments), of_several_bodies(arguments), of_outputs(arguments)});
}

std::optional<std::string> contradiction_in(const MakeArguments& arguments) {
  return first_of({of_bends_and_dxf(arguments), of_outputs(arguments)});
}

}  // namespace planish::cli
