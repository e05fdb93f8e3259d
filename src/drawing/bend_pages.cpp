#include "filling.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>
#include <planish/drawing/bend_pages.hpp>
#include <planish/drawing/page_parts.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <span>

// Pages to hang at the press brake (bend.md#pages): the flat pattern with the numbers of its
// strokes, then a row for each stroke. The sheet is drawn as the operator sees it: turned so that
// the gauge is above, and mirrored if the undrawn side is up. Beside it the workpiece in the
// machine, cut to what surrounds it, since tools and beams are much larger than the part.

namespace planish::drawing {
using namespace schema;
namespace {

constexpr double kHead = 34.0, kFlat = 104.0, kRow = 60.0;  // heights, mm
constexpr Colour kUp = kPageUp, kDown = kPageDown, kGrey = kPageGrey;
constexpr Colour kSheet = kPageSheet, kSteel{0.80, 0.83, 0.86}, kPart{0.16, 0.42, 0.75};
constexpr Colour kBefore{0.78, 0.86, 0.95}, kAlert = kPageAlert;

const FlatBend& bend_of(const BendDrawing& drawing, BendId id) {
  const auto found = std::ranges::find(drawing.flat.bends, id, &FlatBend::bend);
  PLANISH_ASSERT(found != drawing.flat.bends.end());
  return *found;
}

Colour colour_of(const FlatBend& bend) { return bend.direction == BendDirection::up ? kUp : kDown; }

/// The lines that a stroke presses.
std::vector<Segment> pressed_lines(const BendDrawing& drawing, const Stroke& stroke) {
  std::vector<Segment> lines;
  for (const BendId id : stroke.bends) {
    const std::vector<Segment>& all = bend_of(drawing, id).lines;
    if (stroke.press_line && *stroke.press_line < std::ssize(all))
      lines.push_back(all[static_cast<std::size_t>(*stroke.press_line)]);
    else
      lines.insert(lines.end(), all.begin(), all.end());
  }
  return lines;
}

std::span<const Stroke> strokes_of(const BendDrawing& drawing) {
  if (!drawing.plan) return {};
  return drawing.plan->strokes;
}

std::string names_of(const BendDrawing& drawing, const Stroke& stroke) {
  std::string names;
  for (const BendId id : stroke.bends)
    names += (names.empty() ? "" : " + ") + bend_of(drawing, id).id;
  if (stroke.press_line) names += fmt::format(", line {}", *stroke.press_line + 1);
  return names;
}

/// The drawn side of the pattern shows the reference skin.
bool shows_reference(const BendDrawing& drawing) {
  return drawing.layout.placement[drawing.layout.root].linear().determinant() > 0.0;
}

/// As exactly as a gauge is set: to 0.1 mm, or a thousandth of another unit.
std::string size_text(const BendDrawing& drawing, double mm) {
  const bool metric = drawing.units == LengthUnit::mm;
  return fmt::format("{:.{}f}", Units(drawing.units).length(mm), metric ? 1 : 3);
}

std::string size_with_unit(const BendDrawing& drawing, double mm) {
  return fmt::format("{} {}", size_text(drawing, mm), Units(drawing.units).symbol());
}

std::string state_of(const Plan& plan) {
  return std::string(
      word_of(plan.status, {"cheapest order, proven", "an order that works",
                            "CANNOT BE BENT with these tools", "no order found within the limit"}));
}

/// One line on the order of strokes.
std::string order_of(const BendDrawing& drawing) {
  if (!drawing.plan) return "no bend plan";
  const Plan& plan = *drawing.plan;
  if (plan.strokes.empty()) return state_of(plan);
  return fmt::format("{}, turned over {}×, rotated {}×, tools changed {}×: {}",
                     counted(plan.strokes.size(), "stroke"), plan.turn_overs, plan.rotations,
                     plan.tool_changes, state_of(plan));
}

void head(Page& page, const BendDrawing& drawing, std::size_t at, std::size_t of) {
  const double right = kSheetWidth - kEdge;
  constexpr double kLargest = 6.5, kRoom = 150.0;  // mm
  const double size = fitting_size(drawing.title, kRoom, kLargest);
  page.text({kEdge, kEdge + 5.0}, drawing.title, {.size = size, .bold = true});
  page.text({right, kEdge + 5.0}, fmt::format("bend plan {} / {}", at, of),
            {.size = 3.5, .anchor = TextAnchor::end, .colour = kGrey});
  const Units units(drawing.units);
  std::string blank = fmt::format(
      "{} {} {}, blank {} × {}", units.short_text(drawing.thickness), units.symbol(), drawing.metal,
      size_text(drawing, drawing.size.x()), size_with_unit(drawing, drawing.size.y()));
  if (drawing.mass) blank += fmt::format(", {:.3g} kg", *drawing.mass);
  page.text({kEdge, kEdge + 12.0}, blank, {.size = 4.0});
  page.text({kEdge, kEdge + 18.0}, order_of(drawing), {.size = 4.0});
  page.line({kEdge, kEdge + 21.0}, {right, kEdge + 21.0}, {.width = 0.4});
}

void flat_drawing(Page& page, const BendDrawing& drawing, const Rectangle& into) {
  const Box2 box = box_of(sampled(drawing.flat.outer.loop, 1.0));
  constexpr double kRoom = 9.0;  // for dimensions
  const Rectangle inner{into.corner + Vec2(kRoom, kRoom), into.size - Vec2(2 * kRoom, 2 * kRoom)};
  const Fit fit(box, inner, 1.0);
  auto rings = mapped(rings_of(drawing.flat, fit.scale()),
                      [&](auto& ring) { return fit(std::move(ring)); });
  page.area(std::move(rings), {.fill = kSheet, .width = 0.35});
  const std::span<const Stroke> strokes = strokes_of(drawing);
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    const Stroke& stroke = strokes[s];
    const Colour colour = colour_of(bend_of(drawing, stroke.bends.front()));
    const std::vector<Segment> lines = pressed_lines(drawing, stroke);
    for (const Segment& line : lines)
      page.line(fit(line.a), fit(line.b), {.stroke = colour, .width = 0.3, .dashes = {2.5, 1.2}});
    const Segment& first = lines.front();
    // Strokes on one line (a hem's two) stand beside each other.
    const double along = 0.5 + 0.06 * static_cast<double>(s % 3);
    number(page, fit(first.a + along * (first.b - first.a)), s, colour);
  }
  for (const FlatBend& bend : drawing.flat.bends) {
    const bool blocked = std::ranges::count(drawing.blocked, bend.bend) > 0;
    for (const Segment& line : bend.lines)
      if (strokes.empty())
        page.line(fit(line.a), fit(line.b),
                  {.stroke = blocked ? kAlert : kGrey, .width = blocked ? 0.6 : 0.3});
    if (!blocked || bend.lines.empty()) continue;
    const Segment& line = bend.lines.front();
    page.text(fit(0.5 * (line.a + line.b)) + Vec2(1.0, -1.0), bend.id,
              {.size = 3.2, .bold = true, .colour = kAlert});
  }
  const Vec2 low = fit(box.lo), high = fit(box.hi);
  dimension(page, {low.x(), high.y()}, {high.x(), high.y()}, {0.0, -6.0},
            size_text(drawing, box.hi.x() - box.lo.x()));
  dimension(page, {low.x(), low.y()}, {low.x(), high.y()}, {-6.0, 0.0},
            size_text(drawing, box.hi.y() - box.lo.y()));
  page.text({into.corner.x() + into.size.x(), into.corner.y() + into.size.y()},
            fmt::format("drawn side up, scale {:.3g} : 1; blue bends up, red down", fit.scale()),
            {.size = 3.0, .anchor = TextAnchor::end, .colour = kGrey});
}

/// The sheet as the operator sees it, the gauge at the top.
void lying(Page& page, const BendDrawing& drawing, std::size_t s, const Rectangle& into) {
  const Stroke& stroke = drawing.plan->strokes[s];
  const bool drawn_up = stroke.reference_up == shows_reference(drawing);
  const Vec2 up = stroke.gauge_direction;
  const Vec2 right = drawn_up ? Vec2(up.y(), -up.x()) : Vec2(-up.y(), up.x());
  const auto seen = [&](std::vector<Vec2> points) {
    for (Vec2& p : points)
      p = Vec2(p.dot(right), p.dot(up));
    return points;
  };
  const Box2 box = box_of(seen(sampled(drawing.flat.outer.loop, 1.0)));
  constexpr double kRoom = 11.0;  // for the dimension
  const Fit fit(box, {into.corner, into.size - Vec2(kRoom, 0.0)}, 1.0);
  auto rings = mapped(rings_of(drawing.flat, fit.scale()),
                      [&](auto& ring) { return fit(seen(std::move(ring))); });
  page.area(std::move(rings), {.fill = kSheet, .width = 0.25});
  for (std::size_t before = 0; before < s; ++before)
    for (const Segment& line : pressed_lines(drawing, drawing.plan->strokes[before]))
      page.lines({fit(seen({line.a, line.b}))}, {.stroke = kGrey, .width = 0.3});
  for (const Segment& line : pressed_lines(drawing, stroke))
    page.lines({fit(seen({line.a, line.b}))}, {.stroke = kPart, .width = 0.9});
  if (!stroke.gauge) return;
  const auto edge = fit(seen({stroke.gauge->edge.a, stroke.gauge->edge.b}));
  const Segment line = pressed_lines(drawing, stroke).front();
  const auto bend = fit(seen({line.a, line.b}));
  page.lines({edge}, {.stroke = kAlert, .width = 0.9});
  const double right_side = fit(box.hi).x();
  dimension(page, {right_side, bend[0].y()}, {right_side, edge[0].y()}, {4.0, 0.0},
            size_text(drawing, stroke.gauge->distance));
}

/// The workpiece between the tools, the gauge on the right.
void between_tools(Page& page, const StrokePicture& picture, const Rectangle& into) {
  // What is around the workpiece; long tools and beams run out of the picture.
  Box2 box;
  for (const auto* sections : {&picture.lying, &picture.bent})
    for (const ToolProfile& section : *sections)
      box.add(box_of(section));
  const double room = std::max(20.0, 0.1 * (box.hi - box.lo).maxCoeff());
  box.lo -= Vec2(0.5 * room, 1.5 * room);
  box.hi += Vec2(0.5 * room, room);
  const Fit fit(box, into, 2.0);
  const auto clip = [&](ToolProfile profile) {
    for (const auto& [normal, offset] :
         {std::pair{Vec2(1, 0), box.hi.x()}, std::pair{Vec2(-1, 0), -box.lo.x()},
          std::pair{Vec2(0, 1), box.hi.y()}, std::pair{Vec2(0, -1), -box.lo.y()}})
      profile = clipped(profile, normal, offset);
    return fit(std::move(profile));
  };
  const Ink tool{.stroke = kGrey, .fill = kSteel, .width = 0.2};
  for (const ToolProfile* profile :
       {&picture.upper_beam, &picture.lower_beam, &picture.punch, &picture.die})
    if (profile->size() > 2) page.area({clip(*profile)}, tool);
  for (const ToolProfile& section : picture.lying)
    page.area({fit(section)}, {.stroke = kBefore, .fill = kBefore, .width = 0.1});
  for (const ToolProfile& section : picture.bent)
    page.area({fit(section)}, {.stroke = kPart, .fill = kPart, .width = 0.1});
  if (picture.finger.size() > 2)
    page.area({clip(picture.finger)}, {.stroke = kAlert, .fill = {}, .width = 0.3});
}

/// "40 + 15 from 0.5 mm", a line for each row.
std::vector<std::string> row_texts(const BendDrawing& drawing,
                                   const std::vector<SegmentRow>& rows) {
  const Units units(drawing.units);
  std::vector<std::string> texts;
  for (const SegmentRow& row : rows) {
    std::string text;
    for (const double length : row.segments)
      text += (text.empty() ? "  " : " + ") + units.short_text(length);
    texts.push_back(text + ", from " + size_with_unit(drawing, row.from));
  }
  return texts;
}

/// What is done to the sheet since the stroke before.
std::string handling(const BendDrawing& drawing, std::size_t s) {
  if (s == 0) return "start";
  const Stroke &now = drawing.plan->strokes[s], &before = drawing.plan->strokes[s - 1];
  std::string text;
  if (now.reference_up != before.reference_up) text = "TURN OVER";
  constexpr double kSame = 1e-9;
  if ((now.gauge_direction - before.gauge_direction).norm() > kSame)
    text += text.empty() ? "ROTATE" : ", ROTATE";
  if (now.punch != before.punch || now.die != before.die)
    text += text.empty() ? "CHANGE TOOLS" : ", CHANGE TOOLS";
  return text;
}

/// Why the part cannot be bent, and how it could be, as far down as `bottom`.
void write_reasons(Page& page, const BendDrawing& drawing, const Vec2& from, double bottom) {
  constexpr std::size_t kReasonLetters = 100;  // about as many as a page is wide
  constexpr double kSpacing = 1.5, kGap = 3.0;
  double y = from.y();
  const auto tell = [&](const std::string& text, const TextStyle& style) {
    for (const std::string& line : wrapped(text, kReasonLetters)) {
      if (y > bottom) return;
      page.text({from.x(), y}, line, style);
      y += kSpacing * style.size;
    }
  };
  for (const std::string& obstacle : drawing.obstacles)
    tell(obstacle, {.size = 3.4, .colour = kPageAlert});
  if (drawing.proposals.empty()) return;
  y += kGap;
  tell("It can be bent", {.size = 3.8, .bold = true});
  for (const std::string& proposal : drawing.proposals)
    tell("– " + proposal, {.size = 3.4});
}

void stroke_texts(Page& page, const BendDrawing& drawing, std::size_t s, const Vec2& at) {
  const Stroke& stroke = drawing.plan->strokes[s];
  const bool drawn_up = stroke.reference_up == shows_reference(drawing);
  double y = at.y();
  const auto line = [&](const std::string& text, const TextStyle& style = {.size = 3.2}) {
    page.text({at.x(), y}, text, style);
    y += 1.45 * style.size;
  };
  line(fmt::format("{}  {}{:.4g}°", names_of(drawing, stroke), stroke.flattening ? "flatten " : "",
                   stroke.angle.degrees()),
       {.size = 4.2, .bold = true});
  if (const std::string text = handling(drawing, s); !text.empty())
    line(text, {.size = 3.4, .bold = true, .colour = kAlert});
  line(drawn_up ? "drawn side up" : "drawn side down");
  line(stroke.gauge ? "gauge " + size_with_unit(drawing, stroke.gauge->distance)
                    : std::string("no edge to gauge: mark the line"));
  line(fmt::format("punch {}", stroke.punch));
  for (const std::string& row : row_texts(drawing, stroke.punch_rows))
    line(row, {.size = 2.9, .colour = kGrey});
  line(fmt::format("die {}", stroke.die));
  for (const std::string& row : row_texts(drawing, stroke.die_rows))
    line(row, {.size = 2.9, .colour = kGrey});
  line(fmt::format("{:.3g} kN, {} clear", stroke.force, size_with_unit(drawing, stroke.clearance)));
}

void stroke_row(Page& page, const BendDrawing& drawing, const StrokePicture& picture, std::size_t s,
                double top) {
  constexpr double kGap = 3.0, kLying = 52.0, kTexts = 52.0;
  const double left = kEdge, inner = kRow - 2 * kGap;
  number(page, {left + 3.0, top + kGap + 3.0}, s, kBlack);
  lying(page, drawing, s, {{left + 8.0, top + kGap}, {kLying, inner}});
  const double tools = kSheetWidth - 2 * kEdge - kLying - kTexts - 16.0;
  between_tools(page, picture, {{left + kLying + 12.0, top + kGap}, {tools, inner}});
  stroke_texts(page, drawing, s, {kSheetWidth - kEdge - kTexts, top + kGap + 4.0});
  page.line({left, top + kRow}, {kSheetWidth - kEdge, top + kRow},
            {.stroke = kGrey, .width = 0.15});
}

}  // namespace

std::vector<Page> bend_pages(const BendDrawing& drawing,
                             const std::vector<StrokePicture>& pictures) {
  const std::size_t strokes = strokes_of(drawing).size();
  PLANISH_ASSERT(pictures.size() == strokes);
  const double below = kSheetHeight - kEdge;
  const auto rows = [&](double top) { return static_cast<std::size_t>((below - top) / kRow); };
  const double first_top = kEdge + kHead - 10.0 + kFlat, next_top = kEdge + kHead - 10.0;
  const std::size_t on_first = rows(first_top), on_next = rows(next_top);
  const std::size_t rest = strokes > on_first ? strokes - on_first : 0;
  const std::size_t count = 1 + (rest + on_next - 1) / on_next;
  std::vector<Page> pages;
  std::size_t s = 0;
  for (std::size_t p = 0; p < count; ++p) {
    Page& page = pages.emplace_back(kSheetWidth, kSheetHeight);
    head(page, drawing, p + 1, count);
    double top = p == 0 ? first_top : next_top;
    if (p == 0)
      flat_drawing(page, drawing,
                   {{kEdge, kEdge + kHead - 9.0}, {kSheetWidth - 2 * kEdge, kFlat - 6.0}});
    if (p == 0 && !drawing.obstacles.empty())
      write_reasons(page, drawing, {kEdge, top + 6.0}, below);
    for (std::size_t row = 0; row < (p == 0 ? on_first : on_next) && s < strokes; ++row, ++s) {
      stroke_row(page, drawing, pictures[s], s, top);
      top += kRow;
    }
  }
  return pages;
}

}  // namespace planish::drawing
