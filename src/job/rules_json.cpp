#include "json_parts.hpp"

#include <planish/job/rules_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace planish::job {
namespace {

constexpr auto kFormat = "planish/rules";
constexpr int kVersion = 1;

// JSON pointer (RFC 6901) of a key at the top.
std::string pointer(const std::string& key) {
  std::string text = "/";
  for (const char c : key) {
    if (c == '~')
      text += "~0";
    else if (c == '/')
      text += "~1";
    else
      text += c;
  }
  return text;
}

std::string known_keys() {
  std::string text = "enabled";
  for (const RuleField& field : rule_fields())
    text += fmt::format(", {}", field.name);
  return text;
}

Error invalid(const std::string& name, const std::string& key, const std::string& what) {
  return {ErrorCode::invalid_input, fmt::format("rules file: {} {}", pointer(key), what),
          name + pointer(key)};
}

std::optional<Error> set_threshold(Rules& rules, const std::string& key, const Json& value,
                                   const std::string& name) {
  const auto fields = rule_fields();
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const RuleField& field) { return field.name == key; });
  if (found == fields.end()) {
    return invalid(name, key, fmt::format("is no rule; the rules are {}", known_keys()));
  }
  if (!value.is_number() || !std::isfinite(value.get<double>()) || value.get<double>() < 0.0) {
    return invalid(name, key, fmt::format("must be a number of at least 0, not {}", value.dump()));
  }
  rules.*(found->value) = value.get<double>();
  return std::nullopt;
}

std::optional<Error> set(Rules& rules, const std::string& key, const Json& value,
                         const std::string& name) {
  if (key == "format") {
    if (value == kFormat) return std::nullopt;
    return invalid(name, key, fmt::format("must be \"{}\", not {}", kFormat, value.dump()));
  }
  if (key == "version") {
    if (value == kVersion) return std::nullopt;
    return invalid(name, key, fmt::format("must be {}, not {}", kVersion, value.dump()));
  }
  if (key == "enabled") {
    if (!value.is_boolean()) {
      return invalid(name, key, fmt::format("must be true or false, not {}", value.dump()));
    }
    rules.enabled = value.get<bool>();
    return std::nullopt;
  }
  return set_threshold(rules, key, value, name);
}

// Line and column, 1-based, of a byte offset.
std::string position(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto last_break = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return fmt::format("{}:{}", line, std::max<std::ptrdiff_t>(1, end - last_break));
}

Result<Json> parsed(const std::string& text, const std::string& name) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::string place = position(text, error.byte);
    return fail(ErrorCode::invalid_input,
                fmt::format("the rules file is not JSON: mistake at line:column {}", place),
                name + ":" + place);
  } catch (const Json::exception& error) {
    return fail(ErrorCode::invalid_input,
                fmt::format("the rules file is not JSON: {}", error.what()), name);
  }
}

}  // namespace

std::string rules_json(const Rules& rules) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["enabled"] = rules.enabled;
  for (const RuleField& field : rule_fields()) {
    json[std::string(field.name)] = rules.*(field.value);
  }
  return text_of(json);
}

Result<Rules> parse_rules(const std::string& text, const std::string& name) {
  const auto json = parsed(text, name);
  if (!json) return tl::unexpected(json.error());
  if (!json->is_object()) {
    return fail(ErrorCode::invalid_input, "the rules file must hold one JSON object", name);
  }
  Rules rules;
  for (const auto& [key, value] : json->items()) {
    if (auto error = set(rules, key, value, name)) return tl::unexpected(*error);
  }
  if (rules.k_low > rules.k_high) {
    return tl::unexpected(invalid(
        name, "k_low", fmt::format("is {}, above k_high, which is {}", rules.k_low, rules.k_high)));
  }
  return rules;
}

}  // namespace planish::job
