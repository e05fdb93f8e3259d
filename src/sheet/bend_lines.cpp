// Bend lines, press lines and tangent lines of a layout, interrupted where there is no material: a
// ruling is cut with the borders of all faces of its bend (even-odd), intervals that touch at a
// seam are joined, and their ends developed. Borders often run exactly along the rulings at the
// ends of a bend; so material is looked up a little aside and, where both agree, measured on the
// ruling itself.

#include "bend_lines.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/interval.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::sheet_detail {
namespace {

using Intervals = std::vector<Interval>;

/// v-intervals of material along the ruling u of a face, by even-odd crossing of its loops.
void add_material(const Face& face, double u, Intervals& intervals) {
  std::vector<double> heights;
  for (const BorderLoop& loop : face.loops)
    for (const Border& border : loop)
      for (const double t : crossings(border.curve, Vec2(u, 0.0), Vec2(0.0, 1.0)))
        heights.push_back(point_at(border.curve, t).y());
  std::ranges::sort(heights);
  for (size_t i = 0; i + 1 < heights.size(); i += 2)
    intervals.push_back({heights[i], heights[i + 1]});
}

/// Whether both are the same, except for the ends of the material moving from one ruling to the
/// next.
bool alike(const Intervals& a, const Intervals& b) {
  constexpr double kMoved = 1e-3;  // share of the length
  if (a.empty() || a.size() != b.size()) return false;
  const double near = kMoved * (a.back().hi - a.front().lo);
  for (size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i].lo - b[i].lo) > near || std::abs(a[i].hi - b[i].hi) > near) return false;
  return true;
}

Intervals material_along(const Sheet& sheet, const Bend& bend, const Box2& box, double u) {
  Intervals intervals;
  for (const FaceId id : bend.faces)
    add_material(sheet[id], u, intervals);
  // Neighbouring faces of one bend share seams. What lies between is far below any cut.
  return joined(std::move(intervals), tolerance::kAside * box.size().y());
}

/// The ruling at the share `at` of the bend's range as segments in the pattern. Material is looked
/// up slightly aside, because seams and tangent lines run exactly along rulings; it is measured on
/// the ruling itself if the result is the same.
std::vector<Segment> ruling_lines(const Sheet& sheet, const Layout& layout, const Bend& bend,
                                  const Box2& box, double at) {
  constexpr double kAside = tolerance::kAside;  // share of the range
  const double first = box.lo.x(), range = box.size().x();
  const double u = first + at * range;
  const double looked_at = first + std::clamp(at + kAside, kAside, 1.0 - kAside) * range;
  auto intervals = material_along(sheet, bend, box, looked_at);
  if (at > 2.0 * kAside && at < 1.0 - 2.0 * kAside)
    if (auto exact = material_along(sheet, bend, box, u); alike(exact, intervals))
      intervals = std::move(exact);
  std::vector<Segment> lines;
  for (const auto& [from, to] : intervals)
    lines.push_back({layout.develop(sheet, bend.faces.front(), {u, from}),
                     layout.develop(sheet, bend.faces.front(), {u, to})});
  return lines;
}

/// By bend: the joints that a sharp one folds.
IdVector<BendId, std::vector<int>> sharp_joints(const Sheet& sheet) {
  IdVector<BendId, std::vector<int>> joints(sheet.bends.size());
  for (int j = 0; j < std::ssize(sheet.joints); ++j)
    if (const auto& sharp = sheet.joints[j].sharp) joints[*sharp].push_back(j);
  return joints;
}

void add_sharp_lines(const Sheet& sheet, const Layout& layout, const std::vector<int>& joints,
                     FlatBend& flat) {
  for (const int j : joints) {
    const Joint& joint = sheet.joints[j];
    const Curve2& a = sheet[joint.a].curve;
    const Curve2& b = sheet[joint.b].curve;
    const Vec2 a0 = layout.develop(sheet, joint.a.face, start_of(a));
    const Vec2 a1 = layout.develop(sheet, joint.a.face, end_of(a));
    const Vec2 b0 = layout.develop(sheet, joint.b.face, end_of(b));
    const Vec2 b1 = layout.develop(sheet, joint.b.face, start_of(b));
    flat.lines.push_back({(a0 + b0) / 2, (a1 + b1) / 2});
    flat.line_angles.push_back(flat.angle);
    flat.tangent_lines.push_back({a0, a1});
    flat.tangent_lines.push_back({b0, b1});
  }
}

void add_press_lines(const Sheet& sheet, const Layout& layout, const Bend& bend, const Box2& box,
                     FlatBend& flat) {
  const auto add = [&](double at, Angle angle) {
    for (const Segment& line : ruling_lines(sheet, layout, bend, box, at)) {
      flat.lines.push_back(line);
      flat.line_angles.push_back(angle);
    }
  };
  for (const PressLine& press : bend.press_lines)
    add((press.u - box.lo.x()) / box.size().x(), press.angle);
  if (bend.press_lines.empty()) add(0.5, bend.angle);
}

/// Total length of the bend lines; for press lines, which lie side by side, their mean.
double length_of(const Bend& bend, const std::vector<Segment>& lines) {
  return sum_of(lines, [&](const Segment& line) { return (line.b - line.a).norm(); }) /
         std::max<double>(1.0, static_cast<double>(bend.press_lines.size()));
}

}  // namespace

std::vector<FlatBend> flat_bends(const Sheet& sheet, const Layout& layout) {
  std::vector<FlatBend> result;
  const auto sharp = sharp_joints(sheet);
  for (const BendId id : sheet.bends.ids()) {
    const Bend& bend = sheet[id];
    FlatBend flat;
    flat.id = fmt::format("B{}", index_of(id) + 1);
    flat.bend = id;
    flat.kind = bend.kind;
    flat.angle = bend.angle;
    flat.inside_radius = bend.inside_radius;
    flat.allowance = layout.allowance[id];
    flat.direction = bend.reference_inside ? BendDirection::up : BendDirection::down;
    if (bend.faces.empty()) {
      add_sharp_lines(sheet, layout, sharp[id], flat);
    } else {
      const Box2 box = parameter_box(sheet, bend);
      add_press_lines(sheet, layout, bend, box, flat);
      flat.tangent_lines = ruling_lines(sheet, layout, bend, box, 0.0);
      for (const Segment& line : ruling_lines(sheet, layout, bend, box, 1.0))
        flat.tangent_lines.push_back(line);
    }
    flat.length = length_of(bend, flat.lines);
    result.push_back(std::move(flat));
  }
  return result;
}

}  // namespace planish::sheet_detail
