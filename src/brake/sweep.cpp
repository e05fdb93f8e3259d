// Whether a part of the sheet meets a tool at any turn. An interval of turns is proven clear if in
// its middle the distance exceeds what part and tool can move in half of it, else it is halved,
// down to `kFollowed`. A part that reaches far is halved first: what is near the bend line comes
// near the tools but is slow, what is fast is far away. Along the line the same is asked of slices:
// a stroke keeps x, so where a block is in the way is found by halving x. What must hold: the
// speeds bound the motion (math.md#stroke-clearance).
#include "sweep.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>

namespace planish::brake_detail {
namespace {

constexpr double kAlong = 0.01;  // mm: how well the ends of a blocked stretch are found

/// At most the distance of what is in the boxes; below 0 if they overlap.
double apart(const Box2& a, const Box2& b) {
  const double x = std::max(a.lo.x() - b.hi.x(), b.lo.x() - a.hi.x()),
               y = std::max(a.lo.y() - b.hi.y(), b.lo.y() - a.hi.y());
  return std::max(x, y);
}

/// A lower bound of the distance from the obstacle, less what is kept; at most 0 only if the part
/// is too near. Exact below `enough`, where something is kept.
double margin(const Convex& part, const Obstacle& obstacle, double enough) {
  const Box2 box = box_of(part);
  double least = apart(box, obstacle.box) - obstacle.keep;
  if (least > enough) return least;
  least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < obstacle.pieces.size(); ++i) {
    const double keep = obstacle.keeps[i];
    double gap = apart(box, obstacle.boxes[i]) - keep;
    if (gap <= 0.0 || gap < enough) {
      gap = std::max(gap, separation(part, obstacle.pieces[i]) - keep);
      if (gap <= 0.0 && keep > 0.0) gap = distance(part, obstacle.pieces[i]) - keep;
    }
    least = std::min(least, gap);
    if (least <= 0.0) return least;
  }
  return least;
}

Convex relative(const PressMotion& motion, const Moving& part, const Obstacle& obstacle,
                double turn) {
  Convex section = part.at(turn);
  if (!obstacle.moves) return section;
  const double down = motion.die_height(turn);
  for (Vec2& p : section)
    p.y() -= down;
  return section;
}

/// A proof by halves: what is farther away in the middle than it can move to either end is clear
/// in between.
class Proof {
 public:
  Proof(const PressMotion& motion, const Moving& part, const Obstacle& obstacle)
      : motion_(motion), part_(part), obstacle_(obstacle) {}

  std::optional<double> hit(double from, double to) const {
    const double half = 0.5 * (to - from), middle = from + half;
    const double moved = half * speed(to);
    const double gap = margin(relative(motion_, part_, obstacle_, middle), obstacle_, moved);
    if (gap <= 0.0) return middle;
    if (gap > moved || moved < kFollowed) return std::nullopt;
    const std::vector<Moving> halves = part_.halves ? part_.halves() : std::vector<Moving>();
    for (const Moving& half_of_it : halves)
      if (const auto turn = Proof(motion_, half_of_it, obstacle_).hit(from, to)) return turn;
    if (!halves.empty()) return std::nullopt;
    if (const auto late = hit(middle, to)) return late;
    return hit(from, middle);
  }

 private:
  double speed(double turn) const {
    return part_.speed(turn) + (obstacle_.moves ? motion_.die_speed(turn) : 0.0);
  }
  const PressMotion& motion_;
  const Moving& part_;
  const Obstacle& obstacle_;
};

bool too_near(const PressMotion& motion, const Moving& part, const Obstacle& obstacle,
              double turn) {
  return margin(relative(motion, part, obstacle, turn), obstacle, 0.0) <= 0.0;
}

/// A polygon cut across its longer side where one half then stays less than half as far from a
/// point as the other; empty if there is no such half.
std::vector<Convex> halves_of(const Convex& section, const Vec2& from) {
  constexpr double kShort = 2.0;    // mm: halving turns is as good
  constexpr double kSlower = 0.45;  // or where even the nearest is about as fast
  const Box2 box = box_of(section);
  const Vec2 size = box.hi - box.lo;
  const int axis = size.x() >= size.y() ? 0 : 1;
  const double near = std::max(box.lo[axis] - from[axis], from[axis] - box.hi[axis]),
               far = std::max(box.hi[axis] - from[axis], from[axis] - box.lo[axis]);
  if (far < kShort || near > kSlower * far || size[axis] < kShort) return {};
  const bool upward = box.hi[axis] - from[axis] >= from[axis] - box.lo[axis];
  const double at = from[axis] + (upward ? 0.5 : -0.5) * far;
  if (at <= box.lo[axis] || at >= box.hi[axis]) return {};
  Vec2 normal = Vec2::Zero();
  normal[axis] = 1.0;
  std::vector<Convex> halves;
  for (Convex half : {clipped(section, normal, at), clipped(section, -normal, -at)})
    if (half.size() > 2) halves.push_back(std::move(half));
  return halves.size() == 2 ? halves : std::vector<Convex>();
}

/// Finds where along x a block is blocked. Its motion keeps x, so every x is a problem of its own;
/// what two sections meet at one turn in one convex piece, all sections between them meet.
class BlockSearch {
 public:
  BlockSearch(const PressMotion& motion, const Block3& block, const Obstacle& obstacle, double most)
      : motion_(motion), block_(block), obstacle_(obstacle), most_(most) {}

  std::optional<double> hit_between(double lo, double hi) const {
    const Convex part = section(block_, lo, hi);
    if (part.empty()) return std::nullopt;
    return hit(motion_, turned_with_side(motion_, part), obstacle_, most_);
  }
  bool blocked_throughout(const Interval& range, double turn) const {
    const Convex lo = section(block_, range.lo, range.lo), hi = section(block_, range.hi, range.hi);
    if (lo.empty() || hi.empty()) return false;
    const Convex at_lo = relative(motion_, turned_with_side(motion_, lo), obstacle_, turn),
                 at_hi = relative(motion_, turned_with_side(motion_, hi), obstacle_, turn);
    for (size_t i = 0; i < obstacle_.pieces.size(); ++i)
      if (meets(at_lo, i) && meets(at_hi, i)) return true;
    return false;
  }
  /// The first blocked place from the low end, or from the high end; `turn`: where some place is.
  std::optional<double> first(double lo, double hi, bool from_low, double turn) const {
    if (blocked_at(from_low ? lo : hi, turn)) return from_low ? lo : hi;
    const auto found = hit_between(lo, hi);
    if (!found) return std::nullopt;
    if (hi - lo < kAlong) return from_low ? lo : hi;
    const double middle = 0.5 * (lo + hi);
    const auto near = from_low ? first(lo, middle, true, *found) : first(middle, hi, false, *found);
    if (near) return near;
    return from_low ? first(middle, hi, true, *found) : first(lo, middle, false, *found);
  }

 private:
  bool blocked_at(double x, double turn) const {
    const Convex part = section(block_, x, x);
    return !part.empty() && too_near(motion_, turned_with_side(motion_, part), obstacle_, turn);
  }
  bool meets(const Convex& part, size_t i) const {
    const Convex& piece = obstacle_.pieces[i];
    const double keep = obstacle_.keeps[i];
    return separation(part, piece) <= 0.0 || (keep > 0.0 && distance(part, piece) <= keep);
  }
  const PressMotion& motion_;
  const Block3& block_;
  const Obstacle& obstacle_;
  double most_;
};

}  // namespace

Moving turned_with_side(const PressMotion& motion, const Convex& section) {
  return {[&motion, section](double turn) { return motion.side(section, turn); },
          [&motion, section](double turn) { return motion.side_speed(section, turn); },
          [&motion, section]() {
            return mapped(halves_of(section, Vec2(0.5 * motion.bend().allowance, 0.0)),
                          [&](const Convex& half) { return turned_with_side(motion, half); });
          }};
}

Moving bent(const PressMotion& motion, double from, double to) {
  return {[&motion, from, to](double turn) { return motion.arc(from, to, turn); },
          [&motion](double turn) { return motion.arc_speed(turn); }};
}

std::optional<double> hit(const PressMotion& motion, const Moving& part, const Obstacle& obstacle,
                          double most) {
  if (obstacle.pieces.empty()) return std::nullopt;
  if (too_near(motion, part, obstacle, most)) return most;
  if (most == 0.0) return std::nullopt;
  if (too_near(motion, part, obstacle, 0.0)) return 0.0;
  return Proof(motion, part, obstacle).hit(0.0, most);
}

Closest closest(const PressMotion& motion, const Moving& part, const Obstacle& obstacle,
                double most, double most_asked) {
  // What slides along a tool is as near at every turn: the last digits would be most of the work.
  Closest best{most_asked, 0.0};
  // Exact below `enough`, a lower bound above.
  const auto gap_at = [&](double turn, double enough) {
    const Convex section = relative(motion, part, obstacle, turn);
    const Box2 box = box_of(section);
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < obstacle.pieces.size(); ++i) {
      const double away = apart(box, obstacle.boxes[i]);
      least = std::min(least, away >= enough ? away : distance(section, obstacle.pieces[i]));
    }
    return least;
  };
  const auto look = [&](double turn, double moved) {
    const double gap = gap_at(turn, best.distance + moved);
    if (gap < best.distance) best = {gap, turn};
    return gap;
  };
  const auto search = [&](const auto& self, double from, double to) -> void {
    const double half = 0.5 * (to - from);
    const double moved = half * (part.speed(to) + (obstacle.moves ? motion.die_speed(to) : 0.0));
    const double gap = look(from + half, moved);
    if (gap - moved >= best.distance || moved < kMeasured) return;
    self(self, from + half, to);
    self(self, from, from + half);
  };
  if (obstacle.pieces.empty()) return best;
  look(most, 0.0);
  look(0.0, 0.0);
  search(search, 0.0, most);
  return best;
}

std::vector<Interval> blocked_along(const PressMotion& motion, const PlacedPart& part,
                                    const Obstacle& left, const Obstacle& right, double most,
                                    const Interval& within) {
  const auto outside = [&](const Interval& range) {
    return range.hi < within.lo || range.lo > within.hi;
  };
  std::vector<Interval> blocked;
  for (const ArcStrip& strip : part.strips)
    if (!outside(strip.along) &&
        hit(motion, bent(motion, strip.from, strip.to), strip.left ? left : right, most))
      blocked.push_back(strip.along);
  if (part.blocks.empty() || outside(part.along)) return joined(std::move(blocked), kAlong);
  const Obstacle& obstacle = part.left ? left : right;
  if (!hit(motion, turned_with_side(motion, part.hull), obstacle, most)) return blocked;
  for (size_t i = 0; i < part.blocks.size(); ++i) {
    const Interval whole = extent(part.blocks[i]);
    if (outside(whole)) continue;
    const auto turn = hit(motion, turned_with_side(motion, part.sections[i]), obstacle, most);
    if (!turn) continue;
    const BlockSearch search(motion, part.blocks[i], obstacle, most);
    if (search.blocked_throughout(whole, *turn)) {
      blocked.push_back(whole);
      continue;
    }
    const Interval range{std::max(whole.lo, within.lo), std::min(whole.hi, within.hi)};
    const auto lo = search.first(range.lo, range.hi, true, *turn);
    const auto hi = lo ? search.first(*lo, range.hi, false, *turn) : std::nullopt;
    if (lo && hi) blocked.push_back({*lo, *hi});
  }
  return joined(std::move(blocked), kAlong);
}

std::optional<double> hit_within(const PressMotion& motion, const PlacedPart& part,
                                 const Obstacle& left, const Obstacle& right, const Interval& along,
                                 double most) {
  for (const ArcStrip& strip : part.strips)
    if (strip.along.lo < along.hi && strip.along.hi > along.lo)
      if (const auto turn = hit(motion, bent(motion, strip.from, strip.to),
                                strip.left ? left : right, most))
        return turn;
  const Obstacle& obstacle = part.left ? left : right;
  const bool clear = part.blocks.empty() ||
                     !hit(motion, turned_with_side(motion, part.hull), obstacle, most);
  if (clear) return std::nullopt;
  for (const Block3& block : part.blocks)
    if (const auto turn = BlockSearch(motion, block, obstacle, most)
                              .hit_between(along.lo, along.hi))
      return turn;
  return std::nullopt;
}

}  // namespace planish::brake_detail
