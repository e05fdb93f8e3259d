#include "bend_drawing.hpp"
#include "filling.hpp"

#include <planish/base/text.hpp>
#include <planish/geometry/interval.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

// A set-up as it stands on the bed, seen by the operator: the punches above the dies, each segment
// for itself, to scale along the bed; below it the words of each station.

namespace planish::drawing {
namespace {

constexpr double kTitle = 6.0, kNamesAbove = 4.0, kTool = 4.0, kFoot = 1.2,
                 kWords = 4.6;  // heights, mm
constexpr Colour kPunch{0.80, 0.83, 0.86}, kDie{0.88, 0.90, 0.92};

std::string row_text(const BendDrawing& drawing, const std::vector<SegmentRow>& rows) {
  const schema::Units units(drawing.units);
  return fmt::format(
      "{}", fmt::join(mapped(rows,
                             [&](const SegmentRow& row) {
                               return fmt::format(
                                   "{} from {}",
                                   text_of(row, [&](double one) { return units.short_text(one); }),
                                   size_text(drawing, row.from));
                             }),
                      ", "));
}

/// The line of words of a station, over as many as it takes.
std::vector<std::string> words_of(const BendDrawing& drawing, std::size_t number) {
  constexpr std::size_t kLetters = 93;  // over the width of the page
  const Station& station = drawing.plan->stations[number];
  return wrapped(fmt::format("{}  punch {}: {}; die {}: {}; {} {}", station_name(number),
                             station.punch, row_text(drawing, station.punch_rows), station.die,
                             row_text(drawing, station.die_rows),
                             station.strokes.size() == 1 ? "stroke" : "strokes",
                             fmt::join(mapped(station.strokes, [](int s) { return s + 1; }), ", ")),
                 kLetters);
}

/// The front of a segment; that of an ear has a foot below, at the end from which its body stands
/// back.
std::vector<Vec2> front_of(const Vec2& a, const Vec2& b, double left_back, double right_back) {
  const double foot = b.y() - kFoot;
  std::vector<Vec2> corners;
  if (left_back > 0.0)
    corners = {
        {a.x() + left_back, a.y()}, {a.x() + left_back, foot}, {a.x(), foot}, {a.x(), b.y()}};
  else
    corners = {a, {a.x(), b.y()}};
  corners.push_back(b);
  if (right_back > 0.0)
    corners.insert(corners.end(),
                   {{b.x(), foot}, {b.x() - right_back, foot}, {b.x() - right_back, a.y()}});
  else
    corners.emplace_back(b.x(), a.y());
  return corners;
}

/// The part of the bed that is drawn: about the tools, a fifth of it at least.
Interval drawn_of(const BendDrawing& drawing, int set_up) {
  constexpr double kWider = 1.2, kLeast = 0.2;  // than what tools take; of the bed
  Interval tools{drawing.bed, 0.0};
  for (const Station& station : drawing.plan->stations) {
    if (station.set_up != set_up) continue;
    for (const auto* rows : {&station.punch_rows, &station.die_rows})
      tools = {std::min(tools.lo, rows->front().from), std::max(tools.hi, end_of(rows->back()))};
  }
  const double length = std::clamp(kWider * (tools.hi - tools.lo), kLeast * drawing.bed,
                                   drawing.bed);
  const double from = std::clamp(0.5 * (tools.lo + tools.hi - length), 0.0, drawing.bed - length);
  return {from, from + length};
}

/// The segments of a row, each for itself, as far down the page as told.
void draw_rows(Page& page, const std::vector<SegmentRow>& rows, const Interval& drawn, double top,
               const Colour& fill) {
  const double scale = kInner / (drawn.hi - drawn.lo);
  for (const SegmentRow& row : rows) {
    double from = row.from - drawn.lo;
    for (std::size_t i = 0; i < row.segments.size(); ++i) {
      const double length = row.segments[i];
      const Vec2 a(kEdge + scale * from, top), b(kEdge + scale * (from + length), top + kTool);
      const bool last = i + 1 == row.segments.size();
      page.area(
          {front_of(a, b, i == 0 ? scale * row.left_ear : 0.0, last ? scale * row.right_ear : 0.0)},
          {.stroke = kPageGrey, .fill = fill, .width = 0.15});
      from += length;
    }
  }
}

}  // namespace

std::string station_name(std::size_t number) {
  constexpr std::size_t kAlphabet = 26;
  const std::string letter(1, static_cast<char>('A' + number % kAlphabet));
  return number < kAlphabet ? letter : fmt::format("{}{}", letter, number / kAlphabet);
}

double height_of_bed(const BendDrawing& drawing, int set_up) {
  std::size_t lines = 0;
  for (std::size_t i = 0; i < drawing.plan->stations.size(); ++i)
    if (drawing.plan->stations[i].set_up == set_up) lines += words_of(drawing, i).size();
  return kTitle + kNamesAbove + 2.0 * kTool + 3.0 + kWords * static_cast<double>(lines);
}

void draw_bed(Page& page, const BendDrawing& drawing, int set_up, double top) {
  const schema::Units units(drawing.units);
  const Interval drawn = drawn_of(drawing, set_up);
  page.text({kEdge, top + kTitle - 2.0},
            fmt::format("Set-up {} on the bed of {} {}, from your left{}", set_up + 1,
                        units.short_text(drawing.bed), units.symbol(),
                        drawn.hi - drawn.lo < drawing.bed ? " (drawn where tools stand)" : ""),
            {.size = 3.8, .bold = true});
  const double scale = kInner / (drawn.hi - drawn.lo), punches = top + kTitle + kNamesAbove;
  double words = punches + 2.0 * kTool + kWords;
  for (const double y : {punches, punches + kTool, punches + 2.0 * kTool})
    page.line({kEdge, y}, {kEdge + kInner, y}, {.stroke = kPageGrey, .width = 0.15});
  for (std::size_t i = 0; i < drawing.plan->stations.size(); ++i) {
    const Station& station = drawing.plan->stations[i];
    if (station.set_up != set_up) continue;
    draw_rows(page, station.punch_rows, drawn, punches, kPunch);
    draw_rows(page, station.die_rows, drawn, punches + kTool, kDie);
    const double middle = 0.5 *
                          (station.punch_rows.front().from + end_of(station.punch_rows.back()));
    page.text({kEdge + scale * (middle - drawn.lo), punches - 1.0}, station_name(i),
              {.size = 3.2, .bold = true, .anchor = TextAnchor::middle});
    for (const std::string& text : words_of(drawing, i)) {
      page.text({kEdge, words}, text, {.size = fitting_size(text, kInner, 3.2)});
      words += kWords;
    }
  }
}

}  // namespace planish::drawing
