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
#include <list>

namespace planish::cli {
namespace {

constexpr int kWrongUsage = 2;

constexpr auto kExamples = R"(Examples:
  planish unfold part.step                   part.dxf beside it, a summary here
  planish unfold cabinet.step --all -o flat/ every body, with summary.csv
  planish connect plates.json                joins plates by bends, and lays them flat
  planish transition spec.json               joins two profiles, and lays the net
  planish slit chair.json                    bends the strips of a slit sheet
  planish bend part.step                     finds the order of bends on a press brake
  planish batch archive/ -o flat/            thousands of files, with summary and page
  planish pack assembly.step -o shop/        what goes to the shop, in one folder
  planish info part.step                     what is in the file
  planish plates part.step -o plates.json    its flanges as plates, for connect
  planish serve --stdio                      all of it for other programs
  planish studio part.step                   all of it in a browser, to see and to change

`planish COMMAND --help` says more, docs/cli.md all.)";

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

/// Arguments of the commands that are not makers.
struct OtherArguments {
  InfoArguments info;
  BendArguments bend;
  BatchArguments batch;
  PackArguments pack;
  PlatesArguments plates;
  std::string schema;
  ServeArguments serve;
  StudioArguments studio;
  std::string completion;
  ManualArguments manual;
};

void set_up(CLI::App& app, const job::Catalogue& catalogue) {
  app.set_version_flag("--version", "planish " PLANISH_VERSION, "print the version and exit");
  const auto print_formats = [&catalogue] {
    fmt::print("{}", formats_text(catalogue));
    throw CLI::Success();
  };
  app.add_flag_callback("--formats", print_formats,
                        "print what is read and what is written, and exit");
  app.require_subcommand(0, 1);  // an argument may have the name of another command
  app.footer(kExamples);
  app.formatter(help_format());  // before the commands, which inherit it
}

int run(int argc, const char* const* argv, const job::Catalogue& catalogue) {
  CLI::App app("Planish lays sheet metal flat and shows that the flat shape is right.", "planish");
  set_up(app, catalogue);
  std::list<Arguments> makers;
  std::vector<std::pair<const CLI::App*, const Arguments*>> commands;
  for (const job::Maker& maker : catalogue.makers) {
    Arguments& arguments = makers.emplace_back();
    commands.emplace_back(add_maker(app, catalogue, maker, arguments), &arguments);
  }
  OtherArguments others;
  const CLI::App* bend = add_bend(app, others.bend);
  const CLI::App* batch = add_batch(app, catalogue, others.batch);
  const CLI::App* pack = add_pack(app, catalogue, others.pack);
  const CLI::App* info = add_info(app, others.info);
  const CLI::App* plates = add_plates(app, others.plates);
  const CLI::App* schema = add_schema(app, others.schema);
  const CLI::App* serve = add_serve(app, others.serve);
  const CLI::App* studio = add_studio(app, others.studio);
  const CLI::App* completion = add_completion(app, others.completion);
  const CLI::App* manual = add_manual(app, others.manual);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help, version and the like.
    if (error.get_exit_code() == 0) return app.exit(error);
    return wrong_usage(error, app);
  }
  for (const auto& [command, arguments] : commands)
    if (command->parsed()) return run_maker(catalogue, *arguments);
  if (bend->parsed()) return run_bend(catalogue, others.bend);
  if (batch->parsed()) return run_batch(catalogue, others.batch);
  if (pack->parsed()) return run_pack(catalogue, others.pack);
  if (info->parsed()) return run_info(others.info);
  if (plates->parsed()) return run_plates(others.plates);
  if (schema->parsed()) return run_schema(catalogue, others.schema);
  if (serve->parsed()) return run_serve(catalogue, others.serve);
  if (studio->parsed()) return run_studio(others.studio);
  if (completion->parsed()) return run_completion(app, catalogue, others.completion);
  if (manual->parsed()) return run_manual(app, catalogue, others.manual);
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
    return complain(error_of(refuse::program_defect, {{"reason", defect.what()}}));
  } catch (...) {
    return complain(error_of(refuse::program_defect, {{"reason", "an exception of unknown type"}}));
  }
}

}  // namespace planish::cli
