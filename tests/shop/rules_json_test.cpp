#include <planish/shop/rules_json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::shop {
namespace {

using ::testing::HasSubstr;

Error refusal_of(const std::string& text) {
  const auto rules = parse_rules(text, "r.json");
  EXPECT_FALSE(rules.has_value()) << text;
  return rules ? Error{} : rules.error();
}

TEST(RulesJson, ReadsWhatItWrites) {
  Rules rules;
  rules.flange_height_t = 4.0;
  rules.hem_return_t = 7.25;
  rules.k_high = 0.6;
  rules.enabled = false;
  const auto read = parse_rules(rules_json(rules), "r.json");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(rules_json(*read), rules_json(rules));
  EXPECT_EQ(read->flange_height_t, 4.0);
  EXPECT_EQ(read->hem_return_t, 7.25);
  EXPECT_FALSE(read->enabled);
}

TEST(RulesJson, WritesEveryThreshold) {
  const auto written = nlohmann::json::parse(rules_json(Rules{}));
  for (const RuleField& field : rule_fields()) {
    EXPECT_EQ(written[std::string(field.name)], Rules{}.*(field.value)) << field.name;
  }
  EXPECT_EQ(written["format"], "planish/rules");
  EXPECT_EQ(written["enabled"], true);
}

TEST(RulesJson, KeepsTheDefaultsOfKeysLeftOut) {
  const auto rules = parse_rules(R"({"opening_to_edge_t": 3})", "r.json");
  ASSERT_TRUE(rules.has_value());
  EXPECT_EQ(rules->opening_to_edge_t, 3.0);
  EXPECT_EQ(rules->opening_to_bend_t, Rules{}.opening_to_bend_t);
  EXPECT_TRUE(parse_rules("{}", "r.json").has_value());
  const auto punched = parse_rules(R"({"opening_to_edge_t": 3})", "r.json",
                                   rules_for(Process::punch));
  ASSERT_TRUE(punched.has_value());
  EXPECT_EQ(punched->opening_to_edge_t, 3.0);
  EXPECT_EQ(punched->smallest_opening_t, 1.2);
}

TEST(RulesJson, IsStrictUnlessItSaysOtherwise) {
  EXPECT_FALSE(Rules{}.strict);
  EXPECT_TRUE(parse_rules("{}", "r.json")->strict);
  EXPECT_FALSE(parse_rules(R"({"strict": false})", "r.json")->strict);
}

TEST(RulesJson, NamesAnUnknownKeyByItsPointer) {
  const Error error = refusal_of(R"({"flange_heigth_t": 2})");
  EXPECT_EQ(error.code, code::invalid_input);
  EXPECT_THAT(error.message, HasSubstr("/flange_heigth_t"));
  EXPECT_THAT(error.message, HasSubstr("flange_height_t"));
  EXPECT_EQ(error.where, "r.json/flange_heigth_t");
  EXPECT_EQ(refusal_of(R"({"a/b~c": 2})").where, "r.json/a~1b~0c");
}

TEST(RulesJson, RefusesValuesThatAreNoThreshold) {
  for (const char* value : {"-1", "\"2\"", "null", "true", "[1]", "{}"}) {
    const Error error = refusal_of(std::string("{\"hem_diameter_t\": ") + value + "}");
    EXPECT_EQ(error.code, code::invalid_input) << value;
    EXPECT_THAT(error.message, HasSubstr("/hem_diameter_t must be a number")) << value;
  }
  EXPECT_THAT(refusal_of(R"({"enabled": 1})").message, HasSubstr("/enabled must be true or false"));
  EXPECT_THAT(refusal_of(R"({"k_low": 0.6})").message, HasSubstr("above k_high"));
}

TEST(RulesJson, RefusesOtherFormatsAndVersions) {
  EXPECT_THAT(refusal_of(R"({"format": "planish/plates"})").message, HasSubstr("/format must be"));
  EXPECT_THAT(refusal_of(R"({"version": 2})").message, HasSubstr("/version must be 1"));
}

TEST(RulesJson, FindsTheLineAndColumnOfAMistake) {
  const Error error = refusal_of("{\n  \"k_low\": 0.1,\n  \"k_high\" 0.6\n}");
  EXPECT_EQ(error.code, code::invalid_input);
  EXPECT_THAT(error.where, HasSubstr("r.json:3:"));
  for (const char* text : {"", "[]", "3", "{", "{\"k_low\": 1e999}", "\xff"}) {
    EXPECT_EQ(refusal_of(text).code, code::invalid_input) << text;
  }
}

}  // namespace
}  // namespace planish::shop
