#include "usage.hpp"

#include "option_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace planish::cli {
namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

// "--flat" of "--flat=a.dxf", "-o" of "-oa.dxf".
std::string option_name(const std::string& word) {
  return word.starts_with("--") ? word.substr(0, word.find('=')) : word.substr(0, 2);
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  auto all = app.get_subcommands([](const CLI::App*) { return true; });
  std::erase_if(all, [](const CLI::App* one) { return one->get_group().empty(); });
  return all;
}

std::string no_such_option(const CLI::App& command, const CLI::App& app, const std::string& word) {
  const std::string name = option_name(word);
  std::vector<std::string> others;
  for (const CLI::App* one : commands_of(app))
    if (one->get_option_no_throw(name)) others.push_back(one->get_name());
  const char* have = others.size() == 1 ? " has it" : " have it";
  return fmt::format("`{}` has no option {}{}", command.get_name(), name,
                     others.empty() ? "" : "; " + listed(others) + have);
}

std::string too_much(const CLI::App& command, const CLI::App& app, const std::string& word) {
  if (&command == &app) {
    const auto names = mapped(commands_of(app),
                              [&](const CLI::App* one) { return one->get_name(); });
    return fmt::format("there is no command \"{}\"; there are {}", word, listed(names));
  }
  const auto inputs = command.get_options(
      [](const CLI::Option* one) { return one->get_positional(); });
  const std::string taken = inputs.empty() ? "no word" : "one " + inputs.front()->get_type_name();
  return fmt::format("`{}` takes {}: leave \"{}\" out", command.get_name(), taken, word);
}

// What was taken by nobody; empty where all was.
std::string left_over(const CLI::App& command, const CLI::App& app) {
  const auto words = command.remaining();
  if (words.empty()) return {};
  const auto option = std::ranges::find_if(words, is_option);
  // A command that is not known has options that are not known either.
  if (option == words.end() || (&command == &app && !is_option(words.front())))
    return too_much(command, app, words.front());
  return no_such_option(command, app, *option);
}

// Of an option that takes one value.
std::string not_one_value(const CLI::App& command, const std::string& text) {
  const std::string name = text.substr(0, text.find(':'));
  const CLI::Option* option = command.get_option_no_throw(name);
  if (!option) return text;
  if (option->count() > 1)
    return fmt::format("{} is given {} times: give it once", name, option->count());
  return fmt::format("{} needs a value: {} {}", name, name, option->get_type_name());
}

std::string sentence(const CLI::ParseError& error, const CLI::App& app, const CLI::App& command) {
  // CLI11's texts may have several lines.
  const std::string text = std::string(error.what())
                               .substr(0, std::string(error.what()).find('\n'));
  for (const CLI::App* one : {&app, &command})
    if (std::string left = left_over(*one, app); !left.empty()) return left;
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return not_one_value(command, text);
  return text;
}

}  // namespace

std::string usage_sentence(const CLI::ParseError& error, const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  return fmt::format("{} (see `planish {}--help`)", sentence(error, app, command),
                     chosen.empty() ? "" : command.get_name() + " ");
}

}  // namespace planish::cli
