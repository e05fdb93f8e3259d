#pragma once

#include <planish/geometry/curve.hpp>
#include <planish/io/pages.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <vector>

namespace planish::drawing {

inline constexpr Colour kPageUp{0.10, 0.35, 0.72}, kPageDown{0.78, 0.10, 0.12};
inline constexpr Colour kPageSheet{0.93, 0.95, 0.96};
inline constexpr Colour kPageGrey{0.45, 0.48, 0.52};
/// What is in the way, or is to be noticed.
inline constexpr Colour kPageAlert{0.80, 0.25, 0.05};

/// A place on a page, mm; y runs down.
struct Rectangle {
  Vec2 corner, size;
  Vec2 middle() const { return corner + 0.5 * size; }
};

/// From a drawing with y up to a rectangle of the page.
class Fit {
 public:
  Fit(const Box2& drawing, const Rectangle& into, double largest_scale);
  double scale() const { return scale_; }
  Vec2 operator()(const Vec2& p) const { return origin_ + scale_ * Vec2(p.x(), -p.y()); }
  std::vector<Vec2> operator()(std::vector<Vec2> points) const {
    for (Vec2& p : points)
      p = (*this)(p);
    return points;
  }

 private:
  double scale_ = 1.0;
  Vec2 origin_;
};

/// The rings of a pattern, outer first, to be drawn at a scale.
std::vector<std::vector<Vec2>> rings_of(const FlatPattern& flat, double scale);

/// Lines of at most that many letters, parted at blanks.
std::vector<std::string> wrapped(const std::string& text, std::size_t letters);

/// The size at which a line of text is no wider than the room for it, mm; at most `largest`.
double fitting_size(const std::string& text, double room, double largest);

/// "1 : 5.7", "2 : 1".
std::string scale_text(double scale);

/// The number of a stroke, from 0, in a circle: counted from 1 as people do.
void number(Page& page, const Vec2& at, std::size_t stroke, const Colour& colour);

/// A dimension: extension lines, a line with ticks, the length beside it.
void dimension(Page& page, const Vec2& a, const Vec2& b, const Vec2& away,
               const std::string& length);

}  // namespace planish::drawing
