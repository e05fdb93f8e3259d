#include "page_drawing.hpp"
#include "plan_report.hpp"
#include "report_text.hpp"
#include "units.hpp"

#include <planish/job/plan_pages.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace planish::job {
namespace {

constexpr double kMargin = 12.0, kPageWidth = 210.0, kPageHeight = 297.0;
constexpr double kRow = 5.0, kSmall = 3.0, kNormal = 3.6, kLarge = 6.0;
constexpr double kTrueSize = 1.0;
constexpr int kStrokesOnPage = 3;
constexpr Colour kSheet{0.93, 0.94, 0.96}, kGrey{0.55, 0.55, 0.55}, kRed{0.80, 0.08, 0.08},
    kBlue{0.05, 0.25, 0.75}, kPunch{0.72, 0.80, 0.90}, kDie{0.88, 0.82, 0.70};

std::string mm_text(const Units& units, double mm) {
  return fmt::format("{} {}", units.length_text(mm), units.symbol());
}

std::string bends_text(const Report& report, const Stroke& stroke) {
  std::string text = fmt::format("{}", fmt::join(bend_ids(report, stroke.bends), " "));
  if (stroke.press_line) text += fmt::format("/{}", *stroke.press_line + 1);
  return text;
}

const FlatBend* bend_of(const Report& report, BendId bend) {
  const auto found = std::ranges::find(report.flat.bends, bend, &FlatBend::bend);
  return found == report.flat.bends.end() ? nullptr : &*found;
}

/// The lines in the pattern that a stroke presses.
std::vector<Segment> lines_of(const Report& report, const Stroke& stroke) {
  std::vector<Segment> lines;
  for (const BendId id : stroke.bends) {
    const FlatBend* bend = bend_of(report, id);
    if (!bend) continue;
    const auto line = static_cast<std::size_t>(stroke.press_line.value_or(0));
    if (stroke.press_line && line < bend->lines.size())
      lines.push_back(bend->lines[line]);
    else
      lines.insert(lines.end(), bend->lines.begin(), bend->lines.end());
  }
  return lines;
}

std::string segments_text(const std::vector<double>& segments, const Units& units) {
  std::vector<std::string> words;
  for (const double segment : segments)
    words.push_back(units.short_text(segment));
  return fmt::format("{}", fmt::join(words, " + "));
}

void head(Page& page, const Report& report, const std::string& right) {
  write_bold(page, {kMargin, kPageHeight - kMargin - kLarge},
             cut_to_width(report.body.empty() ? input_name(report) : report.body, kLarge, 130.0),
             kLarge);
  write(page, {kPageWidth - kMargin, kPageHeight - kMargin - kLarge}, right, kNormal,
        TextAnchor::end);
  const double y = kPageHeight - kMargin - kLarge - 2.5;
  page.items.emplace_back(PagePath{{{kMargin, y}, {kPageWidth - kMargin, y}}, kBlack, 0.4});
}

std::vector<std::string> facts_of(const Report& report, const Units& units) {
  std::vector<std::string> lines{
      fmt::format("sheet {}, blank {} × {}, {}", mm_text(units, report.summary.thickness),
                  units.length_text(report.size.x()), mm_text(units, report.size.y()),
                  counted(static_cast<int>(report.flat.bends.size()), "bend"))};
  if (!report.plan) return lines;
  std::string plan = plan_text(*report.plan, report);
  lines.push_back(plan.substr(0, plan.find('\n')));
  return lines;
}

/// The pattern with its overall sizes and the number of the stroke at each bend.
void draw_flat(Page& page, const Report& report, const PageArea& area) {
  const Units units(report.units);
  const PageDrawing drawing(page, area, Isometry2::Identity(), outline_of(report.flat), kTrueSize);
  drawing.pattern(report.flat, PagePath{{}, kBlack, 0.35, true, kSheet});
  const auto numbers = report.plan ? stroke_numbers(*report.plan) : std::map<BendId, int>();
  for (const FlatBend& bend : report.flat.bends) {
    const Colour colour = bend.direction == BendDirection::up ? kBlue : kRed;
    for (const Segment& line : bend.lines)
      drawing.line(line, PagePath{{}, colour, 0.3, false, {}, 2.0});
    if (bend.lines.empty()) continue;
    const auto number = numbers.find(bend.bend);
    const Segment& line = bend.lines.front();
    badge(page, drawing.at(0.5 * (line.a + line.b)),
          number == numbers.end() ? bend.id : std::to_string(number->second), colour);
  }
  const auto& [lo, hi] = drawing.extent();
  const Vec2 size = (hi - lo) / drawing.scale();
  dimension(page, {lo.x(), lo.y() - 5.0}, {hi.x(), lo.y() - 5.0}, mm_text(units, size.x()));
  dimension(page, {hi.x() + 4.0, lo.y()}, {hi.x() + 4.0, hi.y()}, mm_text(units, size.y()));
}

bool shows_reference(const Report& report) {
  return report.layout.placement[report.layout.root].linear().determinant() > 0.0;
}

constexpr std::array kColumns{12.0, 21.0, 46.0, 60.0, 89.0, 112.0, 131.0, 146.0, 166.0, 184.0};
constexpr std::array kTitles{"no.", "bends",  "angle", "punch", "die",
                             "up",  "gauge:", "at",    "force", "clear"};

std::array<std::string, 10> row_of(const Report& report, const Stroke& stroke, int number) {
  const Units units(report.units);
  return {std::to_string(number),
          bends_text(report, stroke),
          fmt::format("{:.1f}°", stroke.angle.degrees()),
          stroke.punch,
          stroke.die,
          stroke.reference_up == shows_reference(report) ? "as drawn" : "back",
          stroke.to_gauge ? fmt::format("F{}", index_of(*stroke.to_gauge) + 1) : "",
          stroke.gauge ? units.length_text(stroke.gauge->distance) : "none",
          fmt::format("{:.0f} kN", stroke.force),
          units.length_text(stroke.clearance)};
}

/// Rows from `first` on, as many as fit; the number of the next one.
std::size_t draw_table(Page& page, const Report& report, std::size_t first, double top) {
  for (std::size_t c = 0; c < kColumns.size(); ++c)
    write_bold(page, {kColumns[c], top}, kTitles[c], kSmall);
  page.items.emplace_back(
      PagePath{{{kMargin, top - 1.5}, {kPageWidth - kMargin, top - 1.5}}, kBlack, 0.2});
  std::size_t next = first;
  for (double y = top - kRow - 1.0; next < report.plan->strokes.size() && y > kMargin; y -= kRow) {
    const auto row = row_of(report, report.plan->strokes[next], static_cast<int>(next) + 1);
    for (std::size_t c = 0; c < row.size(); ++c) {
      const double end = c + 1 < kColumns.size() ? kColumns[c + 1] : kPageWidth - kMargin;
      write(page, {kColumns[c], y}, cut_to_width(row[c], kSmall, end - kColumns[c] - 1.0), kSmall);
    }
    ++next;
  }
  return next;
}

/// Turns the pattern so that the gauge is above, and mirrors it where its other side faces up.
Isometry2 lying(const Report& report, const Stroke& stroke) {
  const Vec2& up = stroke.gauge_direction;
  Eigen::Matrix2d turn;
  turn << up.y(), -up.x(), up.x(), up.y();
  if (stroke.reference_up != shows_reference(report)) turn.row(0) *= -1.0;
  Isometry2 motion = Isometry2::Identity();
  motion.linear() = turn;
  return motion;
}

void draw_lying(Page& page, const Report& report, std::size_t number, const PageArea& area) {
  const Stroke& stroke = report.plan->strokes[number];
  const Units units(report.units);
  const PageDrawing drawing(page, area, lying(report, stroke), outline_of(report.flat), kTrueSize);
  drawing.pattern(report.flat, PagePath{{}, kBlack, 0.3, true, kSheet});
  for (std::size_t s = 0; s < number; ++s)
    for (const Segment& line : lines_of(report, report.plan->strokes[s]))
      drawing.line(line, PagePath{{}, kGrey, 0.6});
  const std::vector<Segment> lines = lines_of(report, stroke);
  for (const Segment& line : lines)
    drawing.line(line, PagePath{{}, kRed, 0.9});
  if (!stroke.gauge || lines.empty()) return;
  drawing.line(stroke.gauge->edge, PagePath{{}, kBlue, 1.1});
  const Vec2 edge = drawing.at(0.5 * (stroke.gauge->edge.a + stroke.gauge->edge.b));
  const Vec2 line = drawing.at(0.5 * (lines.front().a + lines.front().b));
  dimension(page, {edge.x(), line.y()}, edge, mm_text(units, stroke.gauge->distance));
}

template <typename Tools>
const ToolProfile* profile_of(const Tools& tools, const std::string& id) {
  const auto found = std::ranges::find_if(tools, [&](const auto& one) { return one.id == id; });
  return found == tools.end() ? nullptr : &found->profile;
}

/// Punch and die in section, seen so that the gauge is on the right; the sheet lies between them.
void draw_tools(Page& page, const Report& report, const Stroke& stroke, const BrakeTools& tools,
                const PageArea& area) {
  const ToolProfile* punch = profile_of(tools.punches, stroke.punch);
  const ToolProfile* die = profile_of(tools.dies, stroke.die);
  if (!punch || !die) return;
  const double thickness = report.summary.thickness;
  std::vector<Vec2> raised = *punch, points = *die;
  for (Vec2& p : raised)
    p.y() += thickness;
  points.insert(points.end(), raised.begin(), raised.end());
  const PageDrawing drawing(page, area, Isometry2::Identity(), points, kTrueSize);
  drawing.path(*die, PagePath{{}, kBlack, 0.25, true, kDie});
  drawing.path(raised, PagePath{{}, kBlack, 0.25, true, kPunch});
  const double half = 0.5 * area.size().x() / drawing.scale();
  drawing.path({{-half, 0.0}, {half, 0.0}, {half, thickness}, {-half, thickness}},
               PagePath{{}, kBlack, 0.2, true, kSheet});
  write(page, {area.hi.x(), drawing.at({0.0, thickness}).y() + 1.0}, "gauge", kSmall,
        TextAnchor::end, kBlue);
}

/// What the operator does before this stroke.
std::string handling(const Plan& plan, std::size_t number) {
  if (number == 0) return {};
  const Stroke &a = plan.strokes[number - 1], &b = plan.strokes[number];
  std::vector<std::string> steps;
  if (a.reference_up != b.reference_up) steps.emplace_back("TURN OVER");
  constexpr double kSameWay = 1e-6;
  if ((a.gauge_direction - b.gauge_direction).norm() > kSameWay) steps.emplace_back("ROTATE");
  if (a.punch != b.punch || a.die != b.die) steps.emplace_back("CHANGE TOOLS");
  return fmt::format("{}", fmt::join(steps, ", "));
}

void draw_stroke(Page& page, const Report& report, std::size_t number, const BrakeTools& tools,
                 const PageArea& area) {
  const Stroke& stroke = report.plan->strokes[number];
  const Units units(report.units);
  const double top = area.hi.y() - 6.0, middle = area.lo.x() + 118.0;
  badge(page, {area.lo.x() + 3.0, top + 1.0}, std::to_string(number + 1), kRed);
  write_bold(page, {area.lo.x() + 8.0, top},
             fmt::format("{}  {:.1f}°{}", bends_text(report, stroke), stroke.angle.degrees(),
                         stroke.flattening ? "  flatten" : ""),
             kNormal + 0.6);
  write_bold(page, {middle, top}, handling(*report.plan, number), kNormal, TextAnchor::end, kRed);
  draw_lying(page, report, number, {area.lo + Vec2(4.0, 6.0), {middle - 4.0, top - 6.0}});
  draw_tools(page, report, stroke, tools,
             {{middle + 4.0, area.lo.y() + 30.0}, {area.hi.x() - 2.0, top - 2.0}});
  const std::vector<std::string> lines{
      fmt::format("punch {}, die {}", stroke.punch, stroke.die),
      fmt::format("punch {} from {}", segments_text(stroke.punch_segments, units),
                  units.short_text(stroke.punch_from)),
      fmt::format("die {} from {}", segments_text(stroke.die_segments, units),
                  units.short_text(stroke.die_from)),
      stroke.gauge ? "gauge " + mm_text(units, stroke.gauge->distance)
                   : std::string("no edge for the gauge"),
      fmt::format("{:.0f} kN, {} clear", stroke.force, mm_text(units, stroke.clearance))};
  double y = area.lo.y() + 25.0;
  for (const std::string& line : lines) {
    write(page, {middle + 4.0, y}, cut_to_width(line, kSmall, area.hi.x() - middle - 5.0), kSmall);
    y -= kRow;
  }
  page.items.emplace_back(PagePath{{area.lo, {area.hi.x(), area.lo.y()}}, kGrey, 0.2});
}

void add_stroke_pages(std::vector<Page>& pages, const Report& report, const BrakeTools& tools) {
  const double top = kPageHeight - kMargin - kLarge - 5.0;
  const double height = (top - kMargin) / kStrokesOnPage;
  const std::size_t strokes = report.plan->strokes.size();
  for (std::size_t number = 0; number < strokes; ++number) {
    const auto place = static_cast<double>(number % kStrokesOnPage);
    if (number % kStrokesOnPage == 0) {
      head(pages.emplace_back(), report,
           fmt::format("strokes {} to {} of {}", number + 1,
                       std::min(number + kStrokesOnPage, strokes), strokes));
    }
    const PageArea area{{kMargin, top - (place + 1.0) * height},
                        {kPageWidth - kMargin, top - place * height}};
    draw_stroke(pages.back(), report, number, tools, area);
  }
}

}  // namespace

std::vector<Page> plan_pages(const Report& report, const BrakeTools& tools) {
  std::vector<Page> pages(1);
  head(pages.front(), report, "bending plan");
  double y = kPageHeight - kMargin - kLarge - 9.0;
  for (const std::string& fact : facts_of(report, Units(report.units))) {
    write(pages.front(), {kMargin, y}, fact, kNormal);
    y -= kRow + 0.5;
  }
  constexpr double kFlat = 125.0;
  draw_flat(pages.front(), report,
            {{kMargin + 5.0, y - kFlat}, {kPageWidth - kMargin - 22.0, y - 4.0}});
  if (!report.plan) return pages;
  std::size_t row = draw_table(pages.front(), report, 0, y - kFlat - 16.0);
  while (row < report.plan->strokes.size()) {
    head(pages.emplace_back(), report, "strokes");
    row = draw_table(pages.back(), report, row, kPageHeight - kMargin - kLarge - 9.0);
  }
  add_stroke_pages(pages, report, tools);
  return pages;
}

}  // namespace planish::job
