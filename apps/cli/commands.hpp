#pragma once

#include "arguments.hpp"
#include "many_parts.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace planish::cli {

/// `planish connect` and the like; returns the exit status.
int run_maker(const job::Catalogue& catalogue, const Arguments& arguments);

struct InfoArguments {
  std::string input;
  std::string json;  ///< file, or "-"; empty: none
  bool sheets = false;
  job::OptionValues options;  ///< body, units
  process::Limits limits;
};

/// Defines the subcommand `info`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_info(CLI::App& app, InfoArguments& arguments);
/// `planish info`; returns the exit status.
int run_info(const InfoArguments& arguments);

struct PlatesArguments {
  std::string input, output;  ///< output empty: beside the input
  bool with_bends = false;
  job::OptionValues options;  ///< body
  process::Limits limits;
};

/// Defines the subcommand `plates`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_plates(CLI::App& app, PlatesArguments& arguments);
/// `planish plates`; returns the exit status.
int run_plates(const PlatesArguments& arguments);

struct BendArguments {
  std::string input;
  std::vector<std::string> outputs;  ///< the plan on pages: .pdf, .svg
  std::string json;                  ///< file, or "-"; empty: none
  bool quiet = false;
  job::OptionValues options;
  process::Limits limits;
};

/// Defines the subcommand `bend`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_bend(CLI::App& app, BendArguments& arguments);
/// `planish bend`, of whatever a maker of the catalogue makes of the input; returns the exit
/// status.
int run_bend(const job::Catalogue& catalogue, const BendArguments& arguments);

struct BatchArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::vector<std::string> formats;
  std::string shard;
  bool merge = false;
  job::OptionValues options;
  ManyParts how;
};

/// Defines the subcommand `batch`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_batch(CLI::App& app, const job::Catalogue& catalogue, BatchArguments& arguments);
/// `planish batch`; returns the exit status.
int run_batch(const job::Catalogue& catalogue, const BatchArguments& arguments);

struct PackArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::string materials, rates;  ///< files; empty: none
  std::string stock;             ///< "3000x1500"; empty: parts are not laid on sheets
  std::optional<double> gap;     ///< mm
  bool grain = false, zip = false, no_plan = false, no_drawings = false;
  ManyParts how;
  job::OptionValues options;
};

/// Defines the subcommand `pack`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_pack(CLI::App& app, const job::Catalogue& catalogue, PackArguments& arguments);
/// `planish pack`; returns the exit status.
int run_pack(const job::Catalogue& catalogue, const PackArguments& arguments);

struct ServeArguments {
  bool stdio = false;  ///< over standard input and output: the only way
  ManyParts how;
};

/// Defines the subcommand `serve`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_serve(CLI::App& app, ServeArguments& arguments);
/// `planish serve`; returns the exit status.
int run_serve(const job::Catalogue& catalogue, const ServeArguments& arguments);

/// Defines the subcommand `schema`; parsing fills `name`, which must outlive `app`.
CLI::App* add_schema(CLI::App& app, std::string& name);
/// `planish schema`; returns the exit status.
int run_schema(const job::Catalogue& catalogue, const std::string& name);

/// What `planish --formats` prints: the tables of makers and artifacts.
std::string formats_text(const job::Catalogue& catalogue);

/// Defines the subcommand `completion`; parsing fills `shell`, which must outlive `app`.
CLI::App* add_completion(CLI::App& app, std::string& shell);
/// `planish completion`; returns the exit status.
int run_completion(const CLI::App& app, const job::Catalogue& catalogue, const std::string& shell);

struct ManualArguments {
  std::string command;  ///< empty: the program itself
  std::string folder;   ///< empty: one page is printed; else all are written there
};

/// Defines the subcommand `manual`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_manual(CLI::App& app, ManualArguments& arguments);
/// `planish manual`; returns the exit status.
int run_manual(const CLI::App& app, const job::Catalogue& catalogue,
               const ManualArguments& arguments);

struct StudioArguments {
  std::string input;          ///< empty: none
  job::OptionValues options;  ///< port, time_limit, end_after (s)
  bool no_browser = false;
};

/// Defines the subcommand `studio`; parsing fills `arguments`, which must outlive `app`.
CLI::App* add_studio(CLI::App& app, StudioArguments& arguments);
/// `planish studio`: goes on as the program planish-studio, whose libraries take long to load, from
/// beside this one. Returns only if that fails, with the exit status.
int run_studio(const StudioArguments& arguments);

}  // namespace planish::cli
