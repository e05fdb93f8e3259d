#include "refusals.hpp"

#include <planish/schema/json_reading.hpp>
#include <planish/shop/rules_json.hpp>
#include <planish/shop/schemas.hpp>

namespace planish::shop {
using namespace schema;
namespace {

constexpr auto kRulesFormat = "planish/rules";
constexpr int kRulesVersion = 1;

Schema make_rules_schema() {
  const Rules usual;
  std::vector<Field> fields = header_fields(kRulesFormat, kRulesVersion);
  fields.push_back(
      optional("enabled", flag().defaulting(usual.enabled).said("false turns every rule off")));
  fields.push_back(optional(
      "strict",
      flag().defaulting(true).said("whether every breach is a warning; false: info where the "
                                   "guidelines keep a margin")));
  fields.push_back(
      optional("sources", map(any_text()).said("where thresholds come from, by key; not read")));
  for (const RuleField& field : rule_fields())
    fields.push_back(optional(std::string(field.name),
                              number(kAtLeastZero).said(std::string(field.description))));
  return object(std::move(fields))
      .said("Thresholds of the rules of manufacture; those left out are those of the process");
}

}  // namespace

std::string rules_json(const Rules& rules) {
  Json json;
  json["format"] = kRulesFormat;
  json["version"] = kRulesVersion;
  json["enabled"] = rules.enabled;
  json["strict"] = rules.strict;
  for (const RuleField& field : rule_fields()) {
    json[std::string(field.name)] = rules.*(field.value);
  }
  for (const RuleField& field : rule_fields())
    json["sources"][std::string(field.name)] = field.origin;
  return text_of(json);
}

const Schema& rules_schema() {
  static const Schema schema = make_rules_schema();
  return schema;
}

Result<Rules> parse_rules(const std::string& text, const std::string& name, const Rules& usual) {
  JsonReading reading(text, "rules file", name, rules_schema());
  const JsonPlace file(reading);
  Rules rules = usual;
  rules.enabled = file["enabled"].yes();
  rules.strict = file["strict"].yes();
  for (const RuleField& field : rule_fields())
    if (const auto value = file[std::string(field.name)].maybe_number())
      rules.*(field.value) = *value;
  if (rules.k_low > rules.k_high) {
    file["k_low"].mistake(refuse::k_low_too_high,
                          {{"low", rules.k_low, unit::none}, {"high", rules.k_high, unit::none}});
  }
  if (reading.error()) return tl::unexpected(*reading.error());
  return rules;
}

}  // namespace planish::shop
