// Cuts a sheet at its lines. Faces of flanges, and the regions of bends between their lines, are
// nodes; what joins them without a line unites them to bodies; bends on one line between the same
// two bodies become one line. What must hold: bodies and lines are a tree, else some bend closes a
// loop and cannot be pressed alone (math.md#stages).
#include "cutting.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kNoRadius = 1e-3;  // mm: a bend that is drawn sharp inside
constexpr double kOneLine = 1e-3;   // mm, and radians: lines that are one straight line

/// Range of u over the faces of a bend.
Interval u_range(const Sheet& sheet, const Bend& bend) {
  const Box2 box = parameter_box(sheet, bend);
  return {box.lo.x(), box.hi.x()};
}

/// Replaces a radius that is not drawn by what the V gives.
void give_radius(BrakeLine& line, double radius) {
  line.given_radius = false;
  line.inside_radius = radius;
  line.bend.allowance = line.angle.radians() * (radius + line.bend.neutral);
}

/// Whether b is the continuation of a: the same straight line, bent alike between the same bodies.
bool continues(const BrakeLine& a, const BrakeLine& b) {
  const double turned = cross(a.along, b.along);
  const int same = a.along.dot(b.along) > 0.0 ? 0 : 1;
  return a.bodies[0] == b.bodies[same] && a.bodies[1] == b.bodies[1 - same] && a.up == b.up &&
         std::abs(turned) < kOneLine && std::abs(a.across().dot(b.origin - a.origin)) < kOneLine &&
         std::abs(a.angle.radians() - b.angle.radians()) < kOneLine;
}

Vec2 point_of(const BrakeLine& line, double at) { return line.origin + at * line.along; }

}  // namespace

/// Nodes are the faces of flanges and the regions of bends between their lines.
int Cutting::count_nodes() {
  int count = static_cast<int>(sheet_.faces.size());
  for (const BendId id : sheet_.bends.ids()) {
    const Bend& bend = sheet_[id];
    auto at = mapped(bend.press_lines, &PressLine::u);
    if (at.empty() && !bend.faces.empty()) {
      const Interval range = u_range(sheet_, bend);
      const int strokes = strokes_of(id);
      for (int i = 0; i < strokes; ++i)
        at.push_back(range.lo + (i + 0.5) / strokes * (range.hi - range.lo));
    }
    first_region_.push_back(count);
    count += static_cast<int>(at.size()) + 1;
    lines_at_.push_back(std::move(at));
  }
  return count;
}

const LargeBend* Cutting::large(BendId bend) const {
  const auto found = std::ranges::find(options_.large, bend, &LargeBend::bend);
  return found == options_.large.end() ? nullptr : &*found;
}

/// Of a bend without press lines: one in its middle, its bumps, or none if it is rolled.
int Cutting::strokes_of(BendId bend) const {
  const LargeBend* large = this->large(bend);
  if (!large || large->forming == Forming::over_v) return 1;
  return large->forming == Forming::bumps ? large->bumps : 0;
}

int Cutting::region_of(BendId bend, double u) const {
  const std::vector<double>& at = lines_at_[bend];
  const auto behind = std::ranges::lower_bound(at, u);
  return first_region_[bend] + static_cast<int>(behind - at.begin());
}

int Cutting::node_at(const BorderRef& ref) const {
  const auto* bend = std::get_if<BendId>(&sheet_[ref.face].part_of);
  if (!bend) return index_of(ref.face);
  const Curve2& curve = sheet_[ref].curve;
  return region_of(*bend, 0.5 * (start_of(curve).x() + end_of(curve).x()));
}

void Cutting::unite_across(const Joint& joint) {
  const auto* a = std::get_if<BendId>(&sheet_[joint.a.face].part_of);
  const auto* b = std::get_if<BendId>(&sheet_[joint.b.face].part_of);
  if (!a || !b || *a != *b) nodes_.unite(node_at(joint.a), node_at(joint.b));
}

BrakeLine Cutting::line_of(BendId id) const {
  const Bend& bend = sheet_[id];
  BrakeLine line;
  line.bends = {id};
  line.kind = bend.kind;
  line.angle = bend.angle;
  line.inside_radius = line.drawn_radius = bend.inside_radius;
  line.bend.thickness = sheet_.thickness;
  line.bend.neutral = layout_.allowance[id].k_factor * sheet_.thickness;
  line.bend.allowance = layout_.allowance[id].allowance;
  line.reference_up = bend.reference_inside;
  line.up = bend.reference_inside == layout_.shows_reference(sheet_);
  return line;
}

std::optional<Error> Cutting::add_lines(BendId id) {
  const Bend& bend = sheet_[id];
  first_raw_.push_back(static_cast<int>(raw_.size()));
  if (bend.faces.empty()) return std::nullopt;
  const std::string name = fmt::format("B{}", index_of(id) + 1);
  if (bend.kind == BendKind::general && bend.press_lines.empty())
    return error_of(refuse::no_line_to_strike, {{"bend", place::bend(name)}}, name);
  for (int i = 0; i < std::ssize(lines_at_[id]); ++i)
    add_press_line(id, i);
  return std::nullopt;
}

void Cutting::add_press_line(BendId id, int number) {
  const Bend& bend = sheet_[id];
  const FaceId face = bend.faces.front();
  const Box2 box = parameter_box(sheet_[face]);
  const double u = lines_at_[id][number];
  const double aside = u + tolerance::kAside * (box.hi.x() - box.lo.x());
  // The ruling's ends may lie beyond an apex, where what is beside it is on the other side.
  const double inside = 0.5 * (box.lo.y() + box.hi.y());
  const Vec2 a = layout_.develop(sheet_, face, {u, box.lo.y()}),
             b = layout_.develop(sheet_, face, {u, box.hi.y()}),
             beside = layout_.develop(sheet_, face, {aside, inside}) -
                      layout_.develop(sheet_, face, {u, inside});
  BrakeLine line = line_of(id);
  line.origin = a;
  line.along = (b - a).normalized();
  if (line.across().dot(beside) < 0.0) line.along = -line.along;
  const LargeBend* large = this->large(id);
  line.is_large = large && large->forming == Forming::over_v;
  if (!bend.press_lines.empty()) {
    line.press_line = number;
    line.angle = bend.press_lines[number].angle;
    give_radius(line, std::min(options_.air_radius, bend.inside_radius));
  } else if (large && large->forming == Forming::bumps) {
    line.press_line = number;
    line.angle = large->angle;
    line.bump_pitch = large->pitch;
    give_radius(line, options_.air_radius);
  } else if (bend.inside_radius < kNoRadius) {
    give_radius(line, options_.air_radius);
  }
  const int region = first_region_[id] + number;
  raw_.push_back({std::move(line), {region, region + 1}, {}, (b - a).norm()});
}

void Cutting::add_sharp_lines() {
  std::map<BendId, std::vector<int>> joints;
  for (int j = 0; j < std::ssize(sheet_.joints); ++j)
    if (sheet_.joints[j].sharp) joints[*sheet_.joints[j].sharp].push_back(j);
  for (const auto& [bend, of_bend] : joints)
    add_sharp_line(bend, of_bend);
}

/// The joints of a sharp bend lie on one line; what lies on one side of it is one body.
void Cutting::add_sharp_line(BendId bend, const std::vector<int>& joints) {
  Raw raw{line_of(bend), {-1, -1}};
  BrakeLine& line = raw.line;
  give_radius(line, options_.air_radius);
  for (const int j : joints) {
    const Joint& joint = sheet_.joints[j];
    const Curve2 &a = layout_.image(joint.a), &b = layout_.image(joint.b);
    const Vec2 start = 0.5 * (start_of(a) + end_of(b)), end = 0.5 * (end_of(a) + start_of(b));
    const bool is_first = raw.nodes.first < 0;
    if (is_first) {
      line.origin = start;
      line.along = (end - start).normalized();
    }
    std::pair<int, int> nodes(node_at(joint.b), node_at(joint.a));
    if ((line.along.dot(end - start) > 0.0) != lies_left(joint.a.face))
      std::swap(nodes.first, nodes.second);
    if (is_first) raw.nodes = nodes;
    nodes_.unite(raw.nodes.first, nodes.first);
    nodes_.unite(raw.nodes.second, nodes.second);
    const double from = line.along.dot(start - line.origin), to = line.along.dot(end - line.origin);
    line.pieces.push_back({std::min(from, to), std::max(from, to)});
    raw.bands.push_back(hull_of({start_of(a), end_of(a), start_of(b), end_of(b)}));
  }
  raw_.push_back(std::move(raw));
}

int Cutting::body_of(int node) {
  const auto [at, added] = body_of_root_.try_emplace(nodes_.root(node), std::ssize(made_.bodies));
  if (added) made_.bodies.emplace_back();
  return at->second;
}

void Cutting::number_bodies() {
  for (const FaceId face : sheet_.faces.ids()) {
    const auto* flange = std::get_if<FlangeId>(&sheet_[face].part_of);
    if (!flange) continue;
    Body& body = made_.bodies[body_of(index_of(face))];
    body.faces.push_back(face);
    if (!body.flange) body.flange = *flange;
  }
  for (Raw& raw : raw_)
    raw.line.bodies = {body_of(raw.nodes.first), body_of(raw.nodes.second)};
}

/// Bends on one line between the same two bodies are pressed together.
void Cutting::number_lines() {
  for (Raw& raw : raw_) {
    for (int i = 0; i < std::ssize(made_.lines) && raw.number < 0; ++i)
      if (continues(made_.lines[i], raw.line)) raw.number = i;
    if (raw.number >= 0) {
      BrakeLine& line = made_.lines[raw.number];
      line.bends.insert(line.bends.end(), raw.line.bends.begin(), raw.line.bends.end());
      for (const Interval& piece : raw.line.pieces) {
        const double a = line.along.dot(point_of(raw.line, piece.lo) - line.origin),
                     b = line.along.dot(point_of(raw.line, piece.hi) - line.origin);
        line.pieces.push_back({std::min(a, b), std::max(a, b)});
      }
      continue;
    }
    raw.number = static_cast<int>(made_.lines.size());
    made_.lines.push_back(raw.line);
  }
}

/// Splits hems into bending and closing.
void Cutting::add_closing_lines() {
  const int count = static_cast<int>(made_.lines.size());
  for (int i = 0; i < count && options_.before_closing.radians() > 0.0; ++i) {
    BrakeLine& line = made_.lines[i];
    if (!is_hem(line) || line.press_line) continue;
    line.closed = line.angle;
    line.angle = options_.before_closing;
    line.inside_radius = line.bend.allowance / line.angle.radians() - line.bend.neutral;
    line.closed_by = static_cast<int>(made_.lines.size());
    BrakeLine closing = line;
    closing.closes = i;
    closing.closed_by.reset();
    made_.lines.push_back(std::move(closing));
  }
  made_.zones.resize(made_.lines.size());
}

std::optional<Error> Cutting::check_tree() const {
  UnionFind bodies(static_cast<int>(made_.bodies.size()));
  for (const BrakeLine& line : made_.lines) {
    if (line.closes || bodies.unite(line.bodies[0], line.bodies[1])) continue;
    const std::string name = fmt::format("B{}", index_of(line.bends.front()) + 1);
    return error_of(refuse::closes_loop, {{"bend", place::bend(name)}}, name);
  }
  return std::nullopt;
}

Result<Workpiece> Cutting::cut() {
  made_.thickness = sheet_.thickness;
  made_.large = options_.large;
  for (const BendId bend : sheet_.bends.ids())
    if (const auto error = add_lines(bend)) return tl::unexpected(*error);
  for (const Joint& joint : sheet_.joints)
    if (!joint.sharp) unite_across(joint);
  add_sharp_lines();
  number_bodies();
  number_lines();
  add_closing_lines();
  if (const auto error = check_tree()) return tl::unexpected(*error);
  add_material();
  add_edges();
  return std::move(made_);
}

}  // namespace planish::brake_detail
