#include <planish/shop/rates.hpp>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace planish::shop {
namespace {

PricedPart part(const std::string& material, int quantity) {
  return {.name = material + " part",
          .material = material,
          .quantity = quantity,
          .cut_length = 700.0,
          .pierces = 3,
          .bends = 2,
          .size = {200.0, 100.0},
          .mass = 0.25};
}

TEST(Rates, AddUpWhatIsAsked) {
  const auto rates = Rates::parse(
      R"({"currency": "EUR", "materials": {"S235": {"cut": 0.01, "pierce": 0.5,
        "bend": 2, "setup": 10, "kg": 4, "area": 0.0001}, "oak": {}}})",
      "rates.json");
  ASSERT_TRUE(rates) << rates.error().message;
  EXPECT_EQ(rates->currency(), "EUR");
  // 10 once; each: 7 to cut, 1.5 to pierce, 4 to bend, 1 for the mass, 2 for the rectangle.
  EXPECT_NEAR(rates->cost_of(part("S235", 5)).value(), 10.0 + 5 * (7.0 + 1.5 + 4.0 + 1.0 + 2.0),
              1e-9);
  EXPECT_EQ(rates->cost_of(part("oak", 2)).value(), 0.0);
}

TEST(Rates, NeedTheMassOnlyWhereTheyAskForIt) {
  const auto rates = Rates::parse(R"({"materials": {"S235": {"kg": 4}, "oak": {"cut": 1}}})",
                                  "rates.json");
  ASSERT_TRUE(rates);
  PricedPart unknown = part("oak", 1);
  unknown.mass.reset();
  EXPECT_TRUE(rates->cost_of(unknown));
  unknown.material = "S235";
  EXPECT_EQ(rates->cost_of(unknown).error().code, code::bad_option);
  unknown.material = "brass";
  EXPECT_EQ(rates->cost_of(unknown).error().code, code::bad_option);
}

TEST(Rates, SayWhereTheirFileIsWrong) {
  for (const auto& [json, where] : std::vector<std::pair<std::string, std::string>>{
           {"[]", "r.json"},
           {R"({"materials": {}})", "r.json/materials"},
           {R"({"materials": {"a/b": {"cut": -1}}})", "r.json/materials/a~1b/cut"},
           {R"({"materials": {"S235": {"hour": 1}}})", "r.json/materials/S235/hour"},
           {R"({"materials": {"S235": 3}})", "r.json/materials/S235"},
           {R"({"version": 2, "materials": {"S235": {}}})", "r.json/version"},
           {R"({"currency": 3, "materials": {"S235": {}}})", "r.json/currency"}}) {
    const auto rates = Rates::parse(json, "r.json");
    ASSERT_FALSE(rates) << json;
    EXPECT_EQ(rates.error().code, code::invalid_input) << json;
    EXPECT_EQ(rates.error().where, where) << json;
  }
}

}  // namespace
}  // namespace planish::shop
