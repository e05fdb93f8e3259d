#include "commands.hpp"
#include "help_format.hpp"
#include "terminal.hpp"

#include <planish/base/result.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#ifndef PLANISH_VERSION
#define PLANISH_VERSION "unknown"
#endif

namespace planish::cli {
namespace {

constexpr int kWrongUsage = 2;

constexpr auto kExamples = R"(Examples:
  planish unfold part.step                   part.dxf beside it, a summary here
  planish unfold cabinet.step --all -o flat/ every body, with summary.csv
  planish connect plates.json                joins plates by bends, and lays them flat
  planish transition spec.json               joins two profiles, and lays the net
  planish slit chair.json                    bends the strips of a slit sheet
  planish info part.step                     what is in the file
  planish studio part.step                   all of it in a browser, to see and to change

`planish COMMAND --help` says more, docs/cli.md all.)";

// CLI11's texts may have several lines; one sentence is enough, and where to read on.
int wrong_usage(const CLI::ParseError& error, const CLI::App& app) {
  std::string text = error.what();
  text = text.substr(0, text.find('\n'));
  const auto chosen = app.get_subcommands();
  fmt::print(stderr, "planish: {} (see `planish {}--help`)\n", text,
             chosen.empty() ? "" : chosen.front()->get_name() + " ");
  return kWrongUsage;
}

// Text that did not reach its reader (a full disk behind `>`) must not end as success.
int flushed(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  const int failed = complain({ErrorCode::cannot_write, "cannot write to standard output", {}});
  return status == 0 ? failed : status;
}

int run(int argc, char** argv) {
  CLI::App app("Planish lays sheet metal flat and shows that the flat shape is right.", "planish");
  app.set_version_flag("--version", "planish " PLANISH_VERSION, "print the version, and end");
  app.footer(kExamples);
  app.formatter(help_format());  // before the commands, which inherit it
  UnfoldArguments unfold_arguments;
  MakeArguments connect_arguments, transition_arguments, slit_arguments;
  InfoArguments info_arguments;
  StudioArguments studio_arguments;
  std::string studio_server;
  const CLI::App* unfold = add_unfold(app, unfold_arguments);
  const CLI::App* connect = add_connect(app, connect_arguments);
  const CLI::App* transition = add_transition(app, transition_arguments);
  const CLI::App* slit = add_slit(app, slit_arguments);
  const CLI::App* info = add_info(app, info_arguments);
  const CLI::App* studio = add_studio(app, studio_arguments);
  const CLI::App* studio_worker = add_studio_worker(app, studio_server);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help, version and the like.
    if (error.get_exit_code() == 0) return app.exit(error);
    return wrong_usage(error, app);
  }
  if (unfold->parsed()) return run_unfold(unfold_arguments);
  if (connect->parsed()) return run_connect(connect_arguments);
  if (transition->parsed()) return run_transition(transition_arguments);
  if (slit->parsed()) return run_slit(slit_arguments);
  if (info->parsed()) return run_info(info_arguments);
  if (studio->parsed()) return run_studio(studio_arguments);
  if (studio_worker->parsed()) return run_studio_worker(studio_server);
  fmt::print("{}", app.help());
  return 0;
}

}  // namespace
}  // namespace planish::cli

int main(int argc, char** argv) {
  using namespace planish;
  cli::stop_on_interrupt();
  try {
    return cli::flushed(cli::run(argc, argv));
  } catch (const std::exception& defect) {
    return cli::complain({ErrorCode::internal, defect.what(), {}});
  } catch (...) {
    return cli::complain({ErrorCode::internal, "an exception of unknown type", {}});
  }
}
