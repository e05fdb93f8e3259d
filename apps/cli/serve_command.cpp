#include "apart.hpp"
#include "commands.hpp"
#include "many_parts.hpp"
#include "option_parts.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/serve/serve.hpp>

#include <fcntl.h>
#include <unistd.h>

namespace planish::cli {
namespace {

constexpr auto kServeExamples = R"(Examples:
  planish serve --stdio               for an editor, an agent or another program
  planish serve --stdio --jobs 2      at most two requests at a time
  echo '{"jsonrpc": "2.0", "id": 1, "method": "info", "params": {"input": "part.step"}}' |
    planish serve --stdio

Exit status:
  0 the messages have ended, or `exit` after `shutdown`     2 wrong usage
  1 `exit` without `shutdown`, or ended by a signal

More in docs/serve.md.)";

}  // namespace

CLI::App* add_serve(const Program& program, ServeArguments& arguments) {
  CLI::App* command = program.app.add_subcommand(
      "serve", "answer requests from other programs: JSON-RPC, Model Context Protocol");
  command->add_flag("--stdio", arguments.stdio, "over standard input and output")->required();
  command
      ->add_option("--jobs", arguments.how.workers,
                   "requests worked on at a time; default one per core")
      ->check(check_of(kJobs))
      ->type_name("N")
      ->group("Running");
  add_limits(*command, arguments.how.limits);
  command->footer(kServeExamples);
  return command;
}

int run_serve(const Program& program, const ServeArguments& arguments) {
  // Standard output is for answers alone: whatever else is printed goes where errors go.
  const int output = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (output < 0) return complain(error_of(refuse::no_standard_output, {}));
  if (dup2(STDERR_FILENO, STDOUT_FILENO) < 0) close(STDOUT_FILENO);
  const serve::ServeOptions options{workers_of(arguments.how), arguments.how.limits,
                                    PLANISH_VERSION};
  return serve::serve(STDIN_FILENO, output, options, program.catalogue, interrupted);
}

}  // namespace planish::cli
