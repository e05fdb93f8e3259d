#include "svg_shapes.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

// Curves as SVG paths, y pointing down, so that a positive sweep still looks counter-clockwise and
// gets flag 0. SVG draws no arc whose ends coincide, so circles are two. Bend zones are
// quadrilaterals between the tangent lines on both sides: where one side is interrupted more often
// than the other, only parts that face each other belong together.

namespace planish::io_detail {
namespace {

using std::numbers::pi;

std::string arc_to(const Arc& arc, const Vec2& end) {
  // With y pointing down, a positive sweep still looks counter-clockwise: SVG's flag 0.
  return fmt::format("A{0} {0} 0 {1} {2} {3}", svg_number(arc.radius),
                     std::abs(arc.sweep) > pi ? 1 : 0, arc.sweep > 0.0 ? 0 : 1, svg_point(end));
}

std::string path_piece(const Segment& segment) { return "L" + svg_point(segment.b); }

std::string path_piece(const Arc& arc) {
  // SVG draws no arc whose ends coincide, as those of a circle do, and those of nearly a circle may
  // after rounding.
  if (std::abs(arc.sweep) < 1.8 * pi) return arc_to(arc, end_of(arc));
  Arc half = arc;
  half.sweep *= 0.5;
  return arc_to(half, end_of(half)) + arc_to(half, end_of(arc));
}

std::string path_piece(const CubicSpline& spline) {
  std::string text;
  for (std::size_t i = 1; i + 2 < spline.poles.size(); i += 3) {
    text += fmt::format("C{} {} {}", svg_point(spline.poles[i]), svg_point(spline.poles[i + 1]),
                        svg_point(spline.poles[i + 2]));
  }
  return text;
}

/// A tangent line as seen from the bend line: the part of the bend line beside it, and the side.
struct Limit {
  double from = 0.0, to = 0.0;  ///< along the bend line, from < to
  double side = 0.0;            ///< distance to the left
  Vec2 a, b;                    ///< its ends, at `from` and `to`
};

Limit limit_of(const Segment& tangent, const Vec2& origin, const Vec2& along) {
  const Vec2 left = perpendicular(along);
  Limit limit{along.dot(tangent.a - origin), along.dot(tangent.b - origin),
              left.dot(0.5 * (tangent.a + tangent.b) - origin), tangent.a, tangent.b};
  if (limit.from > limit.to) {
    std::swap(limit.from, limit.to);
    std::swap(limit.a, limit.b);
  }
  return limit;
}

Vec2 point_beside(const Limit& limit, double t) {
  const double share = std::clamp((t - limit.from) / (limit.to - limit.from), 0.0, 1.0);
  return limit.a + share * (limit.b - limit.a);
}

bool overlap(const Limit& a, const Limit& b) {
  return std::max(a.from, b.from) < std::min(a.to, b.to);
}

std::array<Vec2, 4> zone_between(const Limit& l, const Limit& r, bool whole) {
  if (whole) return {r.a, r.b, l.b, l.a};
  const double from = std::max(l.from, r.from);
  const double to = std::min(l.to, r.to);
  return {point_beside(r, from), point_beside(r, to), point_beside(l, to), point_beside(l, from)};
}

}  // namespace

std::string svg_number(double value, int decimals) { return trimmed_number(value, decimals); }

std::string xml_escaped(std::string_view text) {
  std::string escaped = replaced(text,
                                 {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
  std::erase_if(escaped, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  return escaped;
}

std::string svg_point(const Vec2& p) {
  return fmt::format("{} {}", svg_number(p.x()), svg_number(-p.y()));
}

std::string svg_path(const Loop& loop) {
  if (loop.empty()) return {};
  std::string text = "M" + svg_point(start_of(loop.front()));
  for (const Curve2& curve : loop) {
    text += std::visit([](const auto& c) { return path_piece(c); }, curve);
  }
  return text + "Z";
}

std::string svg_open_path(const Curve2& curve) {
  return "M" + svg_point(start_of(curve)) +
         std::visit([](const auto& c) { return path_piece(c); }, curve);
}

std::vector<std::array<Vec2, 4>> bend_zones(const FlatBend& bend) {
  if (bend.lines.empty()) return {};
  const Vec2 origin = bend.lines.front().a;
  const Vec2 along = (bend.lines.front().b - origin).normalized();
  std::vector<Limit> left;
  std::vector<Limit> right;
  for (const Segment& tangent : bend.tangent_lines) {
    const Limit limit = limit_of(tangent, origin, along);
    if (limit.from < limit.to) (limit.side > 0.0 ? left : right).push_back(limit);
  }
  std::vector<std::array<Vec2, 4>> zones;
  for (const Limit& l : left) {
    for (const Limit& r : right) {
      if (!overlap(l, r)) continue;
      // Two lines that face only each other bound one quadrilateral, whose ends may be slanted; if
      // one side is interrupted more often than the other, only opposite parts belong together.
      const auto meets = [](const Limit& one) {
        return [&one](const Limit& other) { return overlap(one, other); };
      };
      const bool whole = std::ranges::count_if(right, meets(l)) == 1 &&
                         std::ranges::count_if(left, meets(r)) == 1;
      zones.push_back(zone_between(l, r, whole));
    }
  }
  return zones;
}

}  // namespace planish::io_detail
