#include <planish/base/message.hpp>
#include <planish/drawing/page_parts.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::drawing {

Fit::Fit(const Box2& drawing, const Rectangle& into, double largest_scale) {
  constexpr double kSmallest = 0.05;  // mm: of what is drawn, where it has no extent
  const Vec2 size = drawing.hi - drawing.lo;
  scale_ = std::min({largest_scale, into.size.x() / std::max(size.x(), kSmallest),
                     into.size.y() / std::max(size.y(), kSmallest)});
  origin_ = into.middle() - scale_ * Vec2(0.5 * (drawing.lo.x() + drawing.hi.x()),
                                          -0.5 * (drawing.lo.y() + drawing.hi.y()));
}

std::vector<std::vector<Vec2>> rings_of(const FlatPattern& flat, double scale) {
  constexpr double kOnPaper = 0.05;  // mm: of curves from their chords
  std::vector<std::vector<Vec2>> rings{sampled(flat.outer.loop, kOnPaper / scale)};
  for (const Contour& opening : flat.openings)
    rings.push_back(sampled(opening.loop, kOnPaper / scale));
  return rings;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!lines.back().empty() && lines.back().size() + word.size() > letters) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

double fitting_size(const std::string& text, double room, double largest) {
  constexpr double kWide = 0.62;  // of a letter, by its size
  return std::min(largest,
                  room / (kWide * static_cast<double>(std::max<std::size_t>(1, text.size()))));
}

std::string scale_text(double scale) {
  constexpr int kDigits = 3;
  return scale < 1.0 ? fmt::format("1 : {}", number_text(1.0 / scale, kDigits))
                     : fmt::format("{} : 1", number_text(scale, kDigits));
}

void number(Page& page, const Vec2& at, std::size_t stroke, const Colour& colour) {
  constexpr double kRadius = 2.6;
  std::vector<Vec2> circle;
  constexpr int kCorners = 32;
  for (int i = 0; i < kCorners; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kCorners;
    circle.push_back(at + kRadius * Vec2(std::cos(turn), std::sin(turn)));
  }
  page.area({circle}, {.stroke = colour, .fill = Colour{1.0, 1.0, 1.0}, .width = 0.3});
  page.text(at + Vec2(0.0, 1.15), std::to_string(stroke + 1),
            {.size = 3.2, .bold = true, .anchor = TextAnchor::middle, .colour = colour});
}

void dimension(Page& page, const Vec2& a, const Vec2& b, const Vec2& away,
               const std::string& length) {
  const Ink thin{.stroke = kPageGrey, .width = 0.15};
  const Vec2 from = a + away, to = b + away, tick = Vec2(1.0, -1.0);
  page.lines({{a + 0.15 * away, from + 0.15 * away},
              {b + 0.15 * away, to + 0.15 * away},
              {from, to},
              {from - tick, from + tick},
              {to - tick, to + tick}},
             thin);
  const bool upright = std::abs(b.x() - a.x()) < std::abs(b.y() - a.y());
  const Vec2 beside = upright ? Vec2(-1.0, 0.0) : Vec2(0.0, -1.0);
  constexpr double kLong = 12.0;  // mm: room for the text between the ticks
  if (upright && (to - from).norm() < kLong) {
    page.text(0.5 * (from + to) + Vec2(1.8, 1.1), length, {.size = 3.2});
    return;
  }
  page.text(0.5 * (from + to) + beside, length,
            {.size = 3.2,
             .anchor = TextAnchor::middle,
             .turned = upright ? 0.5 * std::numbers::pi : 0.0});
}

}  // namespace planish::drawing
