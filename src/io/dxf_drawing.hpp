#pragma once

#include "dxf_writer.hpp"

#include <planish/io/flat_writers.hpp>

#include <string>
#include <variant>
#include <vector>

namespace planish::io_detail {

struct DxfStyles {
  EntityStyle outer, openings, slits, bend_up, bend_down, bend_zone, features, text;
};
DxfStyles styles_of(const DxfOptions& options);

struct DxfEntity {
  EntityStyle style;
  std::variant<Segment, Outline, DxfText> geometry;
};

/// What a DXF file shows, in the units of the file.
class Drawing {
 public:
  explicit Drawing(const DxfOptions& options);

  /// Adds a pattern's entities in the order of work.
  void add(const FlatPattern& pattern);
  /// Adds the edge of a sheet that patterns lie on, its corner at the origin.
  void add_sheet(double length, double width);
  /// Adds a name, inside the pattern's outer contour, as high as it has room there.
  void add_name(const FlatPattern& pattern, const std::string& name);

  const std::vector<DxfEntity>& entities() const { return entities_; }
  const Box2& extents() const { return extents_; }
  /// Whether a contour cannot be cut, so the pattern is unsound.
  bool has_empty_outline() const { return has_empty_outline_; }
  /// The layers in use, once each.
  std::vector<EntityStyle> layers() const;

 private:
  OutlineOptions outline_options() const;
  void add_line(const EntityStyle& style, const Vec2& a, const Vec2& b);
  void add_slit(const Curve2& slit);
  void add_bend(const FlatBend& bend);
  void add_text(const FlatBend& bend);
  void add_tangent_lines(const FlatBend& bend);
  void add_outline(const EntityStyle& style, const Loop& loop);

  DxfStyles styles_;
  DxfOptions options_;
  double scale_;
  std::vector<DxfEntity> entities_;
  Box2 extents_;
  bool has_empty_outline_ = false;
};

}  // namespace planish::io_detail
