#include "drawing/planned_pages.hpp"

namespace planish::drawing {
namespace {

using namespace planish::test;

using BendPages = PlannedPages;

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

TEST_F(BendPages, SayThatThereIsNothingToBend) {
  take(l_bracket());
  plan_.strokes.clear();
  plan_.status = PlanStatus::optimal;
  EXPECT_EQ(times(pages(), "nothing to bend"), 1);
  EXPECT_EQ(times(pages(), "cheapest order, proven"), 0);
}

TEST_F(BendPages, SayWhereTheGaugeAndThePersonAre) {
  take(u_channel());
  const auto made = pages();
  EXPECT_EQ(times(made, "back gauge"), 2);
  EXPECT_EQ(times(made, "you"), 4) << "in each picture";
}

TEST_F(BendPages, WriteNoEmptyTexts) {
  take(u_channel());
  EXPECT_EQ(times(pages(), ""), 0);
}

TEST_F(BendPages, PutNotesBehindTheStrokes) {
  take(staircase(2));
  notes_ = std::vector<std::string>(40, "No stroke bends B9, which is rolled.");
  const auto made = pages();
  EXPECT_EQ(times(made, "To know"), 1);
  EXPECT_EQ(times(made, notes_[0]), 40);
  for (const Page& page : made)
    for (const Page::Text& text : page.texts())
      EXPECT_LE(text.at.y(), 285.0) << text.text;
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
