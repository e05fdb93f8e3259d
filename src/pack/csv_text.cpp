#include "csv_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::pack {
namespace {

std::string cell(const std::string& text) {
  if (text.find_first_of(",;\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::string csv_row(const std::vector<std::string>& cells) {
  std::vector<std::string> safe;
  for (const std::string& text : cells)
    safe.push_back(cell(text));
  return fmt::format("{}\n", fmt::join(safe, ","));
}

std::string csv_number(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string csv_number(const std::optional<double>& value) {
  return value ? csv_number(*value) : std::string();
}

}  // namespace planish::pack
