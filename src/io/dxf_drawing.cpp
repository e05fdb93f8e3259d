#include "dxf_drawing.hpp"

#include "bend_text.hpp"
#include "room_for_text.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <algorithm>
#include <cmath>

// What a pattern becomes in a DXF, in the order and on the layers of formats.md#dxf: marks before
// cuts, the outer contour last. Lengths are scaled once, when an entity is added. A mark too short
// to be drawn is left out, and so is a formed feature without extent; a contour without extent
// makes the drawing invalid.

namespace planish::io_detail {
namespace {

/// Shorter lines cannot be marked by any tool.
constexpr double kShortestMark = 1e-6;  // mm

/// A letter, by its height.
constexpr double kLetterWidth = 0.9;

}  // namespace

DxfStyles styles_of(const DxfOptions& options) {
  const LayerNames names = options.layers.value_or(layer_names(options.profile));
  const bool dashed = options.bend_linetype == BendLinetype::dashed;
  DxfStyles styles{.outer = {names.outer, 7},
                   .openings = {names.openings, 4},
                   .slits = {names.slits, 6},
                   .bend_up = {names.bend_up, 5, dashed},
                   .bend_down = {names.bend_down, 1, dashed},
                   // Not dashed: some shops bend along every dashed line.
                   .bend_zone = {names.bend_zone, 8},
                   .features = {names.features, 3},
                   // Readers take every layer with BEND in its name for bend lines.
                   .text = {"TEXT", 8}};
  if (names.openings == names.outer) styles.openings.color = styles.outer.color;
  if (names.slits == names.openings) styles.slits.color = styles.openings.color;
  if (names.slits == names.outer) styles.slits.color = styles.outer.color;
  return styles;
}

Drawing::Drawing(const DxfOptions& options)
    : styles_(styles_of(options)), options_(options), scale_(1.0 / millimetres_in(options.units)) {}

void Drawing::add(const FlatPattern& pattern) {
  for (const FlatBend& bend : pattern.bends)
    add_text(bend);
  for (const FlatBend& bend : pattern.bends)
    add_bend(bend);
  for (const FlatBend& bend : pattern.bends)
    add_tangent_lines(bend);
  for (const FlatFeature& feature : pattern.features) {
    for (const Loop& loop : feature.outlines)
      add_outline(styles_.features, loop);
  }
  for (const Curve2& slit : pattern.slits)
    add_slit(slit);
  for (const Contour& opening : pattern.openings)
    add_outline(styles_.openings, opening.loop);
  add_outline(styles_.outer, pattern.outer.loop);
}

void Drawing::add_sheet(double length, double width) {
  const std::vector<Vec2> corners{{0.0, 0.0}, {length, 0.0}, {length, width}, {0.0, width}};
  Loop edge;
  for (const Segment& side : sides_of(corners))
    edge.emplace_back(side);
  add_outline({"SHEET", 9}, edge);
}

void Drawing::add_name(const FlatPattern& pattern, const std::string& name) {
  constexpr double kHighest = 20.0;  // mm
  if (name.empty()) return;
  const RoomForText room = room_for_text(pattern);
  const double letters = kLetterWidth * static_cast<double>(name.size());
  // Its diagonal within the circle that is free.
  const double height = std::min(kHighest, 2.0 * room.radius / std::hypot(letters, 1.0));
  if (height < kShortestMark) return;
  const EntityStyle style{.layer = "PART_NAMES", .color = 8, .off = true};
  entities_.push_back({style, DxfText{room.middle * scale_, height * scale_, {}, name}});
}

std::vector<EntityStyle> Drawing::layers() const {
  std::vector<EntityStyle> layers;
  for (const DxfEntity& entity : entities_) {
    const auto same = [&](const EntityStyle& s) { return s.layer == entity.style.layer; };
    if (std::ranges::none_of(layers, same)) layers.push_back(entity.style);
  }
  return layers;
}

OutlineOptions Drawing::outline_options() const {
  const bool keep = options_.splines == Splines::keep && options_.version != DxfVersion::r12;
  return {.splines = keep ? Splines::keep : Splines::arcs,
          .arc_tolerance = options_.arc_tolerance,
          .scale = scale_};
}

void Drawing::add_line(const EntityStyle& style, const Vec2& a, const Vec2& b) {
  if ((b - a).norm() < kShortestMark) return;
  const Segment line{a * scale_, b * scale_};
  extents_.add(bounds(Curve2(line)));
  entities_.push_back({style, line});
}

void Drawing::add_slit(const Curve2& slit) {
  for (const Curve2& curve : curves_of_slit(slit, outline_options())) {
    if (const auto* line = std::get_if<Segment>(&curve)) {
      add_line(styles_.slits, line->a, line->b);
    } else {
      extents_.add(bounds(curve));
      entities_.push_back({styles_.slits, Outline(Loop{curve})});
    }
  }
}

void Drawing::add_bend(const FlatBend& bend) {
  const auto& style = bend.direction == BendDirection::up ? styles_.bend_up : styles_.bend_down;
  for (const Segment& line : bend.lines) {
    const Vec2 whole = line.b - line.a;
    const double tick = std::min(options_.tick_length, whole.norm() / 3.0);
    if (options_.bend_marks == BendMarks::lines || tick < kShortestMark) {
      add_line(style, line.a, line.b);
    } else {
      add_line(style, line.a, line.a + tick * whole.normalized());
      add_line(style, line.b - tick * whole.normalized(), line.b);
    }
  }
}

void Drawing::add_text(const FlatBend& bend) {
  constexpr double kHighest = 3.0;  // mm
  if (!options_.bend_text || bend.lines.empty()) return;
  const Segment line = *longest_line(bend);
  const std::string text = bend_text(bend);
  Vec2 along = line.b - line.a;
  const double length = along.norm();
  if (length < kShortestMark) return;
  // Read from below or from the right.
  if (along.x() < -kShortestMark || (along.x() < kShortestMark && along.y() < 0.0)) along = -along;
  const double height = std::min(kHighest,
                                 length / (kLetterWidth * static_cast<double>(text.size())));
  const Vec2 above = height / length * perpendicular(along);
  entities_.push_back(
      {styles_.text, DxfText{(0.5 * (line.a + line.b) + above) * scale_, height * scale_,
                             Angle::radians(std::atan2(along.y(), along.x())), text}});
}

void Drawing::add_tangent_lines(const FlatBend& bend) {
  if (!options_.tangent_lines || styles_.bend_zone.layer.empty()) return;
  for (const Segment& line : bend.tangent_lines)
    add_line(styles_.bend_zone, line.a, line.b);
}

void Drawing::add_outline(const EntityStyle& style, const Loop& loop) {
  const Outline outline = outline_of(loop, outline_options());
  const Box2 box = bounds(outline);
  if (box.empty() || box.size().minCoeff() <= 0.0) {
    // A formed feature is only marked: one without extent is left out.
    has_empty_outline_ |= style.layer != styles_.features.layer;
    return;
  }
  extents_.add(box);
  entities_.push_back({style, outline});
}

}  // namespace planish::io_detail
