#include "apart.hpp"
#include "commands.hpp"
#include "option_parts.hpp"

#include <planish/job/info.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

constexpr auto kInfoExamples = R"(Examples:
  planish info part.step            schema, system, unit, bodies
  planish info part.step --sheets   and what sheet is in each body
  planish info part.step --json -

More in docs/cli.md.)";

job::InfoRequest request_of(const InfoArguments& arguments) {
  job::Request asked;
  (void)arguments.options.enter(asked);  // each was checked
  return {arguments.input, asked.body, arguments.sheets, asked.units.value_or(LengthUnit::mm)};
}

/// Errors of the command line, before any work.
std::optional<Error> unwritable(const InfoArguments& arguments) {
  for (const auto& file : files_named({arguments.json}))
    if (const auto fine = check_output(file, arguments.input); !fine) return fine.error();
  return std::nullopt;
}

class Info : public Command {
 public:
  explicit Info(const InfoArguments& arguments) : arguments_(arguments) {}

  Outcome make(const process::Parent& parent) override {
    const auto report = job::info(request_of(arguments_), parent.progress);
    if (!report) return failed(report.error());
    const bool printed = arguments_.json != "-";
    return {.json = job::info_json(*report), .output = printed ? job::info_text(*report) : ""};
  }

  Outcome failed(const Error& error) const override {
    job::InfoReport report;
    report.input = arguments_.input;
    report.units = request_of(arguments_).units;
    return {.json = job::info_json(report, error), .error = error};
  }

 private:
  const InfoArguments& arguments_;
};

}  // namespace

CLI::App* add_info(const Program& program, InfoArguments& arguments) {
  const job::Task& task = *program.catalogue.task("info");
  CLI::App* command = program.app.add_subcommand("info", std::string(task.description));
  add_step_input(*command, arguments.input);
  const job::Option &body = job::option("body"), &units = job::option("units");
  add_option(*command, body, "body to show, by number or name; default all", type_name(body),
             arguments.options);
  command->add_flag(
      "--sheets", arguments.sheets,
      "find the sheet in each body: thickness, bends, faces for --root, or why there is none");
  add_text(*command, "--json", arguments.json, "FILE", "the same as JSON; - for standard output");
  add_option(*command, units, "unit of the lengths printed; default mm", type_name(units),
             arguments.options);
  add_limits(*command, arguments.limits);
  command->footer(kInfoExamples);
  return command;
}

int run_info(const Program&, const InfoArguments& arguments) {
  if (const auto error = unwritable(arguments)) return complain(*error);
  Info info(arguments);
  return run_apart(info, {arguments.input, arguments.json, false, arguments.limits});
}

}  // namespace planish::cli
