#include "commands.hpp"
#include "option_parts.hpp"
#include "terminal.hpp"

#ifdef PLANISH_STUDIO
#include "../studio/studio.hpp"
#endif

namespace planish::cli {
namespace {

constexpr auto kStudioExamples = R"(Examples:
  planish studio                         opens a page in the browser: files are dropped there
  planish studio chair.json              the same, with a file open
  planish studio --no-browser --port 8731

It serves this machine alone and ends with Ctrl-C. More in docs/cli.md.)";

}  // namespace

CLI::App* add_studio(CLI::App& app, StudioArguments& arguments) {
  CLI::App* command = app.add_subcommand("studio", "see and change parts in a browser");
  add_text(*command, "input", arguments.input, "FILE",
           "file to open: STEP, plates, transition or slit file");
  constexpr int kLastPort = 65535;
  command
      ->add_option("--port", arguments.port, "port of the page's address; default: any free port")
      ->check(CLI::Range(1, kLastPort))
      ->type_name("N");
  constexpr int kDay = 86400;
  command
      ->add_option("--time-limit", arguments.time_limit,
                   "longest time for one request; default 120")
      ->check(CLI::Range(1, kDay))
      ->type_name("SECONDS");
  command->add_flag("--no-browser", arguments.no_browser,
                    "print the address, do not open a browser");
  command->footer(kStudioExamples);
  return command;
}

CLI::App* add_studio_worker(CLI::App& app, std::string& server) {
  CLI::App* command = app.add_subcommand("studio-worker")->group("");
  command->add_option("server", server)->required();
  return command;
}

#ifdef PLANISH_STUDIO

int run_studio(const StudioArguments& arguments) {
  studio::StudioOptions options;
  if (!arguments.input.empty()) options.file = arguments.input;
  options.port = arguments.port;
  if (arguments.time_limit) options.time_limit = std::chrono::seconds(*arguments.time_limit);
  options.open_browser = !arguments.no_browser;
  const auto done = studio::run_studio(options);
  return done ? 0 : complain(done.error());
}

int run_studio_worker(const std::string& server) { return studio::run_worker(server); }

#else

int run_studio(const StudioArguments&) {
  return complain({ErrorCode::bad_option,
                   "this planish was built without the studio (PLANISH_STUDIO=OFF)",
                   {}});
}

int run_studio_worker(const std::string&) { return run_studio({}); }

#endif

}  // namespace planish::cli
