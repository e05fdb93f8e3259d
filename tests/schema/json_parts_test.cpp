#include <planish/schema/json_parts.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace planish::schema {
namespace {

TEST(JsonParts, WriteNumbersThatAreNoneAsNull) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double none : {kInfinite, -kInfinite, std::nan("")})
    EXPECT_TRUE(number_json(none).is_null());
  EXPECT_TRUE(number_json(std::optional<double>()).is_null());
  EXPECT_EQ(number_json(std::optional(0.25)), 0.25);
  EXPECT_EQ(number_json(-0.0).dump(), "0.0");
  EXPECT_EQ(number_json(-2.5), -2.5);
}

TEST(JsonParts, WriteNumbersThatAreReadBackToTheLastBit) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -6.0946897, 5e17})
    EXPECT_EQ(Json::parse(number_json(value).dump()).get<double>(), value);
}

TEST(JsonParts, WritePointsInTheUnitOfTheReport) {
  EXPECT_EQ(point_json({1, -2}, Units(LengthUnit::mm)), Json::parse("[1.0, -2.0]"));
  EXPECT_EQ(point_json({25.4, 50.8}, Units(LengthUnit::inch)), Json::parse("[1.0, 2.0]"));
  EXPECT_EQ(space_point_json({1000, 2000, -3000}, Units(LengthUnit::m)),
            Json::parse("[1.0, 2.0, -3.0]"));
}

TEST(JsonParts, WriteDocumentsThatAreTextsWhateverTheyHold) {
  const std::string text = text_of({{"b", 1}, {"a", "tr\xE4ger"}});
  EXPECT_EQ(text, "{\n  \"b\": 1,\n  \"a\": \"tr\uFFFDger\"\n}\n") << "keys keep their order";
}

}  // namespace
}  // namespace planish::schema
