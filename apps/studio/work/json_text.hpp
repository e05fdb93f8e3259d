#pragma once

#include <planish/base/result.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace planish::studio {

/// Keys keep their order, so that files edited here look as before.
using Json = nlohmann::ordered_json;

/// Errors: `invalid_input` for text that is not JSON, or nested more than 100 deep. `what` names it
/// in messages.
Result<Json> parse_json(const std::string& text, const std::string& what);

/// The same JSON without line breaks and indentation.
std::string without_indents(const std::string& json);

/// Bytes that are not UTF-8 become U+FFFD. `indent` −1: one line.
std::string json_text(const Json& json, int indent = -1);

}  // namespace planish::studio
