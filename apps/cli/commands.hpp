#pragma once

#include "arguments.hpp"
#include "many_parts.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace planish::cli {

/// What commands are defined in and run with.
struct Program {
  CLI::App& app;
  const job::Catalogue& catalogue;
};

// Of each command: `add_NAME` defines the subcommand, whose parsing fills `arguments`, which must
// outlive the program; `run_NAME` runs it and returns the exit status. The table is in program.cpp.

/// `planish connect` and the like.
int run_maker(const job::Catalogue& catalogue, const Arguments& arguments);

struct InfoArguments {
  std::string input;
  std::string json;  ///< file, or "-"; empty: none
  bool sheets = false;
  job::OptionValues options;  ///< body, units
  process::Limits limits;
};

CLI::App* add_info(const Program& program, InfoArguments& arguments);
int run_info(const Program& program, const InfoArguments& arguments);

struct PlatesArguments {
  std::string input, output;  ///< output empty: beside the input
  bool with_bends = false;
  job::OptionValues options;  ///< body
  process::Limits limits;
};

CLI::App* add_plates(const Program& program, PlatesArguments& arguments);
int run_plates(const Program& program, const PlatesArguments& arguments);

struct BendArguments {
  std::string input;
  std::vector<std::string> outputs;  ///< the plan on pages: .pdf, .svg
  std::string json;                  ///< file, or "-"; empty: none
  std::string as_made;               ///< DXF of the flat pattern for the radii made; empty: none
  bool quiet = false;
  job::OptionValues options;
  process::Limits limits;
};

CLI::App* add_bend(const Program& program, BendArguments& arguments);
/// Of whatever a maker of the catalogue makes of the input.
int run_bend(const Program& program, const BendArguments& arguments);

struct BatchArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::vector<std::string> formats;
  std::string shard;
  bool merge = false;
  job::OptionValues options;
  ManyParts how;
};

CLI::App* add_batch(const Program& program, BatchArguments& arguments);
int run_batch(const Program& program, const BatchArguments& arguments);

struct PackArguments {
  std::vector<std::string> inputs;
  std::string output;
  std::string rates;          ///< a file; empty: none
  std::string stock;          ///< "3000x1500"; empty: parts are not laid on sheets
  std::optional<double> gap;  ///< mm
  bool grain = false, zip = false, no_plan = false, no_drawings = false;
  ManyParts how;
  job::OptionValues options;
};

CLI::App* add_pack(const Program& program, PackArguments& arguments);
int run_pack(const Program& program, const PackArguments& arguments);

struct ServeArguments {
  bool stdio = false;  ///< over standard input and output: the only way
  ManyParts how;
};

CLI::App* add_serve(const Program& program, ServeArguments& arguments);
int run_serve(const Program& program, const ServeArguments& arguments);

struct SchemaArguments {
  std::string name;  ///< empty: names are printed
};

CLI::App* add_schema(const Program& program, SchemaArguments& arguments);
int run_schema(const Program& program, const SchemaArguments& arguments);

/// What `planish --formats` prints: the tables of makers and artifacts.
std::string formats_text(const job::Catalogue& catalogue);

struct CompletionArguments {
  std::string shell;
};

CLI::App* add_completion(const Program& program, CompletionArguments& arguments);
int run_completion(const Program& program, const CompletionArguments& arguments);

struct ManualArguments {
  std::string command;  ///< empty: the program itself
  std::string folder;   ///< empty: one page is printed; else all are written there
};

CLI::App* add_manual(const Program& program, ManualArguments& arguments);
int run_manual(const Program& program, const ManualArguments& arguments);

struct StudioArguments {
  std::string input;          ///< empty: none
  job::OptionValues options;  ///< port, time_limit, end_after (s)
  bool no_browser = false;
};

CLI::App* add_studio(const Program& program, StudioArguments& arguments);
/// Goes on as the program planish-studio, whose libraries take long to load, from beside this one.
/// Returns only if that fails.
int run_studio(const Program& program, const StudioArguments& arguments);

}  // namespace planish::cli
