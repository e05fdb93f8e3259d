#include "apart.hpp"
#include "commands.hpp"
#include "option_parts.hpp"
#include "output_files.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/base/text.hpp>
#include <planish/job/plates_of.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

constexpr auto kPlatesExamples = R"(Examples:
  planish plates part.step -o plates.json               its flanges as bare plates
  planish plates part.step --with-bends -o plates.json  and which of them its bends join
  planish plates cabinet.step --body door -o - | planish connect - -o door.step

More in docs/connect.md.)";

std::filesystem::path output_of(const PlatesArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return std::filesystem::path(arguments.input).parent_path() /
         (stem_of(arguments.input) + "_plates.json");
}

/// Errors of the command line, before any work.
std::optional<Error> unwritable(const PlatesArguments& arguments) {
  if (arguments.output == "-") return std::nullopt;
  if (arguments.input == "-" && arguments.output.empty())
    return error_of(refuse::plates_unnamed, {});
  if (const auto fine = check_output(output_of(arguments), arguments.input); !fine)
    return fine.error();
  return std::nullopt;
}

class Plates : public Command {
 public:
  explicit Plates(const PlatesArguments& arguments) : arguments_(arguments) {}

  Outcome make(const process::Parent& parent) override {
    job::Request request;
    request.input = arguments_.input;
    (void)arguments_.options.enter(request);  // each was checked
    request.rules.enabled = false;
    const auto report = job::unfold(request, parent.progress);
    if (!report) return failed(report.error());
    const PlateStructure plates = job::plates_of(report->sheet,
                                                 {.with_bends = arguments_.with_bends});
    if (arguments_.output == "-") return {.output = job::plates_text(plates)};
    const std::filesystem::path output = output_of(arguments_);
    return {.files = {{output, job::plates_text(plates)}},
            .output = fmt::format("{} of {:.4g} mm\nwrote {}\n",
                                  counted(static_cast<int>(plates.plates.size()), "plate"),
                                  plates.thickness, output.string())};
  }

  Outcome failed(const Error& error) const override { return {.error = error}; }

 private:
  const PlatesArguments& arguments_;
};

}  // namespace

CLI::App* add_plates(const Program& program, PlatesArguments& arguments) {
  CLI::App* command = program.app.add_subcommand(
      "plates", "write the flanges of a part as plates, for connect");
  add_step_input(*command, arguments.input);
  add_text(*command, "-o,--output", arguments.output, "FILE",
           "plates file to write; - for standard output; default FILE_plates.json beside it");
  const job::Option& body = job::option("body");
  add_option(*command, body, "body to use, by number or name", type_name(body), arguments.options);
  command->add_flag("--with-bends", arguments.with_bends,
                    "also list which plates the bends join, and their inside radii");
  add_limits(*command, arguments.limits);
  command->footer(kPlatesExamples);
  return command;
}

int run_plates(const Program&, const PlatesArguments& arguments) {
  if (const auto error = unwritable(arguments)) return complain(*error);
  Plates plates(arguments);
  return run_apart(plates, {arguments.input, "", false, arguments.limits});
}

}  // namespace planish::cli
