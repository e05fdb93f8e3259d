#include "json_text.hpp"

#include <fmt/format.h>

namespace planish::studio {

Result<Json> parse_json(const std::string& text, const std::string& what) {
  // Whoever walks through a document calls itself once a level.
  constexpr int kDeepest = 100;
  bool too_deep = false;
  const auto watch = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  try {
    Json json = Json::parse(text, watch);
    if (too_deep) return fail(ErrorCode::invalid_input, fmt::format("the {} is nested more than {} deep", what, kDeepest));
    return json;
  } catch (const Json::exception& error) {
    return fail(ErrorCode::invalid_input, fmt::format("the {} is not JSON: {}", what, error.what()));
  }
}

std::string json_text(const Json& json, int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

}  // namespace planish::studio
