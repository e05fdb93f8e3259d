#include <planish/schema/schema.hpp>

#include <gtest/gtest.h>

namespace planish::schema {
namespace {

Json printed(const Schema& schema) {
  Json json = json_schema(schema, "title", "id.json");
  for (const char* head : {"$schema", "$id", "title"})
    json.erase(head);
  return json;
}

// Whether the rules are those that are checked: SchemaCheck.TakesWhatThePrintedSchemaTakes.

TEST(SchemaJson, SaysWhatNumbersMeasure) {
  EXPECT_EQ(printed(length()), Json::parse(R"({"type": "number", "quantity": "length"})"));
  EXPECT_EQ(printed(area())["quantity"], "area");
  EXPECT_EQ(printed(volume())["quantity"], "volume");
  EXPECT_EQ(printed(angle(kAnyNumber))["quantity"], "degrees");
  EXPECT_FALSE(printed(number()).contains("quantity"));
}

TEST(SchemaJson, WritesWholeLimitsWithoutAPoint) {
  EXPECT_EQ(printed(number({"", 0.0, 45.0, true, false})).dump(),
            R"({"type":"number","minimum":0,"exclusiveMaximum":45})");
  EXPECT_EQ(printed(number({"", 0.5, 1.5, false, true})).dump(),
            R"({"type":"number","exclusiveMinimum":0.5,"maximum":1.5})");
  EXPECT_EQ(printed(number()).dump(), R"({"type":"number"})");
}

TEST(SchemaJson, HasDescriptionsAndDefaults) {
  EXPECT_EQ(printed(flag().defaulting(false).said("if so")),
            Json::parse(R"({"description": "if so", "type": "boolean", "default": false})"));
  const Json either = printed(text().said("a name").or_null());
  EXPECT_EQ(either["description"], "a name");
  EXPECT_EQ(either["anyOf"], Json::parse(R"([{"type": "string", "minLength": 1},
                                             {"type": "null"}])"));
}

TEST(SchemaJson, BeginsWithWhichStandardItFollows) {
  const Json json = json_schema(anything(), "planish/x", "x.json");
  EXPECT_EQ(json.dump(), R"({"$schema":"https://json-schema.org/draft/2020-12/schema",)"
                         R"("$id":"x.json","title":"planish/x"})");
}

}  // namespace
}  // namespace planish::schema
