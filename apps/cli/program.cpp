#include "program.hpp"

#include "commands.hpp"
#include "help_format.hpp"
#include "refusals.hpp"
#include "terminal.hpp"
#include "usage.hpp"

#include <planish/batch/batch.hpp>
#include <planish/schema/printable.hpp>
#include <planish/serve/serve.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

namespace planish::cli {
namespace {

constexpr int kWrongUsage = 2;

/// A command in the program: what parses its arguments, and what runs it once it is parsed.
struct Defined {
  const CLI::App* command = nullptr;
  std::function<int()> run;
};

template <typename Arguments, auto add, auto run>
Defined defined(const Program& program) {
  const auto arguments = std::make_shared<Arguments>();
  return {add(program, *arguments), [=] { return run(program, *arguments); }};
}

Defined defined_maker(const Program& program, const job::Maker& maker) {
  const auto arguments = std::make_shared<Arguments>();
  return {add_maker(program.app, program.catalogue, maker, *arguments),
          [=] { return run_maker(program.catalogue, *arguments); }};
}

/// The commands that are no makers, in the order of the help; an example and what it does.
struct Row {
  Defined (*define)(const Program& program);
  std::string_view example = {}, what = {};
};
constexpr Row kCommands[] = {
    {defined<BendArguments, add_bend, run_bend>, "planish bend part.step",
     "finds the order of bends on a press brake"},
    {defined<BatchArguments, add_batch, run_batch>, "planish batch archive/ -o flat/",
     "unfolds thousands of files, with a summary and a page"},
    {defined<PackArguments, add_pack, run_pack>, "planish pack assembly.step -o shop/",
     "makes everything for production, in one folder"},
    {defined<InfoArguments, add_info, run_info>, "planish info part.step",
     "shows what is in the file"},
    {defined<PlatesArguments, add_plates, run_plates>, "planish plates part.step -o plates.json",
     "writes its flanges as plates, for connect"},
    {defined<SchemaArguments, add_schema, run_schema>},
    {defined<ServeArguments, add_serve, run_serve>, "planish serve --stdio",
     "answers other programs"},
    {defined<StudioArguments, add_studio, run_studio>, "planish studio part.step",
     "shows and edits parts in a browser"},
    {defined<CompletionArguments, add_completion, run_completion>},
    {defined<ManualArguments, add_manual, run_manual>}};

std::string examples(const job::Catalogue& catalogue) {
  std::string text = "Examples:\n";
  const auto add = [&](std::string_view command, std::string_view what) {
    if (!command.empty()) text += fmt::format("  {:<42} {}\n", command, what);
  };
  for (const job::Maker& maker : catalogue.makers)
    for (const auto& [command, what] : maker.examples)
      add(command, what);
  for (const Row& row : kCommands)
    add(row.example, row.what);
  return text + "\n`planish COMMAND --help` lists the options; docs/cli.md describes everything.";
}

int wrong_usage(const CLI::ParseError& error, const CLI::App& app) {
  fmt::print(stderr, "planish: {}\n", schema::printable(usage_sentence(error, app)));
  return kWrongUsage;
}

// Output that could not be written (a full disk behind `>`) must not end as success.
int flushed(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  const int failed = complain(error_of(refuse::no_standard_output, {}));
  return status == 0 ? failed : status;
}

void set_up(CLI::App& app, const job::Catalogue& catalogue) {
  app.set_version_flag("--version", "planish " PLANISH_VERSION, "print the version and exit");
  const auto print_formats = [&catalogue] {
    fmt::print("{}", formats_text(catalogue));
    throw CLI::Success();
  };
  app.add_flag_callback("--formats", print_formats,
                        "print the formats that are read and written, and exit");
  app.require_subcommand(0, 1);  // an argument may have the name of another command
  app.footer(examples(catalogue));
  app.formatter(help_format());  // before the commands, which inherit it
}

int run(int argc, const char* const* argv, const job::Catalogue& catalogue) {
  CLI::App app("Planish lays sheet metal flat and shows that the flat shape is right.", "planish");
  set_up(app, catalogue);
  const Program program{app, catalogue};
  auto commands = mapped(catalogue.makers,
                         [&](const job::Maker& maker) { return defined_maker(program, maker); });
  for (const Row& row : kCommands)
    commands.push_back(row.define(program));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help, version and the like.
    if (error.get_exit_code() == 0) return app.exit(error);
    return wrong_usage(error, app);
  }
  for (const Defined& one : commands)
    if (one.command->parsed()) return one.run();
  fmt::print("{}", app.help());
  return 0;
}

}  // namespace

int run_program(int argc, const char* const* argv, const job::Catalogue& catalogue) {
  try {
    // What `planish batch` and `planish serve` start: batch-worker MEMORY PARENT.
    const std::string_view worker = argc == 4 ? argv[1] : "";
    if (worker == "batch-worker")
      return batch::run_batch_worker(argv[3], std::strtoull(argv[2], nullptr, 10), catalogue);
    if (worker == "serve-worker")
      return serve::run_serve_worker(argv[3], std::strtoull(argv[2], nullptr, 10), catalogue);
    return flushed(run(argc, argv, catalogue));
  } catch (const std::exception& defect) {
    if (std::ferror(stdout) != 0) return complain(error_of(refuse::no_standard_output, {}));
    return complain(error_of(refuse::program_defect, {{"reason", defect.what()}}));
  } catch (...) {
    return complain(error_of(refuse::program_defect, {{"reason", "an exception of unknown type"}}));
  }
}

}  // namespace planish::cli
