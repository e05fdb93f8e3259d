#include "commands.hpp"
#include "completion.hpp"
#include "manual.hpp"
#include "option_parts.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/io/flat_writers.hpp>
#include <planish/job/options.hpp>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>

// The commands that are about the program itself: its completion and its manual.

namespace planish::cli {
namespace {

constexpr auto kCompletionExamples = R"(Examples:
  source <(planish completion bash)          for this shell, in bash
  planish completion zsh > ~/.zfunc/_planish where a folder of `fpath` has it, zsh finds it
  planish completion fish > ~/.config/fish/completions/planish.fish

Debian's package has them in their places.)";

constexpr auto kManualExamples = R"(Examples:
  planish manual | man -l -           the page of the program, planish(1)
  planish manual unfold | man -l -    that of a command, planish-unfold(1)
  planish manual -o man/man1          all of them, as files

Debian's package has them in their places: `man planish`.)";

/// The day of the page: SOURCE_DATE_EPOCH, by which builds are made reproducible, or today.
std::string day_of_manual() {
  std::time_t time = std::time(nullptr);
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH"))
    if (const auto seconds = job::parse_number(given)) time = static_cast<std::time_t>(*seconds);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(time));
}

Error no_such(const std::string& what, const std::string& name,
              const std::vector<std::string>& names) {
  return error_of(refuse::no_such_name, {{"what", what}, {"name", name}, {"known", listed(names)}});
}

}  // namespace

CLI::App* add_completion(const Program& program, CompletionArguments& arguments) {
  CLI::App* command = program.app.add_subcommand("completion",
                                                 "print the completion script for a shell");
  add_text(*command, "shell", arguments.shell, "bash|zsh|fish", "which shell")->required();
  command->footer(kCompletionExamples);
  return command;
}

CLI::App* add_manual(const Program& program, ManualArguments& arguments) {
  CLI::App* command = program.app.add_subcommand("manual", "print the manual page of a command");
  add_text(*command, "command", arguments.command, "COMMAND",
           "command; without it, the page of the program itself");
  add_text(*command, "-o,--output", arguments.folder, "FOLDER/",
           "existing folder to write the pages of all commands to");
  command->footer(kManualExamples);
  return command;
}

int run_completion(const Program& program, const CompletionArguments& arguments) {
  const auto table = command_table(program.app, program.catalogue);
  const std::string& shell = arguments.shell;
  if (shell == "bash")
    fmt::print("{}", bash_completion(table));
  else if (shell == "zsh")
    fmt::print("{}", zsh_completion(table));
  else if (shell == "fish")
    fmt::print("{}", fish_completion(table));
  else
    return complain(no_such("completion for", shell, {"bash", "zsh", "fish"}));
  return 0;
}

int run_manual(const Program& program, const ManualArguments& arguments) {
  const auto table = command_table(program.app, program.catalogue);
  const std::string day = day_of_manual();
  std::vector<std::string> names;
  for (const TableCommand& command : table) {
    const bool whole = &command == &table.front();
    const std::string page = manual_page(table, command, day, PLANISH_VERSION);
    if (!arguments.folder.empty()) {
      const auto name = page_name(table, command) + ".1";
      if (const auto done = write_file(std::filesystem::path(arguments.folder) / name, page); !done)
        return complain(done.error());
    } else if (arguments.command.empty() ? whole : command.name == arguments.command) {
      fmt::print("{}", page);
      return 0;
    }
    if (!whole) names.push_back(command.name);
  }
  return arguments.folder.empty() ? complain(no_such("command", arguments.command, names)) : 0;
}

}  // namespace planish::cli
