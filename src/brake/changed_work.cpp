// Workpieces with a change that is tried: a flange shorter at its end, or by a strip taken out
// beside a line, after which what hangs there comes nearer; or the two halves beside a line. What
// must hold: everything else keeps its shape, and the strip lies where no other line is.
#include "changed_work.hpp"

#include "stage_pose.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kAlike = 1e-3;  // radians, mm: lines that run the same way

/// Away from a line into the body on one of its sides: a unit vector of the pattern.
Vec2 away_from(const BrakeLine& line, int body) {
  return line.bodies[1] == body ? line.across() : Vec2(-line.across());
}

double half_zone(const BrakeLine& line) { return 0.5 * line.bend.allowance; }

/// The lines on a body beside the given one.
std::vector<int> other_lines(const Workpiece& work, int body, int line) {
  std::vector<int> others;
  for (int i = 0; i < std::ssize(work.lines); ++i)
    if (!is_same(work, i, line) && touches(work.lines[i], body)) others.push_back(i);
  return others;
}

double farthest(const Body& body, const BrakeLine& from, const Vec2& away) {
  double far = 0.0;
  for (const Convex& piece : body.pieces)
    for (const Vec2& p : piece)
      far = std::max(far, away.dot(p - from.origin));
  return far;
}

/// How far from a line a body ends, or the next bend begins.
double plane_until(const Workpiece& work, int body, int line) {
  const BrakeLine& near = work.lines[line];
  const Vec2 away = away_from(near, body);
  double far = farthest(work.bodies[body], near, away);
  for (const int number : other_lines(work, body, line)) {
    const BrakeLine& other = work.lines[number];
    far = std::min(far, away.dot(other.origin - near.origin) - half_zone(other));
  }
  return far;
}

void move(FreeEdge& edge, const Vec2& by) {
  edge.a += by;
  edge.b += by;
}

void move(Body& body, const Vec2& by) {
  for (Convex& piece : body.pieces)
    piece = moved(std::move(piece), by);
  for (FreeEdge& edge : body.edges)
    move(edge, by);
}

/// Takes out what lies between two distances from a line and closes the gap.
void take_out(Body& body, const BrakeLine& line, const Vec2& away, const Interval& strip) {
  const Vec2 back = -(strip.hi - strip.lo) * away;
  const double at = away.dot(line.origin);
  std::vector<Convex> pieces;
  for (const Convex& piece : body.pieces) {
    Convex near = clipped(piece, away, at + strip.lo),
           far = moved(clipped(piece, -away, -at - strip.hi), back);
    for (Convex* kept : {&near, &far})
      if (kept->size() > 2) pieces.push_back(std::move(*kept));
  }
  body.pieces = std::move(pieces);
  for (FreeEdge& edge : body.edges)
    for (Vec2* p : {&edge.a, &edge.b})
      if (away.dot(*p) - at > strip.lo)
        *p += std::min(1.0, (away.dot(*p) - at - strip.lo) / (strip.hi - strip.lo)) * back;
}

/// Opens a gap at that height along `away` and fills it with what is cut there, drawn out.
void put_in(Body& body, const Vec2& away, double at, double by) {
  const Vec2 out = by * away;
  std::vector<Convex> pieces;
  for (const Convex& piece : body.pieces) {
    Convex near = clipped(piece, away, at), far = moved(clipped(piece, -away, -at), out);
    if (near.size() > 2 && far.size() > 2) {
      Convex cut = near;
      std::erase_if(cut, [&](const Vec2& p) { return away.dot(p) < at - kAlike; });
      Convex strip = cut;
      for (const Vec2& p : cut)
        strip.push_back(p + out);
      pieces.push_back(hull_of(std::move(strip)));
    }
    for (Convex* kept : {&near, &far})
      if (kept->size() > 2) pieces.push_back(std::move(*kept));
  }
  body.pieces = std::move(pieces);
  for (FreeEdge& edge : body.edges)
    for (Vec2* p : {&edge.a, &edge.b})
      if (away.dot(*p) > at) *p += out;
}

/// Moves what hangs on a body away from a line, as `work` has it.
void move_beyond(Workpiece& made, const Workpiece& work, int body, int line, const Vec2& by) {
  const std::vector<bool> reached = reached_from(work, body, line);
  for (int i = 0; i < std::ssize(work.bodies); ++i)
    if (reached[i] && i != body) move(made.bodies[i], by);
  for (int i = 0; i < std::ssize(work.lines); ++i) {
    if (is_same(work, i, line) || !reached[work.lines[i].bodies[0]]) continue;
    made.lines[i].origin += by;
    for (FreeEdge& edge : made.zones[i].edges)
      move(edge, by);
  }
}

}  // namespace

double most_shorter(const Workpiece& work, int body, int line) {
  constexpr double kLeft = 0.5;  // mm of the flange
  if (!can_lengthen(work, body, line)) return 0.0;
  const BrakeLine& near = work.lines[line];
  return std::max(0.0, plane_until(work, body, line) - half_zone(near) - kLeft);
}

Workpiece shortened(const Workpiece& work, int body, int line, double by) {
  Workpiece made = work;
  const BrakeLine& near = work.lines[line];
  const Vec2 away = away_from(near, body);
  const bool is_end = other_lines(work, body, line).empty();
  const double far = farthest(work.bodies[body], near, away);
  const Interval strip = is_end ? Interval{far - by, far}
                                : Interval{half_zone(near), half_zone(near) + by};
  take_out(made.bodies[body], near, away, strip);
  move_beyond(made, work, body, line, -by * away);
  return made;
}

bool can_lengthen(const Workpiece& work, int body, int line) {
  return std::ranges::all_of(other_lines(work, body, line), [&](int other) {
    return std::abs(cross(work.lines[line].along, work.lines[other].along)) <= kAlike;
  });
}

Workpiece lengthened(const Workpiece& work, int body, int line, double at, double by) {
  constexpr double kBefore = 0.1;  // mm: a border there moves
  Workpiece made = work;
  const BrakeLine& near = work.lines[line];
  const Vec2 away = away_from(near, body);
  put_in(made.bodies[body], away, away.dot(near.origin) + at - kBefore, by);
  move_beyond(made, work, body, line, by * away);
  return made;
}

std::vector<ChangedBody> bodies_to_change(const Workpiece& work, int body, int line) {
  const PartTree tree(work, line);
  std::vector<ChangedBody> bodies;
  const auto add = [&](const PartTree::Part& part) {
    if (!part.is_zone && part.over >= 0) bodies.push_back({part.index, part.over});
  };
  for (int part = tree.part_of_body(body); part >= 0; part = tree.parts()[part].before)
    add(tree.parts()[part]);
  for (const PartTree::Part& part : tree.parts())
    add(part);
  return bodies;
}

bool is_web(const Workpiece& work, const ChangedBody& one) {
  return can_lengthen(work, one.body, one.near) && !other_lines(work, one.body, one.near).empty();
}

Workpiece widened(const Workpiece& work, const ChangedBody& web, double by) {
  const BrakeLine& near = work.lines[web.near];
  return lengthened(work, web.body, web.near,
                    0.5 * (half_zone(near) + plane_until(work, web.body, web.near)), by);
}

std::array<Workpiece, 2> split_at(const Workpiece& work, int line) {
  std::array<Workpiece, 2> halves;
  for (const size_t side : {size_t{0}, size_t{1}}) {
    Workpiece& half = halves[side];
    half.thickness = work.thickness;
    const std::vector<bool> reached = reached_from(work, work.lines[line].bodies[side], line);
    std::vector<int> body_number(work.bodies.size(), -1), line_number(work.lines.size(), -1);
    for (int i = 0; i < std::ssize(work.bodies); ++i) {
      if (!reached[i]) continue;
      body_number[i] = static_cast<int>(half.bodies.size());
      half.bodies.push_back(work.bodies[i]);
    }
    for (int i = 0; i < std::ssize(work.lines); ++i) {
      if (is_same(work, i, line) || !reached[work.lines[i].bodies[0]]) continue;
      line_number[i] = static_cast<int>(half.lines.size());
      half.lines.push_back(work.lines[i]);
      half.zones.push_back(work.zones[i]);
    }
    for (BrakeLine& kept : half.lines) {
      for (int& body : kept.bodies)
        body = body_number[body];
      for (std::optional<int>* other : {&kept.closes, &kept.closed_by})
        if (*other) *other = line_number[**other];
    }
  }
  return halves;
}

}  // namespace planish::brake_detail
