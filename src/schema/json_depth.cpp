#include <planish/schema/json_depth.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace planish::schema {

std::optional<std::size_t> too_deep_at(const std::string& json) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') in_text = !in_text;
    if (in_text) {
      if (c == '\\') ++i;  // what is escaped ends no text
      continue;
    }
    if (c == ']' || c == '}') --depth;
    if ((c == '[' || c == '{') && ++depth > kDeepestJson) return i + 1;
  }
  return std::nullopt;
}

std::string line_and_column(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto last_break = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return fmt::format("{}:{}", line, std::max<std::ptrdiff_t>(1, end - last_break));
}

std::string too_deep_sentence(const std::string& json, std::size_t byte) {
  return fmt::format("is nested more than {} deep at line:column {}: leave out what is inside",
                     kDeepestJson, line_and_column(json, byte));
}

}  // namespace planish::schema
