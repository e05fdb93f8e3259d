#include "bend_text.hpp"
#include "dxf_writer.hpp"

#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace planish {

using namespace io_detail;

namespace {

/// Shorter lines cannot be marked by any tool.
constexpr double kShortestMark = 1e-6;  // mm

struct Styles {
  EntityStyle outer, openings, bend_up, bend_down, bend_zone, features, text;
};

Styles styles_of(LayerProfile profile) {
  const LayerNames names = layer_names(profile);
  Styles styles{.outer = {names.outer, 7},
                .openings = {names.openings, 4},
                .bend_up = {names.bend_up, 5, true},
                .bend_down = {names.bend_down, 1, true},
                // Not dashed: some shops bend along every dashed line.
                .bend_zone = {names.bend_zone, 8},
                .features = {names.features, 3},
                // Readers take every layer with BEND in its name for bend lines.
                .text = {"TEXT", 8}};
  if (names.openings == names.outer) styles.openings.color = styles.outer.color;
  return styles;
}

struct Entity {
  EntityStyle style;
  std::variant<Segment, Outline, DxfText> geometry;
};

/// Entities in the order of work.
class Drawing {
 public:
  Drawing(const FlatPattern& pattern, const DxfOptions& options)
      : styles_(styles_of(options.profile)),
        options_(options),
        scale_(1.0 / millimetres_in(options.units)) {
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

  const std::vector<Entity>& entities() const { return entities_; }
  const Box2& extents() const { return extents_; }
  /// Whether a contour cannot be cut, so the pattern is unsound.
  bool has_empty_outline() const { return has_empty_outline_; }

  /// The layers in use, once each.
  std::vector<EntityStyle> layers() const {
    std::vector<EntityStyle> layers;
    for (const Entity& entity : entities_) {
      const auto same = [&](const EntityStyle& s) { return s.layer == entity.style.layer; };
      if (std::ranges::none_of(layers, same)) layers.push_back(entity.style);
    }
    return layers;
  }

 private:
  OutlineOptions outline_options() const {
    const bool keep = options_.splines == Splines::keep && options_.version != DxfVersion::r12;
    return {.splines = keep ? Splines::keep : Splines::arcs,
            .arc_tolerance = options_.arc_tolerance,
            .scale = scale_};
  }

  void add_line(const EntityStyle& style, const Vec2& a, const Vec2& b) {
    if ((b - a).norm() < kShortestMark) return;
    const Segment line{a * scale_, b * scale_};
    extents_.add(bounds(Curve2(line)));
    entities_.push_back({style, line});
  }

  void add_slit(const Curve2& slit) {
    for (const Curve2& curve : curves_of_slit(slit, outline_options())) {
      if (const auto* line = std::get_if<Segment>(&curve)) {
        add_line(styles_.openings, line->a, line->b);
      } else {
        extents_.add(bounds(curve));
        entities_.push_back({styles_.openings, Outline(Loop{curve})});
      }
    }
  }

  void add_bend(const FlatBend& bend) {
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

  void add_text(const FlatBend& bend) {
    constexpr double kHighest = 3.0, kWide = 0.9;  // mm; a letter, by its height
    if (!options_.bend_text || bend.lines.empty()) return;
    const Segment& line = longest_line(bend);
    const std::string text = bend_text(bend);
    Vec2 along = line.b - line.a;
    const double length = along.norm();
    if (length < kShortestMark) return;
    // Read from below or from the right.
    if (along.x() < -kShortestMark || (along.x() < kShortestMark && along.y() < 0.0))
      along = -along;
    const double height = std::min(kHighest, length / (kWide * static_cast<double>(text.size())));
    const Vec2 above = height / length * Vec2(-along.y(), along.x());
    entities_.push_back(
        {styles_.text, DxfText{(0.5 * (line.a + line.b) + above) * scale_, height * scale_,
                               Angle::radians(std::atan2(along.y(), along.x())), text}});
  }

  void add_tangent_lines(const FlatBend& bend) {
    if (!options_.tangent_lines || styles_.bend_zone.layer.empty()) return;
    for (const Segment& line : bend.tangent_lines)
      add_line(styles_.bend_zone, line.a, line.b);
  }

  void add_outline(const EntityStyle& style, const Loop& loop) {
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

  Styles styles_;
  DxfOptions options_;
  double scale_;
  std::vector<Entity> entities_;
  Box2 extents_;
  bool has_empty_outline_ = false;
};

/// At least two periods of dash and gap, so that a short bend line visibly is dashed.
double dash_scale(const Segment& line, double unit) {
  const double periods = (line.b - line.a).norm() * unit / (kDash + kGap);
  return std::clamp(periods / 2.0, 0.01, 1.0);
}

void write(DxfWriter& writer, const Entity& entity, double unit) {
  if (const auto* line = std::get_if<Segment>(&entity.geometry)) {
    const double scale = entity.style.dashed ? dash_scale(*line, unit) : 1.0;
    write_line(writer, entity.style, *line, scale);
  } else if (const auto* text = std::get_if<DxfText>(&entity.geometry)) {
    write_text(writer, entity.style, *text);
  } else {
    write_outline(writer, entity.style, std::get<Outline>(entity.geometry));
  }
}

Result<void> checked(const DxfOptions& options) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(options.arc_tolerance)) {
    return fail(ErrorCode::bad_option, fmt::format("the arc tolerance is {} mm; it must be above 0",
                                                   options.arc_tolerance));
  }
  if (!positive(options.tick_length)) {
    return fail(ErrorCode::bad_option,
                fmt::format("the tick length is {} mm; it must be above 0", options.tick_length));
  }
  return {};
}

}  // namespace

Result<std::string> dxf_text(const FlatPattern& pattern, const DxfOptions& options) {
  if (auto good = checked(options); !good) return tl::unexpected(good.error());
  if (auto sound = check(pattern); !sound) return tl::unexpected(sound.error());
  if (pattern.outer.loop.empty())
    return fail(ErrorCode::invalid_sheet, "The pattern has no outer contour.");
  const Drawing drawing(pattern, options);
  if (drawing.has_empty_outline()) {
    return fail(ErrorCode::internal, "the pattern has a contour without extent");
  }

  DL_Dxf dxf;
  // dxflib learns the version only on opening a file; an empty name opens none.
  const std::unique_ptr<DL_WriterA> unused(dxf.out("", dxflib_version(options.version)));
  DxfWriter writer(options.version);
  write_prolog(dxf, writer, {drawing.extents(), options.units, drawing.layers()});
  for (const Entity& entity : drawing.entities())
    write(writer, entity, millimetres_in(options.units));
  write_epilog(dxf, writer);
  return writer.text();
}

}  // namespace planish
