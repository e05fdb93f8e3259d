#include "page_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::job {
namespace {

constexpr double kChord = 0.05;  // mm in the pattern; far below a printed line
constexpr double kArrow = 1.6;   // mm
constexpr double kBadge = 2.3;   // radius, mm

std::vector<Vec2> arc_points(const Vec2& middle, double radius) {
  constexpr int kSides = 24;
  std::vector<Vec2> points;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    points.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void arrow_head(Page& page, const Vec2& tip, const Vec2& towards) {
  const Vec2 side(-towards.y(), towards.x());
  PagePath head{{tip, tip - kArrow * towards + 0.3 * kArrow * side,
                 tip - kArrow * towards - 0.3 * kArrow * side}};
  head.width = 0.0;
  head.filled = true;
  page.items.emplace_back(std::move(head));
}

}  // namespace

PageDrawing::PageDrawing(Page& page, const PageArea& area, const Isometry2& motion,
                         const std::vector<Vec2>& points, double largest_scale)
    : page_(page), motion_(motion), scale_(largest_scale) {
  Box2 box;
  for (const Vec2& p : points)
    box.add(motion_ * p);
  if (box.empty()) box.add(Vec2::Zero());
  const Vec2 size = box.hi - box.lo;
  for (int i = 0; i < 2; ++i)
    if (size[i] > 0.0) scale_ = std::min(scale_, area.size()[i] / size[i]);
  shift_ = area.middle() - scale_ * 0.5 * (box.lo + box.hi);
  extent_ = {shift_ + scale_ * box.lo, shift_ + scale_ * box.hi};
}

void PageDrawing::path(const std::vector<Vec2>& points, PagePath style) const {
  style.points.clear();
  for (const Vec2& p : points)
    style.points.push_back(at(p));
  page_.items.emplace_back(std::move(style));
}

void PageDrawing::pattern(const FlatPattern& flat, const PagePath& style) const {
  PagePath outer = style, opening = style;
  outer.filled = opening.filled = true;
  opening.fill = {1.0, 1.0, 1.0};
  path(outline_of(flat), outer);
  for (const Contour& contour : flat.openings)
    path(sampled(contour.loop, kChord), opening);
  for (const Curve2& slit : flat.slits)
    path(sampled(slit, kChord), PagePath{{}, style.colour, style.width});
}

std::vector<Vec2> outline_of(const FlatPattern& flat) { return sampled(flat.outer.loop, kChord); }

void write(Page& page, const Vec2& at, const std::string& text, double size, TextAnchor anchor,
           const Colour& colour) {
  page.items.emplace_back(PageText{at, text, size, anchor, false, colour});
}

void write_bold(Page& page, const Vec2& at, const std::string& text, double size, TextAnchor anchor,
                const Colour& colour) {
  page.items.emplace_back(PageText{at, text, size, anchor, true, colour});
}

void badge(Page& page, const Vec2& at, const std::string& text, const Colour& colour) {
  const double size = text.size() > 2 ? 2.2 : 3.0;
  PagePath disc{arc_points(at, kBadge), colour, 0.3, true, {1.0, 1.0, 1.0}};
  page.items.emplace_back(std::move(disc));
  write_bold(page, at - Vec2(0.0, 0.35 * size), text, size, TextAnchor::middle, colour);
}

void dimension(Page& page, const Vec2& a, const Vec2& b, const std::string& text) {
  page.items.emplace_back(PagePath{{a, b}, kBlack, 0.13});
  const Vec2 along = b - a;
  const double length = along.norm();
  if (length > 2.0 * kArrow) {
    arrow_head(page, b, along / length);
    arrow_head(page, a, -along / length);
  }
  constexpr double kSize = 3.0;
  const Vec2 middle = 0.5 * (a + b);
  const bool upright = std::abs(along.x()) < std::abs(along.y());
  write(page, middle + (upright ? Vec2(1.2, -0.35 * kSize) : Vec2(0.0, 1.0)), text, kSize,
        upright ? TextAnchor::start : TextAnchor::middle);
}

std::string cut_to_width(const std::string& text, double size, double width) {
  if (text_width(text, size, false) <= width) return text;
  std::string cut = text;
  while (!cut.empty() && text_width(cut + "...", size, false) > width) {
    cut.pop_back();
    // Not within a character of UTF-8.
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80)
      cut.pop_back();
    if (!cut.empty() && static_cast<unsigned char>(cut.back()) >= 0xC0) cut.pop_back();
  }
  return cut + "...";
}

}  // namespace planish::job
