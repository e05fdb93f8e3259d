#include "option_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::cli {

std::string spelled(const Error& error) {
  std::string text;
  for (const Piece& piece : wording(error))
    text += piece.option.empty() ? piece.text : flag_of(piece.option);
  return text;
}

namespace {

/// A sentence about an option without the option, which the parser says before it.
std::string behind_option(Error error) {
  const std::vector<Piece> pieces = wording(error);
  const bool begins = !pieces.empty() && !pieces.front().option.empty();
  std::string text = spelled(error);
  if (begins) text.erase(0, flag_of(pieces.front().option).size() + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

void add_grouped(CLI::App& app, const job::Option& option, const std::string& description,
                 job::OptionValues& values) {
  CLI::Option* added = option.kind == job::OptionKind::flag
                           ? app.add_flag_callback(
                                 flag_of(option.name),
                                 [&values, &option] { values.set(option, true); }, description)
                           : add_option(app, option, description, type_name(option), values);
  added->group(std::string(job::heading(option.group)));
}

std::string type_name(const job::Option& option) {
  using job::OptionKind;
  switch (option.kind) {
    case OptionKind::word:
      return fmt::format("{}", fmt::join(option.words, "|"));
    case OptionKind::face:
      return fmt::format("{}|FACE", fmt::join(option.words, "|"));
    case OptionKind::name:
      return "N|NAME";
    case OptionKind::file:
      return std::string(option.file_type);
    case OptionKind::by_bend:
      return "BEND=K";
    case OptionKind::whole:
      return "N";
    default:
      return "NUMBER";
  }
}

std::function<std::string(const std::string&)> check_of(job::Option option) {
  return [option = std::move(option)](const std::string& text) -> std::string {
    const auto fine = job::OptionValues().set_text(option, text);
    return fine ? std::string() : behind_option(fine.error());
  };
}

CLI::Option* add_option(CLI::App& app, const job::Option& option, const std::string& description,
                        const std::string& type, job::OptionValues& values) {
  const auto set = [&](const std::vector<std::string>& texts) {
    for (const std::string& text : texts)
      (void)values.set_text(option, text);  // each was checked
  };
  auto* made = app.add_option_function<std::vector<std::string>>(flag_of(option.name), set,
                                                                 description);
  made->allow_extra_args(false)->check(check_of(option))->type_name(type);
  if (option.kind != job::OptionKind::by_bend)
    made->multi_option_policy(CLI::MultiOptionPolicy::Throw)->expected(1);
  return made;
}

std::vector<std::string> between_commas(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text)
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& type, const std::string& description) {
  return app.add_option(name, target, description)->check(not_empty)->type_name(type);
}

void add_step_input(CLI::App& app, std::string& target) {
  add_text(app, "input", target, "STEP", "STEP file, or - for standard input")->required();
}

CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description) {
  return app.add_option(name, target, description)->allow_extra_args(false)->check(not_empty);
}

std::string not_empty(const std::string& text) { return text.empty() ? "is empty" : ""; }

}  // namespace planish::cli
