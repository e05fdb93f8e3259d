// Joins neighbouring curves of a loop that are one line or circle within a tolerance, and removes
// those too short to matter. The longest group that one curve replaces is found by doubling and
// halving; where curves go, their neighbours are extended to where they cross. Each result knows
// its first input.

#include "planar.hpp"
#include "recognition.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/fit.hpp>

#include <numbers>
#include <optional>

// Joins what was split: neighbours that are one line or one circle, and curves too short to keep.
// The longest group that one curve replaces is found by doubling and halving, so each curve is
// looked at a logarithmic number of times. Grouping and absorbing alternate until nothing changes,
// each within the tolerance of what it was given, and a loop that would lose its area stays as it
// is. At the end joints are made one point: arcs determine it, the others follow.

namespace planish {
namespace {

using namespace geometry_detail;
using std::numbers::pi;

/// Grouping and absorbing are repeated while they change anything; ordinary loops need two rounds.
constexpr int kMostRounds = 8;

struct Item {
  Curve2 curve;
  int first = 0;  // input it begins with
};
using Items = std::vector<Item>;

enum class Kind { segment, left_arc, right_arc, spline };

Kind kind_of(const Curve2& curve) {
  if (std::holds_alternative<Segment>(curve)) return Kind::segment;
  if (std::holds_alternative<CubicSpline>(curve)) return Kind::spline;
  return std::get<Arc>(curve).sweep > 0.0 ? Kind::left_arc : Kind::right_arc;
}
bool is_arc(const Curve2& curve) { return std::holds_alternative<Arc>(curve); }

/// Stations at the ends of segments and every 22.5° of arcs.
std::vector<Station> path_along(const Items& items, std::size_t from, std::size_t to) {
  std::vector<Station> path{{start_of(items[from].curve), 0.0}};
  for (std::size_t i = from; i < to; ++i) {
    const Curve2& curve = items[i].curve;
    int n = 1;
    if (const Arc* arc = std::get_if<Arc>(&curve)) {
      n = std::max(2, static_cast<int>(std::ceil(std::abs(arc->sweep) * 8.0 / pi)));
    }
    const double weight = length(curve) / n;
    for (int k = 1; k <= n; ++k)
      path.push_back({point_at(curve, k / static_cast<double>(n)), weight});
  }
  return path;
}

/// How far joined curves may lie from the curve that replaces them.
struct Allowance {
  double line = 0.0;
  double circle = 0.0;
};

/// One curve for items [from, to), which are all of one kind.
std::optional<Curve2> joined(const Items& items, std::size_t from, std::size_t to,
                             const Allowance& allowance) {
  if (to - from == 1) return items[from].curve;
  const Kind kind = kind_of(items[from].curve);
  if (kind == Kind::spline) return std::nullopt;
  std::vector<Station> path = path_along(items, from, to);
  if (kind == Kind::segment) {
    const auto line = line_along(path, allowance.line);
    return line ? std::optional<Curve2>(*line) : std::nullopt;
  }
  const std::optional<Arc> arc = arc_through(path);
  const bool same_sense = arc && kind_of(*arc) == kind;
  if (!same_sense || !follows(path, *arc, kBetweenStations * allowance.circle)) return std::nullopt;
  return *arc;
}

/// The full circle that all items together form, if they do.
std::optional<Arc> whole_circle(const Items& items, double tolerance) {
  const Kind kind = kind_of(items.front().curve);
  for (const Item& item : items) {
    if (!is_arc(item.curve) || kind_of(item.curve) != kind) return std::nullopt;
  }
  std::vector<Station> path = path_along(items, 0, items.size());
  if ((path.back().point - path.front().point).norm() > tolerance) return std::nullopt;
  path.back().point = path.front().point;
  std::optional<Arc> circle = arc_through(path);
  if (!circle || kind_of(*circle) != kind) return std::nullopt;
  // Arcs of one circle keep its centre and radius to the bit.
  const Arc& model = std::get<Arc>(items.front().curve);
  const double noise = kSamePoint * size_of(path);
  const bool same = std::ranges::all_of(items, [&](const Item& item) {
    const Arc& arc = std::get<Arc>(item.curve);
    return largest(arc.center - model.center) <= noise &&
           std::abs(arc.radius - model.radius) <= noise;
  });
  if (same) circle = Arc{model.center, model.radius, model.start, circle->sweep};
  if (!follows(path, *circle, kBetweenStations * tolerance)) return std::nullopt;
  return circle;
}

/// The longest group from `from` on that can be one curve, by doubling and halving its size: each
/// item is visited a logarithmic number of times.
std::pair<std::size_t, Curve2> longest_group(const Items& items, std::size_t from, std::size_t end,
                                             const Allowance& allowance) {
  std::size_t good = 1;
  std::size_t bad = end - from + 1;
  Curve2 curve = items[from].curve;
  while (bad - good > 1) {
    const std::size_t size = bad > end - from ? std::min(2 * good, end - from) : (good + bad) / 2;
    if (auto join = joined(items, from, from + size, allowance)) {
      good = size;
      curve = std::move(*join);
    } else {
      bad = size;
    }
  }
  return {good, std::move(curve)};
}

/// Whether what is left cannot enclose an area.
bool vanishes(const Items& items) {
  return items.size() < 2 || (items.size() == 2 && kind_of(items[0].curve) == Kind::segment &&
                              kind_of(items[1].curve) == Kind::segment);
}

/// Joins neighbours, including the last with the first.
Items grouped(const Items& items, const Allowance& allowance) {
  if (items.size() < 2) return items;
  if (const auto circle = whole_circle(items, allowance.circle))
    return {{*circle, items.front().first}};
  Items made;
  std::vector<std::size_t> begins;
  std::size_t run_end = 0;
  for (std::size_t i = 0; i < items.size();) {
    if (i == run_end) {
      const Kind kind = kind_of(items[i].curve);
      while (run_end < items.size() && kind_of(items[run_end].curve) == kind)
        ++run_end;
    }
    auto [size, curve] = longest_group(items, i, run_end, allowance);
    made.push_back({std::move(curve), items[i].first});
    begins.push_back(i);
    i += size;
  }
  if (vanishes(made)) return items;
  if (made.size() < 3 || kind_of(made.front().curve) != kind_of(made.back().curve)) return made;
  Items seam(items.begin() + static_cast<std::ptrdiff_t>(begins.back()), items.end());
  seam.insert(seam.end(), items.begin(), items.begin() + static_cast<std::ptrdiff_t>(begins[1]));
  if (auto join = joined(seam, 0, seam.size(), allowance)) {
    made.front() = {std::move(*join), seam.front().first};
    made.pop_back();
  }
  return made;
}

/// The curve with its ends moved to a and b. An arc keeps its midpoint; a spline moves the poles
/// next to its ends along with them.
Curve2 with_ends(const Curve2& curve, const Vec2& a, const Vec2& b) {
  return std::visit(Overloaded{
                        [&](const Segment&) -> Curve2 {
                          return Segment{a, b};
                        },
                        [&](const Arc& arc) -> Curve2 {
                          const Vec2 middle = point_at(arc, 0.5);
                          const double sweep = 2.0 * turn(middle - a, b - middle);
                          if (std::abs(sweep) <= tolerance::kRounding) return Segment{a, b};
                          return arc_between(a, b, sweep);
                        },
                        [&](const CubicSpline& s) -> Curve2 {
                          CubicSpline moved = s;
                          const std::size_t last = s.poles.size() - 1;
                          moved.poles[1] += a - s.poles[0];
                          moved.poles[last - 1] += b - s.poles[last];
                          moved.poles[0] = a;
                          moved.poles[last] = b;
                          return moved;
                        },
                    },
                    curve);
}

/// Where two curves shall meet once the curves between the end p of the one and the start q of the
/// other are removed. Arcs stay unchanged if possible: moving an end moves the whole arc.
Vec2 meeting_point(const Curve2& before, const Curve2& after, double tolerance) {
  const Vec2 p = end_of(before);
  const Vec2 q = start_of(after);
  if (is_arc(before) && is_arc(after)) {
    return std::abs(std::get<Arc>(before).sweep) > std::abs(std::get<Arc>(after).sweep) ? p : q;
  }
  if (is_arc(before)) return p;
  if (is_arc(after)) return q;
  const Vec2 middle = 0.5 * (p + q);
  const Segment* s = std::get_if<Segment>(&before);
  const Segment* t = std::get_if<Segment>(&after);
  if (!s || !t) return middle;
  // At the crossing of the two lines, both keep their direction.
  const Vec2 d = s->b - s->a;
  const Vec2 e = t->b - t->a;
  const Vec2 corner = p + cross(q - p, e) / cross(d, e) * d;
  const bool near = (corner - p).norm() <= tolerance && (corner - q).norm() <= tolerance;
  return near ? corner : middle;
}

/// The items left after short curves are removed, and which of them a gap follows.
struct Thinned {
  Items kept;
  std::vector<char> gap_after;
};

/// Several short curves in a row become segments as long as the tolerance, until less than that is
/// left: a chain of short curves is thinned, not lost.
Thinned thinned(const Items& items, const std::vector<char>& is_short, double tolerance) {
  const std::size_t n = items.size();
  const auto first_long = std::ranges::find(is_short, 0) - is_short.begin();
  const std::size_t offset = static_cast<std::size_t>(first_long) % n;  // runs must not wrap around
  Thinned result;
  for (std::size_t k = 0; k < n;) {
    const std::size_t i = (offset + k) % n;
    if (!is_short[i]) {
      result.kept.push_back(items[i]);
      result.gap_after.push_back(0);
      ++k;
      continue;
    }
    const Vec2 anchor = start_of(items[i].curve);
    Vec2 reached = anchor;
    while (k < n && is_short[(offset + k) % n] && (reached - anchor).norm() < tolerance) {
      reached = end_of(items[(offset + k) % n].curve);
      ++k;
    }
    if ((reached - anchor).norm() >= tolerance) {
      result.kept.push_back({Segment{anchor, reached}, items[i].first});
      result.gap_after.push_back(0);
    } else if (!result.kept.empty()) {
      result.gap_after.back() = 1;
    }
  }
  return result;
}

/// Extends the curves beside gaps to where they meet.
Items closed_up(Thinned thinned, double tolerance) {
  auto& [kept, gap_after] = thinned;
  const std::size_t m = kept.size();
  std::vector<Vec2> starts(m);
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t next = (i + 1) % m;
    starts[next] = gap_after[i] ? meeting_point(kept[i].curve, kept[next].curve, tolerance)
                                : start_of(kept[next].curve);
  }
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t before = (i + m - 1) % m;
    if (!gap_after[i] && !gap_after[before]) continue;
    const Vec2 end = gap_after[i] ? starts[(i + 1) % m] : end_of(kept[i].curve);
    kept[i].curve = with_ends(kept[i].curve, starts[i], end);
  }
  return std::move(kept);
}

/// The items without curves shorter than the tolerance; empty if there are none, or if a sliver
/// would vanish.
std::optional<Items> absorbed(const Items& items, double tolerance) {
  std::vector<char> is_short(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    is_short[i] = length(items[i].curve) < tolerance;
  if (std::ranges::find(is_short, 1) == is_short.end()) return std::nullopt;
  Thinned left = thinned(items, is_short, tolerance);
  if (left.kept.size() == 1 && is_arc(left.kept[0].curve)) {
    Arc& arc = std::get<Arc>(left.kept[0].curve);
    if (std::abs(arc.sweep) > pi) {
      arc.sweep = std::copysign(2.0 * pi, arc.sweep);
      return left.kept;
    }
  }
  if (vanishes(left.kept)) return std::nullopt;
  return closed_up(std::move(left), tolerance);
}

/// Makes each joint one point: arcs determine it, segments and splines follow to the bit; of two
/// arcs that miss each other by more than rounding, the first is moved.
void snap(Items& items, double noise) {
  const std::size_t n = items.size();
  if (n == 1 && !std::holds_alternative<CubicSpline>(items[0].curve)) return;
  for (std::size_t i = 0; i < n; ++i) {
    const Curve2& next = items[(i + 1) % n].curve;
    if (!is_arc(items[i].curve) || !is_arc(next)) continue;
    const Vec2 end = start_of(next);
    if (largest(end_of(items[i].curve) - end) <= noise) continue;
    items[i].curve = with_ends(items[i].curve, start_of(items[i].curve), end);
  }
  std::vector<Vec2> starts(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Curve2& before = items[(i + n - 1) % n].curve;
    starts[i] = is_arc(before) && !is_arc(items[i].curve) ? end_of(before)
                                                          : start_of(items[i].curve);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_arc(items[i].curve))
      items[i].curve = with_ends(items[i].curve, starts[i], starts[(i + 1) % n]);
  }
}

}  // namespace

MergedLoop merged(const Loop& loop, double tolerance) {
  Items items;
  items.reserve(loop.size());
  for (const Curve2& curve : loop) {
    const CubicSpline* spline = std::get_if<CubicSpline>(&curve);
    items.push_back(
        {spline ? recognized(*spline, tolerance) : curve, static_cast<int>(items.size())});
  }
  const auto joints = mapped(items,
                             [&](const Item& item) { return Station{start_of(item.curve)}; });
  const double noise = joints.empty() ? 0.0 : kSamePoint * size_of(joints);
  // Rounding alone must not preserve a curve of no length, or split a line in two.
  tolerance = std::max(tolerance, noise);
  // Curves of one line or circle are joined first, so that short ones are not lost; but a short
  // edge merely within the tolerance of its neighbour's line is better absorbed, which keeps both
  // directions.
  items = grouped(items, {noise, tolerance});
  for (int round = 0; round < kMostRounds; ++round) {
    auto fewer = absorbed(items, tolerance);
    if (fewer) items = std::move(*fewer);
    items = grouped(items, {tolerance, tolerance});
    if (!fewer) break;
  }
  if (!items.empty()) snap(items, noise);
  MergedLoop result;
  for (Item& item : items) {
    result.loop.push_back(std::move(item.curve));
    result.first_input.push_back(item.first);
  }
  return result;
}

}  // namespace planish
