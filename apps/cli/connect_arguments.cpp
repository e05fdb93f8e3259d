#include "connect_arguments.hpp"

#include "option_parts.hpp"

namespace planish::cli {
namespace {

constexpr auto kExamples = R"(Examples:
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

void add_files(CLI::App& app, ConnectArguments& to) {
  add_text(app, "input", to.input, "FILE", "plates file (JSON), or - for standard input")
      ->required();
  add_repeatable(app, "-o,--output", to.folded,
                 "folded part: .step or .stl (mesh) file; may be given several times; default, without --flat: "
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

CLI::App* add_connect(CLI::App& app, ConnectArguments& arguments) {
  CLI::App* command = app.add_subcommand("connect", "join plates by bends to one sheet");
  add_files(*command, arguments);
  add_report_options(*command, arguments, "that of the plates file");
  add_k_options(*command, arguments, "that of the plates file, or 0.44");
  add_dxf_options(*command, arguments);
  add_check_options(*command, arguments);
  command->footer(kExamples);
  return command;
}

}  // namespace planish::cli
