#pragma once

#include <planish/io/flat_writers.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::cli {

/// What stands on the command line of `planish unfold`, each value checked by itself; what they
/// mean together is settled in `planned`.
struct UnfoldArguments {
  std::string input;
  std::string body;
  bool all = false;

  std::vector<std::string> outputs;
  std::vector<std::string> formats;  ///< "dxf", "svg", "step"
  std::string json;                  ///< file, or "-"; empty: none
  bool check = false;                ///< no pattern is written
  bool quiet = false;
  LengthUnit units = LengthUnit::mm;

  std::optional<double> k;
  std::string k_table;
  bool din6935 = false;
  std::string root = "largest";
  std::string up = "auto";

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

/// Defines the subcommand `unfold`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_unfold(CLI::App& app, UnfoldArguments& arguments);

}  // namespace planish::cli
