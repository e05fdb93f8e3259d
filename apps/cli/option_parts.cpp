#include "option_parts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace planish::cli {

std::optional<double> parse_number(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        bool (*allowed)(double), const std::string& range,
                        const std::string& description) {
  const auto set = [&target](const std::string& text) { target = parse_number(text); };
  const auto check = [allowed, range](const std::string& text) -> std::string {
    const auto value = parse_number(text);
    if (value && allowed(*value)) return {};
    return fmt::format("\"{}\" is no number {}", text, range);
  };
  return app.add_option_function<std::string>(name, set, description)
      ->check(check)
      ->type_name("NUMBER");
}

CLI::Option* add_face(CLI::App& app, const std::string& name, std::string& target,
                      const std::vector<std::string>& words, const std::string& description) {
  const auto check = [words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return {};
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && number >= 1) return {};
    return fmt::format("\"{}\" is neither a face number (1, 2, …) nor {}", text,
                       fmt::join(words, ", "));
  };
  return app.add_option(name, target, description)
      ->check(check)
      ->type_name(alternatives(words) + "|FACE");
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& type, const std::string& description) {
  return app.add_option(name, target, description)->check(not_empty)->type_name(type);
}

CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description) {
  return app.add_option(name, target, description)->allow_extra_args(false)->check(not_empty);
}

std::string not_empty(const std::string& text) { return text.empty() ? "is empty" : ""; }

std::string alternatives(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, "|"));
}

}  // namespace planish::cli
