#include "json_reading.hpp"

#include <planish/job/rules_json.hpp>

#include <fmt/format.h>

namespace planish::job {
namespace {

constexpr auto kFormat = "planish/rules";
constexpr int kVersion = 1;

std::vector<std::string> known_keys() {
  std::vector<std::string> keys{"format", "version", "enabled"};
  for (const RuleField& field : rule_fields())
    keys.emplace_back(field.name);
  return keys;
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
  JsonReading reading(text, "rules file", name);
  const JsonPlace file(reading);
  file.keys({}, known_keys());
  file.format(kFormat, kVersion);
  Rules rules;
  if (const JsonPlace enabled = file["enabled"]; enabled.given()) rules.enabled = enabled.yes();
  for (const RuleField& field : rule_fields()) {
    double& threshold = rules.*(field.value);
    threshold = file[std::string(field.name)].maybe_number(kAtLeastZero).value_or(threshold);
  }
  if (rules.k_low > rules.k_high) {
    file["k_low"].mistake(
        fmt::format("is {}, above k_high, which is {}", rules.k_low, rules.k_high));
  }
  if (reading.error()) return tl::unexpected(*reading.error());
  return rules;
}

}  // namespace planish::job
