#include <planish/drawing/page_parts.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::drawing {
namespace {

Box2 box_from(const Vec2& lo, const Vec2& hi) {
  Box2 box;
  box.add(lo);
  box.add(hi);
  return box;
}

TEST(PageFit, FillsTheRectangleTurnedToPagesThatCountDown) {
  const Fit fit(box_from({-10, 20}, {90, 70}), {{30, 40}, {50, 100}}, 5.0);
  EXPECT_NEAR(fit.scale(), 0.5, 1e-12) << "100 along 50";
  EXPECT_NEAR((fit({40, 45}) - Vec2(55, 90)).norm(), 0.0, 1e-12) << "middle upon middle";
  EXPECT_NEAR((fit({-10, 70}) - Vec2(30, 77.5)).norm(), 0.0, 1e-12) << "up is less";
  const Fit high(box_from({0, 0}, {10, 50}), {{0, 0}, {100, 100}}, 50.0);
  EXPECT_NEAR(high.scale(), 2.0, 1e-12);
  EXPECT_NEAR(Fit(box_from({0, 0}, {1, 1}), {{0, 0}, {100, 100}}, 5.0).scale(), 5.0, 1e-12);
  const Fit line(box_from({0, 0}, {0, 0}), {{0, 0}, {100, 80}}, 1e9);
  EXPECT_NEAR(line.scale(), 80 / 0.05, 1e-9) << "what has no extent counts as 0.05";
}

TEST(RingsOf, AreAsFineAsThePaperShows) {
  FlatPattern flat;
  const double pi = std::numbers::pi;
  flat.outer.loop = {Arc{{0, 0}, 100, 0.0, 2 * pi}};
  flat.openings.push_back({{Arc{{0, 0}, 50, 0.0, -2 * pi}}, {}});
  for (const double scale : {1.0, 0.1}) {
    const auto rings = rings_of(flat, scale);
    ASSERT_EQ(rings.size(), 2u);
    // n chords of a circle are r (1 − cos(π/n)) off.
    for (const auto& [ring, radius] : {std::pair{rings[0], 100.0}, {rings[1], 50.0}}) {
      const double off = radius * (1 - std::cos(pi / static_cast<double>(ring.size())));
      EXPECT_LE(off, 0.05 / scale * 1.001);
      EXPECT_GE(off, 0.05 / scale * 0.3);
      for (const Vec2& p : ring)
        EXPECT_NEAR(p.norm(), radius, 1e-9);
    }
  }
}

TEST(Wrapped, BreaksBetweenWordsWhereALineIsFull) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("one two three four", 8), (Lines{"one two", "three", "four"}));
  EXPECT_EQ(wrapped("one two three four", 100), (Lines{"one two three four"}));
  EXPECT_EQ(wrapped("incomprehensible word", 5), (Lines{"incomprehensible", "word"}));
  EXPECT_EQ(wrapped("", 5), (Lines{""}));
}

TEST(FittingSize, IsTheLargestThatTheTextHasRoomFor) {
  EXPECT_EQ(fitting_size("ab", 1000, 3.5), 3.5);
  EXPECT_NEAR(fitting_size("0123456789", 12.4, 3.5), 2.0, 1e-12) << "letters are 0.62 wide";
  EXPECT_EQ(fitting_size("", 1000, 3.5), 3.5);
}

TEST(StrokeNumber, StandsInACircleAndCountsFromOne) {
  Page page(100, 100);
  number(page, {40, 30}, 4, {1, 0, 0});
  ASSERT_EQ(page.texts().size(), 1u);
  EXPECT_EQ(page.texts()[0].text, "5");
  EXPECT_EQ(page.texts()[0].style.anchor, TextAnchor::middle);
  EXPECT_EQ(page.texts()[0].at.x(), 40);
  ASSERT_EQ(page.shapes().size(), 1u);
  for (const Vec2& p : page.shapes()[0].lines.at(0))
    EXPECT_NEAR((p - Vec2(40, 30)).norm(), 2.6, 1e-12);
}

TEST(DimensionLine, LiesBesideWhatItMeasures) {
  Page page(200, 200);
  dimension(page, {10, 100}, {90, 100}, {0, 8}, "80");
  const auto& lines = page.shapes().at(0).lines;
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_NEAR((lines[2][0] - Vec2(10, 108)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((lines[2][1] - Vec2(90, 108)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((lines[0][0] - Vec2(10, 101.2)).norm(), 0.0, 1e-12) << "a little off the part";
  EXPECT_NEAR((lines[0][1] - Vec2(10, 109.2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((page.texts().at(0).at - Vec2(50, 107)).norm(), 0.0, 1e-12) << "above the line";
  EXPECT_EQ(page.texts()[0].style.turned, 0.0);
  EXPECT_EQ(page.texts()[0].text, "80");
  // Upright: read from the right, to the left of the line; short ones stand beside it, upright.
  Page upright(200, 200);
  dimension(upright, {100, 10}, {100, 60}, {-8, 0}, "50");
  EXPECT_NEAR((upright.texts().at(0).at - Vec2(91, 35)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(upright.texts()[0].style.turned, std::numbers::pi / 2, 1e-12);
  Page narrow(200, 200);
  dimension(narrow, {100, 10}, {100, 20}, {-8, 0}, "10");
  EXPECT_EQ(narrow.texts().at(0).style.turned, 0.0);
  EXPECT_GT(narrow.texts()[0].at.x(), 92);
}

}  // namespace
}  // namespace planish::drawing
