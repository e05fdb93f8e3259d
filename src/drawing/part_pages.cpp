#include "bend_dimensions.hpp"
#include "filling.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>
#include <planish/drawing/page_parts.hpp>
#include <planish/drawing/part_pages.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

// The drawing of a part: view and facts, pattern with its dimensions, table of bends, sentences.
// They flow down the page, and what does not fit begins another one, where the table repeats its
// head. The pattern is drawn as large as its place allows. The page's y runs down, the pattern's
// up; `Fit` turns it.

namespace planish::drawing {
using namespace schema;
namespace {

constexpr double kLine = 4.8;                 // between lines of text, mm
constexpr double kText = 3.2;                 // of letters, mm
constexpr double kOutlineChord = 0.05;        // of curves on paper, mm
constexpr double kDrawnAtMost = 20.0;         // scale: what is small is drawn larger
constexpr double kUpright = 1e-6;             // sine
const std::vector<double> kHidden{1.2, 0.6};  // dashes of outlines on the side that faces down
const std::vector<double> kDotted{0.4, 0.8};

Box2 box_of(const std::vector<std::vector<Vec2>>& lines) {
  Box2 box;
  for (const auto& line : lines)
    box.add(planish::box_of(line));
  return box;
}

/// The blank, where it is turned against the overall sizes.
std::optional<std::vector<Vec2>> turned_blank(const FlatPattern& flat) {
  constexpr double kSeen = 0.01;  // mm
  const Vec2 size = blank_size(flat), overall = bounds(flat.outer.loop).size();
  if (std::abs(size.x() - std::max(overall.x(), overall.y())) < kSeen &&
      std::abs(size.y() - std::min(overall.x(), overall.y())) < kSeen)
    return std::nullopt;
  const Isometry2 back = laid_by_blank(flat).inverse();
  return std::vector<Vec2>{back * Vec2(0, 0), back * Vec2(size.x(), 0), back * size,
                           back * Vec2(0, size.y()), back * Vec2(0, 0)};
}

void draw_pattern(Page& page, const FlatPattern& flat, const Fit& fit) {
  auto rings = mapped(rings_of(flat, fit.scale()),
                      [&](auto& ring) { return fit(std::move(ring)); });
  page.area(std::move(rings), {.fill = kPageSheet, .width = 0.3});
  const double chord = kOutlineChord / fit.scale();
  for (const Curve2& slit : flat.slits)
    page.lines({fit(sampled(slit, chord))}, {.width = 0.3});
  for (const FlatFeature& feature : flat.features)
    for (const Loop& outline : feature.outlines)
      page.area({fit(sampled(outline, chord))},
                {.stroke = kPageGrey,
                 .width = 0.15,
                 .dashes = feature.side == FormSide::down ? kHidden : std::vector<double>()});
  for (const FlatBend& bend : flat.bends)
    for (const Segment& line : bend.lines)
      page.line(fit(line.a), fit(line.b),
                {.stroke = bend.direction == BendDirection::up ? kPageUp : kPageDown,
                 .width = 0.25,
                 .dashes = {2.5, 1.2}});
}

/// The ids of bends beside their lines, read from below or from the right.
void name_bends(Page& page, const FlatPattern& flat, const Fit& fit) {
  for (const FlatBend& bend : flat.bends) {
    const auto line = longest_line(bend);
    if (!line) continue;
    const Vec2 a = fit(line->a), b = fit(line->b);
    Vec2 along = b - a;
    if (along.norm() <= 0.0) continue;
    along.normalize();
    // The page's y runs down.
    if (along.x() < -kUpright || (along.x() < kUpright && along.y() > 0.0)) along = -along;
    const Vec2 above(along.y(), -along.x());
    page.text(0.5 * (a + b) + 0.9 * above, bend.id,
              {.size = 2.8,
               .bold = true,
               .anchor = TextAnchor::middle,
               .colour = bend.direction == BendDirection::up ? kPageUp : kPageDown,
               .turned = std::atan2(-along.y(), along.x())});
  }
}

void write_line(Filling& filling, const std::string& text, const TextStyle& style) {
  filling.need(kLine);
  filling.page().text({kEdge, filling.top() + style.size}, text, style);
  filling.skip(kLine);
}

/// The folded part on the left, the facts on the right.
void write_facts(Filling& filling, const PartDrawing& drawing) {
  constexpr double kHeight = 82.0, kFacts = 72.0, kNames = 30.0;
  Page& page = filling.page();
  const Vec2 corner(kEdge, filling.top());
  if (drawing.view && !drawing.view->edges.empty())
    draw_view(page, *drawing.view, corner, {kInner - kFacts - 6.0, kHeight});
  double y = filling.top() + 4.0;
  const double x = kSheetWidth - kEdge - kFacts;
  for (const auto& [name, value] : drawing.facts) {
    page.text({x, y}, name, {.size = kText, .colour = kPageGrey});
    page.text({x + kNames, y}, value, {.size = fitting_size(value, kFacts - kNames, kText)});
    y += kLine;
  }
  filling.skip(kHeight + 3.0);
}

/// What the numbers around a pattern are, in grey below it.
std::vector<std::string> captions_of(const PartDrawing& drawing, const Fit& fit,
                                     std::size_t unwritten, bool turned) {
  const Units units(drawing.units);
  std::vector<std::string> captions{
      fmt::format("flat pattern, scale {}; blue bends up, red down, lengths in {}",
                  scale_text(fit.scale()), units.symbol())};
  if (turned) {
    const Vec2 size = blank_size(*drawing.flat);
    captions.push_back(
        fmt::format("dimensions: as the pattern lies here; dotted: the blank of {} × {}, the "
                    "smallest rectangle around it",
                    units.short_text(size.x()), units.short_text(size.y())));
  }
  if (unwritten > 0)
    captions.push_back(fmt::format("{} too close together to be dimensioned",
                                   counted(unwritten, "bend line/bend lines are")));
  return captions;
}

void write_flat(Filling& filling, const PartDrawing& drawing) {
  constexpr double kHeight = 108.0, kRoom = 10.0;  // for the dimensions
  constexpr double kBendRoom = 18.0;               // for those of bend lines
  constexpr double kCaption = 3.6;                 // between lines
  Page& page = filling.page();
  const FlatPattern& flat = *drawing.flat;
  const double behind = flat.bends.empty() ? kRoom : kBendRoom;
  const Rectangle into{{kEdge + kRoom, filling.top() + kRoom},
                       {kInner - kRoom - behind, kHeight - kRoom - behind}};
  const Box2 box = bounds(flat.outer.loop);
  const auto blank = turned_blank(flat);
  Box2 drawn = box;
  for (const Vec2& corner : blank.value_or(std::vector<Vec2>()))
    drawn.add(corner);
  const Fit fit(drawn, into, kDrawnAtMost);
  if (blank) page.lines({fit(*blank)}, {.stroke = kPageGrey, .width = 0.2, .dashes = kDotted});
  draw_pattern(page, flat, fit);
  name_bends(page, flat, fit);
  const Vec2 low = fit(box.lo), high = fit(box.hi);
  const Units units(drawing.units);
  dimension(page, {low.x(), high.y()}, {high.x(), high.y()}, {0.0, -6.0},
            units.short_text(box.size().x()));
  dimension(page, {low.x(), low.y()}, {low.x(), high.y()}, {-6.0, 0.0},
            units.short_text(box.size().y()));
  const std::size_t unwritten = dimension_bends(page, flat, fit, units);
  filling.skip(kHeight);
  for (const std::string& caption : captions_of(drawing, fit, unwritten, blank.has_value())) {
    page.text({kSheetWidth - kEdge, filling.top()}, caption,
              {.size = 2.8, .anchor = TextAnchor::end, .colour = kPageGrey});
    filling.skip(kCaption);
  }
  filling.skip(1.0);
}

struct BendColumn {
  std::string_view title;
  double at;  ///< right edge, from the left edge of the table, mm
};
constexpr std::array kBendColumns{BendColumn{"bend", 12.0},          BendColumn{"stroke", 28.0},
                                  BendColumn{"direction", 50.0},     BendColumn{"angle", 70.0},
                                  BendColumn{"radius", 90.0},        BendColumn{"K", 108.0},
                                  BendColumn{"allowance", 132.0},    BendColumn{"deduction", 158.0},
                                  BendColumn{"length", kInner - 2.0}};

std::array<std::string, kBendColumns.size()> bend_cells(const FlatBend& bend, const Units& units) {
  return {bend.id,
          bend.stroke ? std::to_string(*bend.stroke) : "–",
          std::string(direction_name(bend.direction)),
          trimmed_number(bend.angle.degrees(), 2) + "°",
          units.short_text(bend.inside_radius),
          trimmed_number(bend.allowance.k_factor, 3),
          units.short_text(bend.allowance.allowance),
          units.short_text(bend.allowance.deduction),
          units.short_text(bend.length)};
}

void write_bends(Filling& filling, const PartDrawing& drawing) {
  if (drawing.flat->bends.empty()) return;
  const Units units(drawing.units);
  const auto head = [&] {
    for (const BendColumn& column : kBendColumns)
      filling.page().text({kEdge + column.at, filling.top() + kText}, std::string(column.title),
                          {.size = kText, .anchor = TextAnchor::end, .colour = kPageGrey});
    filling.skip(kLine);
    filling.page().line({kEdge, filling.top()}, {kSheetWidth - kEdge, filling.top()},
                        {.stroke = kPageGrey, .width = 0.2});
    filling.skip(1.0);
  };
  filling.need(3.0 * kLine);
  head();
  for (const FlatBend& bend : drawing.flat->bends) {
    const double before = filling.top();
    filling.need(kLine);
    if (filling.top() < before) head();
    const auto cells = bend_cells(bend, units);
    for (std::size_t i = 0; i < cells.size(); ++i)
      filling.page().text({kEdge + kBendColumns[i].at, filling.top() + kText}, cells[i],
                          {.size = kText, .anchor = TextAnchor::end});
    filling.skip(kLine);
  }
  filling.skip(2.0);
}

void write_sentences(Filling& filling, const std::vector<std::string>& sentences,
                     const Colour& colour) {
  constexpr std::size_t kLetters = 108;
  for (const std::string& sentence : sentences)
    for (const std::string& line : wrapped(sentence, kLetters))
      write_line(filling, line, {.size = kText, .colour = colour});
}

}  // namespace

void draw_view(Page& page, const PartView& view, const Vec2& corner, const Vec2& size) {
  Box2 box = box_of(view.edges);
  box.add(box_of(view.bends));
  if (box.empty()) return;
  const Fit fit(box, {corner, size}, kDrawnAtMost);
  const auto drawn = [&](const std::vector<std::vector<Vec2>>& lines, const Ink& ink) {
    auto there = mapped(lines, [&](const auto& line) { return fit(line); });
    if (!there.empty()) page.lines(std::move(there), ink);
  };
  drawn(view.bends, {.stroke = kPageGrey, .width = 0.12});
  drawn(view.edges, {.width = 0.22});
}

void draw_flat(Page& page, const FlatPattern& flat, const Vec2& corner, const Vec2& size) {
  draw_pattern(page, flat, Fit(bounds(flat.outer.loop), {corner, size}, kDrawnAtMost));
}

std::vector<Page> part_pages(const PartDrawing& drawing) {
  PLANISH_ASSERT(drawing.flat && !drawing.flat->outer.loop.empty());
  Filling filling(drawing.title, drawing.subtitle, PageNumbers::where_several);
  write_facts(filling, drawing);
  write_flat(filling, drawing);
  write_bends(filling, drawing);
  write_sentences(filling, drawing.warnings, kPageAlert);
  if (const std::string forms = forms_text(*drawing.flat); !forms.empty())
    write_sentences(filling, {fmt::format("Forms: {}.", forms)}, kBlack);
  write_sentences(filling, drawing.notes, kBlack);
  return std::move(filling).take();
}

}  // namespace planish::drawing
