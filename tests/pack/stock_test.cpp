#include "stock.hpp"

#include "pack/pack_parts.hpp"

#include <planish/sheet/csv.hpp>

#include <gtest/gtest.h>

namespace planish::pack {
namespace {

/// Two materials: three plates of 400 × 300, and one that no sheet bears.
PartList plates_list() {
  PartList list;
  list.parts = {test::pack_part("S235", 2), test::pack_part("S235", 1), test::pack_part("oak", 1)};
  for (PackPart& part : list.parts)
    part.flat = test::flat_plate(400, 300);
  list.parts[0].stem = "a_x2";
  list.parts[1].stem = "b_x1";
  list.parts[1].flat = test::flat_plate(300, 200);
  list.parts[2].stem = "huge_x1";
  list.parts[2].flat = test::flat_plate(5000, 300);
  list.groups = {{"S235", 2.0, 0, 2}, {"oak", 2.0, 2, 3}};
  return list;
}

const Stock kSheet{.length = 1000, .width = 700, .gap = 5};

StockSheets laid(const PartList& list, const Stock& stock = kSheet) {
  const auto sheets = lay_on_stock(list, stock, {});
  EXPECT_TRUE(sheets) << (sheets ? "" : sheets.error().message);
  return sheets ? *sheets : StockSheets{};
}

TEST(Stock, BearsEachGroupOnSheetsOfItsOwn) {
  const StockSheets found = laid(plates_list());
  ASSERT_EQ(found.sheets.size(), 1u);
  const StockSheet& sheet = found.sheets[0];
  EXPECT_EQ(sheet.stem, "sheet_S235_2mm_1");
  EXPECT_EQ(sheet.material, "S235");
  EXPECT_EQ(sheet.thickness, 2.0);
  ASSERT_EQ(sheet.nested.placed.size(), 3u);
  EXPECT_NEAR(sheet.nested.use, (2 * 400.0 * 300 + 300.0 * 200) / (1000.0 * 700), 1e-9);
  ASSERT_EQ(found.notes.size(), 1u);
  EXPECT_NE(found.notes[0].find("huge_x1"), std::string::npos);
  EXPECT_NE(found.notes[0].find("5010"), std::string::npos) << "with its margin";
}

TEST(Stock, CountsPartsOfTheWholeList) {
  PartList list = plates_list();
  list.parts[2].flat = test::flat_plate(400, 300);
  const StockSheets found = laid(list);
  ASSERT_EQ(found.sheets.size(), 2u);
  EXPECT_EQ(found.sheets[1].stem, "sheet_oak_2mm_1");
  ASSERT_EQ(found.sheets[1].nested.placed.size(), 1u);
  EXPECT_EQ(found.sheets[1].nested.placed[0].part, 2);
  EXPECT_TRUE(found.notes.empty());
  list.parts[2].quantity = 6;
  const StockSheets more = laid(list);
  ASSERT_EQ(more.sheets.size(), 3u);
  EXPECT_EQ(more.sheets[2].stem, "sheet_oak_2mm_2");
}

TEST(Stock, IsListedAsCsv) {
  const PartList list = plates_list();
  const StockSheets found = laid(list);
  const auto table = split_csv(sheets_csv(list, found.sheets), "sheets.csv");
  ASSERT_TRUE(table);
  ASSERT_EQ(table->size(), 2u);
  EXPECT_EQ((*table)[0].fields,
            (std::vector<std::string>{"file", "material", "thickness", "pieces", "use", "parts"}));
  EXPECT_EQ((*table)[1].fields, (std::vector<std::string>{"sheet_S235_2mm_1", "S235", "2", "3",
                                                          "42.8571", "a_x2 ×2; b_x1 ×1"}));
}

TEST(Stock, IsDrawnWithItsParts) {
  const PartList list = plates_list();
  const StockSheets found = laid(list);
  const auto dxf = sheet_dxf(list, found.sheets[0], kSheet, {});
  ASSERT_TRUE(dxf) << dxf.error().message;
  std::size_t names = 0;
  for (std::size_t at = dxf->find("S235 part"); at != std::string::npos;
       at = dxf->find("S235 part", at + 1))
    ++names;
  EXPECT_EQ(names, 3u) << "each piece has its name";
}

TEST(Stock, StopsWhenAskedAndSaysWhatCannotBe) {
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_EQ(lay_on_stock(plates_list(), kSheet, progress).error().code, code::cancelled);
  EXPECT_EQ(lay_on_stock(plates_list(), {.length = -1, .width = 700}, {}).error().code,
            code::bad_option);
}

}  // namespace
}  // namespace planish::pack
