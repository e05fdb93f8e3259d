#include "parts_csv.hpp"

#include "pack/pack_parts.hpp"

#include <planish/sheet/csv.hpp>

#include <gtest/gtest.h>

namespace planish::pack {
namespace {

using test::pack_part;

TEST(Totals, CountEachPieceAndKnowWhatIsNotKnown) {
  PartList list{{pack_part("S235", 5), pack_part("S235", 2)}, {}, {}};
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

/// The list as a reader of CSV has it: cells by title.
std::vector<std::map<std::string, std::string>> listed(const PartList& list,
                                                       const std::string& currency = "") {
  const auto records = split_csv(parts_csv(list, currency), "parts.csv");
  EXPECT_TRUE(records);
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t r = 1; r < records->size(); ++r) {
    EXPECT_EQ((*records)[r].fields.size(), (*records)[0].fields.size());
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < (*records)[r].fields.size(); ++c)
      row[(*records)[0].fields[c]] = (*records)[r].fields[c];
  }
  return rows;
}

PartList two_materials() {
  PartList list;
  list.parts = {pack_part("S235", 5), pack_part("S235", 2), pack_part("oak, \"best\"", 1)};
  list.parts[0].flat.thickness = list.parts[1].flat.thickness = 1.5;
  list.parts[0].bend_length = 80.25;
  list.parts[0].cost = 12.345;
  list.parts[0].plan = "can be bent";
  list.parts[1].warnings = {"too near", "too low"};
  list.parts[2].mass.reset();
  list.parts[0].sources = {{"chair.step", "leg", 4}, {"panel.step", "", 1}};
  list.groups = {{"S235", 1.5, 0, 2}, {"oak, \"best\"", 0.0, 2, 3}};
  list.refused = {{{"x.step", "block", 3}, "not_a_sheet", "it is a block; solid"}};
  return list;
}

TEST(PartsCsv, HasARowForEachPart) {
  const auto rows = listed(two_materials(), "EUR");
  ASSERT_EQ(rows.size(), 3u + 2 + 1 + 1) << "parts, groups, all, refused";
  auto row = rows[0];
  EXPECT_EQ(row["file"], "S235 part");
  EXPECT_EQ(row["material"], "S235");
  EXPECT_EQ(row["thickness"], "1.5");
  EXPECT_EQ(row["quantity"], "5");
  EXPECT_EQ(row["length"], "200");
  EXPECT_EQ(row["width"], "100");
  EXPECT_EQ(row["area"], "19000");
  EXPECT_EQ(row["mass"], "0.25");
  EXPECT_EQ(row["cut_length"], "700");
  EXPECT_EQ(row["pierces"], "3");
  EXPECT_EQ(row["bends"], "2");
  EXPECT_EQ(row["bend_length"], "80.25");
  EXPECT_EQ(row["plan"], "can be bent");
  EXPECT_EQ(row["status"], "ok");
  EXPECT_EQ(row["cost EUR"], "12.35");
  EXPECT_NE(row["sources"].find("chair.step: leg ×4"), std::string::npos);
  EXPECT_TRUE(row["sources"].ends_with("panel.step")) << "once and without a body";
  row = rows[1];
  EXPECT_EQ(row["status"], "warning");
  EXPECT_NE(row["warnings"].find("too low"), std::string::npos);
  EXPECT_EQ(row["cost EUR"], "");
  row = rows[3];
  EXPECT_EQ(row["material"], "oak, \"best\"");
  EXPECT_EQ(row["mass"], "");
}

TEST(PartsCsv, AddsUpEachGroupAndAll) {
  const auto rows = listed(two_materials());
  auto steel = rows[2], all = rows[5];
  EXPECT_EQ(steel["file"], "total");
  EXPECT_EQ(steel["material"], "S235");
  EXPECT_EQ(steel["thickness"], "1.5");
  EXPECT_EQ(steel["quantity"], "7");
  EXPECT_EQ(steel["area"], "133000");
  EXPECT_EQ(steel["mass"], "1.75");
  EXPECT_EQ(steel["pierces"], "21");
  EXPECT_EQ(steel["cost"], "") << "of one it is not known";
  EXPECT_EQ(all["file"], "total");
  EXPECT_EQ(all["quantity"], "8");
  EXPECT_EQ(all["bends"], "16");
  EXPECT_EQ(all["mass"], "");
  EXPECT_EQ(all["bend_length"], "401.25");
}

TEST(PartsCsv, EndsWithWhatWasRefused) {
  auto row = listed(two_materials()).back();
  EXPECT_EQ(row["part"], "block");
  EXPECT_EQ(row["status"], "refused");
  EXPECT_EQ(row["quantity"], "3");
  EXPECT_NE(row["warnings"].find("not_a_sheet"), std::string::npos);
  EXPECT_NE(row["warnings"].find("solid"), std::string::npos);
  EXPECT_TRUE(listed({}).empty()) << "nothing to add up";
}

}  // namespace
}  // namespace planish::pack
