#pragma once

#include <planish/geometry/curve.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::io_detail {

/// A text that belongs to a line.
struct LabelRequest {
  std::string text;
  Segment line;
  double clearance = 0.0;  ///< to keep free on both sides of the line, if small
};

/// A text that names a point.
struct PointRequest {
  std::string text;
  Vec2 at;
};

/// A placed text: its `center`, turned counter-clockwise by `angle` in (−90°, 90°], radians.
struct PlacedLabel {
  std::string text;
  Vec2 center;
  double angle = 0.0;
  double font = 0.0;              ///< height of the letters' box
  std::optional<Segment> leader;  ///< from the line to a text that does not lie along it
};

/// Approximate width of a text in a plain sans-serif face.
double text_width(const std::string& text, double font);

/// The four corners of a label's box.
std::vector<Vec2> corners(const PlacedLabel& label);

/// Places each text along its line, or beside a line too short for it, in the order given. Of
/// several places, chooses the one that meets the fewest labels (those already `there` and those
/// placed) and obstacles. Obstacles may contain the lines themselves.
std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                      const std::vector<Segment>& obstacles, double font,
                                      const std::vector<PlacedLabel>& there = {});

/// Places each text level beside its point, outside `rings` (even-odd) where there is room, all in
/// one size, `font` or smaller. Where points are crowded, labels that would lie on another label or
/// a line are left out.
std::vector<PlacedLabel> place_point_labels(const std::vector<PointRequest>& requests,
                                            const std::vector<std::vector<Vec2>>& rings,
                                            const std::vector<Segment>& obstacles, double font);

}  // namespace planish::io_detail
