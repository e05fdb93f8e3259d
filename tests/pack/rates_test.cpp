#include "rates.hpp"

#include "pack/pack_parts.hpp"

#include <gtest/gtest.h>

namespace planish::pack {
namespace {

TEST(Rates, AddUpWhatIsAsked) {
  const auto rates = Rates::parse(
      {"rates.json", R"({"currency": "EUR", "materials": {"S235": {"cut": 0.01, "pierce": 0.5,
        "bend": 2, "setup": 10, "kg": 4, "area": 0.0001}, "oak": {}}})"});
  ASSERT_TRUE(rates) << rates.error().message;
  EXPECT_EQ(rates->currency(), "EUR");
  PartList list{{test::pack_part("S235", 5), test::pack_part("oak", 2)}, {}, {}};
  ASSERT_TRUE(rates->apply(list));
  // 10 once; each: 7 to cut, 1.5 to pierce, 4 to bend, 1 for the mass, 2 for the rectangle.
  EXPECT_NEAR(*list.parts[0].cost, 10.0 + 5 * (7.0 + 1.5 + 4.0 + 1.0 + 2.0), 1e-9);
  EXPECT_EQ(list.parts[1].cost, 0.0);
}

TEST(Rates, NeedTheMassOnlyWhereTheyAskForIt) {
  const auto rates = Rates::parse(
      {"rates.json", R"({"materials": {"S235": {"kg": 4}, "oak": {"cut": 1}}})"});
  ASSERT_TRUE(rates);
  PartList list{{test::pack_part("oak", 1)}, {}, {}};
  list.parts[0].mass.reset();
  EXPECT_TRUE(rates->apply(list));
  list.parts[0].material = "S235";
  EXPECT_EQ(rates->apply(list).error().code, code::bad_option);
}

}  // namespace
}  // namespace planish::pack
