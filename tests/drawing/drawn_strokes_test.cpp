#include "support/sample_strokes.hpp"

#include <planish/drawing/bend_pages.hpp>
#include <planish/drawing/page_parts.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

// Pages are values: what is drawn on them is looked for, and measured.

namespace planish::drawing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Shape = Page::Shape;

constexpr Colour kLyingSheet{0.78, 0.86, 0.95}, kBentSheet{0.16, 0.42, 0.75};
constexpr Colour kToolSteel{0.80, 0.83, 0.86};
constexpr double kChord = 0.05;  // mm on paper: of circles from their polygons

/// What a page is drawn of.
struct Report {
  FlatPattern flat;
  Layout layout;
  std::optional<Plan> plan;
  Vec2 size{100.0, 60.0};
  std::optional<double> mass;
  LengthUnit units = LengthUnit::mm;
  std::vector<BendId> blocked;
  std::vector<std::string> obstacles;
};

/// A blank of 100 × 60 with a hole, B1 at x = 40 in two pieces, B2 at x = 20, and a plan of two
/// strokes.
Report planned_report() {
  Report report;
  FlatPattern& flat = report.flat;
  flat.thickness = 2.0;
  flat.outer.loop = {Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 60}},
                     Segment{{100, 60}, {0, 60}}, Segment{{0, 60}, {0, 0}}};
  flat.openings.resize(1);
  flat.openings[0].loop = {Arc{{70, 15}, 5.0, 0.0, -2.0 * std::numbers::pi}};
  FlatBend first;
  first.id = "B1";
  first.bend = BendId{0};
  first.direction = BendDirection::down;
  first.lines = {Segment{{40, 0}, {40, 20}}, Segment{{40, 25}, {40, 60}}};
  FlatBend second = first;
  second.id = "B2";
  second.bend = BendId{1};
  second.direction = BendDirection::up;
  second.lines = {Segment{{20, 0}, {20, 60}}};
  flat.bends = {first, second};
  report.layout.placement.push_back(Isometry2::Identity());
  Plan plan;
  plan.status = PlanStatus::optimal;
  plan.turn_overs = 1;
  plan.rotations = 2;
  plan.tool_changes = 3;
  plan.strokes = {test::stroke_at_40(), test::stroke_at_20()};
  report.plan = plan;
  return report;
}

Report infeasible_report() {
  Report report = planned_report();
  report.plan->status = PlanStatus::infeasible;
  report.plan->strokes.clear();
  report.blocked = {BendId{1}};
  report.obstacles = {"B2 hits punch P88"};
  return report;
}

std::vector<Page> pages_of(const Report& report, const std::vector<StrokePicture>& pictures) {
  return bend_pages({.title = "bracket",
                     .metal = "steel 450 N/mm²",
                     .thickness = 2.0,
                     .size = report.size,
                     .mass = report.mass,
                     .units = report.units,
                     .flat = report.flat,
                     .layout = report.layout,
                     .plan = report.plan ? &*report.plan : nullptr,
                     .blocked = report.blocked,
                     .obstacles = report.obstacles,
                     .proposals = {}},
                    pictures);
}

ToolProfile block(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// A workpiece of 60 mm, tools of which parts run far out of the picture.
StrokePicture picture_of_a_stroke() {
  StrokePicture picture;
  picture.lying = {block(-30, 0, 30, 2)};
  picture.bent = {block(-30, 0, 0, 2), block(0, 0, 2, 30)};
  picture.punch = block(-5, 2, 5, 300);
  picture.die = block(-8, -200, 8, 0);
  picture.lower_beam = block(-500, -300, 500, -20);
  picture.finger = block(30, 0, 35, 5);
  return picture;
}

std::vector<Page> pages_with(const Report& report) {
  const std::size_t strokes = report.plan ? report.plan->strokes.size() : 0;
  return pages_of(report, std::vector<StrokePicture>(strokes, picture_of_a_stroke()));
}

std::vector<std::string> texts_on(const Page& page) {
  std::vector<std::string> texts;
  for (const Page::Text& text : page.texts())
    texts.push_back(text.text);
  return texts;
}

/// Where a text begins; fails without it.
Vec2 place_of(const Page& page, const std::string& text) {
  for (const Page::Text& one : page.texts())
    if (one.text == text) return one.at;
  ADD_FAILURE() << "no text \"" << text << "\"";
  return Vec2::Zero();
}

std::vector<const Shape*> filled_with(const Page& page, const Colour& fill) {
  std::vector<const Shape*> found;
  for (const Shape& shape : page.shapes())
    if (shape.ink.fill == fill) found.push_back(&shape);
  return found;
}

std::vector<const Shape*> drawn_with(const Page& page, const Colour& stroke, double width) {
  std::vector<const Shape*> found;
  for (const Shape& shape : page.shapes())
    if (shape.ink.stroke == stroke && shape.ink.width == width) found.push_back(&shape);
  return found;
}

Box2 box_of(const std::vector<std::vector<Vec2>>& lines) {
  Box2 box;
  for (const auto& line : lines)
    for (const Vec2& p : line)
      box.add(p);
  return box;
}

Box2 box_of(const Shape& shape) { return box_of(shape.lines); }

/// Of a ring as it is seen, y up: positive if it runs counter-clockwise.
double seen_area(const std::vector<Vec2>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice -= a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// One page of two strokes.
const Page& usual_page() {
  static const Page page = pages_with(planned_report()).front();
  return page;
}

// The flat pattern is the first sheet that is drawn, each stroke's the next.
const Shape& flat_on(const Page& page) { return *filled_with(page, kPageSheet).at(0); }
const Shape& sheet_of_stroke(const Page& page, std::size_t stroke) {
  return *filled_with(page, kPageSheet).at(1 + stroke);
}

TEST(DrawnStrokes, AreAsManyAsTheStrokesNeed) {
  // 297 − 2·12 mm: two rows of 60 below the pattern, four on each further page.
  for (std::size_t strokes = 0; strokes <= 11; ++strokes) {
    Report report = planned_report();
    report.plan->strokes.assign(strokes, test::stroke_at_40());
    const auto pages = pages_with(report);
    const std::size_t expected = strokes <= 2 ? 1 : 1 + (strokes - 2 + 3) / 4;
    ASSERT_EQ(pages.size(), expected) << strokes;
    std::size_t rows = 0;
    for (std::size_t p = 0; p < pages.size(); ++p) {
      EXPECT_THAT(texts_on(pages[p]), Contains("bend plan " + std::to_string(p + 1) + " / " +
                                               std::to_string(expected)));
      rows += filled_with(pages[p], kLyingSheet).size();
    }
    EXPECT_EQ(rows, strokes);
  }
  Report report = planned_report();
  report.plan.reset();
  EXPECT_EQ(pages_of(report, {}).size(), 1u) << "without a plan";
}

TEST(DrawnStrokes, DrawEverythingWithinTheMargins) {
  Report report = planned_report();
  report.plan->strokes.assign(7, test::stroke_at_20());
  for (const Page& page : pages_with(report)) {
    EXPECT_EQ(page.size(), Vec2(210, 297));
    for (const Shape& shape : page.shapes()) {
      const Box2 box = box_of(shape);
      EXPECT_GE(box.lo.x(), 12.0 - 1e-9);
      EXPECT_GE(box.lo.y(), 12.0 - 1e-9);
      EXPECT_LE(box.hi.x(), 198.0 + 1e-9);
      EXPECT_LE(box.hi.y(), 285.0 + 1e-9);
    }
    for (const Page::Text& text : page.texts()) {
      EXPECT_GE(text.at.x(), 12.0) << text.text;
      EXPECT_LE(text.at.x(), 198.0) << text.text;
      EXPECT_GE(text.at.y(), 12.0) << text.text;
      EXPECT_LE(text.at.y(), 285.0) << text.text;
    }
  }
}

TEST(DrawnStrokes, PutRowsBelowOneAnother) {
  Report report = planned_report();
  report.plan->strokes.assign(6, test::stroke_at_40());
  const auto pages = pages_with(report);
  ASSERT_EQ(pages.size(), 2u);
  const auto cells = filled_with(pages[1], kLyingSheet);
  ASSERT_EQ(cells.size(), 4u);
  for (std::size_t i = 1; i < cells.size(); ++i)
    EXPECT_NEAR(box_of(*cells[i]).lo.y() - box_of(*cells[i - 1]).lo.y(), 60.0, 1e-9);
  for (const char* number : {"3", "4", "5", "6"})
    EXPECT_THAT(texts_on(pages[1]), Contains(number));
  EXPECT_THAT(texts_on(pages[1]), Not(Contains("2")));
  // The first page has them below its pattern, within rows that lines close.
  const Page& first = pages[0];
  EXPECT_GT(box_of(*filled_with(first, kLyingSheet)[0]).lo.y(), box_of(flat_on(first)).hi.y());
  const double line = box_of(*drawn_with(first, kPageGrey, 0.15).back()).lo.y();
  EXPECT_GT(line, box_of(sheet_of_stroke(first, 1)).hi.y());
}

TEST(DrawnStrokes, SayWhichPartOfWhatMetal) {
  Report report = planned_report();
  const auto plain = texts_on(pages_with(report).front());
  EXPECT_THAT(plain, Contains("bracket"));
  EXPECT_THAT(plain, Contains(AllOf(HasSubstr("2 mm"), HasSubstr("steel 450 N/mm²"),
                                    HasSubstr("100.0 × 60.0 mm"), Not(HasSubstr("kg")))));
  EXPECT_THAT(plain, Contains(AllOf(HasSubstr("2 strokes"), HasSubstr("over 1×"),
                                    HasSubstr("rotated 2×"), HasSubstr("changed 3×"))));
  report.mass = 0.12345;
  EXPECT_THAT(texts_on(pages_with(report).front()), Contains(HasSubstr("0.123 kg")));
}

TEST(DrawnStrokes, SayWhatBecameOfThePlan) {
  std::set<std::string> all;
  Report report = planned_report();
  for (const PlanStatus status :
       {PlanStatus::optimal, PlanStatus::feasible, PlanStatus::infeasible, PlanStatus::gave_up}) {
    report.plan->status = status;
    if (status != PlanStatus::optimal && status != PlanStatus::feasible)
      report.plan->strokes.clear();
    all.insert(pages_with(report).front().texts().at(2).text);
  }
  report.plan.reset();
  all.insert(pages_with(report).front().texts().at(2).text);
  EXPECT_EQ(all.size(), 5u) << "each its own sentence";
}

TEST(DrawnStrokes, DrawThePatternInItsSizeInTheMiddle) {
  const Shape& flat = flat_on(usual_page());
  const Box2 box = box_of(flat);
  EXPECT_NEAR(box.size().x(), 100.0, 1e-9) << "1 : 1, since there is room";
  EXPECT_NEAR(box.size().y(), 60.0, 1e-9);
  EXPECT_NEAR(0.5 * (box.lo.x() + box.hi.x()), 105.0, 1e-9);
  EXPECT_GT(box.lo.y(), 33.0) << "below the head";
  EXPECT_LT(box.hi.y(), 140.0) << "above the strokes";
  ASSERT_EQ(flat.lines.size(), 2u);
  const Box2 hole = box_of({flat.lines[1]});
  EXPECT_NEAR(hole.lo.x() - box.lo.x(), 65.0, kChord);
  EXPECT_NEAR(box.hi.y() - hole.hi.y(), 10.0, kChord) << "y of the page runs down";
  EXPECT_GT(seen_area(flat.lines[0]), 0.0) << "seen as it is, not mirrored";
}

TEST(DrawnStrokes, DrawLargePatternsSmaller) {
  Report report = planned_report();
  for (Curve2& side : report.flat.outer.loop) {
    auto& segment = std::get<Segment>(side);
    segment = {10.0 * segment.a, 10.0 * segment.b};
  }
  report.size = {1000.0, 600.0};
  const Page page = pages_with(report).front();
  const Box2 box = box_of({flat_on(page).lines[0]});
  EXPECT_NEAR(box.size().x() / box.size().y(), 1000.0 / 600.0, 1e-9);
  EXPECT_LT(box.size().x(), 186.0);
  EXPECT_GT(box.size().x(), 100.0);
  EXPECT_THAT(texts_on(page), Contains("1000.0"));
  EXPECT_THAT(texts_on(page), Contains("600.0"));
}

TEST(DrawnStrokes, NumberEachBendAtItsLineInTheColourOfItsDirection) {
  const Page& page = usual_page();
  const Box2 flat = box_of(flat_on(page));
  const auto down = drawn_with(page, kPageDown, 0.3);
  const auto up = drawn_with(page, kPageUp, 0.3);
  // B1's two pieces and the circle of its number; B2's one and its circle.
  ASSERT_EQ(down.size(), 3u);
  ASSERT_EQ(up.size(), 2u);
  EXPECT_NEAR(box_of(*down[0]).lo.x(), flat.lo.x() + 40.0, 1e-9);
  EXPECT_NEAR(box_of(*down[0]).hi.y(), flat.hi.y(), 1e-9);
  EXPECT_NEAR(box_of(*down[0]).size().y(), 20.0, 1e-9);
  EXPECT_NEAR(box_of(*down[1]).size().y(), 35.0, 1e-9);
  EXPECT_NEAR(box_of(*up[0]).lo.x(), flat.lo.x() + 20.0, 1e-9);
  EXPECT_FALSE(up[0]->ink.dashes.empty());
  // The numbers stand on the lines.
  const auto middle = [](const Shape& circle) {
    return Vec2(0.5 * (box_of(circle).lo + box_of(circle).hi));
  };
  EXPECT_NEAR(middle(*down[2]).x(), flat.lo.x() + 40.0, 1e-9);
  EXPECT_NEAR(middle(*up[1]).x(), flat.lo.x() + 20.0, 1e-9);
  EXPECT_GT(middle(*down[2]).y(), box_of(*down[0]).lo.y());
  EXPECT_LT(middle(*down[2]).y(), box_of(*down[0]).hi.y());
}

TEST(DrawnStrokes, KeepNumbersOnOneLineApart) {
  Report report = planned_report();
  report.plan->strokes.assign(2, test::stroke_at_40());
  report.plan->strokes[1].flattening = true;
  const Page page = pages_with(report).front();
  std::vector<Vec2> circles;
  for (const Shape* shape : drawn_with(page, kPageDown, 0.3))
    if (shape->closed) circles.push_back(box_of(*shape).lo);
  ASSERT_EQ(circles.size(), 2u);
  EXPECT_GT((circles[1] - circles[0]).norm(), 1.0);
  EXPECT_THAT(texts_on(page), Contains(HasSubstr("flatten 90°")));
}

TEST(DrawnStrokes, KeepNumbersOfSmallFlangesApart) {
  // Four short lines within a few millimetres: their numbers go beside them.
  Report report = planned_report();
  report.flat.bends.resize(1);
  report.plan->strokes.clear();
  for (int i = 0; i < 4; ++i) {
    FlatBend bend = report.flat.bends[0];
    bend.id = "B" + std::to_string(i + 1);
    bend.bend = BendId{i};
    bend.lines = {Segment{{40.0 + i, 30.0}, {40.0 + i, 33.0}}};
    if (i > 0) report.flat.bends.push_back(bend);
    if (i == 0) report.flat.bends[0] = bend;
    Stroke stroke = test::stroke_at_40();
    stroke.bends = {bend.bend};
    report.plan->strokes.push_back(stroke);
  }
  std::vector<Vec2> circles;
  const auto pages = pages_with(report);
  for (const Shape* shape : drawn_with(pages.front(), kPageDown, 0.3))
    if (shape->closed) circles.push_back(0.5 * (box_of(*shape).lo + box_of(*shape).hi));
  ASSERT_EQ(circles.size(), 4u);
  for (std::size_t i = 0; i < circles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((circles[i] - circles[j]).norm(), 5.2) << i << " and " << j;
  EXPECT_GE(drawn_with(pages.front(), kPageDown, 0.15).size(), 1u) << "with a line to each";
}

TEST(DrawnStrokes, DimensionThePattern) {
  const Page& page = usual_page();
  const Box2 flat = box_of(flat_on(page));
  EXPECT_LT(place_of(page, "100.0").y(), flat.lo.y()) << "above it";
  EXPECT_NEAR(place_of(page, "100.0").x(), 105.0, 1e-9);
  EXPECT_LT(place_of(page, "60.0").x(), flat.lo.x()) << "at its left";
  Report report = planned_report();
  report.units = LengthUnit::inch;
  const auto said = texts_on(pages_with(report).front());
  EXPECT_THAT(said, Contains("3.937"));
  EXPECT_THAT(said, Contains(HasSubstr("3.937 × 2.362 in")));
}

TEST(DrawnStrokes, ShowTheSheetAsItLiesWithTheGaugeAtTheTop) {
  const Page& page = usual_page();
  const auto pressed = drawn_with(page, kBentSheet, 0.9);
  const auto edges = drawn_with(page, kPageAlert, 0.9);
  ASSERT_EQ(pressed.size(), 3u) << "two pieces of B1, one of B2";
  ASSERT_EQ(edges.size(), 2u);
  for (const auto& [line, edge, sheet, distance] :
       {std::tuple{pressed[0], edges[0], &sheet_of_stroke(page, 0), 60.0},
        std::tuple{pressed[2], edges[1], &sheet_of_stroke(page, 1), 20.0}}) {
    const Box2 box = box_of({sheet->lines[0]});
    const double scale = box.size().y() / 100.0;  // its x axis is upright
    EXPECT_NEAR(box.size().x(), 60.0 * scale, 1e-9);
    EXPECT_NEAR(box_of(*line).size().y(), 0.0, 1e-9);
    EXPECT_NEAR(box_of(*edge).size().y(), 0.0, 1e-9);
    EXPECT_NEAR(box_of(*line).lo.y() - box_of(*edge).lo.y(), distance * scale, 1e-9);
    EXPECT_NEAR(box_of(*edge).lo.y(), box.lo.y(), 1e-9) << "the edge is the upper one";
    EXPECT_LT(box.hi.x(), box_of(*filled_with(page, kLyingSheet)[0]).lo.x());
  }
  // Turned so that +x is up and seen from the drawn side, y = 15 lies on the right; turned over,
  // with −x up, on the right again.
  EXPECT_GT(seen_area(sheet_of_stroke(page, 0).lines[0]), 0.0);
  EXPECT_LT(seen_area(sheet_of_stroke(page, 1).lines[0]), 0.0) << "turned over";
  for (std::size_t s = 0; s < 2; ++s) {
    const Shape& sheet = sheet_of_stroke(page, s);
    const Box2 box = box_of({sheet.lines[0]}), hole = box_of({sheet.lines[1]});
    const double share = (0.5 * (hole.lo.x() + hole.hi.x()) - box.lo.x()) / box.size().x();
    EXPECT_NEAR(share, 0.75, kChord / 10.0) << s;
    const double from_top = (0.5 * (hole.lo.y() + hole.hi.y()) - box.lo.y()) / box.size().y();
    EXPECT_NEAR(from_top, s == 0 ? 0.3 : 0.7, kChord / 10.0);
  }
}

TEST(DrawnStrokes, ShowWhatIsBentAlreadyInGrey) {
  // On the sheet of the second stroke, the two pieces of the first.
  const auto grey = drawn_with(usual_page(), kPageGrey, 0.3);
  ASSERT_EQ(grey.size(), 2u);
  const Box2 box = box_of({sheet_of_stroke(usual_page(), 1).lines[0]});
  for (const Shape* line : grey)
    EXPECT_NEAR(box_of(*line).lo.y() - box.lo.y(), 0.4 * box.size().y(), 1e-9);
}

TEST(DrawnStrokes, WriteTheDistanceOfTheGaugeBesideTheSheet) {
  const Page& page = usual_page();
  const Box2 box = box_of({sheet_of_stroke(page, 0).lines[0]});
  std::vector<Vec2> places;  // the pattern's is 60.0 too
  for (const Page::Text& text : page.texts())
    if (text.text == "60.0" && text.at.y() > box_of(flat_on(page)).hi.y())
      places.push_back(text.at);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_GT(places[0].x(), box.hi.x());
  EXPECT_LT(places[0].x(), box.hi.x() + 11.0);
  EXPECT_NEAR(places[0].y(), box.lo.y() + 0.3 * box.size().y(), 2.0) << "between line and edge";
  Report report = planned_report();
  report.plan->strokes[0].gauge.reset();
  EXPECT_EQ(drawn_with(pages_with(report).front(), kPageAlert, 0.9).size(), 1u);
}

TEST(DrawnStrokes, KnowWhichSideIsDrawnWhereThePatternShowsTheOther) {
  const auto sides = [](const Report& report) {
    std::vector<std::string> said;
    for (const std::string& text : texts_on(pages_with(report).front()))
      if (text == "front side up" || text == "back side up") said.push_back(text);
    return said;
  };
  Report report = planned_report();
  EXPECT_EQ(sides(report), (std::vector<std::string>{"front side up", "back side up"}));
  Isometry2 mirrored = Isometry2::Identity();
  mirrored.linear() << -1, 0, 0, 1;
  report.layout.placement[FaceId{0}] = mirrored;
  EXPECT_EQ(sides(report), (std::vector<std::string>{"back side up", "front side up"}));
  EXPECT_LT(seen_area(sheet_of_stroke(pages_with(report).front(), 0).lines[0]), 0.0);
}

TEST(DrawnStrokes, ShowTheWorkpieceBetweenTheTools) {
  const Page& page = usual_page();
  const Shape& before = *filled_with(page, kLyingSheet).at(0);
  const double scale = box_of(before).size().x() / 60.0;
  EXPECT_NEAR(box_of(before).size().y(), 2.0 * scale, 1e-9);
  EXPECT_LE(scale, 2.0);
  const auto after = filled_with(page, kBentSheet);
  ASSERT_EQ(after.size(), 4u) << "two pieces a stroke";
  EXPECT_NEAR(box_of(*after[0]).lo.x(), box_of(before).lo.x(), 1e-9);
  EXPECT_NEAR(box_of(*after[1]).size().y(), 30.0 * scale, 1e-9);
  const auto tools = filled_with(page, kToolSteel);
  ASSERT_EQ(tools.size(), 6u) << "lower beam, punch and die";
  // The picture ends 20 mm above the workpiece, 30 below it and 10 at either side.
  const Box2 beam = box_of(*tools[0]), punch = box_of(*tools[1]), die = box_of(*tools[2]);
  EXPECT_NEAR(punch.size().x(), 10.0 * scale, 1e-9);
  EXPECT_NEAR(punch.size().y(), 48.0 * scale, 1e-9);
  EXPECT_NEAR(punch.hi.y(), box_of(before).lo.y(), 1e-9) << "it stands on the sheet";
  EXPECT_NEAR(die.size().x(), 16.0 * scale, 1e-9);
  EXPECT_NEAR(die.size().y(), 30.0 * scale, 1e-9);
  EXPECT_NEAR(die.lo.y(), box_of(before).hi.y(), 1e-9);
  EXPECT_NEAR(beam.size().x(), 80.0 * scale, 1e-9);
  EXPECT_NEAR(beam.size().y(), 10.0 * scale, 1e-9);
  EXPECT_NEAR(0.5 * (beam.lo.x() + beam.hi.x()),
              0.5 * (box_of(before).lo.x() + box_of(before).hi.x()), 1e-9);
  // The gauge is on the right.
  const auto fingers = drawn_with(page, kPageAlert, 0.3);
  ASSERT_EQ(fingers.size(), 2u);
  EXPECT_NEAR(box_of(*fingers[0]).lo.x(), box_of(before).hi.x(), 1e-9);
  EXPECT_NEAR(box_of(*fingers[0]).size().x(), 5.0 * scale, 1e-9);
}

/// The die is drawn where it is after the stroke, 5 higher to the punch than before: the sheet that
/// lies on it, and the finger at its edge, are moved by as much.
TEST(DrawnStrokes, ShowTheSheetAndTheFingerOnTheDie) {
  StrokePicture picture = picture_of_a_stroke();
  picture.die = block(-8, -195, 8, 5);
  picture.die_drop = -5.0;
  const Page page = pages_of(planned_report(), {picture, picture}).front();
  const Box2 sheet = box_of(*filled_with(page, kLyingSheet)[0]),
             die = box_of(*filled_with(page, kToolSteel)[2]),
             finger = box_of(*drawn_with(page, kPageAlert, 0.3)[0]);
  EXPECT_NEAR(sheet.hi.y(), die.lo.y(), 1e-9);
  EXPECT_NEAR(finger.hi.y(), die.lo.y(), 1e-9);
}

TEST(DrawnStrokes, LeaveRoomForToolsAroundLargeWorkpieces) {
  const Report report = planned_report();
  StrokePicture picture;
  picture.lying = picture.bent = {block(-300, 0, 300, 2)};
  picture.punch = block(-5, 2, 5, 3000);
  picture.die = {{-2000, 0}, {0, -2000}, {2000, 0}};  // a triangle that is cut on all sides
  const Page page = pages_of(report, {picture, picture}).front();
  const double scale = box_of(*filled_with(page, kLyingSheet)[0]).size().x() / 600.0;
  const auto tools = filled_with(page, kToolSteel);
  ASSERT_EQ(tools.size(), 4u) << "no beam";
  EXPECT_NEAR(box_of(*tools[0]).size().y(), 60.0 * scale, 1e-9) << "a tenth of its extent";
  EXPECT_NEAR(box_of(*tools[1]).size().y(), 90.0 * scale, 1e-9);
  EXPECT_NEAR(box_of(*tools[1]).size().x(), 660.0 * scale, 1e-9);
  EXPECT_TRUE(drawn_with(page, kPageAlert, 0.3).empty()) << "no finger";
}

TEST(DrawnStrokes, ClipToolsThatReachALittleBeyond) {
  const Report report = planned_report();
  StrokePicture picture;
  picture.lying = picture.bent = {block(-30, 0, 30, 2)};
  picture.die = block(-40.5, -30.5, 40.5, 22.5);  // half a millimetre on each side
  const Page page = pages_of(report, {picture, picture}).front();
  const double scale = box_of(*filled_with(page, kLyingSheet)[0]).size().x() / 60.0;
  const Box2 die = box_of(*filled_with(page, kToolSteel)[0]);
  EXPECT_NEAR(die.size().x(), 80.0 * scale, 1e-9);
  EXPECT_NEAR(die.size().y(), 52.0 * scale, 1e-9);
}

TEST(DrawnStrokes, ClipTheCornersOfTools) {
  // What is left of a triangle is as large as by hand: a square of 80 by 52 less two corners.
  const Report report = planned_report();
  StrokePicture picture = picture_of_a_stroke();
  picture.bent = picture.lying;
  picture.lower_beam.clear();
  picture.punch = {{0, -18}, {60, 42}, {-60, 42}};  // |x| ≤ y + 18
  picture.die.clear();
  const Page page = pages_of(report, {picture, picture}).front();
  const double scale = box_of(*filled_with(page, kLyingSheet)[0]).size().x() / 60.0;
  const auto tools = filled_with(page, kToolSteel);
  ASSERT_EQ(tools.size(), 2u);
  // Up to y = 22, where it is 80 wide: as wide as the picture.
  EXPECT_NEAR(std::abs(seen_area(tools[0]->lines[0])), 0.5 * 80.0 * 40.0 * scale * scale, 1e-6);
}

TEST(DrawnStrokes, SayHowEachStrokeIsDone) {
  const auto said = texts_on(usual_page());
  EXPECT_THAT(said, Contains("B1  90°"));
  EXPECT_THAT(said, Contains("B2  30°"));
  EXPECT_THAT(said, Contains(HasSubstr("gauge 60.0 mm")));
  EXPECT_THAT(said, Contains(HasSubstr("gauge 20.0 mm")));
  EXPECT_THAT(said, Contains("punch P88"));
  EXPECT_THAT(said, Contains("die V16"));
  EXPECT_THAT(said, Contains("  40 + 15, from 5.1 mm"));
  EXPECT_THAT(said, Contains("  55, from 0.0 mm"));
  EXPECT_THAT(said, Contains("12.3 kN, 2.5 mm clear"));
}

TEST(DrawnStrokes, NameAllBendsOfAStrokeAndItsLine) {
  Report report = planned_report();
  report.plan->strokes[0].bends = {BendId{0}, BendId{1}};
  report.plan->strokes[1].bends = {BendId{0}};
  report.plan->strokes[1].press_line = 1;
  const Page page = pages_with(report).front();
  EXPECT_THAT(texts_on(page), Contains("B1 + B2  90°"));
  EXPECT_THAT(texts_on(page), Contains("B1, line 2  30°"));
  // All lines of the first stroke, then the second of B1 alone.
  const auto pressed = drawn_with(page, kBentSheet, 0.9);
  ASSERT_EQ(pressed.size(), 4u);
  const double scale = box_of({sheet_of_stroke(page, 1).lines[0]}).size().y() / 100.0;
  EXPECT_NEAR(box_of(*pressed[3]).size().x(), 35.0 * scale, 1e-9);
}

TEST(DrawnStrokes, WriteTheTextsOfAStrokeBelowOneAnother) {
  const Page& page = usual_page();
  double last = 0.0;
  for (const char* text : {"B1  90°", "front side up", "gauge 60.0 mm", "punch P88",
                           "  40 + 15, from 5.1 mm", "die V16"}) {
    const Vec2 at = place_of(page, text);
    EXPECT_GT(at.y(), last + 3.0) << text;
    EXPECT_NEAR(at.x(), place_of(page, "B1  90°").x(), 1e-9);
    EXPECT_GT(at.x(), box_of(*filled_with(page, kLyingSheet)[0]).hi.x());
    last = at.y();
  }
}

TEST(DrawnStrokes, SayWhatIsDoneToTheSheetBetweenStrokes) {
  const auto handled = [](const auto& change, const std::vector<Station>& stations = {}) {
    Report report = planned_report();
    report.plan->strokes = {test::stroke_at_40(), test::stroke_at_40()};
    change(report.plan->strokes[1]);
    report.plan->stations = stations;
    std::string said;
    const auto pages = pages_with(report);
    for (const Page& page : pages)
      for (const Page::Text& text : page.texts())
        if (text.style.colour == kPageAlert) said += (said.empty() ? "" : "|") + text.text;
    return said;
  };
  EXPECT_EQ(handled([](Stroke&) {}), "start") << "nothing before the second";
  EXPECT_EQ(handled([](Stroke& s) { s.reference_up = false; }), "start|TURN OVER");
  EXPECT_EQ(handled([](Stroke& s) { s.gauge_direction = Vec2::UnitY(); }), "start|ROTATE");
  const std::vector<SegmentRow> row{{100.0, {40.0}}};
  const Station first{0, "P88", "V16", row, row, {0}};
  Station second = first;
  second.strokes = {1};
  EXPECT_EQ(handled([](Stroke&) {}, {first, second}), "start|GO TO B");
  second.set_up = 1;
  EXPECT_EQ(handled([](Stroke&) {}, {first, second}), "start|NEW SET-UP");
  EXPECT_EQ(handled(
                [](Stroke& s) {
                  s.reference_up = false;
                  s.gauge_direction = -s.gauge_direction;
                },
                {first, second}),
            "start|TURN OVER, ROTATE, NEW SET-UP");
}

TEST(DrawnStrokes, MarkWhatCannotBeBent) {
  const Page page = pages_with(infeasible_report()).front();
  const Box2 flat = box_of(flat_on(page));
  const auto blocked = drawn_with(page, kPageAlert, 0.6);
  ASSERT_EQ(blocked.size(), 1u);
  EXPECT_NEAR(box_of(*blocked[0]).lo.x(), flat.lo.x() + 20.0, 1e-9);
  EXPECT_EQ(drawn_with(page, kPageGrey, 0.3).size(), 2u) << "the pieces of B1";
  EXPECT_NEAR(place_of(page, "B2").x(), flat.lo.x() + 21.0, 1e-9);
  EXPECT_NEAR(place_of(page, "B2").y(), 0.5 * (flat.lo.y() + flat.hi.y()) - 1.0, 1e-9);
  EXPECT_THAT(texts_on(page), Contains(HasSubstr("punch P88"))) << "with the reason";
  const Page usual = pages_with(planned_report()).front();
  EXPECT_THAT(texts_on(usual), Not(Contains("B2")));
}

}  // namespace
}  // namespace planish::drawing
