#include "json_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::studio {
namespace {

/// Line and column, from 1, of a byte.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t last = before.rfind('\n');
  return fmt::format("{}:{}", line, before.size() - (last == std::string::npos ? 0 : last + 1) + 1);
}

}  // namespace

Result<Json> parse_json(const std::string& text, const std::string& what) {
  // Functions that walk a document recurse once per level.
  constexpr int kDeepest = 100;
  bool too_deep = false;
  const auto watch = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  try {
    Json json = Json::parse(text, watch);
    if (too_deep)
      return fail(code::invalid_input,
                  fmt::format("the {} is nested more than {} deep", what, kDeepest));
    return json;
  } catch (const Json::parse_error& error) {
    return fail(code::invalid_input, fmt::format("the {} is not JSON: mistake at line:column {}",
                                                 what, place_of(text, error.byte)));
  } catch (const Json::exception&) {
    return fail(code::invalid_input,
                fmt::format("the {} is not JSON: a number is too large", what));
  }
}

std::string without_indents(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  // Strings contain no line breaks: JSON writes them as escapes.
  for (std::size_t at = 0; at < json.size();) {
    const std::size_t end = std::min(json.find('\n', at), json.size());
    text.append(json, at, end - at);
    at = std::min(json.find_first_not_of(' ', end + 1), json.size());
  }
  return text;
}

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace planish::studio
