#include <planish/schema/fail_at.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/schema/schema.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::schema {
namespace {

using ::testing::HasSubstr;

std::string sentence(const Schema& schema, const char* text) {
  const auto wrong = first_mistake(schema, Json::parse(text));
  return wrong ? error_at(*wrong->refusal, wrong->pointer, wrong->facts).message : "";
}

TEST(Schema, TakesNumbersWithinTheirRangeAlone) {
  const Schema share = number(kShare);
  for (const char* fine : {"0", "1", "0.25"})
    EXPECT_EQ(sentence(share, fine), "");
  EXPECT_EQ(sentence(share, "-0.1"), "The whole input must be a number from 0 to 1, not -0.1.");
  EXPECT_EQ(sentence(share, "\"1\""), "The whole input must be a number from 0 to 1, not \"1\".");
  EXPECT_EQ(sentence(number(kAboveZero), "0"), "The whole input must be a number above 0, not 0.");
  EXPECT_EQ(sentence(whole(1, 6), "2.0"), "") << "as JSON Schema has it";
  EXPECT_EQ(sentence(whole(1, 6), "7"),
            "The whole input must be a whole number from 1 to 6, not 7.");
}

TEST(Schema, NamesThePlaceByItsPointer) {
  const Schema schema = object({required("rows", list(object({required("a/b", text())})))});
  EXPECT_EQ(sentence(schema, R"({"rows": [{"a/b": "x"}, {"a/b": 3}]})"),
            "/rows/1/a~1b must be a text that is not empty, not 3.");
  EXPECT_EQ(sentence(schema, R"({"rows": [{}]})"), "/rows/0/a~1b is missing.");
  EXPECT_EQ(sentence(schema, R"({"rows": {}})"), "/rows must be a list, not an object.");
}

TEST(Schema, SaysWhichChoicesThereAre) {
  const Schema either = any_of({whole(1), words({"auto", "none"})}, "auto, none or a number");
  EXPECT_EQ(sentence(either, "3"), "");
  EXPECT_EQ(sentence(either, "\"auto\""), "");
  EXPECT_EQ(sentence(either, "true"), "The whole input must be auto, none or a number, not true.");
  EXPECT_EQ(sentence(either, "0"), "The whole input must be a whole number of at least 1, not 0.");
  const Schema one = one_key({optional("radius", number()), optional("corner", whole())});
  EXPECT_EQ(sentence(one, R"({"radius": 1})"), "");
  EXPECT_EQ(sentence(one, R"({"radius": 1, "corner": 2})"),
            "The whole input must be one of radius, corner.");
  EXPECT_EQ(sentence(one, "{}"), "The whole input must be one of radius, corner.");
  const Schema keyed = by_key("width",
                              object({required("width", number()), required("n", whole())}),
                              object({required("n", list(number()))}));
  EXPECT_EQ(sentence(keyed, R"({"n": [1]})"), "");
  EXPECT_EQ(sentence(keyed, R"({"n": 1})"), "/n must be a list, not 1.");
  EXPECT_EQ(sentence(keyed, R"({"n": 1, "width": 2})"), "");
}

TEST(Schema, CountsWhatAListHolds) {
  const Schema pair = list(number()).of_length(1, 2, "a list of 1 or 2 numbers");
  EXPECT_EQ(sentence(pair, "[1]"), "");
  EXPECT_EQ(sentence(pair, "[1, 2]"), "");
  EXPECT_EQ(sentence(pair, "[]"),
            "The whole input must be a list of 1 or 2 numbers, not a list of 0.");
  EXPECT_EQ(sentence(pair, "[1, 2, 3]"),
            "The whole input must be a list of 1 or 2 numbers, not a list of 3.");
  EXPECT_EQ(sentence(list(number()), "[]"), "");
  EXPECT_EQ(json_schema(pair, "", "")["minItems"], 1);
  EXPECT_EQ(json_schema(pair, "", "")["maxItems"], 2);
}

TEST(Schema, MeasuresLengthsInMillimetres) {
  const Schema most = length({"a length of at most 1000 mm", 0.0, 1000.0});
  EXPECT_FALSE(first_mistake(most, 999.0));
  EXPECT_TRUE(first_mistake(most, 1001.0));
  EXPECT_FALSE(first_mistake(most, 1.0, 1000.0)) << "one metre";
  EXPECT_TRUE(first_mistake(most, 1.1, 1000.0));
}

TEST(Schema, IsPrintedAsJsonSchema) {
  const Json schema = json_schema(object({required("r", length(kAboveZero).said("radius")),
                                          optional("n", whole(0, 6).defaulting(2))}),
                                  "title", "id.json");
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["properties"]["r"], Json::parse(R"({"description": "radius", "type": "number",
                                                     "exclusiveMinimum": 0,
                                                     "quantity": "length"})"));
  EXPECT_EQ(schema["properties"]["n"], Json::parse(R"({"type": "integer", "minimum": 0,
                                                     "maximum": 6, "default": 2})"));
  EXPECT_EQ(schema["required"], Json::array({"r"}));
  EXPECT_EQ(schema["additionalProperties"], false);
}

TEST(JsonReading, GivesTheSchemasDefaultsForWhatIsLeftOut) {
  const Schema schema = object({optional("units", units()), optional("gap", length().defaulting(3)),
                                optional("on", flag().defaulting(true)),
                                optional("inner", object({optional("n", whole().defaulting(7))}))});
  JsonReading reading(R"({"units": "inch"})", "file", "f", schema);
  const JsonPlace place(reading);
  EXPECT_DOUBLE_EQ(place["gap"].length(), 3 * 25.4);
  EXPECT_TRUE(place["on"].yes());
  EXPECT_EQ(place["inner"]["n"].whole(), 7);
  EXPECT_FALSE(place["gap"].maybe_length().has_value());
}

TEST(JsonReading, RefusesWhatIsNestedTooDeep) {
  const Schema schema = object({optional("a", anything())});
  const auto error_of = [&](const std::string& text) {
    return JsonReading(text, "disc file", "f", schema).error();
  };
  const auto nested = [](int depth) {
    return "{\n\"a\": " + std::string(depth - 1, '[') + std::string(depth - 1, ']') + "}";
  };
  EXPECT_FALSE(error_of(nested(100)));
  EXPECT_EQ(error_of(nested(101))->where, "f:2:105");
  EXPECT_THAT(error_of(nested(300000))->message,
              HasSubstr("The disc file is nested more than 100 deep in line 2, column 105."));
  EXPECT_FALSE(error_of(R"({"a": ")" + std::string(200, '[') + R"(\"[\\"})")) << "in a text";
}

TEST(JsonReading, KnowsAStepFileWhenItSeesOne) {
  const Schema schema = object({});
  EXPECT_EQ(JsonReading("ISO-10303-21;\n", "disc file", "f", schema).error()->message,
            "The disc file is not JSON: it is a STEP file.");
}

TEST(JsonReadingDeathTest, ReadsNoKeyThatTheSchemaDoesNotDescribe) {
  const Schema schema = object({optional("gap", length())});
  JsonReading reading("{}", "file", "f", schema);
  EXPECT_DEATH((void)JsonPlace(reading)["gaps"].length(), "field");
}

}  // namespace
}  // namespace planish::schema
