#include "make_arguments.hpp"

#include "option_parts.hpp"

namespace planish::cli {
namespace {

constexpr auto kConnectExamples = R"(Examples:
  planish connect plates.json                  plates.step and plates.dxf beside it
  planish connect plates.json -o part.step --flat part.dxf --json report.json
  planish connect plates.json --flat part.svg  the flat pattern only, to look at
  planish connect plates.json --check          what comes of it, on the terminal
  cat plates.json | planish connect - -o part.step --din6935

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: understood, but the plates cannot be joined so
  2 wrong usage

The plates file and all else in docs/connect.md.)";

constexpr auto kTransitionExamples = R"(Examples:
  planish transition spec.json                 spec.step and spec.dxf beside it
  planish transition spec.json -o part.step --flat net.dxf --json report.json
  planish transition spec.json --flat net.svg  the net only, to look at
  planish transition spec.json --check         what comes of it, on the terminal

Of several pieces each has files of its own: net-1.dxf, net-2.dxf, ...

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: understood, but the profiles have no transition
  2 wrong usage

The transition file and all else in docs/transition.md.)";

constexpr auto kSlitExamples = R"(Examples:
  planish slit chair.json                      chair.step and chair.dxf beside it
  planish slit chair.json -o folded.step --flat pattern.dxf --mould mould.stl --json report.json
  planish slit chair.json -o folded.stl --flat pattern.svg     to look at
  planish slit chair.json --check              what comes of it, on the terminal

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: strips cannot reach, or curves do not fit
  2 wrong usage

The slit file and all else in docs/slit.md.)";

void add_files(CLI::App& app, MakeArguments& to, const std::string& kind) {
  add_text(app, "input", to.input, "FILE", kind + " file (JSON), or - for standard input")
      ->required();
  add_repeatable(app, "-o,--output", to.folded,
                 "folded part: .step, or a mesh: .stl, .obj; may be given several times; default, "
                 "without --flat: "
                 "<input>.step beside the input")
      ->type_name("PATH")
      ->group("Output");
  add_repeatable(app, "--flat", to.flat,
                 "flat pattern: .dxf, .svg or .step (flat solid) file; may be given several times; "
                 "default, without -o: <input>.dxf beside the input")
      ->type_name("PATH")
      ->group("Output");
}

}  // namespace

CLI::App* add_connect(CLI::App& app, MakeArguments& arguments) {
  CLI::App* command = app.add_subcommand("connect", "join plates by bends to one sheet");
  add_files(*command, arguments, "plates");
  add_report_options(*command, arguments, "that of the plates file");
  add_k_options(*command, arguments, "that of the plates file, or 0.44");
  add_dxf_options(*command, arguments);
  add_check_options(*command, arguments);
  command->footer(kConnectExamples);
  return command;
}

CLI::App* add_transition(CLI::App& app, MakeArguments& arguments) {
  CLI::App* command = app.add_subcommand("transition",
                                         "make the surface between two profiles, and its net");
  add_files(*command, arguments, "transition");
  add_report_options(*command, arguments, "that of the transition file");
  add_k_option(*command, arguments, "that of the transition file, or 0.5");
  add_dxf_options(*command, arguments);
  add_check_options(*command, arguments);
  command->footer(kTransitionExamples);
  return command;
}

CLI::App* add_slit(CLI::App& app, MakeArguments& arguments) {
  CLI::App* command = app.add_subcommand("slit", "bend the strips of a slit sheet into a form");
  add_files(*command, arguments, "slit");
  add_repeatable(*command, "--mould", arguments.mould,
                 "mould that the sheet is laid on: .stl, .obj or .step; may be given several times")
      ->type_name("PATH")
      ->group("Output");
  add_report_options(*command, arguments, "that of the slit file");
  add_dxf_options(*command, arguments);
  add_pattern_check_options(*command, arguments);
  command->footer(kSlitExamples);
  return command;
}

}  // namespace planish::cli
