#pragma once

#include <planish/io/flat_writers.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace planish::cli {

/// What stands on the command line of every command that makes flat patterns, each value checked by
/// itself.
struct PatternArguments {
  std::string input;
  std::string json;    ///< file, or "-"; empty: none
  bool check = false;  ///< nothing but the report is written
  bool quiet = false;
  std::optional<LengthUnit> units;

  std::optional<double> k;
  std::string k_table;
  bool din6935 = false;

  LayerProfile profile = LayerProfile::standard;
  bool r12 = false;
  std::optional<Splines> splines;
  std::optional<double> arc_tolerance;
  BendMarks bend_marks = BendMarks::lines;
  std::optional<double> tick_length;
  bool tangent_lines = false;

  bool write_overlapping = false;
  std::string rules;
  bool no_rules = false;
  std::optional<double> density;
};

/// --json, --check, --quiet, --units; `otherwise` says in words which unit is the default.
void add_report_options(CLI::App& app, PatternArguments& to, const std::string& otherwise);
/// --k alone; `otherwise` as below.
void add_k_option(CLI::App& app, PatternArguments& to, const std::string& otherwise);
/// --k, --k-table, --din6935; `otherwise` says in words what K is without.
void add_k_options(CLI::App& app, PatternArguments& to, const std::string& otherwise);
/// --profile and all else that is said of the DXF.
void add_dxf_options(CLI::App& app, PatternArguments& to);
/// --rules, --no-rules, --print-rules, and what follows.
void add_check_options(CLI::App& app, PatternArguments& to);
/// --write-overlapping, --density.
void add_pattern_check_options(CLI::App& app, PatternArguments& to);

/// All but the units, which are those of the report.
DxfOptions dxf_of(const PatternArguments& arguments);

}  // namespace planish::cli
