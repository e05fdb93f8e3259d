#include "support/sheets.hpp"

#include <planish/drawing/part_pages.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::drawing {
namespace {

using namespace planish::test;

std::vector<std::string> texts_of(const std::vector<Page>& pages) {
  std::vector<std::string> texts;
  for (const Page& page : pages)
    for (const Page::Text& text : page.texts())
      texts.push_back(text.text);
  return texts;
}

std::ptrdiff_t count(const std::vector<Page>& pages, const std::string& text) {
  return std::ranges::count(texts_of(pages), text);
}

std::vector<Page> pages_of(const FlatPattern& flat, PartDrawing drawing = {}) {
  drawing.title = "panel";
  drawing.flat = &flat;
  return part_pages(drawing);
}

TEST(PartPages, HoldSizesBendsAndFacts) {
  const FlatPattern flat = *flatten(l_bracket());
  const auto pages = pages_of(
      flat, {.facts = {{"quantity", "4"}}, .warnings = {"mind the gap"}, .notes = {"a note"}});
  ASSERT_EQ(pages.size(), 1U);
  // The bend's id in the drawing and in the table.
  EXPECT_EQ(count(pages, "B1"), 2);
  for (const char* text : {"panel", "quantity", "4", "90°", "up", "40", "mind the gap", "a note"})
    EXPECT_GE(count(pages, text), 1) << text;
}

TEST(PartPages, GoOnWhereATableIsLong) {
  const FlatPattern flat = *flatten(staircase(40));
  ASSERT_EQ(flat.bends.size(), 80U);
  const auto pages = pages_of(flat);
  EXPECT_GT(pages.size(), 1U);
  EXPECT_EQ(count(pages, "allowance"), static_cast<std::ptrdiff_t>(pages.size()));
  for (const FlatBend& bend : flat.bends)
    EXPECT_EQ(count(pages, bend.id), 2) << bend.id;
  for (const Page& page : pages)
    for (const Page::Text& text : page.texts())
      EXPECT_TRUE(text.at.y() > 0.0 && text.at.y() < page.size().y() - 8.0) << text.text;
}

TEST(PartPages, HaveLengthsInTheUnitOfThePart) {
  const FlatPattern flat = *flatten(strip({Straight{254.0}}, 127.0, 1.0));
  const auto pages = pages_of(flat, {.units = LengthUnit::inch});
  EXPECT_EQ(count(pages, "10"), 1);
  EXPECT_EQ(count(pages, "5"), 1);
}

}  // namespace
}  // namespace planish::drawing
