#include "rates.hpp"

#include "parts_csv.hpp"

#include <gtest/gtest.h>

namespace planish::pack {
namespace {

PackPart part(const std::string& material, int quantity) {
  PackPart part;
  part.name = material + " part";
  part.stem = part.name;
  part.material = material;
  part.quantity = quantity;
  part.size = {200.0, 100.0};
  part.cut_length = 700.0;
  part.pierces = 3;
  part.flat.area = 19'000.0;
  part.flat.bends.resize(2);
  part.mass = 0.25;
  return part;
}

TEST(Rates, AddUpWhatIsAsked) {
  const auto rates = Rates::parse(
      {"rates.json", R"({"currency": "EUR", "materials": {"S235": {"cut": 0.01, "pierce": 0.5,
        "bend": 2, "setup": 10, "kg": 4, "area": 0.0001}, "oak": {}}})"});
  ASSERT_TRUE(rates) << rates.error().message;
  EXPECT_EQ(rates->currency(), "EUR");
  PartList list{{part("S235", 5), part("oak", 2)}, {}, {}};
  ASSERT_TRUE(rates->apply(list));
  // 10 once; each: 7 to cut, 1.5 to pierce, 4 to bend, 1 for the mass, 2 for the rectangle.
  EXPECT_NEAR(*list.parts[0].cost, 10.0 + 5 * (7.0 + 1.5 + 4.0 + 1.0 + 2.0), 1e-9);
  EXPECT_EQ(list.parts[1].cost, 0.0);
}

TEST(Rates, NeedTheMassOnlyWhereTheyAskForIt) {
  const auto rates = Rates::parse(
      {"rates.json", R"({"materials": {"S235": {"kg": 4}, "oak": {"cut": 1}}})"});
  ASSERT_TRUE(rates);
  PartList list{{part("oak", 1)}, {}, {}};
  list.parts[0].mass.reset();
  EXPECT_TRUE(rates->apply(list));
  list.parts[0].material = "S235";
  EXPECT_EQ(rates->apply(list).error().code, code::bad_option);
}

TEST(Totals, CountEachPieceAndKnowWhatIsNotKnown) {
  PartList list{{part("S235", 5), part("S235", 2)}, {}, {}};
  const Totals totals = totals_of(list, 0, 2);
  EXPECT_EQ(totals.parts, 2);
  EXPECT_EQ(totals.quantity, 7);
  EXPECT_EQ(totals.pierces, 21U);
  EXPECT_EQ(totals.bends, 14U);
  EXPECT_NEAR(totals.cut_length, 4900.0, 1e-9);
  EXPECT_NEAR(*totals.mass, 1.75, 1e-12);
  EXPECT_EQ(totals.cost, std::nullopt);
  list.parts[1].mass.reset();
  EXPECT_EQ(totals_of(list, 0, 2).mass, std::nullopt);
  EXPECT_EQ(totals_of(list, 0, 1).mass, 1.25);
}

}  // namespace
}  // namespace planish::pack
