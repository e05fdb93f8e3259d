#include "json_text.hpp"

#include "../refusals.hpp"

#include <planish/schema/json_depth.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::studio {
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
      return fail(refuse::nested_too_deep, {{"what", "The " + what}, {"most", kDeepest}});
    return json;
  } catch (const Json::parse_error& error) {
    return fail(schema::not_json(text, error.byte, "The " + what, ":"));
  } catch (const Json::exception&) {
    return fail(refuse::number_too_large, {{"what", "The " + what}});
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
