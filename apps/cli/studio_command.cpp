#include "commands.hpp"
#include "option_parts.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

namespace planish::cli {
namespace {

constexpr auto kStudioExamples = R"(Examples:
  planish studio                         opens a page in the browser: files are dropped there
  planish studio chair.json              the same, with a file open
  planish studio --no-browser --port 8731

It serves this machine alone and ends with Ctrl-C. More in docs/studio.md.)";

const job::Option kPort{.name = "port",
                        .kind = job::OptionKind::whole,
                        .description = "port of the page's address; default: any free port",
                        .range = {"a whole number from 1 to 65535", 1, 65535}};
const job::Option kRequestTime{.name = "time_limit",
                               .kind = job::OptionKind::whole,
                               .description = "time limit for one request; default 120",
                               .range = {"a whole number from 1 to 86400", 1, 86400}};  // a day
const job::Option kEndAfter{
    .name = "end_after",
    .kind = job::OptionKind::whole,
    .description = "end when no page has been open for this long; default: stay until Ctrl-C",
    .range = {"a whole number from 1 to 86400", 1, 86400}};

std::filesystem::path own_path() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
}

// "STEP, plates, transition or slit"
std::string any_input_of(const job::Catalogue& catalogue) {
  std::string text;
  for (const job::Maker& maker : catalogue.makers) {
    const bool last = &maker == &catalogue.makers.back();
    text += fmt::format("{}{}", text.empty() ? "" : last ? " or " : ", ", maker.input);
  }
  return text;
}

}  // namespace

CLI::App* add_studio(const Program& program, StudioArguments& arguments) {
  CLI::App* command = program.app.add_subcommand("studio", "show and edit parts in a browser");
  add_text(*command, "input", arguments.input, "FILE",
           fmt::format("file to open: {} file", any_input_of(program.catalogue)));
  add_option(*command, kPort, std::string(kPort.description), "N", arguments.options);
  add_option(*command, kRequestTime, std::string(kRequestTime.description), "SECONDS",
             arguments.options);
  add_option(*command, kEndAfter, std::string(kEndAfter.description), "SECONDS", arguments.options);
  command->add_flag("--no-browser", arguments.no_browser, "print the address and open no browser");
  command->footer(kStudioExamples);
  return command;
}

int run_studio(const Program&, const StudioArguments& arguments) {
  const auto given = [&](const char* name) {
    const auto value = arguments.options.number(name);
    return value ? std::to_string(static_cast<int>(*value)) : std::string();
  };
  const std::filesystem::path program = own_path().parent_path() / "planish-studio";
  std::array<std::string, 7> words{program.string(),
                                   "serve",
                                   arguments.input,
                                   given("port"),
                                   given("time_limit"),
                                   given("end_after"),
                                   arguments.no_browser ? "no-browser" : "browser"};
  std::array<char*, words.size() + 1> raw{};
  std::ranges::transform(words, raw.begin(), [](std::string& word) { return word.data(); });
  execv(program.c_str(), raw.data());
  const int reason = errno;
  return complain(error_of(refuse::no_studio,
                           {{"reason", std::strerror(reason)}, {"program", program.string()}}));
}

}  // namespace planish::cli
