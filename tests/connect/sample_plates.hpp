#pragma once

#include <planish/connect/plates.hpp>

#include <Eigen/Geometry>

#include <string>

namespace planish::test {

/// A rectangle of size (a, b) with corners o, o + a·x, … .
inline Plate rectangle_plate(const std::string& id, const Vec3& o, const Vec3& a, const Vec3& b) {
  return {id, {o, o + a, o + a + b, o + b}, {}};
}

/// Two plates w × 100 at a right angle whose mid-surfaces leave `gap` to the line where they meet.
inline PlateStructure angle_pair(double gap, double w = 200.0, double thickness = 4.0) {
  PlateStructure structure;
  structure.thickness = thickness;
  structure.plates = {rectangle_plate("A", {0, 0, 0}, {w, 0, 0}, {0, 100, 0}),
                      rectangle_plate("B", {0, 100 + gap, gap}, {w, 0, 0}, {0, 0, 100})};
  return structure;
}

/// A floor and four walls, each `gap` away from the lines where the planes meet.
inline PlateStructure tray(double gap = 8.0, double thickness = 3.0) {
  PlateStructure s;
  s.thickness = thickness;
  const double a = 300, b = 200, h = 60;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {a, 0, 0}, {0, b, 0}),
              rectangle_plate("front", {0, -gap, gap}, {a, 0, 0}, {0, 0, h}),
              rectangle_plate("back", {0, b + gap, gap}, {a, 0, 0}, {0, 0, h}),
              rectangle_plate("left", {-gap, 0, gap}, {0, b, 0}, {0, 0, h}),
              rectangle_plate("right", {a + gap, 0, gap}, {0, b, 0}, {0, 0, h})};
  return s;
}

/// Two plates at a right angle whose facing edges run apart: a cone joins them without extension.
/// Their edges lie on y = k x on both sides, x from x0 to x1.
inline PlateStructure cone_pair(double k = 0.2, double x0 = 200, double x1 = 500,
                                double thickness = 3.0) {
  PlateStructure s;
  s.thickness = thickness;
  s.plates = {{"A", {{x0, k * x0, 0}, {x1, k * x1, 0}, {x1, 300, 0}, {x0, 300, 0}}, {}},
              {"B", {{x0, 0, k * x0}, {x1, 0, k * x1}, {x1, 0, 300}, {x0, 0, 300}}, {}}};
  return s;
}

/// Two parallel plates h apart: a U.
inline PlateStructure u_pair(double h = 40.0, double thickness = 3.0) {
  PlateStructure s;
  s.thickness = thickness;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
              rectangle_plate("B", {0, 0, h}, {200, 0, 0}, {0, 80, 0})};
  return s;
}

inline PlateStructure moved(PlateStructure s, const Eigen::Isometry3d& motion) {
  for (Plate& plate : s.plates) {
    for (Vec3& p : plate.outline)
      p = motion * p;
    for (auto& hole : plate.holes)
      for (Vec3& p : hole)
        p = motion * p;
  }
  return s;
}

inline PlateStructure mirrored(PlateStructure s) {
  for (Plate& plate : s.plates)
    for (Vec3& p : plate.outline)
      p.x() = -p.x();
  return s;
}

inline PlateStructure scaled(PlateStructure s, double factor) {
  s.thickness *= factor;
  for (Plate& plate : s.plates)
    for (Vec3& p : plate.outline)
      p *= factor;
  return s;
}

/// Two truncated triangles of a square-to-round piece: their edges run to one corner of the square.
inline PlateStructure lofted(double t = 2.0) {
  PlateStructure s;
  s.thickness = t;
  s.plates = {{"A",
               {{200, -170, 0}, {200, 170, 0}, {190.4, 176, 36}, {120, 0, 300}, {190.4, -176, 36}},
               {}},
              {"B",
               {{170, 200, 0}, {-170, 200, 0}, {-176, 190.4, 36}, {0, 120, 300}, {176, 190.4, 36}},
               {}}};
  s.bends = {{.between = {"A", "B"},
              .edges = {std::vector{2}, std::vector{3}},
              .surface = SurfaceChoice::general,
              .tangent_point = Vec3(120, 120, 300),
              .lateral = LateralBoundary::arc}};
  return s;
}

}  // namespace planish::test
