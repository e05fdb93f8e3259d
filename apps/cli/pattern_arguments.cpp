#include "pattern_arguments.hpp"

#include "option_parts.hpp"

#include <planish/job/rules_json.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

bool is_share(double value) { return value >= 0.0 && value <= 1.0; }
bool is_positive(double value) { return value > 0.0; }

}  // namespace

void add_report_options(CLI::App& app, PatternArguments& to, const std::string& otherwise) {
  add_text(app, "--json", to.json, "FILE", "the report as JSON; - writes it to standard output")
      ->group("Output");
  app.add_flag("--check", to.check, "do the work and report, but write no other file")
      ->group("Output");
  app.add_flag("-q,--quiet", to.quiet, "no summary on the terminal")->group("Output");
  add_units(app, to.units, "unit of the DXF and of the reports; default " + otherwise)
      ->group("Output");
}

void add_k_option(CLI::App& app, PatternArguments& to, const std::string& otherwise) {
  add_number(app, "--k", to.k, is_share, "from 0 to 1",
             std::string("K-factor of every bend: the neutral line lies at K times the thickness "
                         "from the inside; default ") +
                 otherwise)
      ->group("Bends");
}

void add_k_options(CLI::App& app, PatternArguments& to, const std::string& otherwise) {
  add_k_option(app, to, otherwise);
  add_text(app, "--k-table", to.k_table, "FILE.csv",
           "bend table: columns r/t (or r and t in mm), angle if wanted, and k, ba or bd")
      ->group("Bends");
  app.add_flag("--din6935", to.din6935, "K by DIN 6935, from the inside radius and the thickness")
      ->group("Bends");
}

void add_dxf_options(CLI::App& app, PatternArguments& to) {
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

void add_check_options(CLI::App& app, PatternArguments& to) {
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
  add_pattern_check_options(app, to);
}

void add_pattern_check_options(CLI::App& app, PatternArguments& to) {
  app.add_flag("--write-overlapping", to.write_overlapping,
               "write a pattern although it covers itself")
      ->group("Checks");
  add_number(app, "--density", to.density, is_positive, "above 0",
             "kg/dm³, for the mass: steel 7.85, aluminium 2.70")
      ->group("Checks");
}

DxfOptions dxf_of(const PatternArguments& arguments) {
  DxfOptions dxf;
  dxf.profile = arguments.profile;
  dxf.version = arguments.r12 ? DxfVersion::r12 : DxfVersion::r2000;
  dxf.splines = arguments.splines.value_or(dxf.splines);
  dxf.arc_tolerance = arguments.arc_tolerance.value_or(dxf.arc_tolerance);
  dxf.bend_marks = arguments.bend_marks;
  dxf.tick_length = arguments.tick_length.value_or(dxf.tick_length);
  dxf.tangent_lines = arguments.tangent_lines;
  return dxf;
}

}  // namespace planish::cli
