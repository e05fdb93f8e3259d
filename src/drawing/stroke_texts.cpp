#include "bend_drawing.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

// The column of texts beside a stroke. All lines are written smaller where there are too many.

namespace planish::drawing {
namespace {

using Lines = std::vector<std::pair<std::string, TextStyle>>;

constexpr double kLineHeight = 1.45;  // of the letters' size
const TextStyle kPlain{.size = 3.2}, kSmall{.size = 2.9, .colour = kPageGrey};

std::string names_of(const BendDrawing& drawing, const Stroke& stroke) {
  std::string names;
  for (const BendId id : stroke.bends)
    names += (names.empty() ? "" : " + ") + bend_of(drawing, id).id;
  if (stroke.press_line) names += fmt::format(", line {}", *stroke.press_line + 1);
  return names;
}

std::string with_unit(const BendDrawing& drawing, double mm) {
  return fmt::format("{} {}", size_text(drawing, mm), schema::Units(drawing.units).symbol());
}

/// Where the stroke is made if that is elsewhere than the one before.
std::string way_to_tools(const BendDrawing& drawing, std::size_t s) {
  const std::size_t now = station_of(drawing, s), before = station_of(drawing, s - 1);
  const std::vector<Station>& stations = drawing.plan->stations;
  if (now == before || now == stations.size()) return {};
  if (before == stations.size() || stations[now].set_up != stations[before].set_up)
    return "NEW SET-UP";
  return "GO TO " + station_name(now);
}

/// What is done to the sheet since the stroke before.
std::string handling(const BendDrawing& drawing, std::size_t s) {
  if (s == 0) return "start";
  const Stroke &now = strokes_of(drawing)[s], &before = strokes_of(drawing)[s - 1];
  std::string text;
  if (now.reference_up != before.reference_up) text = "TURN OVER";
  constexpr double kSame = 1e-9;
  if ((now.gauge_direction - before.gauge_direction).norm() > kSame)
    text += text.empty() ? "ROTATE" : ", ROTATE";
  if (const std::string tools = way_to_tools(drawing, s); !tools.empty())
    text += text.empty() ? tools : ", " + tools;
  return text;
}

/// "40 + 15, from 0.5 mm" for each row, over as many lines as it takes.
void add_rows(Lines& lines, const BendDrawing& drawing, const std::vector<SegmentRow>& rows) {
  constexpr std::size_t kLetters = 31;  // of the column
  const schema::Units units(drawing.units);
  for (const SegmentRow& row : rows) {
    const std::string text = text_of(row, [&](double one) { return units.short_text(one); });
    std::vector<std::string> parts = wrapped(text + ",", kLetters);
    const std::string from = "from " + with_unit(drawing, row.from);
    if (parts.back().size() + 1 + from.size() > kLetters) parts.emplace_back();
    parts.back() += (parts.back().empty() ? "" : " ") + from;
    for (const std::string& part : parts)
      lines.emplace_back("  " + part, kSmall);
  }
}

bool same(const std::vector<SegmentRow>& a, const std::vector<SegmentRow>& b) {
  return std::ranges::equal(a, b, [](const SegmentRow& one, const SegmentRow& other) {
    return one.from == other.from && one.segments == other.segments &&
           one.left_ear == other.left_ear && one.right_ear == other.right_ear;
  });
}

constexpr double kShown = 0.05;  // mm, degrees: less is written as 0

std::string gauge_text(const BendDrawing& drawing, const Stroke& stroke) {
  if (stroke.flattening) return "no gauge: slide the hem in";
  return stroke.gauge ? "gauge " + with_unit(drawing, stroke.gauge->distance)
                      : "no gauge: mark the line while flat";
}

void add_stop(Lines& lines, const BendDrawing& drawing, const Stroke& stroke) {
  lines.emplace_back(gauge_text(drawing, stroke), kPlain);
  if (stroke.open_hem)
    lines.emplace_back(
        fmt::format("stop {} above the die", with_unit(drawing, stroke.open_hem->height)),
        TextStyle{.size = 3.4, .bold = true, .colour = kPageAlert});
  if (!stroke.gauge) return;
  const GaugeStop& stop = *stroke.gauge;
  if (!stop.flange && !stop.fold && stop.height > kShown)
    lines.emplace_back("  fingers " + with_unit(drawing, stop.height) + " up, on the die", kSmall);
  if (stop.in_opening)
    lines.emplace_back(stop.by_nose ? "  in the opening, by the nose" : "  in the opening", kSmall);
  if (stop.flange || stop.fold) {
    const std::string at = stop.flange ? fmt::format("on F{}", index_of(*stop.flange) + 1)
                                       : "on the fold of " + bend_of(drawing, *stop.fold).id;
    const std::string height = with_unit(drawing, std::abs(stop.height));
    const bool is_level = std::abs(stop.height) < kShown;
    lines.emplace_back(is_level ? "  " + at
                                : fmt::format("  {}, fingers {} {}", at, height,
                                              stop.height < 0.0 ? "down" : "up"),
                       kSmall);
  }
  if (!stop.is_square())
    lines.emplace_back(
        fmt::format("  touches only {}: hold it square", with_unit(drawing, stop.touched)), kSmall);
}

Lines lines_of(const BendDrawing& drawing, std::size_t s) {
  const Stroke& stroke = strokes_of(drawing)[s];
  Lines lines{
      {fmt::format("{}  {}{}°", names_of(drawing, stroke), stroke.flattening ? "flatten " : "",
                   number_text(stroke.angle.degrees())),
       {.size = 4.2, .bold = true}}};
  if (std::string text = handling(drawing, s); !text.empty())
    lines.emplace_back(std::move(text), TextStyle{.size = 3.4, .bold = true, .colour = kPageAlert});
  lines.emplace_back(fmt::format("{} side up", side_up(stroke, drawing.layout)), kPlain);
  add_stop(lines, drawing, stroke);
  if (s < drawing.checks.size() && drawing.checks[s])
    lines.emplace_back(fmt::format("check {}: {} outside", drawing.checks[s]->flange,
                                   with_unit(drawing, drawing.checks[s]->length)),
                       kPlain);
  const std::size_t station = station_of(drawing, s);
  lines.emplace_back(station == drawing.plan->stations.size()
                         ? "punch " + stroke.punch
                         : fmt::format("{}: punch {}", station_name(station), stroke.punch),
                     kPlain);
  add_rows(lines, drawing, stroke.punch_rows);
  lines.emplace_back("die " + stroke.die, kPlain);
  if (!stroke.die_rows.empty() && same(stroke.punch_rows, stroke.die_rows))
    lines.emplace_back("  the same segments", kSmall);
  else
    add_rows(lines, drawing, stroke.die_rows);
  if (is_made_otherwise(stroke, drawing.thickness))
    lines.emplace_back(
        fmt::format("inside radius {}, drawn {}", size_text(drawing, stroke.radius_made),
                    with_unit(drawing, stroke.radius_drawn)),
        kPlain);
  std::string force = number_text(stroke.force, 3) + " kN";
  if (!stroke.flattening) force += ", " + with_unit(drawing, stroke.clearance) + " clear";
  lines.emplace_back(std::move(force), kPlain);
  if (stroke.on_ears) {
    lines.emplace_back("lips over ears: take plain", kSmall);
    lines.emplace_back("segments out, push ears in", kSmall);
  }
  return lines;
}

/// What is between the legs afterwards, as a protractor shows it; empty at a right angle, where
/// both angles are the same.
std::string opening_text(const Stroke& stroke) {
  const double opening = 180.0 - stroke.angle.degrees();
  if (stroke.flattening || stroke.press_line || std::abs(opening - 90.0) < kShown || opening < 0.0)
    return {};
  return fmt::format("leaves {}°", number_text(opening));
}

}  // namespace

std::string_view side_up(const Stroke& stroke, const Layout& layout) {
  const bool shows_reference = layout.placement[layout.root].linear().determinant() > 0.0;
  return stroke.reference_up == shows_reference ? "front" : "back";
}

void write_stroke(Page& page, const BendDrawing& drawing, std::size_t stroke,
                  const Rectangle& into) {
  const Lines lines = lines_of(drawing, stroke);
  double height = 0.0;
  for (const auto& [text, style] : lines)
    height += kLineHeight * style.size;
  const double smaller = std::min(1.0, into.size.y() / height);
  double y = into.corner.y();
  if (std::string opening = opening_text(strokes_of(drawing)[stroke]); !opening.empty())
    page.text({into.corner.x() + into.size.x(), y + smaller * kPlain.size}, std::move(opening),
              {.size = smaller * kPlain.size, .anchor = TextAnchor::end});
  for (const auto& [text, style] : lines) {
    TextStyle fitting = style;
    fitting.size = fitting_size(text, into.size.x(), smaller * style.size);
    page.text({into.corner.x(), y + smaller * kPlain.size}, text, fitting);
    y += smaller * kLineHeight * style.size;
  }
}

}  // namespace planish::drawing
