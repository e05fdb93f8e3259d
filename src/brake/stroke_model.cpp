#include "stroke_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kSameLine = 1e-3;              // mm, and radians: lines that are pressed together
constexpr double kSameWay = 1e-3;               // of unit vectors: one direction of the gauge
constexpr double kLongEnough = 1e-3;            // mm: of a flange, for rounding of what is drawn
constexpr int kLooksAtFlange = 81;              // along a bend line, over all its pieces
constexpr double kTouchingParts = 1e-3;         // mm: neighbouring faces as they were laid out
constexpr std::size_t kMostBlocks = 1'500'000;  // of parts that are known: 1 GB

/// Middles of equal shares of the pieces' common length.
std::vector<double> looks_along(const std::vector<Interval>& pieces) {
  double length = 0.0;
  for (const Interval& piece : pieces)
    length += piece.hi - piece.lo;
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

int first_line(const LineSet& set) {
  int line = 0;
  while (!holds(set, line))
    ++line;
  return line;
}

/// Whether two lines are pieces of one line of the pattern, bent alike.
bool lie_on_one_line(const BrakeLine& a, const BrakeLine& b) {
  const double turned = a.along.x() * b.along.y() - a.along.y() * b.along.x();
  return a.reference_up == b.reference_up && !a.press_line && !b.press_line && !a.closes &&
         !b.closes && std::abs(turned) < kSameLine &&
         std::abs(a.across().dot(b.origin - a.origin)) < kSameLine &&
         std::abs(a.angle.radians() - b.angle.radians()) < kSameLine &&
         std::abs(a.inside_radius - b.inside_radius) < kSameLine;
}

}  // namespace

StrokeModel::StrokeModel(Workpiece work, const BrakeTools& tools, const PlanOptions& options,
                         std::shared_ptr<ToolRoom> obstacles)
    : work_(std::move(work)),
      tools_(tools),
      options_(options),
      room_of_tools_(obstacles ? std::move(obstacles)
                               : std::make_shared<ToolRoom>(tools, options.clearance)),
      rooms_(work_.lines.size()),
      on_one_line_(work_.lines.size()) {
  for (const Punch& punch : tools.punches)
    punch_segments_.emplace_back(punch.segments);
  for (const Die& die : tools.dies)
    die_segments_.emplace_back(die.segments);
  for (int i = 0; i < std::ssize(work_.lines); ++i) {
    const BrakeLine& line = work_.lines[i];
    fitting_.push_back(fitting_tools(line, tools, options));
    for (const Vec2& way : {line.across(), Vec2(-line.across())})
      if (direction_number(way) < 0) directions_.push_back(way);
    for (int j = 0; j < std::ssize(work_.lines); ++j)
      if (i == j || lie_on_one_line(line, work_.lines[j])) on_one_line_[i].push_back(j);
  }
}

int StrokeModel::direction_number(const Vec2& direction) const {
  for (int i = 0; i < std::ssize(directions_); ++i)
    if ((directions_[i] - direction).norm() < kSameWay) return i;
  return -1;
}

/// A hem is closed where it was bent.
StrokeModel::LineRoom& StrokeModel::room(int line) {
  if (work_.lines[line].closes) line = *work_.lines[line].closes;
  if (!rooms_[line]) {
    rooms_[line] = std::make_unique<LineRoom>(LineRoom{PartTree(work_, line)});
    LineRoom& made = *rooms_[line];
    made.at_line.resize(made.tree.parts().size());
    made.beyond.fill(no_lines(static_cast<int>(work_.lines.size())));
    for (const PartTree::Part& part : made.tree.parts())
      if (part.before >= 0) insert(made.beyond[part.left ? 1 : 0], part.over);
  }
  return *rooms_[line];
}

/// Forgets what parts hit when it is more than memory holds; it is found again where it is needed.
void StrokeModel::forget_if_many() {
  if (blocks_known_ < kMostBlocks) return;
  blocks_known_ = 0;
  for (const auto& room : rooms_) {
    if (!room) continue;
    room->parts.clear();
    for (auto& known : room->at_line)
      known.reset();
  }
}

/// What is known of each part in a stage. A part's place follows from that of the body it hangs on
/// and from how the line between them is.
const std::vector<StrokeModel::Known*>& StrokeModel::parts_in(const Setting& stroke) {
  LineRoom& room = this->room(stroke.line);
  if (!room.parts.empty() && room.formed == *stroke.formed && room.pressed == stroke.pressed)
    return room.parts;
  forget_if_many();
  room.formed = *stroke.formed;
  room.pressed = stroke.pressed;
  room.parts.clear();
  for (int i = 0; i < std::ssize(room.tree.parts()); ++i) {
    const PartTree::Part& part = room.tree.parts()[i];
    std::unique_ptr<Known>* known = &room.at_line[i];
    PartTree::State over = PartTree::State::flat;
    Known* before = part.before >= 0 ? room.parts[part.before] : nullptr;
    if (before) {
      over = room.tree.state(part.over, *stroke.formed, stroke.pressed);
      known = &before->hanging[part.slot][static_cast<size_t>(over)];
    }
    if (!*known) {
      *known = std::make_unique<Known>(
          Known{room.tree.placed(i, before ? &before->placed : nullptr, over)});
      (*known)->hanging.resize(room.tree.hanging(i));
      blocks_known_ += (*known)->placed.blocks.size() + (*known)->placed.strips.size();
    }
    room.parts.push_back(known->get());
  }
  return room.parts;
}

PressMotion StrokeModel::motion(const Setting& stroke) const {
  return {work_.lines[stroke.line].bend, shoulder_of(tools_.dies[stroke.die])};
}

double StrokeModel::most_turn(int line) const {
  return work_.lines[line].angle.radians() + options_.springback.radians();
}

double StrokeModel::shortfall() const { return options_.shortfall.value_or(work_.thickness); }

StrokeModel::Setting StrokeModel::setting(const LineSet& formed, const StrokeChoice& choice) const {
  Setting stroke{&formed, choice.lines, first_line(choice.lines), choice.punch, choice.die, 1};
  const Vec2 left = work_.lines[stroke.line].across();
  if (directions_[choice.direction].dot(left) < 0.0) stroke.direction = -1;
  return stroke;
}

/// The lines that continue a line in a stage, itself included.
std::vector<int> StrokeModel::together(int line, const LineSet& formed) {
  std::vector<int> lines;
  if (work_.lines[line].closes) return {line};
  const PartTree& tree = room(line).tree;
  for (const int other : on_one_line_[line]) {
    if (holds(formed, other)) continue;
    const BrakeLine& seen = work_.lines[other];
    const Eigen::Isometry3d at = tree.place(tree.part_of_body(seen.bodies[0]), formed);
    const Vec3 origin = at * Vec3(seen.origin.x(), seen.origin.y(), 0.0);
    const Vec3 along = at.linear() * Vec3(seen.along.x(), seen.along.y(), 0.0);
    const bool same = std::abs(origin.y()) < kSameLine &&
                      std::abs(origin.z() + 0.5 * work_.thickness) < kSameLine &&
                      std::abs(std::abs(along.x()) - 1.0) < kSameLine * kSameLine &&
                      std::abs(at.linear()(2, 2)) > 0.5;
    if (same) lines.push_back(other);
  }
  return lines;
}

std::vector<StrokeChoice> StrokeModel::choices(const LineSet& formed) {
  std::vector<StrokeChoice> all;
  const auto add = [&](const std::vector<int>& lines) {
    StrokeChoice choice;
    choice.lines = no_lines(static_cast<int>(work_.lines.size()));
    for (const int line : lines)
      insert(choice.lines, line);
    const BrakeLine& first = work_.lines[lines.front()];
    const FittingTools& fitting = fitting_[lines.front()];
    choice.reference_up = first.reference_up;
    for (const int direction : {1, -1}) {
      choice.direction = direction_number(direction * first.across());
      bool is_known = false;
      for (const int punch : fitting.punches)
        for (const int die : fitting.dies) {
          choice.punch = punch;
          choice.die = die;
          if (!is_known) choice.gauged = first.closes || gauge(setting(formed, choice)).has_value();
          is_known = true;
          all.push_back(choice);
        }
    }
  };
  for (int line = 0; line < std::ssize(work_.lines); ++line) {
    const auto& closes = work_.lines[line].closes;
    if (holds(formed, line) || (closes && !holds(formed, *closes))) continue;
    const std::vector<int> lines = together(line, formed);
    if (lines.front() == line) add(lines);
    if (lines.size() > 1) add({line});
  }
  return all;
}

/// Only lines that continue each other in the pattern are ever pressed together.
std::vector<StrokeChoice> StrokeModel::possible() const {
  std::vector<StrokeChoice> all;
  for (int line = 0; line < std::ssize(work_.lines); ++line) {
    if (on_one_line_[line].front() != line) continue;
    StrokeChoice choice;
    choice.lines = no_lines(static_cast<int>(work_.lines.size()));
    for (const int other : on_one_line_[line])
      insert(choice.lines, other);
    choice.reference_up = work_.lines[line].reference_up;
    for (const int other : on_one_line_[line])
      for (const int direction : {1, -1})
        for (const int punch : fitting_[line].punches)
          for (const int die : fitting_[line].dies) {
            choice.punch = punch;
            choice.die = die;
            choice.direction = direction_number(direction * work_.lines[other].across());
            all.push_back(choice);
          }
  }
  return all;
}

bool StrokeModel::is_outermost(const LineSet& formed, const StrokeChoice& choice) {
  const LineSet done = joined(formed, choice.lines);
  return std::ranges::all_of(members(choice.lines), [&](int line) {
    const auto& beyond = room(line).beyond;
    return within(beyond[0], done) || within(beyond[1], done);
  });
}

/// Pieces of the bend line along x, from the lowest on.
std::vector<Interval> StrokeModel::pressed_pieces(const Setting& stroke) {
  const PartTree& tree = room(stroke.line).tree;
  std::vector<Interval> pieces;
  for (const int number : on_one_line_[stroke.line]) {
    if (!holds(stroke.pressed, number)) continue;
    const BrakeLine& line = work_.lines[number];
    const Eigen::Isometry3d at = tree.place(tree.part_of_body(line.bodies[0]), *stroke.formed);
    for (const Interval& piece : line.pieces) {
      const Vec2 a = line.origin + piece.lo * line.along, b = line.origin + piece.hi * line.along;
      const double lo = (at * Vec3(a.x(), a.y(), 0.0)).x(), hi = (at * Vec3(b.x(), b.y(), 0.0)).x();
      pieces.push_back({std::min(lo, hi), std::max(lo, hi)});
    }
  }
  return joined(std::move(pieces), 0.0);
}

/// Which formed lines end the plane sides on one side of the line.
LineSet StrokeModel::limits_of(const Setting& stroke, bool left) {
  const PartTree& tree = room(stroke.line).tree;
  const std::vector<Known*>& known = parts_in(stroke);
  LineSet limits = no_lines(static_cast<int>(work_.lines.size()));
  for (const PartTree::Part& part : tree.parts())
    if (part.is_zone && part.before >= 0 && known[part.before]->placed.left == left &&
        holds(*stroke.formed, part.index) && known[part.before]->placed.flat)
      insert(limits, part.index);
  return limits;
}

double StrokeModel::reach(const Setting& stroke, bool left) {
  LineSet key = limits_of(stroke, left);
  key.insert(key.end(), stroke.pressed.begin(), stroke.pressed.end());
  auto& reaches = room(stroke.line).reaches[left ? 1 : 0];
  const auto found = reaches.find(key);
  if (found != reaches.end()) return found->second;
  return reaches[std::move(key)] = measured_reach(stroke, left);
}

/// How far the plane side goes from the bend line: as far as it does along half of the line.
double StrokeModel::measured_reach(const Setting& stroke, bool left) {
  std::vector<const PlacedPart*> flat;
  for (const Known* known : parts_in(stroke))
    if (known->placed.flat) flat.push_back(&known->placed);
  std::vector<double> reaches;
  for (const double x : looks_along(pressed_pieces(stroke))) {
    std::vector<Interval> material;
    for (const PlacedPart* part : flat) {
      for (const ArcStrip& strip : part->strips)
        if (strip.left == left && strip.along.lo <= x && x <= strip.along.hi)
          material.push_back({strip.from, strip.to});
      for (size_t k = 0; k < part->blocks.size() && part->left == left; ++k) {
        const Convex cut = section(part->blocks[k], x, x);
        if (cut.empty()) continue;
        Box2 box;
        for (const Vec2& p : cut)
          box.add(p);
        material.push_back({box.lo.x(), box.hi.x()});
      }
    }
    double far = 0.0;
    for (const Interval& run : joined(std::move(material), kTouchingParts))
      if (run.lo <= far + kTouchingParts) far = std::max(far, run.hi);
    reaches.push_back(far);
  }
  const auto middle = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 2);
  std::nth_element(reaches.begin(), middle, reaches.end());
  return *middle;
}

/// Where the shoulder touches the sides, from the bend line, over all turns.
Interval StrokeModel::contact_range(int line, int die) {
  const int key = line * static_cast<int>(tools_.dies.size()) + die;
  const auto found = contact_ranges_.find(key);
  if (found != contact_ranges_.end()) return found->second;
  const PressMotion motion(work_.lines[line].bend, shoulder_of(tools_.dies[die]));
  const double most = most_turn(line);
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
  return contact_ranges_[key] = range;
}

/// Whether the plane sides are long enough for the die, at every turn.
std::optional<StrokeModel::Obstruction> StrokeModel::too_short(const Setting& stroke) {
  const BrakeLine& line = work_.lines[stroke.line];
  const Die& die = tools_.dies[stroke.die];
  const Interval contact = contact_range(stroke.line, stroke.die);
  if (contact.lo < 0.5 * line.bend.allowance - kLongEnough)
    return Obstruction{no_lines(static_cast<int>(work_.lines.size())), ToolKind::die, -1,
                       fmt::format("the shoulders of die {} would touch the bend, {:.4g} mm wide, "
                                   "and not the plane sides",
                                   die.id, line.bend.allowance)};
  const double needed = std::max(0.5 * die.opening + die.shoulder_radius, contact.hi);
  for (const bool left : {false, true}) {
    const double far = reach(stroke, left);
    if (far >= needed - kLongEnough) continue;
    const double opening = 2.0 * (far - die.shoulder_radius);
    const std::string help = opening > 0.0
                                 ? fmt::format("a V of {:.4g} mm or less would take it", opening)
                                 : std::string("no V would take it");
    return Obstruction{
        limits_of(stroke, left), std::nullopt, left ? 1 : 0,
        fmt::format("a side is {:.4g} mm from the bend line, and die {} needs {:.4g} "
                    "mm; {}",
                    far, die.id, needed, help)};
  }
  return std::nullopt;
}

StrokeVerdict StrokeModel::check(const LineSet& formed, const StrokeChoice& choice) {
  const Setting stroke = setting(formed, choice);
  if (work_.lines[stroke.line].closes) {
    const auto obstruction = cannot_close(stroke, nullptr);
    return obstruction ? StrokeVerdict{false, obstruction->because} : StrokeVerdict{};
  }
  if (const auto obstruction = too_short(stroke)) return {false, obstruction->because};
  if (const auto obstruction = obstructed(stroke, nullptr)) return {false, obstruction->because};
  return {};
}

}  // namespace planish::brake_detail
