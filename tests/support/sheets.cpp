#include "support/sheets.hpp"

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;
constexpr auto up = BendDirection::up;
constexpr auto down = BendDirection::down;

Turn turn(double degrees, double radius, BendDirection direction) {
  return {Angle::degrees(degrees), radius, direction};
}

/// Where the next part of a strip goes on, and the part itself.
struct StripEnd {
  SheetBuilder& builder;
  double width;
  Rim rim;

  void operator()(const Straight& part) {
    if (!rim.border && !rim.sharp) {
      rim = builder.rim(builder.flange(Frame{}, {rectangle(part.length, width)}), 1);
      return;
    }
    rim = builder.rim(builder.flange_behind(rim, {rectangle(width, part.length)}), 2);
  }
  void operator()(const Turn& part) { rim = builder.bend(rim, part); }
  void operator()(const ConeTurn& part) { rim = builder.bend(rim, part); }
  void operator()(const Crease& part) { rim = builder.crease(rim, part); }
};

}  // namespace

Sheet strip(const std::vector<StripPart>& parts, double width, double thickness) {
  SheetBuilder builder(thickness);
  StripEnd end{builder, width, {Frame{}, width, {}, {}}};
  for (const StripPart& part : parts)
    std::visit(end, part);
  return builder.finish();
}

double flat_length(const std::vector<StripPart>& parts, double thickness, double k) {
  double sum = 0.0;
  for (const StripPart& part : parts) {
    if (const auto* straight = std::get_if<Straight>(&part)) sum += straight->length;
    if (const auto* bend = std::get_if<Turn>(&part))
      sum += bend->angle.radians() * (bend->inside_radius + k * thickness);
    if (const auto* fold = std::get_if<Crease>(&part)) {
      sum += fold->angle.radians() * k * thickness;
      if (fold->direction == down) sum -= 2 * thickness * std::tan(0.5 * fold->angle.radians());
    }
  }
  return sum;
}

Sheet l_bracket() { return strip({Straight{50}, turn(90, 3, up), Straight{30}}, 40, 2); }

Sheet l_bracket_down() { return strip({Straight{50}, turn(90, 3, down), Straight{30}}, 40, 2); }

Sheet u_channel() {
  return strip({Straight{30}, turn(90, 2, up), Straight{40}, turn(90, 2, up), Straight{30}}, 25,
               1.5);
}

Sheet z_profile() {
  return strip({Straight{30}, turn(90, 1, up), Straight{20}, turn(90, 1, down), Straight{30}}, 25,
               1);
}

Sheet staircase(int n) {
  std::vector<StripPart> parts{Straight{20}};
  for (int i = 0; i < n; ++i)
    parts.insert(parts.end(), {turn(90, 1, up), Straight{20}, turn(90, 1, down), Straight{20}});
  return strip(parts, 30, 1);
}

Sheet hem() { return strip({Straight{40}, turn(180, 0.5, up), Straight{15}}, 20, 1); }

Sheet two_flaps() {
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(
      Frame{},
      {polygon({{0, 0}, {40, 0}, {40, 2}, {60, 2}, {60, 0}, {100, 0}, {100, 80}, {0, 80}})});
  for (const int side : {0, 4}) {
    const Rim rim = builder.bend(builder.rim(base, side), turn(90, 1.0, up));
    builder.flange_behind(rim, {rectangle(rim.length, 30)});
  }
  return builder.finish();
}

Sheet turn_of_250() { return strip({Straight{40}, turn(250, 8, up), Straight{4}}, 20, 1); }

Sheet two_turns_of_270() {
  return strip({Straight{6}, turn(270, 10, up), Straight{60}, turn(270, 10, up), Straight{6}}, 20,
               1);
}

Sheet rolled() { return strip({turn(300, 20, up)}, 50, 1.5); }

Sheet box(const BoxSize& size, BendDirection direction) {
  const double l = size.length, w = size.width, c = size.relief;
  SheetBuilder builder(size.thickness);
  const FaceId base = builder.flange(Frame{}, {polygon({{c, 0},
                                                        {l - c, 0},
                                                        {l - c, c},
                                                        {l, c},
                                                        {l, w - c},
                                                        {l - c, w - c},
                                                        {l - c, w},
                                                        {c, w},
                                                        {c, w - c},
                                                        {0, w - c},
                                                        {0, c},
                                                        {c, c}})});
  for (int side : {0, 3, 6, 9}) {
    const Turn turn{Angle::radians(pi / 2), size.inside_radius, direction};
    const Rim rim = builder.bend(builder.rim(base, side), turn);
    builder.flange_behind(rim, {rectangle(rim.length, size.height)});
  }
  return builder.finish();
}

Sheet cone_joined(const ConeJoint& joint) {
  return strip({Straight{joint.first}, joint.turn, Straight{joint.second}}, joint.width,
               joint.thickness);
}

Sheet truncated_cone(double r1, double r2, double height, Angle sweep, double thickness) {
  const double half_angle = std::atan2(r2 - r1, height);
  const double slant = std::hypot(r2 - r1, height);
  return strip({ConeTurn{sweep, Angle::radians(half_angle), r1 / std::sin(half_angle), down}},
               slant, thickness);
}

Sheet plate_with_holes() {
  SheetBuilder builder(3.0);
  builder.flange(
      Frame{}, {rectangle(100, 60), circular_opening({20, 30}, 5), circular_opening({80, 15}, 3.3),
                obround_opening({60, 40}, 12, 4, Angle::degrees(30))});
  return builder.finish();
}

Sheet ring(double outer_radius, double inner_radius, double thickness) {
  SheetBuilder builder(thickness);
  builder.flange(Frame{}, {Loop{Arc{Vec2::Zero(), outer_radius, 0.0, 2 * pi}},
                           circular_opening(Vec2::Zero(), inner_radius)});
  return builder.finish();
}

}  // namespace planish::test
