#include "apart.hpp"
#include "commands.hpp"
#include "option_parts.hpp"

#include <planish/job/info.hpp>

#include <fmt/format.h>

#include <map>

namespace planish::cli {
namespace {

constexpr auto kExamples = R"(Examples:
  planish info part.step            schema, system, unit, bodies
  planish info part.step --sheets   and what sheet is in each body
  planish info part.step --json -

More in docs/cli.md.)";

Ending end_failed(const InfoArguments& arguments, const Error& error) {
  job::InfoReport failed;
  failed.input = arguments.input;
  failed.refusal = error;
  failed.units = arguments.units;
  return {job::info_json(failed), {}, {}, error};
}

class Info : public Command {
 public:
  explicit Info(const InfoArguments& arguments) : arguments_(arguments) {}

  std::variant<Products, Ending> make(const job::Parent& parent) override {
    if (arguments_.input != "-" && !arguments_.json.empty()) {
      const auto spared = spare_inputs(arguments_.json, {arguments_.input});
      if (!spared) return Ending{{}, {}, {}, spared.error()};
    }
    const auto report = job::info(
        {arguments_.input, arguments_.body, arguments_.sheets, arguments_.units}, parent.progress);
    if (!report) return end_failed(arguments_, report.error());
    const bool printed = arguments_.json != "-";
    return Ending{job::info_json(*report), printed ? job::info_text(*report) : "", {}, {}};
  }

  Ending lost(const Error& error) const override { return end_failed(arguments_, error); }

 private:
  const InfoArguments& arguments_;
};

}  // namespace

CLI::App* add_info(CLI::App& app, InfoArguments& arguments) {
  CLI::App* command = app.add_subcommand("info", "say what is in a STEP file");
  add_text(*command, "input", arguments.input, "FILE", "STEP file, or - for standard input")
      ->required();
  add_text(*command, "--body", arguments.body, "N|NAME", "only this body: its number or name");
  command->add_flag("--sheets", arguments.sheets,
                    "look for the sheet in each body: thickness, bends, faces for --root, or why "
                    "it has none");
  add_text(*command, "--json", arguments.json, "FILE",
           "the same as JSON; - writes it to standard output");
  const std::map<std::string, LengthUnit> units{
      {"mm", LengthUnit::mm}, {"inch", LengthUnit::inch}, {"m", LengthUnit::m}};
  command->add_option("--units", arguments.units, "unit of the lengths printed; default mm")
      ->transform(CLI::Transformer(units))
      ->type_name("mm|inch|m");
  add_limits(*command, arguments.limits);
  command->footer(kExamples);
  return command;
}

int run_info(const InfoArguments& arguments) {
  Info info(arguments);
  return run_apart(info, {arguments.input, arguments.json, false, arguments.limits});
}

}  // namespace planish::cli
