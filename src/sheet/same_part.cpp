// Whether two patterns are one part: centres of gravity and the farthest corner fix the few motions
// that can take one onto the other; each is tried, curve by curve, bend by bend. Turned over, bends
// up must be bends down, so mirror images are different parts. Groups are searched by area first:
// equal parts have equal areas.

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/quadrature.hpp>
#include <planish/sheet/same_part.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

// Whether two patterns are the same part, perhaps turned or turned over. Marks at contours, bends
// and features give the motions that could take one to the other; each is tried, and the whole must
// agree under it, curve by curve, whichever curve a loop begins with. Groups compare first by
// numbers that no motion changes, widened by what the tolerance can move them.

namespace planish {
namespace {

using std::numbers::pi;

/// What a press brake is set to: a hundredth of a degree.
constexpr double kSameAngle = 0.01 * pi / 180.0;

/// On splines and between curves of different kinds.
constexpr int kComparedPoints = 7;

/// The sweep of a circle that was put together from arcs may lack a rounding.
bool is_circle(const Loop& loop) {
  const auto* arc = loop.size() == 1 ? std::get_if<Arc>(&loop.front()) : nullptr;
  return arc && std::abs(arc->sweep) >= 2.0 * pi - tolerance::kComputed;
}

/// Integral of f(p, dp/dt) along a curve; exact for splines where it is of degree 9 at most.
template <typename F>
double integral(const Curve2& curve, F f) {
  int pieces = 1;
  if (const auto* arc = std::get_if<Arc>(&curve))
    pieces = static_cast<int>(std::ceil(std::abs(arc->sweep) / (pi / 8.0)));
  if (const auto* spline = std::get_if<CubicSpline>(&curve))
    pieces = static_cast<int>(spline->poles.size() / 3);
  const auto at = [&](double t) { return f(point_at(curve, t), derivative_at(curve, t)); };
  return sum_of(std::views::iota(0, pieces), [&](int i) {
    return gauss(at, i / static_cast<double>(pieces), (i + 1) / static_cast<double>(pieces));
  });
}

/// Centre of gravity of what a loop encloses; does not depend on where its curves begin.
Vec2 middle_of(const Loop& loop) {
  if (is_circle(loop)) return std::get<Arc>(loop.front()).center;
  const Vec2 near = start_of(loop.front());
  Vec2 moments = Vec2::Zero();
  double area = 0.0;
  for (const Curve2& curve : loop) {
    const auto along = [&](auto f) {
      return integral(curve, [&](const Vec2& p, const Vec2& d) { return f(Vec2(p - near), d); });
    };
    area += along([](const Vec2& p, const Vec2& d) { return 0.5 * cross(p, d); });
    moments.x() += along([](const Vec2& p, const Vec2& d) { return 0.5 * p.x() * p.x() * d.y(); });
    moments.y() -= along([](const Vec2& p, const Vec2& d) { return 0.5 * p.y() * p.y() * d.x(); });
  }
  if (std::abs(area) < tolerance::kTiniest) return near;
  return near + moments / area;
}

/// A point of a pattern that a motion takes to one of the same kind.
struct Mark {
  enum class Kind { outer, opening, bend, slit, feature } kind;
  Vec2 at;
};

void add_marks(std::vector<Mark>& marks, Mark::Kind kind, const Loop& loop) {
  if (is_circle(loop)) {
    marks.push_back({kind, middle_of(loop)});
    return;
  }
  for (const Curve2& curve : loop)
    marks.push_back({kind, start_of(curve)});
}

std::vector<Mark> marks_of(const FlatPattern& pattern) {
  std::vector<Mark> marks;
  add_marks(marks, Mark::Kind::outer, pattern.outer.loop);
  for (const Contour& opening : pattern.openings)
    add_marks(marks, Mark::Kind::opening, opening.loop);
  for (const FlatBend& bend : pattern.bends)
    for (const Segment& line : bend.lines)
      marks.insert(marks.end(), {{Mark::Kind::bend, line.a}, {Mark::Kind::bend, line.b}});
  for (const Curve2& slit : pattern.slits)
    marks.insert(marks.end(),
                 {{Mark::Kind::slit, start_of(slit)}, {Mark::Kind::slit, end_of(slit)}});
  for (const FlatFeature& feature : pattern.features)
    for (const Loop& outline : feature.outlines)
      add_marks(marks, Mark::Kind::feature, outline);
  return marks;
}

/// Whether each of `a` has one of `b` of its own that is the same.
template <typename T, typename Same>
bool one_to_one(const std::vector<T>& a, const std::vector<T>& b, Same same) {
  auto others = mapped(b, [&](const T& one) { return &one; });
  return a.size() == b.size() && std::ranges::all_of(a, [&](const T& one) {
           const auto other = std::ranges::find_if(others,
                                                   [&](const T* row) { return same(one, *row); });
           if (other == others.end()) return false;
           others.erase(other);
           return true;
         });
}

/// The other pattern as it lies once it has been moved, compared with one piece by piece.
class Comparison {
 public:
  Comparison(const FlatPattern& a, const FlatPattern& b, const Isometry2& motion, double tolerance)
      : a_(a),
        b_(b),
        motion_(motion),
        turned_over_(motion.linear().determinant() < 0.0),
        tolerance_(tolerance) {}

  bool holds() const {
    return same_loop(a_.outer.loop, moved(b_.outer.loop)) && same_openings() && same_bends() &&
           same_slits() && same_features();
  }

 private:
  bool near(const Vec2& p, const Vec2& q) const { return (p - q).norm() <= tolerance_; }

  Loop moved(const Loop& loop) const {
    const Loop there = transformed(loop, motion_);
    return turned_over_ ? reversed(there) : there;
  }

  bool on(const Curve2& curve, const Curve2& other) const {
    for (int i = 1; i <= kComparedPoints; ++i)
      if (nearest(other, point_at(curve, i / (kComparedPoints + 1.0))).distance > tolerance_)
        return false;
    return true;
  }

  bool same_curve(const Curve2& a, const Curve2& b) const {
    if (!near(start_of(a), start_of(b)) || !near(end_of(a), end_of(b))) return false;
    if (std::holds_alternative<Segment>(a) && std::holds_alternative<Segment>(b)) return true;
    if (std::holds_alternative<Arc>(a) && std::holds_alternative<Arc>(b))
      return near(point_at(a, 0.5), point_at(b, 0.5));
    return on(a, b) && on(b, a);
  }

  bool same_loop(const Loop& a, const Loop& b) const {
    if (a.size() != b.size() || is_circle(a) != is_circle(b)) return false;
    if (is_circle(a)) {
      const auto &p = std::get<Arc>(a.front()), &q = std::get<Arc>(b.front());
      return near(p.center, q.center) && std::abs(p.radius - q.radius) <= tolerance_;
    }
    const std::size_t n = a.size();
    for (std::size_t first = 0; first < n; ++first) {
      std::size_t i = 0;
      while (i < n && same_curve(a[i], b[(first + i) % n]))
        ++i;
      if (i == n) return true;
    }
    return false;
  }

  /// Whether each of `a` has one of `b` of its own: `place` of both are near, and they are `same`.
  template <typename T, typename PointOf, typename Same>
  bool matched(const std::vector<T>& a, const std::vector<T>& b, PointOf place, Same same) const {
    if (a.size() != b.size()) return false;
    struct Placed {
      Vec2 at;
      std::size_t row;
      bool taken = false;
    };
    std::vector<Placed> others;
    for (std::size_t i = 0; i < b.size(); ++i)
      others.push_back({place(b[i]), i});
    std::ranges::sort(others, {}, [](const Placed& one) { return one.at.x(); });
    return std::ranges::all_of(a, [&](const T& one) {
      const Vec2 at = place(one);
      auto other = std::ranges::lower_bound(others, at.x() - tolerance_, {},
                                            [](const Placed& placed) { return placed.at.x(); });
      for (; other != others.end() && other->at.x() <= at.x() + tolerance_; ++other)
        if (!other->taken && near(other->at, at) && same(one, b[other->row]))
          return other->taken = true;
      return false;
    });
  }

  bool same_loops(const std::vector<Loop>& a, const std::vector<Loop>& b) const {
    return matched(a, b, middle_of, [&](const Loop& p, const Loop& q) { return same_loop(p, q); });
  }

  bool same_openings() const {
    const auto loops = [](const std::vector<Contour>& contours, auto moving) {
      return mapped(contours, [&](const Contour& contour) { return moving(contour.loop); });
    };
    return same_loops(loops(a_.openings, [](const Loop& loop) { return loop; }),
                      loops(b_.openings, [&](const Loop& loop) { return moved(loop); }));
  }

  /// Curves that may run either way.
  bool same_cuts(const std::vector<Curve2>& a, const std::vector<Curve2>& b) const {
    return matched(
        a, b, [](const Curve2& curve) { return Vec2(0.5 * (start_of(curve) + end_of(curve))); },
        [&](const Curve2& p, const Curve2& q) {
          return same_curve(p, q) || same_curve(p, reversed(q));
        });
  }

  bool same_slits() const { return same_cuts(a_.slits, transformed(b_.slits, motion_)); }

  /// A bend line with what is done there.
  struct Line {
    Segment line;
    double angle = 0.0;
  };

  std::vector<Line> lines_of(const FlatBend& bend, const Isometry2& motion) const {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < bend.lines.size(); ++i)
      lines.push_back({{motion * bend.lines[i].a, motion * bend.lines[i].b},
                       bend.line_angles.empty() ? 0.0 : bend.line_angles[i].radians()});
    return lines;
  }

  bool same_lines(const FlatBend& a, const FlatBend& b) const {
    return matched(
        lines_of(a, Isometry2::Identity()), lines_of(b, motion_),
        [](const Line& line) { return Vec2(0.5 * (line.line.a + line.line.b)); },
        [&](const Line& p, const Line& q) {
          return std::abs(p.angle - q.angle) <= kSameAngle &&
                 (same_curve(p.line, q.line) || same_curve(p.line, reversed(Curve2(q.line))));
        });
  }

  bool same_bend(const FlatBend& a, const FlatBend& b) const {
    const bool same_way = (a.direction == b.direction) != turned_over_;
    const auto zone = [](const FlatBend& bend) {
      return std::vector<Curve2>(bend.tangent_lines.begin(), bend.tangent_lines.end());
    };
    return same_way && a.kind == b.kind &&
           std::abs(a.angle.radians() - b.angle.radians()) <= kSameAngle &&
           std::abs(a.inside_radius - b.inside_radius) <= tolerance_ && same_lines(a, b) &&
           same_cuts(zone(a), transformed(zone(b), motion_));
  }

  bool same_bends() const {
    return one_to_one(a_.bends, b_.bends,
                      [&](const FlatBend& a, const FlatBend& b) { return same_bend(a, b); });
  }

  bool same_feature(const FlatFeature& a, const FlatFeature& b) const {
    const auto outlines = mapped(b.outlines, [&](const Loop& outline) { return moved(outline); });
    const auto pilots = mapped(b.pilots, [&](const Vec2& at) -> Vec2 { return motion_ * at; });
    const FormSide side = turned_over_ ? other_side(b.side) : b.side;
    return a.kind == b.kind && a.side == side && a.uncut_openings == b.uncut_openings &&
           matched(
               a.pilots, pilots, [](const Vec2& at) { return at; },
               [](const Vec2&, const Vec2&) { return true; }) &&
           same_loops(a.outlines, outlines);
  }

  bool same_features() const {
    return one_to_one(a_.features, b_.features, [&](const FlatFeature& a, const FlatFeature& b) {
      return same_feature(a, b);
    });
  }

  const FlatPattern& a_;
  const FlatPattern& b_;
  Isometry2 motion_;
  bool turned_over_;
  double tolerance_;
};

Vec2 mirrored(const Vec2& p) { return {p.x(), -p.y()}; }

/// Takes `from` to `to`, mirrored first if `over`, and turned.
Isometry2 motion(const Vec2& from, const Vec2& to, double turn, bool over) {
  Isometry2 motion = Isometry2::Identity();
  motion.translate(to);
  motion.rotate(Eigen::Rotation2Dd(turn));
  if (over) motion.linear() = motion.linear() * Eigen::Scaling(1.0, -1.0);
  motion.translate(-from);
  return motion;
}

/// Whether `b` covers `a` after one of the motions that are possible, turned over or not.
bool covers(const FlatPattern& a, const FlatPattern& b, double tolerance, bool over) {
  const Vec2 from = middle_of(b.outer.loop), to = middle_of(a.outer.loop);
  const std::vector<Mark> marks = marks_of(a);
  // The farthest point from the middle fixes the turn best.
  const auto distance = [&](const Mark& mark) { return (mark.at - to).norm(); };
  const auto farthest = std::ranges::max_element(marks, {}, distance);
  const double reach = distance(*farthest);
  if (reach <= tolerance)  // round
    return Comparison(a, b, motion(from, to, 0.0, over), tolerance).holds();
  const std::vector<Mark> others = marks_of(b);
  return std::ranges::any_of(others, [&](const Mark& mark) {
    const Vec2 arm = over ? mirrored(mark.at - from) : Vec2(mark.at - from);
    if (mark.kind != farthest->kind || std::abs(arm.norm() - reach) > tolerance) return false;
    const double turn = angle_of(farthest->at - to) - angle_of(arm);
    return Comparison(a, b, motion(from, to, turn, over), tolerance).holds();
  });
}

double tolerance_for(const FlatPattern& pattern, double tolerance) {
  return std::max(tolerance, tolerance::kFileDigits * bounds(pattern.outer.loop).size().norm());
}

}  // namespace

bool is_same_part(const FlatPattern& a, const FlatPattern& b, double tolerance) {
  require_valid(a);
  require_valid(b);
  if (a.outer.loop.empty()) return false;
  const double near = tolerance_for(a, tolerance);
  if (std::abs(a.thickness - b.thickness) > near || a.openings.size() != b.openings.size() ||
      a.outer.loop.size() != b.outer.loop.size() || a.bends.size() != b.bends.size())
    return false;
  return covers(a, b, near, false) || covers(a, b, near, true);
}

PartGroups::Counts PartGroups::counts_of(const FlatPattern& pattern) {
  return {pattern.outer.loop.size(), pattern.openings.size(), pattern.slits.size(),
          pattern.bends.size(), pattern.features.size()};
}

PartGroups::Sizes PartGroups::sizes_of(const FlatPattern& pattern) {
  Sizes sizes{.thickness = pattern.thickness, .perimeter = pattern.perimeter};
  for (const FlatBend& bend : pattern.bends) {
    sizes.bend_length += bend.length;
    sizes.bend_angle += bend.angle.radians();
  }
  return sizes;
}

bool PartGroups::may_equal(const Sizes& a, const Sizes& b, double slack) const {
  return std::abs(a.thickness - b.thickness) <= slack &&
         std::abs(a.perimeter - b.perimeter) <= slack &&
         std::abs(a.bend_length - b.bend_length) <= slack &&
         std::abs(a.bend_angle - b.bend_angle) <= slack;
}

std::size_t PartGroups::add(const FlatPattern& pattern) {
  auto& groups = groups_[counts_of(pattern)];
  Sizes sizes = sizes_of(pattern);
  // Contours that move by the tolerance change the area by no more than their length times that; a
  // curve's length, by twice that and what it bends.
  const double near = tolerance_for(pattern, tolerance_);
  const double area_slack = near * (pattern.perimeter + 1.0);
  const double slack = near * (1.0 + 4.0 * static_cast<double>(marks_of(pattern).size()));
  std::vector<std::size_t> candidates;
  for (auto row = groups.lower_bound(pattern.area - area_slack);
       row != groups.end() && row->first <= pattern.area + area_slack; ++row)
    if (may_equal(row->second, sizes, slack)) candidates.push_back(row->second.group);
  std::ranges::sort(candidates);
  for (const std::size_t group : candidates)
    if (is_same_part(first_(group), pattern, tolerance_)) return group;
  sizes.group = count_++;
  groups.emplace(pattern.area, sizes);
  return sizes.group;
}

}  // namespace planish
