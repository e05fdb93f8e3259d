#include "support/sheets.hpp"

#include <planish/drawing/bend_pages.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::drawing {
namespace {

using namespace planish::test;

std::vector<std::string> words_of(const std::vector<Page>& pages) {
  std::vector<std::string> words;
  for (const Page& page : pages)
    for (const Page::Text& text : page.texts())
      words.push_back(text.text);
  return words;
}

std::ptrdiff_t times(const std::vector<Page>& pages, const std::string& text) {
  return std::ranges::count(words_of(pages), text);
}

/// A plan that presses each bend of a sheet in a stroke of its own.
class BendPages : public ::testing::Test {
 protected:
  void take(Sheet sheet) {
    flat_ = *flat_sheet(sheet);
    for (const FlatBend& bend : flat_.pattern.bends)
      plan_.strokes.push_back({.bends = {bend.bend},
                               .angle = bend.angle,
                               .punch = "P88",
                               .die = "V16",
                               .punch_rows = {{0.5, {40.0, 15.0}}},
                               .die_rows = {},
                               .force = 12.3,
                               .clearance = 5.0});
  }
  std::vector<Page> pages(LengthUnit units = LengthUnit::mm) {
    const ToolProfile square{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}};
    StrokePicture picture;
    picture.lying = picture.bent = {square};
    picture.punch = picture.die = square;
    return bend_pages({.title = "panel",
                       .metal = "steel 400 N/mm²",
                       .thickness = 2.0,
                       .size = {254.0, 127.0},
                       .mass = 1.5,
                       .units = units,
                       .flat = flat_.pattern,
                       .layout = flat_.layout,
                       .plan = has_plan_ ? &plan_ : nullptr,
                       .blocked = blocked_,
                       .obstacles = obstacles_,
                       .proposals = proposals_},
                      std::vector<StrokePicture>(has_plan_ ? plan_.strokes.size() : 0, picture));
  }

  FlatSheet flat_;
  Plan plan_;
  bool has_plan_ = true;
  std::vector<BendId> blocked_;
  std::vector<std::string> obstacles_, proposals_;
};

TEST_F(BendPages, ShowEachStrokeOnce) {
  take(staircase(8));
  plan_.status = PlanStatus::optimal;
  ASSERT_EQ(plan_.strokes.size(), 16U);
  const auto made = pages();
  EXPECT_GT(made.size(), 1U);
  for (std::size_t p = 0; p < made.size(); ++p)
    EXPECT_EQ(
        times(made, "bend plan " + std::to_string(p + 1) + " / " + std::to_string(made.size())), 1);
  for (std::size_t s = 0; s < plan_.strokes.size(); ++s) {
    // In the flat pattern of the first page, and beside the stroke.
    EXPECT_EQ(times(made, std::to_string(s + 1)), 2) << s;
    EXPECT_EQ(times(made, flat_.pattern.bends[s].id + "  90°"), 1) << s;
  }
  EXPECT_EQ(times(made, "punch P88"), 16);
  EXPECT_EQ(times(made, "die V16"), 16);
  EXPECT_EQ(times(made, "  40 + 15, from 0.5 mm"), 16);
  EXPECT_EQ(times(made, "12.3 kN, 5.0 mm clear"), 16);
}

TEST_F(BendPages, TellWhatIsTurnedSinceTheStrokeBefore) {
  take(u_channel());
  ASSERT_EQ(plan_.strokes.size(), 2U);
  plan_.strokes[1].gauge_direction = -plan_.strokes[0].gauge_direction;
  EXPECT_EQ(times(pages(), "ROTATE"), 1);
  plan_.strokes[1].reference_up = !plan_.strokes[0].reference_up;
  EXPECT_EQ(times(pages(), "TURN OVER, ROTATE"), 1);
  plan_.strokes[1].die = "V12";
  EXPECT_EQ(times(pages(), "TURN OVER, ROTATE, CHANGE TOOLS"), 1);
}

TEST_F(BendPages, HaveLengthsInTheUnitOfThePart) {
  take(l_bracket());
  EXPECT_EQ(times(pages(), "2 mm steel 400 N/mm², blank 254.0 × 127.0 mm, 1.5 kg"), 1);
  EXPECT_EQ(
      times(pages(LengthUnit::inch), "0.0787 in steel 400 N/mm², blank 10.000 × 5.000 in, 1.5 kg"),
      1);
}

TEST_F(BendPages, SayWhyThereIsNoOrder) {
  take(l_bracket());
  plan_ = {};
  plan_.status = PlanStatus::infeasible;
  blocked_ = {flat_.pattern.bends[0].bend};
  obstacles_ = {"B1 hits the punch."};
  proposals_ = {"a smaller V"};
  const auto made = pages();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(times(made, "B1 hits the punch."), 1);
  EXPECT_EQ(times(made, "– a smaller V"), 1);
}

TEST_F(BendPages, AreOneWithoutAPlan) {
  take(l_bracket());
  has_plan_ = false;
  const auto made = pages();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(times(made, "no bend plan"), 1);
}

}  // namespace
}  // namespace planish::drawing
