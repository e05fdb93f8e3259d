#include "drawing/planned_pages.hpp"

namespace planish::drawing {
namespace {

using namespace planish::test;

using StrokeTexts = PlannedPages;

TEST_F(StrokeTexts, KeepLongListsOfSegmentsInTheColumn) {
  take(l_bracket());
  plan_.strokes[0].punch_rows = {{-123.4, std::vector<double>(24, 835.5)},
                                 {2000.0, std::vector<double>(6, 100.0)}};
  plan_.strokes[0].die_rows = {{0.5, std::vector<double>(20, 500.0)}};
  const auto made = pages();
  std::ptrdiff_t segments = 0;
  for (const Page::Text& text : made.front().texts()) {
    constexpr double kDigit = 0.64, kRight = 198.0, kBottom = 12.0 + 24.0 + 104.0 + 60.0;
    if (text.text.find(" + ") == std::string::npos) continue;
    segments += std::ranges::count(text.text, '+');
    // Blanks are half as wide as digits.
    const auto blanks = static_cast<double>(std::ranges::count(text.text, ' '));
    const double wide = static_cast<double>(text.text.size()) - 0.5 * blanks;
    EXPECT_LE(text.at.x() + kDigit * text.style.size * wide, kRight + 2.0) << text.text;
    EXPECT_LE(text.at.y(), kBottom) << text.text;
    EXPECT_FALSE(text.text.ends_with("from")) << "with its length";
  }
  EXPECT_GE(segments, 40) << "none is left out";
}

TEST_F(StrokeTexts, WriteNumbersInPlainDigits) {
  take(l_bracket());
  plan_.strokes[0].force = 2034.4;
  plan_.strokes[0].clearance = 12345.6;
  EXPECT_EQ(times(pages(), "2030 kN, 12345.6 mm clear"), 1);
  plan_.strokes[0].punch_rows = {{-0.04, {40.0}}};
  EXPECT_EQ(times(pages(), "  40, from 0.0 mm"), 1);
  for (const std::string& word : words_of(pages()))
    EXPECT_EQ(word.find("e+"), std::string::npos) << word;
}

TEST_F(StrokeTexts, SayWhatToMeasureAndWhatAProtractorShows) {
  take(u_channel());
  checks_ = {FlangeCheck{"F2", 47.04}, std::nullopt};
  plan_.strokes[1].angle = Angle::degrees(60.0);
  const auto made = pages();
  EXPECT_EQ(times(made, "check F2: 47.0 mm outside"), 1);
  EXPECT_EQ(times(made, "leaves 120°"), 1);
  EXPECT_EQ(times(made, "leaves 90°"), 0) << "the same either way";
}

TEST_F(StrokeTexts, SayTheRadiusThatIsMadeWhereItIsAnother) {
  take(l_bracket());
  plan_.strokes[0].radius_drawn = 3.0;
  plan_.strokes[0].radius_made = 3.25;  // a tenth of it would be told from 0.3 on
  EXPECT_EQ(times(pages(), "inside radius 3.2, drawn 3.0 mm"), 0);
  plan_.strokes[0].radius_made = 1.6;
  EXPECT_EQ(times(pages(), "inside radius 1.6, drawn 3.0 mm"), 1);
}

TEST_F(StrokeTexts, SayWhereFingersTouchAFormedFlange) {
  take(l_bracket());
  plan_.strokes[0].gauge = GaugeStop{75.25, {}, -3.5, FlangeId(2)};
  EXPECT_EQ(times(pages(), "gauge 75.2 mm"), 1);
  EXPECT_EQ(times(pages(), "  on F3, fingers 3.5 mm down"), 1);
  plan_.strokes[0].gauge->height = 22.0;
  EXPECT_EQ(times(pages(), "  on F3, fingers 22.0 mm up"), 1);
}

TEST_F(StrokeTexts, SayWhatHoldsTheSheet) {
  take(l_bracket());
  plan_.strokes[0].gauge = GaugeStop{75.25, {}, 1.25};
  plan_.strokes[0].gauge->fold = BendId(0);
  plan_.strokes[0].gauge->touched = 20.0;
  plan_.strokes[0].gauge->line = 60.0;
  EXPECT_EQ(times(pages(), "  on the fold of B1, fingers 1.2 mm up"), 1);
  EXPECT_EQ(times(pages(), "hold it square"), 0);
  plan_.strokes[0].gauge->line = 60.1;  // a third of it
  EXPECT_EQ(times(pages(), "  touches only 20.0 mm: hold it square"), 1);
}

TEST_F(StrokeTexts, SayThatTheNoseTouchesInTheOpening) {
  take(l_bracket());
  plan_.strokes[0].gauge = GaugeStop{75.25, {}};
  EXPECT_EQ(times(pages(), "  in the opening, by the nose"), 0);
  plan_.strokes[0].gauge->height = 18.5;
  EXPECT_EQ(times(pages(), "  fingers 18.5 mm up, on the die"), 1);
  plan_.strokes[0].gauge->height = 0.0;
  plan_.strokes[0].gauge->in_opening = true;
  EXPECT_EQ(times(pages(), "gauge 75.2 mm"), 1);
  EXPECT_EQ(times(pages(), "  in the opening"), 1);
  plan_.strokes[0].gauge->by_nose = true;
  EXPECT_EQ(times(pages(), "  in the opening, by the nose"), 1);
}

TEST_F(StrokeTexts, TellWhatIsTurnedSinceTheStrokeBefore) {
  take(u_channel());
  ASSERT_EQ(plan_.strokes.size(), 2U);
  plan_.strokes[1].gauge_direction = -plan_.strokes[0].gauge_direction;
  EXPECT_EQ(times(pages(), "ROTATE"), 1);
  plan_.strokes[1].reference_up = !plan_.strokes[0].reference_up;
  EXPECT_EQ(times(pages(), "TURN OVER, ROTATE"), 1);
  const std::vector<SegmentRow> row{{100.0, {40.0, 15.0}}};
  plan_.stations = {{0, "P88", "V16", row, row, {0}}, {0, "P85", "V16", row, row, {1}}};
  EXPECT_EQ(times(pages(), "TURN OVER, ROTATE, GO TO B"), 1);
  EXPECT_EQ(times(pages(), "B: punch P88"), 1);
  plan_.stations[1].set_up = 1;
  EXPECT_EQ(times(pages(), "TURN OVER, ROTATE, NEW SET-UP"), 1);
}

}  // namespace
}  // namespace planish::drawing
