#pragma once

#include <planish/io/page.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// A rectangle on a page, mm.
struct PageArea {
  Vec2 lo, hi;
  Vec2 size() const { return hi - lo; }
  Vec2 middle() const { return 0.5 * (lo + hi); }
};

/// Draws on a page in the coordinates of something else: mirrored, turned, scaled to fit an area.
class PageDrawing {
 public:
  /// `motion` comes before scale and shift, which fit `points` into the area, at most as large as
  /// `largest_scale` makes it.
  PageDrawing(Page& page, const PageArea& area, const Isometry2& motion,
              const std::vector<Vec2>& points, double largest_scale);

  Vec2 at(const Vec2& p) const { return shift_ + scale_ * (motion_ * p); }
  double scale() const { return scale_; }
  const PageArea& extent() const { return extent_; }  ///< of the points, on the page

  void path(const std::vector<Vec2>& points, PagePath style) const;
  void line(const Segment& line, PagePath style) const { path({line.a, line.b}, std::move(style)); }
  /// Outline and openings of a pattern.
  void pattern(const FlatPattern& flat, const PagePath& style) const;

 private:
  Page& page_;
  Isometry2 motion_;
  double scale_ = 1.0;
  Vec2 shift_ = Vec2::Zero();
  PageArea extent_;
};

/// Points of the outer contour.
std::vector<Vec2> outline_of(const FlatPattern& flat);

void write(Page& page, const Vec2& at, const std::string& text, double size,
           TextAnchor anchor = TextAnchor::start, const Colour& colour = kBlack);
void write_bold(Page& page, const Vec2& at, const std::string& text, double size,
                TextAnchor anchor = TextAnchor::start, const Colour& colour = kBlack);
/// A number in a circle.
void badge(Page& page, const Vec2& at, const std::string& text, const Colour& colour);
/// An arrow on both ends of a line, and a text at its middle.
void dimension(Page& page, const Vec2& a, const Vec2& b, const std::string& text);
/// A text that is cut with "…" where it is wider than there is room.
std::string cut_to_width(const std::string& text, double size, double width);

}  // namespace planish::job
