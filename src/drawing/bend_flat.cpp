#include "bend_dimensions.hpp"
#include "bend_drawing.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

// The flat pattern on the first page. Numbers of strokes stand on their lines, names of flanges in
// their widest part; where a mark has no room it moves along its line or beside it.

namespace planish::drawing {
namespace {

/// Places of marks that are to keep apart.
class Marks {
 public:
  /// The first of the places at which a mark of this radius meets no other; the first of all if it
  /// meets one everywhere.
  Vec2 put(const std::vector<Vec2>& wanted, double radius) {
    const auto free = [&](const Vec2& at) {
      return std::ranges::all_of(put_, [&](const auto& other) {
        return (other.first - at).norm() >= other.second + radius;
      });
    };
    const auto found = std::ranges::find_if(wanted, free);
    const Vec2 at = found != wanted.end() ? *found : wanted.front();
    put_.emplace_back(at, radius);
    return at;
  }

 private:
  std::vector<std::pair<Vec2, double>> put_;
};

/// On the lines of a stroke from the middle outwards, then beside the first.
std::vector<Vec2> places_on(const std::vector<std::pair<Vec2, Vec2>>& lines) {
  constexpr double kBeside = 6.0;  // mm
  std::vector<Vec2> places;
  for (const auto& [a, b] : lines)
    for (const double along : {0.5, 0.56, 0.62, 0.38, 0.44, 0.75, 0.25, 0.9, 0.1})
      places.push_back(a + along * (b - a));
  const auto& [a, b] = lines.front();
  const Vec2 along = (b - a).normalized(), across(-along.y(), along.x());
  for (const double away : {1.0, -1.0, 2.0, -2.0, 3.0, -3.0})
    places.push_back(0.5 * (a + b) + away * kBeside * across);
  return places;
}

void draw_stroke(Page& page, const BendDrawing& drawing, std::size_t s, const Fit& fit,
                 Marks& marks) {
  constexpr double kNumber = 2.8, kOnLine = 1e-6;  // mm
  const Stroke& stroke = strokes_of(drawing)[s];
  const bool up = bend_of(drawing, stroke.bends.front()).direction == BendDirection::up;
  const Colour colour = up ? kPageUp : kPageDown;
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (const Segment& line : pressed_lines(drawing, stroke)) {
    lines.emplace_back(fit(line.a), fit(line.b));
    page.line(lines.back().first, lines.back().second,
              {.stroke = colour, .width = 0.3, .dashes = {2.5, 1.2}});
  }
  const Vec2 at = marks.put(places_on(lines), kNumber);
  const Vec2 middle = 0.5 * (lines.front().first + lines.front().second);
  const Vec2 along = (lines.front().second - lines.front().first).normalized();
  const double away = std::abs((at - middle).dot(Vec2(-along.y(), along.x())));
  if (away > kOnLine && lines.size() == 1) page.line(middle, at, {.stroke = colour, .width = 0.15});
  number(page, at, s, colour);
}

/// Lines that no stroke presses: those that are blocked, and of a plan those that are rolled.
void draw_unpressed(Page& page, const BendDrawing& drawing, const Fit& fit, Marks& marks) {
  constexpr double kName = 2.4;  // mm
  std::set<BendId> pressed;
  for (const Stroke& stroke : strokes_of(drawing))
    pressed.insert(stroke.bends.begin(), stroke.bends.end());
  for (const FlatBend& bend : drawing.flat.bends) {
    if (pressed.contains(bend.bend)) continue;
    const bool blocked = std::ranges::count(drawing.blocked, bend.bend) > 0;
    const Ink ink{.stroke = blocked ? kPageAlert : kPageGrey, .width = blocked ? 0.6 : 0.3};
    std::vector<std::pair<Vec2, Vec2>> lines;
    for (const Segment& line : bend.lines) {
      lines.emplace_back(fit(line.a), fit(line.b));
      page.line(lines.back().first, lines.back().second, ink);
    }
    if (bend.lines.empty() || (!blocked && pressed.empty() && !drawing.blocked.empty())) continue;
    page.text(marks.put(places_on(lines), kName) + Vec2(1.0, -1.0), bend.id,
              {.size = 3.2, .bold = true, .colour = *ink.stroke});
  }
}

/// Beside the sheet, near a place in a flange that has no room for its name.
std::vector<Vec2> places_beside(const Vec2& from, const std::vector<std::vector<Vec2>>& rings) {
  constexpr int kDirections = 8;
  std::vector<Vec2> places;
  for (const double away : {6.0, 8.0, 10.0, 13.0})
    for (int i = 0; i < kDirections; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kDirections;
      const Vec2 at = from + away * Vec2(std::cos(turn), std::sin(turn));
      if (!inside(rings, at)) places.push_back(at);
    }
  return places;
}

void name_flanges(Page& page, const BendDrawing& drawing, const Fit& fit,
                  const std::vector<std::vector<Vec2>>& rings, Marks& marks) {
  constexpr double kName = 2.2, kDown = 1.0;  // mm
  for (const FlangeName& flange : drawing.flanges) {
    const Vec2 middle = fit(flange.at);
    const std::vector<Vec2> beside = places_beside(middle, rings);
    const bool outside = fit.scale() * flange.room < kName && !beside.empty();
    std::vector<Vec2> places;
    for (const Vec2& by : {Vec2(0, 0), Vec2(6, 0), Vec2(-6, 0), Vec2(0, 5), Vec2(0, -5)})
      places.emplace_back(middle + by);
    const Vec2 at = marks.put(outside ? beside : places, kName);
    if (outside)
      page.line(middle, at - kName * (at - middle).normalized(),
                {.stroke = kPageGrey, .width = 0.1});
    page.text(at + Vec2(0.0, kDown), flange.name,
              {.size = 2.8, .anchor = TextAnchor::middle, .colour = kPageGrey});
  }
}

/// The extents of the pattern as it is drawn, told as that where the blank lies at an angle to it.
std::pair<std::string, std::string> extents(const BendDrawing& drawing, const Box2& box) {
  std::string wide = size_text(drawing, box.size().x()), tall = size_text(drawing, box.size().y());
  const std::string length = size_text(drawing, drawing.size.x()),
                    width = size_text(drawing, drawing.size.y());
  if (std::minmax(wide, tall) == std::minmax(length, width)) return {wide, tall};
  return {wide + " as drawn", tall + " as drawn"};
}

/// A line without a gauge is marked by hand: that takes its distance from an edge.
bool has_to_be_marked(const Stroke& stroke) { return !stroke.gauge && !stroke.flattening; }

}  // namespace

void draw_flat_pattern(Page& page, const BendDrawing& drawing, const Rectangle& into) {
  const Box2 box = box_of(sampled(drawing.flat.outer.loop, 1.0));
  const bool marked = std::ranges::any_of(strokes_of(drawing), has_to_be_marked);
  constexpr double kRoom = 9.0, kDistances = 25.0;  // mm: for dimensions
  const double beyond = marked ? kDistances : kRoom;
  const Rectangle inner{into.corner + Vec2(kRoom, kRoom),
                        into.size - Vec2(kRoom + beyond, kRoom + beyond)};
  const Fit fit(box, inner, 1.0);
  const auto rings = mapped(rings_of(drawing.flat, fit.scale()),
                            [&](auto& ring) { return fit(std::move(ring)); });
  page.area(rings, {.fill = kPageSheet, .width = 0.35});
  Marks marks;
  draw_unpressed(page, drawing, fit, marks);
  for (std::size_t s = 0; s < strokes_of(drawing).size(); ++s)
    draw_stroke(page, drawing, s, fit, marks);
  name_flanges(page, drawing, fit, rings, marks);
  if (marked) dimension_bends(page, drawing.flat, fit, schema::Units(drawing.units));
  const Vec2 low = fit(box.lo), high = fit(box.hi);
  const auto [wide, tall] = extents(drawing, box);
  dimension(page, {low.x(), high.y()}, {high.x(), high.y()}, {0.0, -6.0}, wide);
  dimension(page, {low.x(), low.y()}, {low.x(), high.y()}, {-6.0, 0.0}, tall);
  constexpr double kLine = 4.0;
  const Vec2 corner = into.corner + into.size;
  const TextStyle grey{.size = 2.8, .anchor = TextAnchor::end, .colour = kPageGrey};
  page.text(
      corner - Vec2(0.0, kLine),
      fmt::format(
          "the front of the sheet, {}{}", scale_text(fit.scale()),
          strokes_of(drawing).empty() ? "" : "; blue bends up, red down; numbers are strokes"),
      grey);
  if (strokes_of(drawing).empty()) return;
  page.text(corner,
            "strokes: the sheet from above, the workpiece before (light) and after; "
            "segments from the left end of the bend line",
            grey);
}

std::vector<std::string> lines_to_mark(const BendDrawing& drawing) {
  const Vec2 corner = bounds(drawing.flat.outer.loop).lo;
  const auto told = [&](const Vec2& point) {
    const Vec2 from = point - corner;
    return fmt::format("({}, {})", size_text(drawing, from.x()), size_text(drawing, from.y()));
  };
  std::vector<std::string> all;
  for (std::size_t s = 0; s < strokes_of(drawing).size(); ++s) {
    if (!has_to_be_marked(strokes_of(drawing)[s])) continue;
    for (const Segment& line : pressed_lines(drawing, strokes_of(drawing)[s]))
      if (!is_dimensioned(line))
        all.push_back(fmt::format("{}: from {} to {}", s + 1, told(line.a), told(line.b)));
  }
  return all;
}

std::vector<FlangeName> flange_names(const Sheet& sheet, const Layout& layout) {
  constexpr double kChord = 0.1;  // mm
  constexpr int kSteps = 24;      // across the box of a face
  std::vector<FlangeName> names;
  for (const FlangeId flange : sheet.flanges.ids()) {
    FlangeName name{fmt::format("F{}", index_of(flange) + 1), Vec2::Zero()};
    for (const FaceId face : sheet[flange].faces) {
      const Polygon polygon = polygon_of(layout.region(face), kChord);
      std::vector<std::vector<Vec2>> rings{polygon.outer};
      rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
      const Box2 box = box_of(polygon.outer);
      for (int i = 1; i < kSteps; ++i)
        for (int j = 1; j < kSteps; ++j) {
          const Vec2 at = box.lo + Vec2(i, j).cwiseProduct(box.size()) / kSteps;
          double room = inside(rings, at) ? box.size().maxCoeff() : 0.0;
          for (const auto& ring : rings)
            if (room > name.room) room = std::min(room, distance_to_ring(ring, at));
          if (room > name.room) name = {name.name, at, room};
        }
    }
    if (name.room > 0.0) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace planish::drawing
