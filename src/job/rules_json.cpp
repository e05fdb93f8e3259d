#include "input_schemas.hpp"
#include "json_reading.hpp"

#include <planish/job/rules_json.hpp>

#include <fmt/format.h>

namespace planish::job {
namespace {

constexpr auto kFormat = "planish/rules";
constexpr int kVersion = 1;

Schema make_schema() {
  const Rules usual;
  std::vector<Field> fields = header_fields(kFormat, kVersion);
  fields.push_back(
      optional("enabled", flag().defaulting(usual.enabled).said("false turns every rule off")));
  for (const RuleField& field : rule_fields())
    fields.push_back(optional(std::string(field.name), number(kAtLeastZero)
                                                           .defaulting(usual.*(field.value))
                                                           .said(std::string(field.description))));
  return object(std::move(fields)).said("Thresholds of the rules of manufacture");
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

const Schema& rules_schema() {
  static const Schema schema = make_schema();
  return schema;
}

Result<Rules> parse_rules(const std::string& text, const std::string& name) {
  JsonReading reading(text, "rules file", name, rules_schema());
  const JsonPlace file(reading);
  Rules rules;
  rules.enabled = file["enabled"].yes();
  for (const RuleField& field : rule_fields())
    rules.*(field.value) = file[std::string(field.name)].number();
  if (rules.k_low > rules.k_high) {
    file["k_low"].mistake(
        fmt::format("is {}, above k_high, which is {}", rules.k_low, rules.k_high));
  }
  if (reading.error()) return tl::unexpected(*reading.error());
  return rules;
}

}  // namespace planish::job
