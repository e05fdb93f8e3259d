#include "unfold_arguments.hpp"

#include "option_parts.hpp"

#include <fmt/format.h>

namespace planish::cli {
namespace {

constexpr auto kExamples = R"(Examples:
  planish unfold part.step                     part.dxf beside it, a summary here
  planish unfold part.step -o a.dxf -o a.svg   two files of one pattern
  planish unfold part.step --k-table steel.csv --json part.json
  planish unfold cabinet.step --body door      one body of several
  planish unfold cabinet.step --all -o flat/   every body, with summary.csv
  planish unfold part.step --r12 --profile onshape --units inch
  planish unfold --print-rules > rules.json    thresholds to edit, for --rules
  cat part.step | planish unfold - --check --json -

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: understood, but no flat pattern exists
  2 wrong usage                        (or, with --all, of none of the bodies)

More in docs/cli.md.)";

void add_input_options(CLI::App& app, UnfoldArguments& to) {
  add_text(app, "input", to.input, "FILE",
           "STEP file (AP203, AP214, AP242), or - for standard input")
      ->required();
  add_text(app, "--body", to.body, "N|NAME",
           "which body of several: its number (see `planish info`) or name")
      ->group("Input");
  app.add_flag(
         "--all", to.all,
         "unfold every different body into the folder of -o, with summary.csv and summary.json")
      ->group("Input");
}

void add_output_options(CLI::App& app, UnfoldArguments& to) {
  add_repeatable(app, "-o,--output", to.outputs,
                 ".dxf, .svg or .step (flat solid) file, or a folder; may be given several times; "
                 "default: <input>.dxf beside the input")
      ->type_name("PATH")
      ->group("Output");
  add_repeatable(app, "--format", to.formats,
                 "what to write into a folder or without -o: dxf, svg, step, with commas between; "
                 "default dxf")
      ->delimiter(',')
      ->type_name("FORMATS")
      ->check([](const std::string& text) -> std::string {
        if (text == "dxf" || text == "svg" || text == "step") return {};
        return fmt::format("\"{}\" is none of dxf, svg, step", text);
      })
      ->group("Output");
  add_report_options(app, to, "mm");
}

void add_bend_options(CLI::App& app, UnfoldArguments& to) {
  add_k_options(app, to, "0.44");
  add_face(app, "--root", to.root, {"largest"},
           "face that stays where it is; `planish info --sheets` lists the faces; default largest")
      ->group("Bends");
  add_face(app, "--up", to.up, {"auto", "reference", "other"},
           "skin that faces up: that of a face, the one that is unfolded (reference) or the other; "
           "default auto: from which more bends go up")
      ->group("Bends");
}

}  // namespace

CLI::App* add_unfold(CLI::App& app, UnfoldArguments& arguments) {
  CLI::App* command = app.add_subcommand("unfold", "lay a sheet-metal part flat");
  add_input_options(*command, arguments);
  add_output_options(*command, arguments);
  add_bend_options(*command, arguments);
  add_dxf_options(*command, arguments);
  add_check_options(*command, arguments);
  command->footer(kExamples);
  return command;
}

}  // namespace planish::cli
