#include "apart.hpp"
#include "commands.hpp"
#include "many_parts.hpp"
#include "option_parts.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/base/message.hpp>
#include <planish/batch/batch.hpp>
#include <planish/job/run.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::cli {
namespace {

constexpr auto kBatchExamples = R"(Examples:
  planish batch archive/ -o flat/                       every STEP and JSON file below archive
  planish batch @parts.txt -o flat/ --format dxf,svg    the files that a list names
  planish batch archive/ -o flat/ --jobs 8 --time-limit 30
  planish batch archive/ -o flat/ --shard 3/64          one of 64 machines
  planish batch --merge flat/ -o flat/                  one result of those of all 64

A second run does only what is missing. Exit status:
  0 done, also where parts are refused    2 wrong usage
  1 internal error, or interrupted        3 there is nothing to work on, or files cannot be written

More in docs/batch.md.)";

std::vector<std::string> formats_of(const std::vector<std::string>& given) {
  std::vector<std::string> formats;
  for (const std::string& words : given)
    for (std::string& word : between_commas(words))
      if (!word.empty()) formats.push_back(std::move(word));
  if (formats.empty()) formats.emplace_back("dxf");
  return formats;
}

std::optional<Error> unknown_format(const std::vector<std::string>& formats,
                                    const job::Catalogue& catalogue) {
  std::vector<std::string> known{"json"};
  for (const job::Artifact& artifact : catalogue.artifacts)
    if (artifact.role != job::Role::report) known.emplace_back(artifact.name);
  for (const std::string& format : formats) {
    const bool written = format == "json" ||
                         std::ranges::any_of(catalogue.makers, [&](const job::Maker& maker) {
                           return catalogue.artifact(maker, format) != nullptr;
                         });
    if (!written)
      return error_of(refuse::bad_format, {{"format", format}, {"known", listed(known)}}, "format");
  }
  return std::nullopt;
}

/// "3/64"
std::optional<batch::Shard> shard_in(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto number = job::parse_number(text.substr(0, slash)),
             of = job::parse_number(text.substr(slash + 1));
  constexpr double kMost = 1e6;
  const auto whole = [](double x) { return x == std::floor(x); };
  if (!number || !of || !whole(*number) || !whole(*of) || *number < 1 || *of > kMost ||
      *number > *of)
    return std::nullopt;
  return batch::Shard{static_cast<int>(*number), static_cast<int>(*of)};
}

std::string summary_text(const batch::BatchResult& result) {
  const Facts counts{{"parts", result.parts},     {"inputs", result.inputs},
                     {"ok", result.ok},           {"warnings", result.warnings},
                     {"refused", result.refused}, {"distinct", result.distinct},
                     {"resumed", result.resumed}, {"left", result.left}};
  std::string pattern =
      "{parts:part} of {inputs:input}: {ok} ok, {warnings} with warnings, {refused} refused\n";
  if (result.distinct < result.ok + result.warnings)
    pattern += "{distinct:distinct part}; the others are copies of these\n";
  if (result.resumed > 0) pattern += "{resumed:input was/inputs were} done before\n";
  if (result.left > 0)
    pattern +=
        "{left:input of an earlier run is/inputs of earlier runs are} not among these; the files "
        "are still there\n";
  std::string notes;
  for (const std::string& note : result.notes)
    notes += note + "\n";
  return tell(pattern, counts).sentence + notes +
         fmt::format("wrote {}\n", (result.out / "index.html").string()) +
         left_out_text(result.refused_for, result.passed_over);
}

/// What is asked for, or the reason why it cannot be.
Result<batch::BatchOptions> options_of(const job::Catalogue& catalogue,
                                       const BatchArguments& arguments) {
  batch::BatchOptions options;
  options.formats = formats_of(arguments.formats);
  options.options = job::options_json(arguments.options);
  options.limits = arguments.how.limits;
  options.workers = workers_of(arguments.how);
  if (const auto error = unknown_format(options.formats, catalogue)) return tl::unexpected(*error);
  if (!arguments.shard.empty()) {
    const auto shard = shard_in(arguments.shard);
    if (!shard) return fail(refuse::bad_shard, {}, "shard");
    options.shard = *shard;
  }
  job::Request tried;
  if (const auto entered = arguments.options.enter(tried); !entered) return pass_on(entered);
  return options;
}

/// What a merge, which only joins results, has no use for; empty if nothing is given.
std::string unused_by_merge(const BatchArguments& arguments) {
  if (!arguments.formats.empty()) return "--format";
  if (!arguments.shard.empty()) return "--shard";
  const auto& given = arguments.options.all();
  return given.empty() ? std::string() : flag_of(given.front().first->name);
}

Result<batch::BatchResult> result_of(const job::Catalogue& catalogue,
                                     const BatchArguments& arguments) {
  if (const std::string unused = arguments.merge ? unused_by_merge(arguments) : ""; !unused.empty())
    return fail(refuse::merge_and_make, {{"option", unused}}, "merge");
  Telling telling(arguments.how);
  const auto tell = [&](const batch::BatchProgress& at) { telling(at); };
  if (arguments.merge) {
    const std::vector<std::filesystem::path> folders(arguments.inputs.begin(),
                                                     arguments.inputs.end());
    return batch::merge_batches(folders, arguments.output, tell, interrupted);
  }
  const auto options = options_of(catalogue, arguments);
  if (!options) return pass_on(options);
  const auto inputs = batch::inputs_of(arguments.inputs, arguments.output, catalogue);
  if (!inputs) return pass_on(inputs);
  return batch::run_batch(*inputs, arguments.output, *options, catalogue, tell, interrupted);
}

}  // namespace

CLI::App* add_batch(const Program& program, BatchArguments& arguments) {
  CLI::App* command = program.app.add_subcommand("batch", "unfold or make thousands of parts");
  command
      ->add_option("input", arguments.inputs,
                   "files, folders or @lists; with --merge, folders of shards")
      ->required()
      ->check(not_empty)
      ->type_name("INPUT");
  add_text(*command, "-o,--output", arguments.output, "FOLDER/", "folder of the results")
      ->required()
      ->group("Output");
  add_repeatable(*command, "--format", arguments.formats,
                 "formats of the files, separated by commas: dxf, svg, step, json, …; default dxf")
      ->group("Output");
  add_text(*command, "--shard", arguments.shard, "I/N", "only the I-th of N shares of the inputs")
      ->group("Running");
  command->add_flag("--merge", arguments.merge, "merge the results of all shards into one")
      ->group("Running");
  add_many_parts(*command, program.catalogue, arguments.how, arguments.options);
  command->footer(kBatchExamples);
  return command;
}

int run_batch(const Program& program, const BatchArguments& arguments) {
  const auto result = result_of(program.catalogue, arguments);
  if (!result) return complain(result.error(), arguments.how);
  if (!arguments.how.quiet) fmt::print("{}", summary_text(*result));
  return status_of(result->ok + result->warnings, result->refused_for);
}

}  // namespace planish::cli
