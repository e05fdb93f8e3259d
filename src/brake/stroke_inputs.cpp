// What all strokes are asked about, made once: tools that fit each line, sums of segments,
// directions of the gauge by number, and the beds on which tools can stand together
// (math.md#stations).
#include "stroke_inputs.hpp"

#include "one_line.hpp"
#include "tool_shape.hpp"

#include <planish/base/id_vector.hpp>

#include <array>
#include <cmath>
#include <map>

namespace planish::brake_detail {
namespace {

constexpr double kSameWay = 1e-3;  // of unit vectors: one direction of the gauge

/// Numbers of beds, by punch and die.
std::vector<std::vector<int>> beds_of(const BrakeTools& tools) {
  constexpr double kSame = 1e-3;  // mm and degrees
  using Bed = std::array<long long, 3>;
  std::map<Bed, int> numbers;
  return mapped(tools.punches, [&](const Punch& punch) {
    return mapped(tools.dies, [&](const Die& die) {
      const Bed bed{std::llround(punch.raises_beam / kSame), std::llround(die.opening / kSame),
                    std::llround(die.angle.degrees() / kSame)};
      return numbers.try_emplace(bed, static_cast<int>(numbers.size())).first->second;
    });
  });
}

}  // namespace

StrokeInputs stroke_inputs(Workpiece work, const BrakeTools& tools, const PlanOptions& options) {
  StrokeInputs inputs{std::move(work), tools, options, {}, {}, {}, {}, beds_of(tools), {}};
  const auto sums = [](const auto& tool) { return SegmentSums(tool.segments); };
  inputs.punch_segments = mapped(tools.punches, sums);
  inputs.die_segments = mapped(tools.dies, sums);
  const std::vector<BrakeLine>& lines = inputs.work.lines;
  inputs.on_one_line.resize(lines.size());
  for (int i = 0; i < std::ssize(lines); ++i) {
    inputs.fitting.push_back(fitting_tools(lines[i], tools, options));
    for (const Vec2& way : {lines[i].across(), Vec2(-lines[i].across())})
      if (direction_number(inputs, way) < 0) inputs.directions.push_back(way);
    for (int j = 0; j < std::ssize(lines); ++j)
      if (i == j || lie_on_one_line(lines[i], lines[j])) inputs.on_one_line[i].push_back(j);
  }
  return inputs;
}

int direction_number(const StrokeInputs& inputs, const Vec2& direction) {
  for (int i = 0; i < std::ssize(inputs.directions); ++i)
    if ((inputs.directions[i] - direction).norm() < kSameWay) return i;
  return -1;
}

double most_turn(const StrokeInputs& inputs, int line) {
  return inputs.work.lines[line].angle.radians() + inputs.options.springback.radians();
}

double shortfall(const StrokeInputs& inputs) {
  return inputs.options.shortfall.value_or(inputs.work.thickness);
}

Setting setting(const StrokeInputs& inputs, const LineSet& formed, const StrokeChoice& choice) {
  Setting stroke{&formed, choice.lines, first_line(choice.lines), choice.punch, choice.die, 1};
  const Vec2 left = inputs.work.lines[stroke.line].across();
  if (inputs.directions[choice.direction].dot(left) < 0.0) stroke.direction = -1;
  return stroke;
}

RowEars ears_of(const Punch& punch) {
  if (!punch.ears) return {};
  return {punch.ears->left, punch.ears->right, punch.ears->reach};
}

RowEars ears_of(const StrokeInputs& inputs, const Setting& stroke, ToolKind kind) {
  if (kind != ToolKind::punch || !stroke.ears) return {};
  const RowEars ears = ears_of(inputs.tools.punches[stroke.punch]);
  return stroke.direction > 0 ? ears : ears.turned();
}

PressMotion motion_at_punch(const StrokeInputs& inputs, const Setting& stroke) {
  const BrakeLine& line = inputs.work.lines[stroke.line];
  PressedBend bend = line.bend;
  const double tip = inputs.tools.punches[stroke.punch].tip_radius;
  if (tip > line.inside_radius) bend.allowance = line.angle.radians() * (tip + bend.neutral);
  return {bend, shoulder_of(inputs.tools.dies[stroke.die])};
}

PressMotion motion(const StrokeInputs& inputs, const Setting& stroke) {
  return {inputs.work.lines[stroke.line].bend, shoulder_of(inputs.tools.dies[stroke.die])};
}

}  // namespace planish::brake_detail
