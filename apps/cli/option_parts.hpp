#pragma once

#include <planish/io/flat_writers.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planish::cli {

/// A finite number, the whole text and nothing else, with a decimal point.
std::optional<double> parse_number(const std::string& text);

/// An option that takes a number for which `allowed` holds; `range` says in words what that is.
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        bool (*allowed)(double), const std::string& range,
                        const std::string& description);

/// An option that takes one of `words` or a face number.
CLI::Option* add_face(CLI::App& app, const std::string& name, std::string& target,
                      const std::vector<std::string>& words, const std::string& description);

/// An option whose value may be any text but the empty one; `type` stands for it in the help.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& type, const std::string& description);

/// An option that may be given several times, each time with one value, so that an input may
/// follow it.
CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description);

/// A check for options: what is wrong with an empty value, "" for any other.
std::string not_empty(const std::string& text);

/// "a|b|c"
std::string alternatives(const std::vector<std::string>& words);

/// An option that takes one of several words, each standing for a value.
template <typename T, typename Target>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target,
                        const std::vector<std::pair<std::string, T>>& choices,
                        const std::string& description) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices)
    words.push_back(word);
  const auto set = [&target, choices](const std::string& text) {
    for (const auto& [word, value] : choices) {
      if (word == text) target = value;
    }
  };
  const auto check = [words](const std::string& text) -> std::string {
    for (const std::string& word : words) {
      if (word == text) return {};
    }
    return fmt::format("\"{}\" is none of {}", text, fmt::join(words, ", "));
  };
  return app.add_option_function<std::string>(name, set, description)
      ->check(check)
      ->type_name(alternatives(words));
}

/// `--units`
template <typename Target>
CLI::Option* add_units(CLI::App& app, Target& target, const std::string& description) {
  return add_choice<LengthUnit>(
      app, "--units", target,
      {{"mm", LengthUnit::mm}, {"inch", LengthUnit::inch}, {"m", LengthUnit::m}}, description);
}

}  // namespace planish::cli
