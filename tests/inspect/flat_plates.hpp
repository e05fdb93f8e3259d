#pragma once

#include "support/sheet_builder.hpp"

#include <planish/inspect/findings.hpp>

#include <algorithm>
#include <string>
#include <vector>

// Flat patterns made by hand for the tests of inspect. Thickness 2 and inside radius 2 throughout,
// unless a test says otherwise.

namespace planish::test {

inline Contour contour(Loop loop) {
  Contour result{std::move(loop), {}};
  result.origins.resize(result.loop.size());
  return result;
}

/// A flat plate with the given outline.
inline FlatPattern flat_plate(const Loop& outline, double thickness = 2.0) {
  FlatPattern pattern;
  pattern.thickness = thickness;
  pattern.outer = contour(outline);
  return pattern;
}

inline void open(FlatPattern& pattern, const Loop& opening) {
  pattern.openings.push_back(contour(opening));
}

inline Loop shifted(const Loop& loop, const Vec2& by) {
  Isometry2 motion = Isometry2::Identity();
  motion.translation() = by;
  return transformed(loop, motion);
}

/// A rectangular opening about a centre.
inline Loop rectangular_opening(const Vec2& center, double width, double height) {
  return reversed(shifted(rectangle(width, height), center - 0.5 * Vec2(width, height)));
}

struct BendShape {
  double degrees = 90.0;
  double inside_radius = 2.0;
  double k = 0.44;
};

/// BA of a bend in sheet of 2 mm.
inline double zone_width(const BendShape& shape = {}) {
  return shape.degrees * 3.14159265358979323846 / 180.0 * (shape.inside_radius + shape.k * 2.0);
}

/// Adds a bend with its bend line and both tangent lines, all in one piece.
inline FlatBend& add_bend(FlatPattern& pattern, const Segment& line, const BendShape& shape = {}) {
  FlatBend bend;
  bend.bend = BendId{static_cast<int>(pattern.bends.size())};
  bend.id = "B" + std::to_string(pattern.bends.size() + 1);
  bend.angle = Angle::degrees(shape.degrees);
  bend.inside_radius = shape.inside_radius;
  bend.allowance = {shape.k, zone_width(shape), 0.0, "test"};
  bend.lines = {line};
  const Vec2 along = (line.b - line.a).normalized();
  const Vec2 half = 0.5 * bend.allowance.allowance * Vec2(-along.y(), along.x());
  bend.tangent_lines = {{line.a - half, line.b - half}, {line.a + half, line.b + half}};
  bend.length = (line.b - line.a).norm();
  pattern.bends.push_back(bend);
  return pattern.bends.back();
}

/// An L laid flat: `first` | bend along y | `second`, 40 wide, the bend's middle at x = 0.
inline FlatPattern flat_l(double first, double second, const BendShape& shape = {}) {
  const double half = 0.5 * zone_width(shape);
  FlatPattern pattern = flat_plate(
      shifted(rectangle(first + second + 2.0 * half, 40.0), Vec2(-half - first, 0.0)));
  add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)}, shape);
  return pattern;
}

/// The pattern moved or mirrored, contours kept in their sense.
inline FlatPattern moved(FlatPattern pattern, const Isometry2& motion) {
  const bool mirrored = motion.linear().determinant() < 0.0;
  const auto move_contour = [&](Contour& c) {
    c.loop = transformed(c.loop, motion);
    if (mirrored) c.loop = reversed(c.loop);
  };
  move_contour(pattern.outer);
  for (Contour& opening : pattern.openings)
    move_contour(opening);
  for (FlatBend& bend : pattern.bends) {
    for (auto* lines : {&bend.lines, &bend.tangent_lines})
      for (Segment& s : *lines)
        s = {motion * s.a, motion * s.b};
  }
  return pattern;
}

inline std::vector<Finding> of_code(const std::vector<Finding>& findings, const std::string& code) {
  std::vector<Finding> result;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(result),
               [&](const Finding& f) { return f.code == code; });
  return result;
}

/// All messages of a list of findings, for the message of a failed expectation.
inline std::string text_of(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings)
    text += f.code + ": " + f.message + "\n";
  return text;
}

}  // namespace planish::test
