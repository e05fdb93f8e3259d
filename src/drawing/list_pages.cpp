#include "filling.hpp"

#include <planish/drawing/list_pages.hpp>
#include <planish/drawing/page_parts.hpp>
#include <planish/drawing/part_pages.hpp>

#include <fmt/format.h>

namespace planish::drawing {
namespace {

constexpr double kRight = kSheetWidth - kEdge;
constexpr double kLetter = 3.1, kSmallLetter = 2.6;  // mm
constexpr double kPartRow = 19.0, kListStep = 4.4;   // heights, mm

void write_part(Filling& filling, const ListedPart& part) {
  filling.need(kPartRow);
  Page& page = filling.page();
  const double top = filling.top();
  constexpr double kPicture = 26.0, kHigh = kPartRow - 3.0;
  const Vec2 corner(kEdge, top + 0.5);
  if (part.view && !part.view->edges.empty())
    draw_view(page, *part.view, corner, {kPicture, kHigh});
  draw_flat(page, *part.flat, corner + Vec2(kPicture + 2.0, 0.0), {kPicture, kHigh});
  const double x = kEdge + 2.0 * kPicture + 7.0;
  const double room = kRight - x - 26.0;
  page.text({kRight, top + 6.0}, fmt::format("{}×", part.quantity),
            {.size = 5.0, .bold = true, .anchor = TextAnchor::end});
  page.text({x, top + 4.5}, part.name, {.size = fitting_size(part.name, room, 3.6), .bold = true});
  page.text({x, top + 9.5}, part.work, {.size = fitting_size(part.work, kRight - x, kLetter)});
  page.text({x, top + 14.0}, part.state,
            {.size = kSmallLetter, .colour = part.alert ? kPageAlert : kPageGrey});
  if (!part.help.empty())
    page.text({x, top + 17.3}, part.help,
              {.size = fitting_size(part.help, kRight - x, kSmallLetter), .colour = kPageAlert});
  filling.skip(kPartRow);
  const double below = filling.top() - 1.0;
  page.line({kEdge, below}, {kRight, below}, {.stroke = kPageGrey, .width = 0.1});
}

void write_sums(Filling& filling, const std::string& text) {
  filling.need(7.0);
  filling.page().text({kEdge, filling.top() + 3.5}, text,
                      {.size = fitting_size(text, kRight - kEdge, kLetter), .bold = true});
  filling.skip(6.0);
}

void write_heading(Filling& filling, const std::string& text, const Colour& colour = kBlack) {
  filling.page().text({kEdge, filling.top() + 4.0}, text,
                      {.size = 4.4, .bold = true, .colour = colour});
  filling.skip(7.0);
}

void write_group(Filling& filling, const ListedGroup& group) {
  filling.need(8.0 + kPartRow);
  write_heading(filling, group.heading);
  for (const ListedPart& part : group.parts)
    write_part(filling, part);
  write_sums(filling, group.sums);
  filling.skip(4.0);
}

void write_section(Filling& filling, const ListedLines& section) {
  const auto colour = [](const ListedLine& line) { return line.alert ? kPageAlert : kBlack; };
  filling.need(8.0 + 2.0 * kListStep);
  filling.skip(3.0);
  write_heading(filling, section.heading.text, colour(section.heading));
  constexpr std::size_t kLetters = 115;
  for (const ListedLine& line : section.lines)
    for (const std::string& text : wrapped(line.text, kLetters)) {
      filling.need(kListStep);
      filling.page().text({kEdge, filling.top() + 3.0}, text,
                          {.size = kSmallLetter + 0.3, .colour = colour(line)});
      filling.skip(kListStep);
    }
}

}  // namespace

std::vector<Page> list_pages(const ListDrawing& drawing) {
  Filling filling(drawing.title, std::nullopt, PageNumbers::always);
  for (const ListedGroup& group : drawing.groups)
    write_group(filling, group);
  if (!drawing.sums.empty()) {
    filling.need(12.0);
    write_sums(filling, drawing.sums);
  }
  for (const ListedLines& section : drawing.sections)
    write_section(filling, section);
  return std::move(filling).take();
}

}  // namespace planish::drawing
