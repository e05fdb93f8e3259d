#include "support/sheets.hpp"

#include <planish/base/assert.hpp>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

/// First flange of an opened strip: x 0 … first, y 0 … width, the bend at x = first. `notch` are
/// the curves that replace the bend's side between y0 and y1 (none: the side is whole).
FaceId first_flange(SheetBuilder& builder, const Opened& part, double y0, double y1,
                    const Loop& notch) {
  const double l = part.first, w = part.width;
  Loop loop{Segment{{0, w}, {0, 0}}, Segment{{0, 0}, {l, 0}}};
  if (notch.empty()) {
    loop.push_back(Segment{{l, 0}, {l, w}});
  } else {
    loop.push_back(Segment{{l, 0}, {l, y0}});
    loop.insert(loop.end(), notch.begin(), notch.end());
    loop.push_back(Segment{{l, y1}, {l, w}});
  }
  loop.push_back(Segment{{l, w}, {0, w}});
  return builder.flange(Frame{}, {loop});
}

/// Second flange: local x from the far end of the bend, running against y of the first one.
FaceId second_flange(SheetBuilder& builder, const Frame& rim, const Opened& part, double x0,
                     double x1, const Loop& notch) {
  const double l = part.second, w = part.width;
  Loop loop{Segment{{0, l}, {0, 0}}};
  if (notch.empty()) {
    loop.push_back(Segment{{0, 0}, {w, 0}});
  } else {
    loop.push_back(Segment{{0, 0}, {x0, 0}});
    loop.insert(loop.end(), notch.begin(), notch.end());
    loop.push_back(Segment{{x1, 0}, {w, 0}});
  }
  loop.push_back(Segment{{w, 0}, {w, l}});
  loop.push_back(Segment{{w, l}, {0, l}});
  return builder.flange({rim.origin + w * rim.y, -rim.y, rim.x, rim.z}, {loop});
}

/// The bend of an opened strip: its surface, and how y of the strip becomes v.
struct OpenedBend {
  Rim rim;
  Cylinder cylinder;
  int sense;
  Frame far;
  double width;

  OpenedBend(const Opened& part)
      : rim{{{part.first, 0, 0}, Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, part.width, {}, {}},
        cylinder(cylinder_behind(rim, part.turn, part.thickness)),
        sense(part.turn.direction == BendDirection::up ? -1 : 1),
        far(turned(rim.frame, part.turn, part.thickness)),
        width(part.width) {}

  Vec2 uv(double azimuth, double y) const { return {azimuth, sense < 0 ? width - y : y}; }
  /// Closed loop through points (azimuth, y).
  Loop loop(const std::vector<Vec2>& points) const {
    std::vector<Vec2> mapped;
    for (const Vec2& p : points)
      mapped.push_back(uv(p.x(), p.y()));
    return polygon(mapped);
  }
  /// Part of the ellipse about (u, y): phi counter-clockwise in (azimuth, y).
  CubicSpline arc(double u, double y, double ru, double ry, double start, double sweep) const {
    return elliptic_arc(uv(u, y), ru, sense < 0 ? -ry : ry, start, sweep);
  }
};

BendId bend_of(SheetBuilder& builder, const Opened& part) {
  return builder.new_bend({BendKind::cylinder,
                           {},
                           part.turn.angle,
                           part.turn.inside_radius,
                           part.turn.direction == BendDirection::up});
}

double neutral_radius(const Opened& part, double k) {
  return part.turn.inside_radius + k * part.thickness;
}

Loop notch_of(const std::vector<Vec2>& points) {
  Loop loop;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    loop.push_back(Segment{points[i], points[i + 1]});
  return loop;
}

constexpr double slot_depth = 8.0;

}  // namespace

Sheet slot_across_bend(double slot, const Opened& part) {
  SheetBuilder builder(part.thickness);
  const OpenedBend bend(part);
  const double w = part.width, l = part.first, a = part.turn.angle.radians();
  const double y0 = 0.5 * (w - slot), y1 = 0.5 * (w + slot);

  const FaceId first = first_flange(
      builder, part, y0, y1,
      notch_of({{l, y0}, {l - slot_depth, y0}, {l - slot_depth, y1}, {l, y1}}));
  const FaceId second = second_flange(
      builder, bend.far, part, y0, y1,
      notch_of({{y0, 0}, {y0, slot_depth}, {y1, slot_depth}, {y1, 0}}));
  const BendId id = bend_of(builder, part);
  const FaceId low = builder.bend_face(id, bend.cylinder, bend.sense,
                                       {bend.loop({{0, y0}, {0, 0}, {a, 0}, {a, y0}})});
  const FaceId high = builder.bend_face(id, bend.cylinder, bend.sense,
                                        {bend.loop({{0, w}, {0, y1}, {a, y1}, {a, w}})});
  builder.join({first, 0, 2}, {low, 0, 0});
  builder.join({first, 0, 6}, {high, 0, 0});
  builder.join({low, 0, 2}, {second, 0, 5});
  builder.join({high, 0, 2}, {second, 0, 1});
  return builder.finish();
}

Sheet slot_into_bend(double slot, const Opened& part) {
  SheetBuilder builder(part.thickness);
  const OpenedBend bend(part);
  const double w = part.width, l = part.first, a = part.turn.angle.radians();
  const double y0 = 0.5 * (w - slot), y1 = 0.5 * (w + slot);

  const FaceId first = first_flange(
      builder, part, y0, y1,
      notch_of({{l, y0}, {l - slot_depth, y0}, {l - slot_depth, y1}, {l, y1}}));
  const FaceId second = second_flange(builder, bend.far, part, 0, 0, {});
  const FaceId face = builder.bend_face(
      bend_of(builder, part), bend.cylinder, bend.sense,
      {bend.loop({{0, w}, {0, y1}, {a / 2, y1}, {a / 2, y0}, {0, y0}, {0, 0}, {a, 0}, {a, w}})});
  builder.join({first, 0, 2}, {face, 0, 4});
  builder.join({first, 0, 6}, {face, 0, 0});
  builder.join({face, 0, 6}, {second, 0, 1});
  return builder.finish();
}

Sheet hole_in_bend(double diameter, double k, const Opened& part) {
  SheetBuilder builder(part.thickness);
  const OpenedBend bend(part);
  const double w = part.width, a = part.turn.angle.radians(), r = 0.5 * diameter;
  const double rho = neutral_radius(part, k);
  PLANISH_ASSERT(r < 0.5 * a * rho);

  const FaceId first = first_flange(builder, part, 0, 0, {});
  const FaceId second = second_flange(builder, bend.far, part, 0, 0, {});
  const FaceId face = builder.bend_face(bend_of(builder, part), bend.cylinder, bend.sense,
                                        {bend.loop({{0, w}, {0, 0}, {a, 0}, {a, w}}),
                                         {bend.arc(0.5 * a, 0.5 * w, r / rho, r, 0.0, -2 * pi)}});
  builder.join({first, 0, 2}, {face, 0, 0});
  builder.join({face, 0, 2}, {second, 0, 1});
  return builder.finish();
}

Sheet hole_across_bend(double diameter, double k, const Opened& part) {
  SheetBuilder builder(part.thickness);
  const OpenedBend bend(part);
  const double w = part.width, a = part.turn.angle.radians(), r = 0.5 * diameter;
  const double rho = neutral_radius(part, k), half = 0.5 * a * rho;
  PLANISH_ASSERT(r > half && diameter < w);
  const double h = std::sqrt(r * r - half * half), y0 = 0.5 * w - h, y1 = 0.5 * w + h;
  const double beta = std::atan2(h, half);  // azimuth on the circle where it meets the tangent line

  // The opening runs clockwise; φ is measured about its middle, which lies `half` behind the
  // tangent line of the first flange and as far before that of the second.
  const FaceId first = first_flange(builder, part, y0, y1,
                                    {Arc{{part.first + half, 0.5 * w}, r, pi + beta, -2 * beta}});
  const FaceId second = second_flange(
      builder, bend.far, part, y0, y1,
      {Arc{{0.5 * w, -half}, r, pi / 2 + std::atan2(h, half), -2 * beta}});
  const BendId id = bend_of(builder, part);
  const double gap = pi - 2 * beta;
  const FaceId low = builder.bend_face(
      id, bend.cylinder, bend.sense,
      {{Segment{bend.uv(0, y0), bend.uv(0, 0)}, Segment{bend.uv(0, 0), bend.uv(a, 0)},
        Segment{bend.uv(a, 0), bend.uv(a, y0)},
        bend.arc(0.5 * a, 0.5 * w, r / rho, r, -beta, -gap)}});
  const FaceId high = builder.bend_face(
      id, bend.cylinder, bend.sense,
      {{Segment{bend.uv(0, w), bend.uv(0, y1)},
        bend.arc(0.5 * a, 0.5 * w, r / rho, r, pi - beta, -gap),
        Segment{bend.uv(a, y1), bend.uv(a, w)}, Segment{bend.uv(a, w), bend.uv(0, w)}}});
  builder.join({first, 0, 2}, {low, 0, 0});
  builder.join({first, 0, 4}, {high, 0, 0});
  builder.join({low, 0, 2}, {second, 0, 3});
  builder.join({high, 0, 2}, {second, 0, 1});
  return builder.finish();
}

CubicSpline elliptic_arc(const Vec2& center, double radius_u, double radius_v, double start,
                         double sweep) {
  // The cubic of a circular arc of angle s leaves it by about s⁶/55000.
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / 0.25)));
  const double step = sweep / pieces, handle = 4.0 / 3.0 * std::tan(step / 4);
  const auto at = [&](double phi, double tangent) -> Vec2 {
    return center + Vec2(radius_u * (std::cos(phi) - tangent * std::sin(phi)),
                         radius_v * (std::sin(phi) + tangent * std::cos(phi)));
  };
  CubicSpline spline{{at(start, 0)}};
  for (int i = 0; i < pieces; ++i) {
    const double phi = start + i * step, next = start + (i + 1) * step;
    spline.poles.insert(spline.poles.end(), {at(phi, handle), at(next, -handle), at(next, 0)});
  }
  return spline;
}

}  // namespace planish::test
