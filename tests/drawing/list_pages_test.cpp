#include "support/sheets.hpp"

#include <planish/drawing/list_pages.hpp>

#include <gtest/gtest.h>

namespace planish::drawing {
namespace {

using namespace planish::test;

/// Where a text stands: page and height on it, in the order of the pages.
std::vector<std::pair<std::size_t, double>> places_of(const std::vector<Page>& pages,
                                                      const std::string& wanted) {
  std::vector<std::pair<std::size_t, double>> places;
  for (std::size_t p = 0; p < pages.size(); ++p)
    for (const Page::Text& text : pages[p].texts())
      if (text.text == wanted) places.emplace_back(p, text.at.y());
  return places;
}

ListedGroup group_of(const std::string& heading, const FlatPattern& flat, int parts) {
  ListedGroup group{heading, {}, "sums of " + heading};
  for (int i = 0; i < parts; ++i)
    group.parts.push_back({.name = heading + std::to_string(i),
                           .work = "work",
                           .state = "state",
                           .quantity = i + 1,
                           .flat = &flat});
  return group;
}

TEST(ListPages, HoldAllInOrder) {
  const FlatPattern flat = *flatten(l_bracket());
  const auto pages = list_pages({.title = "panel",
                                 .groups = {group_of("a", flat, 2), group_of("b", flat, 1)},
                                 .sums = "all",
                                 .sections = {{{"Refused", true}, {{"a sentence", false}}}}});
  ASSERT_EQ(pages.size(), 1U);
  std::pair<std::size_t, double> before{0, 0.0};
  for (const char* text : {"panel", "a", "a0", "a1", "sums of a", "b", "b0", "sums of b", "all",
                           "Refused", "a sentence"}) {
    const auto places = places_of(pages, text);
    ASSERT_EQ(places.size(), 1U) << text;
    EXPECT_LT(before, places[0]) << text;
    before = places[0];
  }
  EXPECT_EQ(places_of(pages, "2×").size(), 1U);
  EXPECT_EQ(places_of(pages, "1 / 1").size(), 1U);
}

TEST(ListPages, GoOnAndNumberEachPage) {
  constexpr int kParts = 60;
  const FlatPattern flat = *flatten(l_bracket());
  const auto pages = list_pages(
      {.title = "panel", .groups = {group_of("a", flat, kParts)}, .sums = {}, .sections = {}});
  ASSERT_GT(pages.size(), 1U);
  EXPECT_EQ(places_of(pages, "panel").size(), pages.size());
  for (int i = 0; i < kParts; ++i)
    EXPECT_EQ(places_of(pages, "a" + std::to_string(i)).size(), 1U) << i;
  for (std::size_t p = 0; p < pages.size(); ++p) {
    const auto number = places_of(pages,
                                  std::to_string(p + 1) + " / " + std::to_string(pages.size()));
    ASSERT_EQ(number.size(), 1U);
    EXPECT_EQ(number[0].first, p);
    for (const Page::Text& text : pages[p].texts())
      EXPECT_LT(text.at.y(), pages[p].size().y() - 10.0) << text.text;
  }
}

TEST(ListPages, DrawWhatIsToBeNoticedInAnotherColour) {
  const auto pages = list_pages({.title = "panel",
                                 .groups = {},
                                 .sums = {},
                                 .sections = {{{"Sheets"}, {{"fine"}, {"too large", true}}}}});
  std::vector<Colour> colours;
  for (const char* wanted : {"fine", "too large"})
    for (const Page::Text& text : pages.at(0).texts())
      if (text.text == wanted) colours.push_back(text.style.colour);
  ASSERT_EQ(colours.size(), 2U);
  EXPECT_EQ(colours[0], kBlack);
  EXPECT_NE(colours[1], kBlack);
}

}  // namespace
}  // namespace planish::drawing
