// Where the parts of the workpiece are in a stage, seen from the line that is pressed: a tree of
// bodies and zones whose place follows from that of the body before and how the line between is.
// Formed zones are blocks between chords of their arcs. What must hold: a part's place depends on
// the lines of its path alone (math.md#stages, math.md#machine-frame).
#include "stage_pose.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kArcChord = 0.01;  // mm: a fifth of what may be penetrated

/// The point of a bent zone that lies flat at (along, across) and at a depth.
Vec3 bent_point(const BrakeLine& line, Angle bent, const Vec3& flat, double depth) {
  const double angle = bent.radians(), half = 0.5 * line.bend.allowance;
  const double r = std::max(0.0, line.bend.allowance / angle - line.bend.neutral);
  const double turn = half > 0.0 ? (flat.y() + half) / (2.0 * half) * angle : 0.0;
  return {flat.x(), -half + (r + depth) * std::sin(turn), r - (r + depth) * std::cos(turn)};
}

/// Of a bend's arc, so that chords of the outside stay within `kArcChord`.
int arc_count(const BrakeLine& line, Angle bent) {
  const double outer = line.bend.allowance / bent.radians() + line.bend.thickness;
  const double step = 2.0 * std::sqrt(2.0 * kArcChord / outer);
  return std::clamp(static_cast<int>(std::ceil(bent.radians() / step)), 1, 60);
}

/// Along and across a line, in the frame of the line: `up` decides which way x runs.
Vec3 in_frame(const BrakeLine& line, const Vec2& p, double z) {
  return {line.up ? p.x() : -p.x(), p.y(), z};
}

void add_cut(const Vec3& a, const Vec3& b, double x, std::vector<Vec2>& points) {
  const double da = a.x() - x, db = b.x() - x;
  if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) {
    const Vec3 p = a + da / (da - db) * (b - a);
    points.emplace_back(p.y(), p.z());
  }
}

/// In the frame of its own side.
void add_block(Block3 block, PlacedPart& placed) {
  if (!placed.left)
    for (auto* ring : {&block.lower, &block.upper})
      for (Vec3& p : *ring)
        p.y() = -p.y();
  placed.blocks.push_back(std::move(block));
}

}  // namespace

Convex section(const Block3& block, double lo, double hi) {
  std::vector<Vec2> points;
  const size_t n = block.lower.size();
  const auto edge = [&](const Vec3& a, const Vec3& b) {
    add_cut(a, b, lo, points);
    add_cut(a, b, hi, points);
  };
  for (const auto* ring : {&block.lower, &block.upper})
    for (size_t i = 0; i < n; ++i) {
      const Vec3& p = (*ring)[i];
      if (p.x() >= lo && p.x() <= hi) points.emplace_back(p.y(), p.z());
      edge(p, (*ring)[(i + 1) % n]);
    }
  for (size_t i = 0; i < n; ++i)
    edge(block.lower[i], block.upper[i]);
  return hull_of(std::move(points));
}

void summarise(PlacedPart& part) {
  std::vector<Vec2> corners;
  part.along = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Block3& block : part.blocks) {
    const Interval range = extent(block);
    part.along = {std::min(part.along.lo, range.lo), std::max(part.along.hi, range.hi)};
    part.sections.push_back(section(block, range.lo, range.hi));
    corners.insert(corners.end(), part.sections.back().begin(), part.sections.back().end());
  }
  part.hull = hull_of(std::move(corners));
}

Interval extent(const Block3& block) {
  Interval range{block.lower.front().x(), block.lower.front().x()};
  for (const auto* ring : {&block.lower, &block.upper})
    for (const Vec3& p : *ring)
      range = {std::min(range.lo, p.x()), std::max(range.hi, p.x())};
  return range;
}

Eigen::Isometry3d bent_side(const BrakeLine& line, Angle bent) {
  const double angle = bent.radians(), half = 0.5 * line.bend.allowance;
  const double r = std::max(0.0, line.bend.allowance / angle - line.bend.neutral);
  return Eigen::Translation3d(0.0, -half + r * std::sin(angle), r * (1.0 - std::cos(angle))) *
         Eigen::AngleAxisd(angle, Vec3::UnitX()) * Eigen::Translation3d(0.0, -half, 0.0);
}

Eigen::Isometry3d line_frame(const BrakeLine& line) {
  const double s = line.up ? 1.0 : -1.0;
  const Vec2 n = line.across();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() << s * line.along.x(), s * line.along.y(), 0.0, n.x(), n.y(), 0.0, 0.0, 0.0, s;
  frame.translation() = -(frame.linear() * Vec3(line.origin.x(), line.origin.y(), 0.0));
  frame.translation().z() = -0.5 * line.bend.thickness;
  return frame;
}

PartTree::PartTree(const Workpiece& work, int line)
    : work_(work), line_(line), part_of_body_(work.bodies.size(), -1) {
  const int lines = static_cast<int>(work.lines.size());
  for (const bool left : {false, true}) {
    const int body = work.lines[line].bodies[left ? 1 : 0];
    part_of_body_[body] = static_cast<int>(parts_.size());
    parts_.push_back({false, body, -1, -1, 0, left, no_lines(lines), {}});
  }
  grow();
  parts_.push_back({true, line, -1, line, 0, false, no_lines(lines), {}});
  hanging_.resize(parts_.size());
  for (Part& part : parts_)
    if (part.before >= 0) part.slot = hanging_[part.before]++;
  for (const Part& part : parts_) {
    const BrakeLine& over = work_.lines[part.over < 0 ? line_ : part.over];
    steps_.push_back(step(part, over.angle));
    closed_steps_.push_back(over.closed_by ? step(part, over.closed) : steps_.back());
  }
}

void PartTree::grow() {
  for (int i = 0; i < std::ssize(parts_); ++i) {
    if (parts_[i].is_zone) continue;
    for (int line = 0; line < std::ssize(work_.lines); ++line) {
      const auto& bodies = work_.lines[line].bodies;
      const int body = parts_[i].index;
      if (line == line_ || line == parts_[i].over || work_.lines[line].closes) continue;
      if (bodies[0] != body && bodies[1] != body) continue;
      const int next = bodies[bodies[0] == body ? 1 : 0];
      LineSet path = parts_[i].path;
      insert(path, line);
      if (work_.lines[line].closed_by) insert(path, *work_.lines[line].closed_by);
      std::vector<int> lines = parts_[i].lines;
      lines.push_back(line);
      const bool left = parts_[i].left;
      part_of_body_[next] = static_cast<int>(parts_.size());
      parts_.push_back({false, next, i, line, 0, left, path, lines});
      parts_.push_back({true, line, i, line, 0, left, std::move(path), std::move(lines)});
    }
  }
}

/// How a body moves when the line that it hangs by is bent: before its place when that is flat.
Eigen::Isometry3d PartTree::step(const Part& part, Angle angle) const {
  if (part.is_zone || part.over < 0) return Eigen::Isometry3d::Identity();
  const BrakeLine& line = work_.lines[part.over];
  const Eigen::Isometry3d frame = line_frame(line), side = bent_side(line, angle);
  const bool to_left = line.bodies[1] == part.index;
  return frame.inverse() * (to_left ? side : side.inverse()) * frame;
}

PartTree::State PartTree::state(int line, const LineSet& formed, const LineSet& pressed) const {
  if (holds(pressed, line)) return State::pressed;
  const auto& closed_by = work_.lines[line].closed_by;
  if (closed_by && holds(formed, *closed_by)) return State::closed;
  return holds(formed, line) ? State::formed : State::flat;
}

Eigen::Isometry3d PartTree::place(int number, const LineSet& formed) const {
  const Part& part = parts_[number];
  if (part.before < 0) return line_frame(work_.lines[line_]);
  const Eigen::Isometry3d before = place(part.before, formed);
  const State over = state(part.over, formed, no_lines(static_cast<int>(work_.lines.size())));
  if (over == State::flat) return before;
  return before * (over == State::closed ? closed_steps_ : steps_)[number];
}

/// The zone of a line in the frame of the tree's line, cut at `count` equal steps across it.
template <typename Take>
void PartTree::cut_zone(const Part& part, const Eigen::Isometry3d& before, State state, int count,
                        const Take& take) const {
  const BrakeLine& line = work_.lines[part.index];
  const bool is_bent = state == State::formed || state == State::closed;
  const Angle angle = state == State::closed ? line.closed : line.angle;
  const double half = 0.5 * line.bend.allowance;
  const Eigen::Isometry3d frame = line_frame(line);
  Eigen::Isometry3d at = before;
  // What hangs on the left of a formed line sees the zone from the side where it ends.
  if (is_bent && part.before >= 0 && line.bodies[1] == parts_[part.before].index)
    at = at * frame.inverse() * bent_side(line, angle).inverse() * frame;
  at = at * frame.inverse();
  for (const Convex& piece : work_.zones[part.index].pieces)
    for (int i = 0; i < count; ++i) {
      const double lo = half * (2.0 * i / count - 1.0), hi = half * (2.0 * (i + 1) / count - 1.0);
      const Convex strip = clipped(clipped(piece, {0, 1}, hi), {0, -1}, -lo);
      if (strip.empty()) continue;
      Block3 block;
      for (const Vec2& p : strip) {
        const Vec3 on = in_frame(line, p, 0.0);
        const auto point = [&](double depth) {
          return is_bent ? at * bent_point(line, angle, on, depth)
                         : at * Vec3(on.x(), on.y(), -depth);
        };
        block.lower.push_back(point(work_.thickness));
        block.upper.push_back(point(0.0));
      }
      take(std::move(block));
    }
}

std::vector<Block3> PartTree::closed_zone() const {
  std::vector<Block3> blocks;
  const BrakeLine& line = work_.lines[line_];
  for (const Part& part : parts_)
    if (part.is_zone && part.before < 0)
      cut_zone(part, line_frame(line), State::closed, arc_count(line, line.closed),
               [&](Block3 block) { blocks.push_back(std::move(block)); });
  return blocks;
}

/// The strips of a zone that is being pressed.
void PartTree::add_strips(const Part& part, const Eigen::Isometry3d& before,
                          PlacedPart& placed) const {
  const double half = 0.5 * work_.lines[part.index].bend.allowance;
  const int count = 2 * arc_count(work_.lines[part.index], work_.lines[part.index].angle);
  cut_zone(part, before, State::flat, count, [&](const Block3& block) {
    double middle = 0.0, from = half, to = 0.0;
    for (const Vec3& p : block.upper) {
      middle += p.y();
      from = std::min(from, std::abs(p.y()));
      to = std::max(to, std::abs(p.y()));
    }
    placed.strips.push_back({from, std::min(to, half), middle > 0.0, extent(block)});
  });
}

void PartTree::add_zone(const Part& part, const Eigen::Isometry3d& before, State state,
                        PlacedPart& placed) const {
  const BrakeLine& line = work_.lines[part.index];
  const int count = state == State::flat     ? 1
                    : state == State::closed ? arc_count(line, line.closed)
                                             : arc_count(line, line.angle);
  cut_zone(part, before, state, count, [&](Block3 block) { add_block(std::move(block), placed); });
}

void PartTree::add_body(const Part& part, PlacedPart& placed) const {
  const double half = 0.5 * work_.thickness;
  for (const Convex& piece : work_.bodies[part.index].pieces) {
    Block3 block;
    for (const Vec2& p : piece) {
      block.lower.push_back(placed.at * Vec3(p.x(), p.y(), -half));
      block.upper.push_back(placed.at * Vec3(p.x(), p.y(), half));
    }
    add_block(std::move(block), placed);
  }
}

PlacedPart PartTree::placed(int number, const PlacedPart* before, State over) const {
  const Part& part = parts_[number];
  const Eigen::Isometry3d start = before ? before->at : line_frame(work_.lines[line_]);
  const bool is_bent = over == State::formed || over == State::closed;
  PlacedPart result;
  result.flat = (!before || before->flat) && !is_bent;
  result.left = before ? before->left : part.left;
  if (part.is_zone && (!before || over == State::pressed)) {
    add_strips(part, start, result);
    return result;
  }
  if (part.is_zone) {
    add_zone(part, start, over, result);
  } else {
    if (over == State::pressed) result.left = !result.left;
    result.at = is_bent ? start * (over == State::closed ? closed_steps_ : steps_)[number] : start;
    add_body(part, result);
  }
  summarise(result);
  return result;
}

}  // namespace planish::brake_detail
