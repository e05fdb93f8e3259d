#include "refusals.hpp"

#include <planish/schema/json_depth.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

// How deep a JSON text is nested, by counting brackets outside of texts, before a parser sees it:
// whoever walks through a document calls itself once a level, and a text of brackets alone would
// overflow the stack. The place of a fault is told by line and column, both from 1.

namespace planish::schema {
namespace {

struct Spot {
  int line, column;
};

Spot spot_of(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto last_break = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return {static_cast<int>(line), static_cast<int>(std::max<std::ptrdiff_t>(1, end - last_break))};
}

Error error_in(const Refusal& refusal, const std::string& text, std::size_t byte,
               std::string_view what, std::string where) {
  const Spot spot = spot_of(text, byte);
  if (where.ends_with(':')) where += line_and_column(text, byte);
  return error_of(refusal,
                  {{"what", what},
                   {"line", place::line(spot.line)},
                   {"column", spot.column},
                   {"most", kDeepestJson}},
                  std::move(where));
}

}  // namespace

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
  const Spot spot = spot_of(text, byte);
  return fmt::format("{}:{}", spot.line, spot.column);
}

Error too_deep(const std::string& json, std::size_t byte, std::string_view what,
               std::string where) {
  return error_in(refuse::too_deep, json, byte, what, std::move(where));
}

Error not_json(const std::string& text, std::size_t byte, std::string_view what,
               std::string where) {
  return error_in(refuse::not_json, text, byte, what, std::move(where));
}

}  // namespace planish::schema
