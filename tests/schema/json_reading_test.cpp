#include <planish/schema/json_reading.hpp>

#include <gtest/gtest.h>

namespace planish::schema {
namespace {

const Schema& cart_schema() {
  static const Schema schema = object(
      {optional("units", units()), optional("at", space_point()), optional("mark", plane_point()),
       optional("axis", space_direction()), optional("lean", angle(kAnyNumber).defaulting(90)),
       optional("wheels", list(object({required("radius", length(kAboveZero))}))),
       optional("loads", map(number())), optional("side", words({"left", "right"})),
       optional("name", any_of({text(), list(text())}, "a name or several"))});
  return schema;
}

std::optional<Error> mistake_of(const std::string& text) {
  return JsonReading(text, "cart file", "cart.json", cart_schema()).error();
}

TEST(JsonReading, SaysWhereATextIsNoJson) {
  EXPECT_FALSE(mistake_of("{}"));
  for (const auto& [text, where] :
       {std::pair{"{\n  \"at\": [1, 2,, 3]}", "cart.json:2:15"}, std::pair{"{", "cart.json:1:1"},
        std::pair{"[]", "cart.json"}, std::pair{R"({"lean": 1, "lean": 2})", "cart.json"},
        std::pair{R"({"wheels": [{"radius": 1, "radius": 2}]})", "cart.json"}}) {
    const auto error = mistake_of(text);
    ASSERT_TRUE(error) << text;
    EXPECT_EQ(error->code, code::invalid_input);
    EXPECT_EQ(error->where, where);
  }
  EXPECT_FALSE(mistake_of(R"({"wheels": [{"radius": 1}, {"radius": 1}]})"))
      << "one key in two objects";
}

TEST(JsonReading, HasThePointerOfAMistakeAsItsPlace) {
  const auto error = mistake_of(R"({"wheels": [{"radius": 1}, {"radius": 0}]})");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->where, "cart.json/wheels/1/radius");
  EXPECT_EQ(error->places, std::vector<Place>{place::pointer("/wheels/1/radius")});
}

TEST(JsonReading, KeepsTheFirstMistake) {
  JsonReading reading("{}", "cart file", "cart.json", cart_schema());
  constexpr static Refusal kWrong{code::invalid_input, "{@field} is wrong."};
  reading.mistake("/a", kWrong);
  reading.mistake("/b", kWrong);
  EXPECT_EQ(reading.error()->where, "cart.json/a");
}

TEST(JsonPlace, ConvertsLengthsFromTheUnitOfTheFile) {
  JsonReading reading(
      R"({"units": "inch", "at": [1, 2, -3], "mark": [4, 5], "axis": [0, 3, 4], "lean": 30,
          "wheels": [{"radius": 1}, {"radius": 2}], "loads": {"b": 7, "a": 8}})",
      "cart file", "cart.json", cart_schema());
  ASSERT_FALSE(reading.error());
  const JsonPlace cart(reading);
  EXPECT_EQ(reading.unit(), LengthUnit::inch);
  EXPECT_LT((cart["at"].point() - Vec3(25.4, 50.8, -76.2)).norm(), 1e-12);
  EXPECT_LT((cart["mark"].plane_point() - Vec2(101.6, 127.0)).norm(), 1e-12);
  EXPECT_LT((*cart["axis"].direction() - Vec3(0, 0.6, 0.8)).norm(), 1e-15) << "of no unit";
  EXPECT_DOUBLE_EQ(cart["lean"].angle().degrees(), 30.0);
  const auto wheels = cart["wheels"].items();
  ASSERT_EQ(wheels.size(), 2u);
  EXPECT_DOUBLE_EQ(wheels[1]["radius"].length(), 50.8);
  EXPECT_EQ(wheels[1]["radius"].pointer(), "/wheels/1/radius");
  const auto loads = cart["loads"].members();
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_EQ(loads[0].first, "b") << "in the order of the file";
  EXPECT_EQ(loads[0].second.number(), 7.0) << "no length";
  EXPECT_EQ(loads[1].second.pointer(), "/loads/a");
}

TEST(JsonPlace, KnowsWhatWasLeftOut) {
  JsonReading reading("{}", "cart file", "cart.json", cart_schema());
  const JsonPlace cart(reading);
  for (const char* key : {"at", "mark", "axis", "lean", "wheels", "loads", "side"})
    EXPECT_FALSE(cart[key].given()) << key;
  EXPECT_EQ(cart["at"].point(), Vec3::Zero());
  EXPECT_EQ(cart["mark"].plane_point(), Vec2::Zero());
  EXPECT_FALSE(cart["axis"].direction());
  EXPECT_DOUBLE_EQ(cart["lean"].angle().degrees(), 90.0) << "the default";
  EXPECT_FALSE(cart["lean"].maybe_angle());
  EXPECT_FALSE(cart["lean"].maybe_number());
  EXPECT_TRUE(cart["wheels"].items().empty());
  EXPECT_TRUE(cart["loads"].members().empty());
  EXPECT_FALSE(reading.error()) << "which is no mistake";
}

TEST(JsonPlace, RefusesPlacesTooFarAwayAndDirectionsThatAreNone) {
  const auto asked = [](const char* text, const auto& read) {
    JsonReading reading(text, "cart file", "cart.json", cart_schema());
    read(JsonPlace(reading));
    return reading.error() ? reading.error()->where : "";
  };
  const auto point = [](const JsonPlace& cart) { (void)cart["at"].point(); };
  EXPECT_EQ(asked(R"({"units": "m", "at": [0, 1e6, 0]})", point), "");
  EXPECT_EQ(asked(R"({"units": "m", "at": [0, 1.1e6, 0]})", point), "cart.json/at/1");
  EXPECT_EQ(asked(R"({"at": [0, 0, -1.1e9]})", point), "cart.json/at/2");
  const auto axis = [](const JsonPlace& cart) { (void)cart["axis"].direction(); };
  EXPECT_EQ(asked(R"({"axis": [0, 0, 0]})", axis), "cart.json/axis");
  EXPECT_EQ(asked(R"({"axis": [0, 1e-300, 0]})", axis), "") << "small, but a direction";
}

TEST(JsonPlace, GivesTheMeaningOfAWordAndTheKindOfAValue) {
  const Words<int> sides{{"left", -1}, {"right", 1}};
  JsonReading reading(R"({"side": "right", "name": ["a", "b"]})", "cart file", "cart.json",
                      cart_schema());
  const JsonPlace cart(reading);
  EXPECT_EQ(cart["side"].choice(sides), 1);
  EXPECT_TRUE(cart["side"].is_text());
  EXPECT_TRUE(cart["name"].is_list());
  EXPECT_FALSE(cart["name"].is_text());
  EXPECT_EQ(cart["name"].items()[1].text(), "b");
}

TEST(JsonPlace, IsEmptyInAnInvalidDocument) {
  JsonReading reading(R"({"lean": "x", "wheels": [{"radius": 1}]})", "cart file", "cart.json",
                      cart_schema());
  ASSERT_TRUE(reading.error());
  const JsonPlace cart(reading);
  EXPECT_EQ(cart["lean"].number(), 0.0);
  EXPECT_TRUE(cart["wheels"].items().empty());
  EXPECT_EQ(cart["nothing"].text(), "");
}

}  // namespace
}  // namespace planish::schema
