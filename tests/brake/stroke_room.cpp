#include "stroke_room.hpp"

#include "support/sheet_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {

using namespace brake_detail;

Punch punch(const PlainPunch& plain) {
  const double b = plain.half_width, up = b / std::tan(0.5 * plain.angle.radians());
  return {"P",
          {{0, 0}, {b, up}, {b, plain.height}, {-b, plain.height}, {-b, up}},
          plain.tip_radius,
          plain.angle,
          plain.segments,
          {}};
}

Die die(const PlainDie& plain) {
  const double v = 0.5 * plain.opening, b = plain.half_width;
  const double deep = v / std::tan(0.5 * plain.angle.radians());
  return {"D",
          plain.opening,
          plain.angle,
          plain.shoulder_radius,
          {{-v, 0}, {-b, 0}, {-b, -plain.height}, {b, -plain.height}, {b, 0}, {v, 0}, {0, -deep}},
          plain.segments,
          {}};
}

BrakeTools plain_tools(const PlainPunch& upper, const PlainDie& lower) {
  BrakeTools tools;
  tools.machine.name = "test";
  tools.machine.force = 1e6;
  tools.machine.length = 3000;
  tools.punches = {punch(upper)};
  tools.dies = {die(lower)};
  return tools;
}

std::vector<Die> plain_dies(const std::vector<double>& openings, const std::string& prefix) {
  std::vector<Die> dies;
  for (const double opening : openings) {
    PlainDie plain;
    plain.opening = opening;
    dies.push_back(die(plain));
    dies.back().id = prefix + std::to_string(static_cast<int>(opening));
  }
  return dies;
}

Sheet lipped_base(double lip) {
  constexpr double kLength = 120.0, kRadius = 1.0, kWall = 28.0;
  const Turn turn{Angle::degrees(90), kRadius, BendDirection::up};
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(
      Frame{}, {polygon({{0, 0}, {kLength, 0}, {kLength, 5}, {kLength, 80}, {0, 80}})});
  const Rim front = builder.bend(builder.rim(base, 0), turn);
  builder.flange_behind(front, {rectangle(front.length, 20)});
  const Rim side = builder.bend(builder.rim(base, 2), turn);
  const FaceId wall = builder.flange_behind(side, {rectangle(side.length, kWall)});
  const Rim top = builder.bend(builder.rim(wall, 2), turn);
  builder.flange_behind(top, {rectangle(top.length, lip)});
  return builder.finish();
}

Sheet tabs_with_lips(double first, double second) {
  const Turn turn{Angle::degrees(90), 1.0, BendDirection::up};
  const Turn down{Angle::degrees(90), 1.0, BendDirection::down};
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(
      Frame{},
      {polygon({{0, 0}, {40, 0}, {40, 5}, {60, 5}, {60, 0}, {120, 0}, {120, 60}, {0, 60}})});
  for (const auto& [border, lip] : {std::pair{0, first}, std::pair{4, second}}) {
    const Rim foot = builder.bend(builder.rim(base, border), turn);
    const FaceId tab = builder.flange_behind(foot, {rectangle(foot.length, 30)});
    const Rim edge = builder.bend(builder.rim(tab, 2), down);
    builder.flange_behind(edge, {rectangle(edge.length, lip)});
  }
  return builder.finish();
}

Room::Room(Sheet sheet, BrakeTools tools, const PlanOptions& options,
           const FlattenOptions& flattening)
    : sheet_(std::move(sheet)), tools_(std::move(tools)) {
  auto flat = flat_sheet(sheet_, flattening);
  EXPECT_TRUE(flat) << flat.error().message;
  flat_ = std::move(*flat);
  WorkpieceOptions work_options;
  work_options.air_radius = options.radius_of_opening * wanted_opening(sheet_.thickness);
  auto work = workpiece_of(sheet_, flat_.layout, work_options);
  EXPECT_TRUE(work) << work.error().message;
  inputs_ = std::make_unique<StrokeInputs>(stroke_inputs(std::move(*work), tools_, options));
  cache_ = std::make_unique<StageCache>(*inputs_);
}

int Room::line_of(int bend) const {
  const auto& lines = work().lines;
  for (int i = 0; i < std::ssize(lines); ++i)
    if (std::ranges::count(lines[i].bends, static_cast<BendId>(bend - 1))) return i;
  ADD_FAILURE() << "no line of bend " << bend;
  return -1;
}

LineSet Room::lines(const std::vector<int>& bends) const {
  LineSet set = no_lines(inputs_->lines());
  for (const int bend : bends)
    insert(set, line_of(bend));
  return set;
}

std::vector<StrokeChoice> Room::ways(int bend, const std::vector<int>& formed) {
  const LineSet stage = lines(formed);
  std::vector<StrokeChoice> ways;
  for (const StrokeChoice& choice : choices(*cache_, stage))
    if (holds(choice.lines, line_of(bend)) && check(*cache_, stage, choice).feasible)
      ways.push_back(choice);
  return ways;
}

bool Room::can_press(int bend, const std::vector<int>& formed) {
  return !ways(bend, formed).empty();
}

}  // namespace planish::test
