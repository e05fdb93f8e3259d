#include "unfold_arguments.hpp"

#include "option_parts.hpp"

#include <planish/job/rules_json.hpp>

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

bool is_share(double value) { return value >= 0.0 && value <= 1.0; }
bool is_positive(double value) { return value > 0.0; }

// Each -o takes one value, so that the input may follow it.
CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description) {
  return app.add_option(name, target, description)->allow_extra_args(false)->check(not_empty);
}

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
  add_text(app, "--json", to.json, "FILE", "the report as JSON; - writes it to standard output")
      ->group("Output");
  app.add_flag("--check", to.check, "unfold and report, but write no pattern")->group("Output");
  app.add_flag("-q,--quiet", to.quiet, "no summary on the terminal")->group("Output");
  add_units(app, to.units, "unit of the DXF and of the reports; default mm")->group("Output");
}

void add_bend_options(CLI::App& app, UnfoldArguments& to) {
  add_number(app, "--k", to.k, is_share, "from 0 to 1",
             "K-factor of every bend: the neutral line lies at K times the thickness from the "
             "inside; default 0.44")
      ->group("Bends");
  add_text(app, "--k-table", to.k_table, "FILE.csv",
           "bend table: columns r/t (or r and t in mm), angle if wanted, and k, ba or bd")
      ->group("Bends");
  app.add_flag("--din6935", to.din6935, "K by DIN 6935, from the inside radius and the thickness")
      ->group("Bends");
  add_face(app, "--root", to.root, {"largest"},
           "face that stays where it is; `planish info --sheets` lists the faces; default largest")
      ->group("Bends");
  add_face(app, "--up", to.up, {"auto", "reference", "other"},
           "skin that faces up: that of a face, the one that is unfolded (reference) or the other; "
           "default auto: from which more bends go up")
      ->group("Bends");
}

void add_dxf_options(CLI::App& app, UnfoldArguments& to) {
  add_choice<LayerProfile>(app, "--profile", to.profile,
                           {{"default", LayerProfile::standard},
                            {"inventor", LayerProfile::inventor},
                            {"onshape", LayerProfile::onshape},
                            {"solidedge", LayerProfile::solid_edge}},
                           "names of the layers; default: default")
      ->group("DXF");
  app.add_flag("--r12", to.r12, "release 12 (AC1009) instead of 2000: no LWPOLYLINE, no SPLINE")
      ->group("DXF");
  app.add_option_function<std::string>(
         "--splines",
         [&to](const std::string& word) {
           to.splines = word == "keep" ? Splines::keep : Splines::arcs;
         },
         "curves that are neither lines nor arcs: keep them or make them arcs; default arcs")
      ->check([](const std::string& word) -> std::string {
        if (word == "keep" || word == "arcs") return {};
        return fmt::format("\"{}\" is none of keep, arcs", word);
      })
      ->type_name("keep|arcs")
      ->group("DXF");
  add_number(app, "--arc-tolerance", to.arc_tolerance, is_positive, "above 0",
             "mm that such arcs may be off; default 0.01")
      ->group("DXF");
  add_choice<BendMarks>(app, "--bend-marks", to.bend_marks,
                        {{"lines", BendMarks::lines}, {"ticks", BendMarks::ticks}},
                        "whole bend lines or only their ends; default lines")
      ->group("DXF");
  add_number(app, "--tick-length", to.tick_length, is_positive, "above 0",
             "mm of each end with ticks; default 5")
      ->group("DXF");
  app.add_flag("--tangent-lines", to.tangent_lines, "limits of the bend zones on their own layer")
      ->group("DXF");
}

void add_check_options(CLI::App& app, UnfoldArguments& to) {
  add_text(app, "--rules", to.rules, "FILE.json", "thresholds of the rules of manufacture")
      ->group("Checks");
  app.add_flag("--no-rules", to.no_rules, "leave the rules of manufacture out")->group("Checks");
  app.add_flag_callback(
         "--print-rules",
         [] {
           fmt::print("{}", job::rules_json(Rules{}));
           throw CLI::Success();
         },
         "print the rules file with all defaults, and end")
      ->group("Checks");
  app.add_flag("--write-overlapping", to.write_overlapping,
               "write a pattern although it covers itself")
      ->group("Checks");
  add_number(app, "--density", to.density, is_positive, "above 0",
             "kg/dm³, for the mass: steel 7.85, aluminium 2.70")
      ->group("Checks");
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
