#include "bend_drawing.hpp"
#include "filling.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/geometry/plane.hpp>

#include <fmt/format.h>

#include <algorithm>

// Pages to hang at the press brake (bend.md#pages): the flat pattern with the numbers of its
// strokes, then a row for each stroke. The sheet is drawn as the operator sees it: turned so that
// the gauge is above, and mirrored if the undrawn side is up. Beside it the workpiece in the
// machine, cut to what surrounds it, since tools and beams are much larger than the part.

namespace planish::drawing {
namespace {

constexpr double kHead = 34.0, kFlat = 104.0, kRow = 60.0;  // heights, mm
constexpr Colour kGrey = kPageGrey, kSteel{0.80, 0.83, 0.86}, kPart{0.16, 0.42, 0.75};
constexpr Colour kBefore{0.78, 0.86, 0.95}, kAlert = kPageAlert;
constexpr double kLabelSize = 2.6, kLabel = 3.5;  // mm: of labels around pictures, and their room

std::string state_of(const Plan& plan) {
  if (has_order(plan) && plan.strokes.empty())
    return only_rolls(plan) ? "no strokes: what is bent is rolled" : "nothing to bend";
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

void head(Page& page, const BendDrawing& drawing) {
  const double right = kSheetWidth - kEdge;
  constexpr double kLargest = 6.5, kRoom = 150.0;  // mm
  const double size = fitting_size(drawing.title, kRoom, kLargest);
  page.text({kEdge, kEdge + 5.0}, drawing.title, {.size = size, .bold = true});
  const schema::Units units(drawing.units);
  std::string blank = fmt::format(
      "{} {} {}, blank {} × {}", units.short_text(drawing.thickness), units.symbol(), drawing.metal,
      size_text(drawing, drawing.size.x()), size_text(drawing, drawing.size.y()));
  blank += fmt::format(" {}", units.symbol());
  if (drawing.mass) blank += fmt::format(", {} kg", number_text(*drawing.mass, 3));
  if (!drawing.machine.empty()) blank += ", on " + drawing.machine;
  constexpr double kLine = 4.0;
  page.text({kEdge, kEdge + 12.0}, blank, {.size = fitting_size(blank, kInner, kLine)});
  const std::string order = order_of(drawing);
  page.text({kEdge, kEdge + 18.0}, order, {.size = fitting_size(order, kInner, kLine)});
  page.line({kEdge, kEdge + 21.0}, {right, kEdge + 21.0}, {.width = 0.4});
}

/// Words around a picture, and its scale.
void label(Page& page, const Vec2& at, TextAnchor anchor, const std::string& text) {
  page.text(at, text, {.size = kLabelSize, .anchor = anchor, .colour = kGrey});
}

/// The sheet as the operator sees it, the gauge at the top.
void lying(Page& page, const BendDrawing& drawing, std::size_t s, const Rectangle& into) {
  const Stroke& stroke = drawing.plan->strokes[s];
  const bool front_up = side_up(stroke, drawing.layout) == "front";
  const Vec2 up = stroke.gauge_direction;
  const Vec2 right = front_up ? Vec2(up.y(), -up.x()) : Vec2(-up.y(), up.x());
  const auto seen = [&](std::vector<Vec2> points) {
    for (Vec2& p : points)
      p = Vec2(p.dot(right), p.dot(up));
    return points;
  };
  const Box2 box = box_of(seen(sampled(drawing.flat.outer.loop, 1.0)));
  constexpr double kRoom = 11.0;  // for the dimension
  const Rectangle inner{into.corner + Vec2(0.0, kLabel), into.size - Vec2(kRoom, 2.0 * kLabel)};
  const Fit fit(box, inner, 1.0);
  const double middle = inner.middle().x(), bottom = into.corner.y() + into.size.y();
  label(page, {middle, into.corner.y() + kLabelSize}, TextAnchor::middle, "back gauge");
  label(page, {middle, bottom}, TextAnchor::middle, "you");
  label(page, {into.corner.x() + into.size.x(), into.corner.y() + kLabelSize}, TextAnchor::end,
        scale_text(fit.scale()));
  auto rings = mapped(rings_of(drawing.flat, fit.scale()),
                      [&](auto& ring) { return fit(seen(std::move(ring))); });
  page.area(std::move(rings), {.fill = kPageSheet, .width = 0.25});
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
  dimension(page, {right_side, bend[0].y()}, {right_side, edge[0].y()}, {5.0, 0.0},
            size_text(drawing, stroke.gauge->distance));
}

/// The sheet and the finger before the stroke, where they are to the die that is drawn.
StrokePicture on_die(StrokePicture picture) {
  const auto lift = [&](ToolProfile& section) {
    for (Vec2& corner : section)
      corner.y() -= picture.die_drop;
  };
  std::ranges::for_each(picture.lying, lift);
  lift(picture.finger);
  return picture;
}

/// The workpiece between the tools, the gauge on the right.
void between_tools(Page& page, const StrokePicture& as_made, const Rectangle& into) {
  const StrokePicture picture = on_die(as_made);
  // What is around the workpiece; long tools and beams run out of the picture.
  Box2 box;
  for (const auto* sections : {&picture.lying, &picture.bent})
    for (const ToolProfile& section : *sections)
      box.add(box_of(section));
  const double room = std::max(20.0, 0.1 * (box.hi - box.lo).maxCoeff());
  box.lo -= Vec2(0.5 * room, 1.5 * room);
  box.hi += Vec2(0.5 * room, room);
  const Fit fit(box, {into.corner, into.size - Vec2(0.0, kLabel)}, 2.0);
  const double bottom = into.corner.y() + into.size.y(), right = into.corner.x() + into.size.x();
  label(page, {into.corner.x(), bottom}, TextAnchor::start, "you");
  label(page, {into.middle().x(), bottom}, TextAnchor::middle, scale_text(fit.scale()));
  label(page, {right, bottom}, TextAnchor::end, "gauge");
  const auto clip = [&](ToolProfile profile) {
    for (const auto& [normal, offset] :
         {std::pair{Vec2(1, 0), box.hi.x()}, std::pair{Vec2(-1, 0), -box.lo.x()},
          std::pair{Vec2(0, 1), box.hi.y()}, std::pair{Vec2(0, -1), -box.lo.y()}})
      profile = clipped(profile, normal, offset);
    return fit(std::move(profile));
  };
  // A punch that has come down may be where the finger was.
  if (picture.finger.size() > 2)
    page.area({clip(picture.finger)}, {.stroke = kAlert, .fill = {}, .width = 0.3});
  const Ink tool{.stroke = kGrey, .fill = kSteel, .width = 0.2};
  for (const ToolProfile* profile :
       {&picture.upper_beam, &picture.lower_beam, &picture.punch, &picture.die})
    if (profile->size() > 2) page.area({clip(*profile)}, tool);
  for (const ToolProfile& section : picture.lying)
    page.area({fit(section)}, {.stroke = kBefore, .fill = kBefore, .width = 0.1});
  for (const ToolProfile& section : picture.bent)
    page.area({fit(section)}, {.stroke = kPart, .fill = kPart, .width = 0.1});
}

void stroke_row(Page& page, const BendDrawing& drawing, const StrokePicture& picture, std::size_t s,
                double top) {
  constexpr double kGap = 3.0, kLying = 52.0, kTexts = 52.0;
  const double left = kEdge, inner = kRow - 2 * kGap;
  number(page, {left + 3.0, top + kGap + 3.0}, s, kBlack);
  lying(page, drawing, s, {{left + 8.0, top + kGap}, {kLying, inner}});
  const double tools = kSheetWidth - 2 * kEdge - kLying - kTexts - 16.0;
  between_tools(page, picture, {{left + kLying + 12.0, top + kGap}, {tools, inner}});
  write_stroke(page, drawing, s,
               {{kSheetWidth - kEdge - kTexts, top + kGap + 1.0}, {kTexts, inner - 1.0}});
  page.line({left, top + kRow}, {kSheetWidth - kEdge, top + kRow},
            {.stroke = kGrey, .width = 0.15});
}

/// Pages that are filled from above.
class Pages {
 public:
  explicit Pages(const BendDrawing& drawing) : drawing_(drawing) {
    begin();
    draw_flat_pattern(pages_.back(), drawing,
                      {{kEdge, kEdge + kHead - 9.0}, {kInner, kFlat - 6.0}});
    top_ += kFlat;
  }

  /// A stroke, and before it the set-up that begins there.
  void add(const StrokePicture& picture, std::size_t stroke) {
    const auto set_up_of = [&](std::size_t s) {
      const std::size_t station = station_of(drawing_, s);
      const auto& stations = drawing_.plan->stations;
      return station < stations.size() ? stations[station].set_up : -1;
    };
    const int set_up = set_up_of(stroke);
    if (set_up >= 0 && (stroke == 0 || set_up_of(stroke - 1) != set_up)) {
      const double height = height_of_bed(drawing_, set_up);
      need(height + kRow);
      draw_bed(pages_.back(), drawing_, set_up, top_);
      top_ += height;
    }
    need(kRow);
    stroke_row(pages_.back(), drawing_, picture, stroke, top_);
    top_ += kRow;
  }

  /// Sentences under a heading, if it has one.
  void add(const std::vector<std::string>& sentences, const std::string& heading,
           const Colour& colour) {
    constexpr std::size_t kLetters = 100;  // about as many as a page is wide
    constexpr double kSize = 3.4, kLine = 5.1;
    if (sentences.empty()) return;
    need(4.0 * kLine);
    top_ += kLine;
    if (!heading.empty()) write(heading, {.size = 3.8, .bold = true});
    for (const std::string& sentence : sentences)
      for (const std::string& line : wrapped(sentence, kLetters)) {
        need(kLine);
        write(line, {.size = kSize, .colour = colour});
      }
  }

  std::vector<Page> take() && {
    for (std::size_t p = 0; p < pages_.size(); ++p)
      pages_[p].text({kSheetWidth - kEdge, kEdge + 5.0},
                     fmt::format("bend plan {} / {}", p + 1, pages_.size()),
                     {.size = 3.5, .anchor = TextAnchor::end, .colour = kGrey});
    return std::move(pages_);
  }

 private:
  void begin() {
    head(pages_.emplace_back(kSheetWidth, kSheetHeight), drawing_);
    top_ = kEdge + kHead - 10.0;
  }

  void need(double height) {
    if (top_ + height > kSheetHeight - kEdge) begin();
  }

  void write(const std::string& text, const TextStyle& style) {
    constexpr double kSpacing = 1.5;
    pages_.back().text({kEdge, top_}, text, style);
    top_ += kSpacing * style.size;
  }

  const BendDrawing& drawing_;
  std::vector<Page> pages_;
  double top_ = 0.0;
};

}  // namespace

std::span<const Stroke> strokes_of(const BendDrawing& drawing) {
  if (!drawing.plan) return {};
  return drawing.plan->strokes;
}

const FlatBend& bend_of(const BendDrawing& drawing, BendId id) {
  const auto found = std::ranges::find(drawing.flat.bends, id, &FlatBend::bend);
  PLANISH_ASSERT(found != drawing.flat.bends.end());
  return *found;
}

std::vector<Segment> pressed_lines(const BendDrawing& drawing, const Stroke& stroke) {
  std::vector<Segment> lines;
  for (const BendId id : stroke.bends) {
    const std::vector<Segment>& all = bend_of(drawing, id).lines;
    if (!stroke.press_line) {
      lines.insert(lines.end(), all.begin(), all.end());
      continue;
    }
    // Each of them may be interrupted.
    std::ptrdiff_t last = *stroke.press_line;
    for (const Stroke& other : strokes_of(drawing))
      if (other.bends == stroke.bends) last = std::max<std::ptrdiff_t>(last, *other.press_line);
    const std::ptrdiff_t pieces = std::max<std::ptrdiff_t>(1, std::ssize(all) / (last + 1));
    const std::ptrdiff_t from = *stroke.press_line * pieces;
    if (from + pieces <= std::ssize(all))
      lines.insert(lines.end(), all.begin() + from, all.begin() + from + pieces);
    else
      lines.insert(lines.end(), all.begin(), all.end());
  }
  return lines;
}

std::size_t station_of(const BendDrawing& drawing, std::size_t stroke) {
  const std::vector<Station>& stations = drawing.plan->stations;
  const auto found = std::ranges::find_if(stations, [&](const Station& station) {
    return std::ranges::count(station.strokes, static_cast<int>(stroke)) > 0;
  });
  return static_cast<std::size_t>(found - stations.begin());
}

std::string size_text(const BendDrawing& drawing, double mm) {
  const int decimals = drawing.units == LengthUnit::mm ? 1 : drawing.units == LengthUnit::m ? 4 : 3;
  const double length = schema::Units(drawing.units).length(mm);
  std::string text = fmt::format("{:.{}f}", length, decimals);
  return text.find_first_not_of("-0.") == std::string::npos ? text.substr(text.find('0')) : text;
}

std::vector<Page> bend_pages(const BendDrawing& drawing,
                             const std::vector<StrokePicture>& pictures) {
  PLANISH_ASSERT(pictures.size() == strokes_of(drawing).size());
  Pages pages(drawing);
  pages.add(drawing.obstacles, {}, kAlert);
  pages.add(mapped(drawing.proposals, [](const std::string& one) { return "– " + one; }),
            "It can be bent", kBlack);
  pages.add(lines_to_mark(drawing),
            "Lines to mark by stroke: ends, right and up from the lower left corner", kBlack);
  for (std::size_t s = 0; s < pictures.size(); ++s)
    pages.add(pictures[s], s);
  pages.add(drawing.notes, "To know", kBlack);
  return std::move(pages).take();
}

}  // namespace planish::drawing
