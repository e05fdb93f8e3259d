#include "drawings.hpp"

#include "pack/pack_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::pack {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

PackPart drawn_part(const std::string& stem, int quantity) {
  PackPart part = test::pack_part("S235", quantity);
  part.flat = test::flat_plate(200, 100);
  part.stem = part.name = stem;
  part.plan = "nothing to bend";
  return part;
}

std::vector<std::string> said_on(const std::vector<Page>& pages) {
  std::vector<std::string> said;
  for (const Page& page : pages)
    for (const Page::Text& text : page.texts())
      said.push_back(text.text);
  return said;
}

PartList list_of(unsigned parts) {
  PartList list;
  for (unsigned i = 0; i < parts; ++i)
    list.parts.push_back(drawn_part("part" + std::to_string(i), 2));
  list.groups = {{"S235", 2.0, 0, std::size_t{parts}}};
  return list;
}

TEST(PackCover, ShowsEachPartOnceWithinTheMargins) {
  const PartList list = list_of(30);
  const auto pages = cover_of(list, {}, "chairs", "EUR");
  EXPECT_GT(pages.size(), 1u);
  const auto said = said_on(pages);
  for (const PackPart& part : list.parts)
    EXPECT_EQ(std::ranges::count(said, part.stem), 1) << part.stem;
  EXPECT_EQ(std::ranges::count(said, "2×"), 30);
  for (std::size_t p = 0; p < pages.size(); ++p) {
    EXPECT_THAT(said_on({pages[p]}),
                Contains(std::to_string(p + 1) + " / " + std::to_string(pages.size())));
    EXPECT_THAT(said_on({pages[p]}), Contains("chairs"));
    for (const Page::Text& text : pages[p].texts()) {
      EXPECT_GE(text.at.x(), 12.0) << text.text;
      EXPECT_LE(text.at.y(), 285.0) << text.text;
    }
    for (const Page::Shape& shape : pages[p].shapes())
      for (const auto& line : shape.lines)
        for (const Vec2& point : line) {
          EXPECT_LE(point.y(), 285.0);
          EXPECT_LE(point.x(), 198.0 + 1e-9);
        }
  }
}

TEST(PackCover, AddsUpWhatIsMade) {
  PartList list = list_of(2);
  list.parts[0].cost = 10.0;
  list.parts[1].cost = 2.5;
  const auto said = said_on(cover_of(list, {}, "chairs", "EUR"));
  // Twice 700 mm, 3 pierces, 0.25 kg of each.
  EXPECT_THAT(said, Contains(AllOf(HasSubstr("In all"), HasSubstr("2 parts"), HasSubstr("4 pieces"),
                                   HasSubstr("2.8 m"), HasSubstr("12 pierces"), HasSubstr("1 kg"),
                                   HasSubstr("12.50 EUR"))));
  EXPECT_THAT(said, Contains(AllOf(HasSubstr("blank 200 × 100 mm"), HasSubstr("10.00 EUR"))));
  list.parts[1].cost.reset();
  EXPECT_THAT(said_on(cover_of(list, {}, "chairs", "EUR")),
              Contains(AllOf(HasSubstr("In all"), Not(HasSubstr("EUR")))));
}

TEST(PackCover, PutsRowsBelowOneAnother) {
  const auto page = cover_of(list_of(3), {}, "chairs", "").front();
  double last = 0.0;
  for (const char* part : {"part0", "part1", "part2"})
    for (const Page::Text& text : page.texts())
      if (text.text == part) {
        if (last > 0.0) {
          EXPECT_NEAR(text.at.y() - last, 19.0, 1e-9);
        }
        last = text.at.y();
      }
  EXPECT_GT(last, 0.0);
}

TEST(PackCover, TellsSheetsNotesAndWhatWasRefused) {
  PartList list = list_of(1);
  list.parts[0].warnings = {"w", "v"};
  list.refused = {{{"x.step", "block", 3}, "not_a_sheet", "it is a block"},
                  {{"y.step", "", 1}, "overlap", ""}};
  StockSheets stock;
  stock.sheets.push_back({"sheet_S235_2mm_1", "S235", 2.0, {{Placed{}, Placed{}}, 0.4287}});
  stock.notes = {"huge does not fit on a sheet"};
  const auto said = said_on(cover_of(list, stock, "chairs", ""));
  EXPECT_THAT(said, Contains(AllOf(HasSubstr("sheet_S235_2mm_1"), HasSubstr("2 pieces"),
                                   HasSubstr("42.9 %"))));
  EXPECT_THAT(said, Contains("huge does not fit on a sheet"));
  EXPECT_THAT(said, Contains(AllOf(HasSubstr("x.step: block ×3"), HasSubstr("it is a block"))));
  EXPECT_THAT(said,
              Contains(AllOf(HasSubstr("y.step"), HasSubstr("overlap"), Not(HasSubstr("×")))));
  EXPECT_THAT(said, Contains(HasSubstr("2 warnings")));
  EXPECT_THAT(said_on(cover_of(list_of(1), {}, "chairs", "")), Not(Contains(HasSubstr("Sheets"))));
}

TEST(PackCover, SaysWhatWouldHelpWhereAPartCannotBeBent) {
  PartList list = list_of(2);
  list.parts[0].plan = "cannot be bent";
  list.parts[0].help = {"Bend it over a V of 10 mm", "Bend it as two parts"};
  const auto said = said_on(cover_of(list, {}, "chairs", ""));
  EXPECT_THAT(said, Contains("Bend it over a V of 10 mm; Bend it as two parts"));
}

TEST(PackCover, SaysOnceThatAMaterialIsNotKnown) {
  PartList list = list_of(3);
  for (PackPart& part : list.parts)
    part.material = kUnknown;
  list.groups = {{kUnknown, 1.5, 0, 1}, {kUnknown, 2.0, 1, 3}};
  const auto said = said_on(cover_of(list, {}, "chairs", ""));
  EXPECT_THAT(said, Contains("1.5 mm"));
  EXPECT_THAT(said, Contains("2 mm"));
  EXPECT_THAT(said, Not(Contains(HasSubstr("unknown"))));
  EXPECT_EQ(std::ranges::count_if(said,
                                  [](const std::string& text) {
                                    return text.find("not known of 3 parts") != std::string::npos;
                                  }),
            1);
  EXPECT_THAT(said_on(drawing_of(list.parts[0])), Not(Contains(HasSubstr("unknown"))));
  EXPECT_THAT(said_on(cover_of(list_of(3), {}, "chairs", "")), Not(Contains("Material")));
}

TEST(PackDrawing, HasTheFactsInTheUnitOfThePart) {
  PackPart part = drawn_part("leg", 5);
  part.mass = 0.25;
  part.sources = {{"a.step", "", 1}, {"b.step", "", 1}};
  auto said = said_on(drawing_of(part));
  for (const char* fact : {"leg", "200 × 100 mm", "700 mm", "0.25 kg", "5", "nothing to bend"})
    EXPECT_THAT(said, Contains(fact));
  EXPECT_THAT(said, Contains(HasSubstr("From a.step, b.step.")));
  part.units = LengthUnit::inch;
  part.size = {254, 127};
  part.sources.assign(8, {"a.step", "", 1});
  said = said_on(drawing_of(part));
  EXPECT_THAT(said, Contains("10 × 5 in"));
  EXPECT_THAT(said, Contains(HasSubstr("2 more")));
}

}  // namespace
}  // namespace planish::pack
