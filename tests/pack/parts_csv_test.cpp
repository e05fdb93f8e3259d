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
  part.cut_length = 700.0;
  part.pierces = 3;
  part.flat.area = 19'000.0;
  part.flat.bends.resize(2);
  part.mass = 0.25;
  return part;
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
