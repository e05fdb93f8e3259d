#include "support/sheets.hpp"

#include <planish/drawing/bend_pages.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>
#include <planish/schema/units.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::drawing {
namespace {

using namespace planish::test;
using schema::Units;

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
                       .proposals = proposals_,
                       .flanges = flanges_,
                       .checks = checks_,
                       .notes = notes_},
                      std::vector<StrokePicture>(has_plan_ ? plan_.strokes.size() : 0, picture));
  }

  FlatSheet flat_;
  Plan plan_;
  bool has_plan_ = true;
  std::vector<BendId> blocked_;
  std::vector<std::string> obstacles_, proposals_, notes_;
  std::vector<FlangeName> flanges_;
  std::vector<std::optional<FlangeCheck>> checks_;
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

TEST_F(BendPages, NameEachFlangeInItsMiddle) {
  const Sheet channel = u_channel();
  const FlatSheet flat = *flat_sheet(channel);
  const auto names = flange_names(channel, flat.layout);
  ASSERT_EQ(names.size(), 3U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i].name, "F" + std::to_string(i + 1));
    const FaceId face = channel[FlangeId{static_cast<int>(i)}].faces.front();
    const auto ring = sampled(flat.layout.outline(face), 0.1);
    // Rectangles of 30 and 40 by 25: half the shorter side is the most that goes.
    EXPECT_TRUE(inside({ring}, names[i].at));
    EXPECT_NEAR(distance_to_ring(ring, names[i].at), 12.5, 1e-6);
  }
  take(channel);
  flanges_ = names;
  for (const char* name : {"F1", "F2", "F3"})
    EXPECT_EQ(times(pages(), name), 1) << name;
}

TEST_F(BendPages, KeepLongListsOfSegmentsInTheColumn) {
  take(l_bracket());
  plan_.strokes[0].punch_rows = {{-123.4, std::vector<double>(24, 835.5)},
                                 {2000.0, std::vector<double>(6, 100.0)}};
  plan_.strokes[0].die_rows = {{0.5, std::vector<double>(20, 500.0)}};
  const auto made = pages();
  std::size_t segments = 0;
  for (const Page::Text& text : made.front().texts()) {
    constexpr double kDigit = 0.64, kRight = 198.0, kBottom = 12.0 + 24.0 + 104.0 + 60.0;
    if (text.text.find(" + ") == std::string::npos) continue;
    segments += static_cast<std::size_t>(std::ranges::count(text.text, '+'));
    // Blanks are half as wide as digits.
    const auto blanks = static_cast<double>(std::ranges::count(text.text, ' '));
    const double wide = static_cast<double>(text.text.size()) - 0.5 * blanks;
    EXPECT_LE(text.at.x() + kDigit * text.style.size * wide, kRight + 2.0) << text.text;
    EXPECT_LE(text.at.y(), kBottom) << text.text;
    EXPECT_FALSE(text.text.ends_with("from")) << "with its length";
  }
  EXPECT_GE(segments, 40U) << "none is left out";
}

TEST_F(BendPages, WriteNumbersInPlainDigits) {
  take(l_bracket());
  plan_.strokes[0].force = 2034.4;
  plan_.strokes[0].clearance = 12345.6;
  EXPECT_EQ(times(pages(), "2030 kN, 12345.6 mm clear"), 1);
  plan_.strokes[0].punch_rows = {{-0.04, {40.0}}};
  EXPECT_EQ(times(pages(), "  40, from 0.0 mm"), 1);
  for (const std::string& word : words_of(pages()))
    EXPECT_EQ(word.find("e+"), std::string::npos) << word;
}

TEST_F(BendPages, SayThatThereIsNothingToBend) {
  take(l_bracket());
  plan_.strokes.clear();
  plan_.status = PlanStatus::optimal;
  EXPECT_EQ(times(pages(), "nothing to bend"), 1);
  EXPECT_EQ(times(pages(), "cheapest order, proven"), 0);
}

TEST_F(BendPages, SayWhatToMeasureAndWhatAProtractorShows) {
  take(u_channel());
  checks_ = {FlangeCheck{"F2", 47.04}, std::nullopt};
  plan_.strokes[1].angle = Angle::degrees(60.0);
  const auto made = pages();
  EXPECT_EQ(times(made, "check F2: 47.0 mm outside"), 1);
  EXPECT_EQ(times(made, "leaves 120°"), 1);
  EXPECT_EQ(times(made, "leaves 90°"), 0) << "the same either way";
}

TEST_F(BendPages, SayWhereTheGaugeAndThePersonAre) {
  take(u_channel());
  const auto made = pages();
  EXPECT_EQ(times(made, "back gauge"), 2);
  EXPECT_EQ(times(made, "you"), 4) << "in each picture";
}

TEST_F(BendPages, DimensionLinesThatAreToBeMarked) {
  take(l_bracket());
  const FlatBend& bend = flat_.pattern.bends[0];
  const Box2 box = bounds(flat_.pattern.outer.loop);
  const Segment& line = bend.lines.front();
  const bool level = std::abs(line.b.y() - line.a.y()) < 1e-9;
  const double away = level ? line.a.y() - box.lo.y() : line.a.x() - box.lo.x();
  const std::string distance = Units(LengthUnit::mm).short_text(away);
  EXPECT_EQ(times(pages(), distance), 1) << "there is no gauge";
  plan_.strokes[0].gauge = GaugeStop{20.0, line};
  EXPECT_EQ(times(pages(), distance), 0);
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

TEST_F(BendPages, ShowBendsThatTakeNoStroke) {
  take(u_channel());
  plan_.strokes.pop_back();
  EXPECT_EQ(times(pages(), flat_.pattern.bends[1].id), 1);
  EXPECT_EQ(times(pages(), flat_.pattern.bends[0].id), 0);
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
