// Whether the plane sides bear the die. A side goes from the bend line to the border or the next
// formed bend; it counts as it is along half of the line (the median of `kLooksAtFlange` places).
// The shoulder's contact wanders as the sheet turns: its range is found by halving turns until the
// bound of its speed leaves nothing (math.md#stroke, math.md#tool-fit). What must hold: how far a
// side goes depends on the formed lines that end it alone, so each of the lines that are pressed
// together is looked along from its own side: on the way from one to the other lines may be formed.
#include "plane_side.hpp"

#include "one_line.hpp"

#include <planish/base/assert.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>

namespace planish::brake_detail {
namespace {

constexpr double kLongEnough = 1e-3;     // mm: of a flange, for rounding of what is drawn
constexpr int kLooksAtFlange = 81;       // along a bend line, over all its pieces
constexpr double kSlight = 30.0;         // degrees at a press line: the shoulder bears them
constexpr double kTouchingParts = 1e-3;  // mm: neighbouring faces as they were laid out

/// Middles of equal shares of the pieces' common length.
std::vector<double> looks_along(const std::vector<Interval>& pieces) {
  const double length = total(pieces);
  std::vector<double> looks;
  double before = 0.0;
  for (const Interval& piece : pieces) {
    const double after = before + piece.hi - piece.lo;
    for (auto i = std::ssize(looks); i < kLooksAtFlange; ++i) {
      const double at = (static_cast<double>(i) + 0.5) / kLooksAtFlange * length;
      if (at > after) break;
      looks.push_back(piece.lo + at - before);
    }
    before = after;
  }
  return looks;
}

/// Formed lines that end a plane side: the die's shoulder also bears what a press line has turned a
/// little.
LineSet without_slight(const StrokeInputs& inputs, const LineSet& formed) {
  LineSet sharp = no_lines(inputs.lines());
  for (const int line : members(formed)) {
    const BrakeLine& one = inputs.work.lines[line];
    if (!one.press_line || one.angle.degrees() > kSlight) insert(sharp, line);
  }
  return sharp;
}

/// Which formed lines end the plane sides on one side of the line.
LineSet limits_of(StageCache& cache, const Setting& stroke, bool left) {
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<const PlacedPart*>& parts = cache.parts(stroke);
  LineSet limits = no_lines(cache.inputs().lines());
  for (const PartTree::Part& part : tree.parts())
    if (part.is_zone && part.before >= 0 && parts[part.before]->left == left &&
        holds(*stroke.formed, part.index) && parts[part.before]->flat)
      insert(limits, part.index);
  return limits;
}

/// How far material goes on from the bend line at one place along it.
double reach_at(const std::vector<const PlacedPart*>& flat, bool left, double x) {
  std::vector<Interval> material;
  for (const PlacedPart* part : flat) {
    for (const ArcStrip& strip : part->strips)
      if (strip.left == left && strip.along.lo <= x && x <= strip.along.hi)
        material.push_back({strip.from, strip.to});
    for (size_t k = 0; k < part->blocks.size() && part->left == left; ++k) {
      const Convex cut = section(part->blocks[k], x, x);
      if (cut.empty()) continue;
      const Box2 box = box_of(cut);
      material.push_back({box.lo.x(), box.hi.x()});
    }
  }
  double far = 0.0;
  for (const Interval& run : joined(std::move(material), kTouchingParts))
    if (run.lo <= far + kTouchingParts) far = std::max(far, run.hi);
  return far;
}

double measured_reach(StageCache& cache, const Setting& stroke, bool left) {
  std::vector<const PlacedPart*> flat;
  for (const PlacedPart* part : cache.parts(stroke))
    if (part->flat) flat.push_back(part);
  auto reaches = mapped(looks_along(pressed_pieces(cache, stroke)),
                        [&](double x) { return reach_at(flat, left, x); });
  const auto middle = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
  std::nth_element(reaches.begin(), middle, reaches.end());
  return *middle;
}

Interval measured_contact(const PressMotion& motion, double most) {
  Interval range{motion.contact(0.0), motion.contact(0.0)};
  const auto look = [&](const auto& self, double from, double to) -> void {
    const double half = 0.5 * (to - from), moved = half * motion.contact_speed(to);
    const double at = motion.contact(from + half);
    const bool inside = at + moved <= range.hi && at - moved >= range.lo;
    range = {std::min(range.lo, at), std::max(range.hi, at)};
    if (inside || moved < kLongEnough) return;
    self(self, from, from + half);
    self(self, from + half, to);
  };
  look(look, 0.0, most);
  return range;
}

double side_on(double opening, double shoulder_radius, const Interval& contact) {
  return std::max(0.5 * opening + shoulder_radius, contact.hi);
}

bool touches_bend(const Interval& contact, const PressedBend& bend) {
  return contact.lo < 0.5 * bend.allowance - kLongEnough;
}

}  // namespace

double reach(StageCache& cache, const Setting& stroke, bool left) {
  PLANISH_ASSERT(count(stroke.pressed) == 1);
  const LineSet sharp = without_slight(cache.inputs(), *stroke.formed);
  Setting seen = stroke;
  seen.formed = &sharp;
  return cache.reach(stroke.line, left, limits_of(cache, seen, left),
                     [&] { return measured_reach(cache, seen, left); });
}

double needed_side(const StrokeInputs& inputs, int line, const Die& die, double narrower) {
  const PressedBend& bend = inputs.work.lines[line].bend;
  Shoulder shoulder = shoulder_of(die);
  shoulder.across -= 0.5 * narrower;
  const Interval contact = measured_contact({bend, shoulder}, most_turn(inputs, line));
  if (touches_bend(contact, bend)) return kEverywhere.hi;
  return side_on(die.opening - narrower, die.shoulder_radius, contact);
}

Interval contact_range(StageCache& cache, int line, int die) {
  const StrokeInputs& inputs = cache.inputs();
  return cache.contact(line, die, [&] {
    const PressMotion motion(inputs.work.lines[line].bend, shoulder_of(inputs.tools.dies[die]));
    return measured_contact(motion, most_turn(inputs, line));
  });
}

std::optional<Obstruction> too_short(StageCache& cache, const Setting& stroke) {
  const StrokeInputs& inputs = cache.inputs();
  const BrakeLine& line = inputs.work.lines[stroke.line];
  const Die& die = inputs.tools.dies[stroke.die];
  const Interval contact = contact_range(cache, stroke.line, stroke.die);
  if (touches_bend(contact, line.bend))
    return Obstruction{no_lines(inputs.lines()),
                       ToolKind::die,
                       -1,
                       {Lack::Kind::plane_sides, line.bend.allowance}};
  const double needed = side_on(die.opening, die.shoulder_radius, contact);
  Setting one = stroke;
  for (const int pressed : members(stroke.pressed)) {
    one.line = pressed;
    one.pressed = only(inputs.lines(), pressed);
    const double far_right = reach(cache, one, false), far_left = reach(cache, one, true);
    const bool left = far_left < far_right;
    const double far = std::min(far_right, far_left);
    if (far >= needed - kLongEnough) continue;
    const int body = cache.tree(pressed).parts()[left ? 1 : 0].index;
    return Obstruction{limits_of(cache, one, left),
                       ToolKind::die,
                       cache.tree(stroke.line).part_of_body(body),
                       {Lack::Kind::reach, far, needed}};
  }
  return std::nullopt;
}

}  // namespace planish::brake_detail
