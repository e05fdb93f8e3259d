#include <planish/schema/schema.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::schema {
namespace {

/// What of JSON Schema 2020-12 is printed, checked without anything of ours; `mm` is one unit of
/// the document's lengths, of which limits are in mm.
bool holds_for(const Json& rules, const Json& value, double mm) {
  const auto has_type = [&](const std::string& type) {
    if (type == "integer")
      return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "array") return value.is_array();
    if (type == "null") return value.is_null();
    return type == "object" && value.is_object();
  };
  if (rules.contains("type") && !has_type(rules["type"])) return false;
  if (rules.contains("enum") && std::count(rules["enum"].begin(), rules["enum"].end(), value) == 0)
    return false;
  if (rules.contains("anyOf") && std::ranges::none_of(rules["anyOf"], [&](const Json& one) {
        return holds_for(one, value, mm);
      }))
    return false;
  if (rules.contains("if")) {
    const std::string key = rules["if"]["required"][0];
    if (!holds_for(rules[value.contains(key) ? "then" : "else"], value, mm)) return false;
  }
  if (value.is_number()) {
    const double x = value.get<double>() * (rules.value("quantity", "") == "length" ? mm : 1.0);
    if (rules.contains("minimum") && x < rules["minimum"]) return false;
    if (rules.contains("maximum") && x > rules["maximum"]) return false;
    if (rules.contains("exclusiveMinimum") && x <= rules["exclusiveMinimum"]) return false;
    if (rules.contains("exclusiveMaximum") && x >= rules["exclusiveMaximum"]) return false;
  }
  if (value.is_string() && rules.contains("minLength") && value == "") return false;
  if (value.is_array()) {
    if (value.size() < rules.value("minItems", 0u)) return false;
    if (value.size() > rules.value("maxItems", 1000u)) return false;
    for (const Json& one : value)
      if (rules.contains("items") && !holds_for(rules["items"], one, mm)) return false;
  }
  if (value.is_object()) {
    if (value.size() < rules.value("minProperties", 0u)) return false;
    if (value.size() > rules.value("maxProperties", 1000u)) return false;
    if (rules.contains("required"))
      for (const Json& key : rules["required"])
        if (!value.contains(key.get<std::string>())) return false;
    for (const auto& [key, one] : value.items()) {
      const bool known = rules.contains("properties") && rules["properties"].contains(key);
      if (known && !holds_for(rules["properties"][key], one, mm)) return false;
      if (known || !rules.contains("additionalProperties")) continue;
      const Json& others = rules["additionalProperties"];
      if (others == false || !holds_for(others, one, mm)) return false;
    }
  }
  return true;
}

std::string any_key() { return *rc::gen::elementOf(std::vector<std::string>{"a", "b", "c/d"}); }

Json any_document(int depth) {
  switch (*rc::gen::inRange(0, depth > 0 ? 8 : 5)) {
    case 0:
      return *rc::gen::inRange(-3, 5);
    case 1:
      return 0.5 * *rc::gen::inRange(-6, 9);
    case 2:
      return *rc::gen::elementOf(std::vector<std::string>{"", "x", "auto"});
    case 3:
      return *rc::gen::arbitrary<bool>();
    case 4:
      return nullptr;
    case 5: {
      Json list = Json::array();
      for (int n = *rc::gen::inRange(0, 4); n > 0; --n)
        list.push_back(any_document(depth - 1));
      return list;
    }
    default: {
      Json object = Json::object();
      for (int n = *rc::gen::inRange(0, 3); n > 0; --n)
        object[any_key()] = any_document(depth - 1);
      return object;
    }
  }
}

Range any_range() {
  Range range{"a number", 0.5 * *rc::gen::inRange(-4, 3), 0.5 * *rc::gen::inRange(3, 8)};
  range.low_too = *rc::gen::arbitrary<bool>();
  range.high_too = *rc::gen::arbitrary<bool>();
  return range;
}

Schema any_schema(int depth) {
  const auto part = [&] { return any_schema(depth - 1); };
  const auto fields = [&] {
    return std::vector<Field>{{"a", part(), *rc::gen::arbitrary<bool>()},
                              {"c/d", part(), *rc::gen::arbitrary<bool>()}};
  };
  switch (*rc::gen::inRange(0, depth > 0 ? 15 : 8)) {
    case 0:
      return number(any_range());
    case 1:
      return length(any_range());
    case 2:
      return whole(*rc::gen::inRange(-2, 1), *rc::gen::inRange(1, 4));
    case 3:
      return text();
    case 4:
      return any_text();
    case 5:
      return flag();
    case 6:
      return words({"auto", "x"});
    case 7:
      return values({1, true, "auto"}, "one of these");
    case 8:
      return list(part());
    case 9:
      return list(part()).of_length(1, 2, "a list of 1 or 2");
    case 10:
      return tuple(2, part(), "two of them");
    case 11:
      return object(fields());
    case 12: {
      auto either = fields();
      for (Field& field : either)
        field.required = false;
      return one_key(either);
    }
    case 13:
      return map(part());
    default:
      return by_key("b", object({required("b", part())}), object(fields()));
  }
}

RC_GTEST_PROP(SchemaCheck, TakesWhatThePrintedSchemaTakes, ()) {
  Schema schema = any_schema(3);
  if (*rc::gen::arbitrary<bool>() && schema.kind != Schema::Kind::by_key) schema = schema.or_null();
  const double mm = *rc::gen::elementOf(std::vector<double>{1.0, 2.0, 0.5});
  const Json printed = json_schema(schema, "", "");
  for (int i = 0; i < 20; ++i) {
    const Json document = any_document(3);
    RC_ASSERT(!first_mistake(schema, document, mm).has_value() == holds_for(printed, document, mm));
  }
}

TEST(SchemaCheck, NamesUnknownKeysBeforeMissingOnes) {
  const Schema schema = object({required("thickness", number()), optional("k", number())});
  EXPECT_EQ(first_mistake(schema, Json::parse(R"({"thicknes": 1})"))->pointer, "/thicknes");
  EXPECT_EQ(first_mistake(schema, Json::parse(R"({"k": "x"})"))->pointer, "/thickness");
  EXPECT_EQ(first_mistake(schema, Json::parse(R"({"k": "x", "thickness": 1})"))->pointer, "/k");
}

TEST(SchemaCheck, FindsTheFirstMistakeInTheOrderOfLists) {
  const Schema rows = list(map(tuple(2, whole(0, 9), "two digits")));
  EXPECT_EQ(first_mistake(rows, Json::parse(R"([{"a": [1, 2]}, {"b": [3, 10], "c": 4}])"))->pointer,
            "/1/b/1");
}

TEST(SchemaCheck, RefusesLengthsThatAreNotFiniteInMillimetres) {
  EXPECT_FALSE(first_mistake(length(), 1e306, 1.0));
  EXPECT_TRUE(first_mistake(length(), 1e306, 1000.0));
  EXPECT_FALSE(first_mistake(number(), 1e306, 1000.0)) << "no length";
}

TEST(SchemaCheck, TakesNumbersHoweverTheyAreWritten) {
  const Schema either = values({1, "auto"}, "1 or auto").or_null();
  for (const char* written : {"1", "1.0", "10e-1", "null", "\"auto\""})
    EXPECT_FALSE(first_mistake(either, Json::parse(written))) << written;
  for (const char* written : {"-1", "1.5", "true", "[]"})
    EXPECT_TRUE(first_mistake(either, Json::parse(written))) << written;
}

TEST(SchemaCheck, EscapesPointersAsRfc6901Does) {
  EXPECT_EQ(escaped_token("a/b~c"), "a~1b~0c");
  EXPECT_EQ(escaped_token("~1"), "~01");
  EXPECT_EQ(escaped_token(""), "");
}

TEST(SchemaCheck, ShowsValuesOfAnySizeBriefly) {
  EXPECT_EQ(shown(Json::parse("[[[]]]")), "a list");
  EXPECT_EQ(shown(Json::object()), "an object");
  EXPECT_EQ(shown(2.5), "2.5");
  EXPECT_EQ(shown("\xE4"), "\"\uFFFD\"");
  EXPECT_LT(shown(std::string(5000, 'x')).size(), 50u);
}

TEST(SchemaCheck, ChoosesTheBranchOfTheValuesType) {
  const Schema either = any_of({whole(1), list(number()), by_key("w", object({}), map(flag()))},
                               "any of these");
  EXPECT_EQ(branch_for(either, 3)->kind, Schema::Kind::whole);
  EXPECT_EQ(branch_for(either, Json::array())->kind, Schema::Kind::list);
  EXPECT_EQ(branch_for(either, {{"w", 1}})->kind, Schema::Kind::object);
  EXPECT_EQ(branch_for(either, {{"v", 1}})->kind, Schema::Kind::map);
  EXPECT_EQ(branch_for(either, "x"), nullptr);
  const Schema plain = number();
  EXPECT_EQ(branch_for(plain, "x"), &plain);
}

}  // namespace
}  // namespace planish::schema
