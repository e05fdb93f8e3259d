#include "commands.hpp"
#include "option_parts.hpp"
#include "output_files.hpp"
#include "terminal.hpp"

#include <planish/job/info.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

constexpr auto kExamples = R"(Examples:
  planish info part.step            schema, system, unit, bodies
  planish info part.step --sheets   and what sheet is in each body
  planish info part.step --json -

More in docs/cli.md.)";

job::InfoRequest request_of(const InfoArguments& arguments) {
  job::Request asked;
  (void)arguments.options.enter(asked);  // each was checked
  return {arguments.input, asked.body, arguments.sheets, asked.units.value_or(LengthUnit::mm)};
}

int end_failed(const InfoArguments& arguments, const Error& error) {
  const int status = complain(error);
  if (error.code == ErrorCode::cancelled) return status;
  job::InfoReport failed;
  failed.input = arguments.input;
  failed.refusal = error;
  failed.units = request_of(arguments).units;
  if (const auto unwritten = write_report(arguments.json, job::info_json(failed))) {
    complain(*unwritten);
  }
  return status;
}

}  // namespace

CLI::App* add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App* command = app.add_subcommand("info", "say what is in a STEP file");
  add_text(*command, "input", arguments.input, "FILE", "STEP file, or - for standard input")
      ->required();
  const job::Option &body = job::option("body"), &units = job::option("units");
  add_option(*command, body, "only this body: its number or name", type_name(body),
             arguments.options);
  command->add_flag("--sheets", arguments.sheets,
                    "look for the sheet in each body: thickness, bends, faces for --root, or why "
                    "it has none");
  add_text(*command, "--json", arguments.json, "FILE",
           "the same as JSON; - writes it to standard output");
  add_option(*command, units, "unit of the lengths printed; default mm", type_name(units),
             arguments.options);
  command->footer(kExamples);
  return command;
}

int run_info(const InfoArguments& arguments) {
  if (arguments.input != "-" && !arguments.json.empty()) {
    const auto spared = spare_inputs(arguments.json, {arguments.input});
    if (!spared) return complain(spared.error());
  }
  for (const auto& file : files_named({arguments.json})) {
    if (const auto exists = folder_exists(file); !exists) return complain(exists.error());
    if (const auto fine = check_writable(file); !fine) return complain(fine.error());
  }
  ProgressLine line(true);
  const auto report = job::info(request_of(arguments), line.progress());
  if (!report) return end_failed(arguments, report.error());
  if (const auto error = write_report(arguments.json, job::info_json(*report))) {
    return complain(*error);
  }
  if (arguments.json != "-") fmt::print("{}", job::info_text(*report));
  return 0;
}

}  // namespace planish::cli
