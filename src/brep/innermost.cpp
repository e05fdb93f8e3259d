#include "innermost.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

// Rays from a point meet the curves; along each the nearest counts. Rays next to each other that
// meet the same curve are a run of it, and runs are as long as possible where curves lie on each
// other, as both ends of an upright wall do. Where runs change, the curves end or cross.

namespace planish::brep {
namespace {

constexpr int kParts = 256;  // along a curve
constexpr int kRays = 2048;
constexpr double kRound = 2 * std::numbers::pi;

struct Hit {
  int curve = 0;
  double t = 0.0, distance = 0.0;
};

/// Rays that follow each other and meet one curve.
struct Run {
  Hit first, last;
  int rays = 1;
};

class Rays {
 public:
  Rays(const std::vector<PlaneCurve>& curves, const Vec2& from) : curves_(curves), from_(from) {
    constexpr double kAside = 1e-5;  // of a turn: on either side of each end
    for (int i = 0; i < kRays; ++i)
      turns_.push_back((i + 0.5) / kRays);
    for (const PlaneCurve& curve : curves)
      for (const double t : {0.0, 1.0})
        for (const double aside : {-kAside, kAside})
          turns_.push_back(turn_of(curve(t)) + aside - std::floor(turn_of(curve(t)) + aside));
    std::ranges::sort(turns_);
    hits_.resize(turns_.size());
    for (int c = 0; c < std::ssize(curves); ++c)
      for (int i = 0; i < kParts; ++i)
        meet(c, static_cast<double>(i) / kParts, static_cast<double>(i + 1) / kParts);
  }

  int count() const { return static_cast<int>(turns_.size()); }
  /// What a ray meets first, and what lies no farther behind than `aside`.
  std::vector<Hit> nearest(int ray, double aside) const {
    std::vector<Hit> near = hits_[ray];
    if (near.empty()) return near;
    const double least = std::ranges::min_element(near, {}, &Hit::distance)->distance;
    std::erase_if(near, [&](const Hit& hit) { return hit.distance > least + aside; });
    return near;
  }

 private:
  /// Of the direction to a point, 0 to 1.
  double turn_of(const Vec2& p) const {
    const double turn = angle_of(p - from_) / kRound;
    return turn < 0.0 ? turn + 1.0 : turn;
  }
  /// Where rays meet a part of a curve that turns by less than a half round the point.
  void meet(int c, double t0, double t1) {
    double a = turn_of(curves_[c](t0)), b = turn_of(curves_[c](t1));
    if (a > b) std::swap(a, b);
    const bool over = b - a > 0.5;  // over the direction 0
    const auto from = std::ranges::lower_bound(turns_, over ? b : a) - turns_.begin();
    const auto to = std::ranges::lower_bound(turns_, over ? a : b) - turns_.begin();
    for (auto ray = from; over ? ray < count() : ray < to; ++ray)
      hits_[ray].push_back(hit_on(c, t0, t1, turns_[ray]));
    for (int ray = 0; over && ray < to; ++ray)
      hits_[ray].push_back(hit_on(c, t0, t1, turns_[ray]));
  }
  /// By false position.
  Hit hit_on(int c, double t0, double t1, double turn) const {
    constexpr int kMost = 60;
    const Vec2 along(std::cos(turn * kRound), std::sin(turn * kRound));
    const auto aside = [&](double t) { return cross(along, curves_[c](t) - from_); };
    double low = aside(t0), high = aside(t1), t = t0;
    for (int i = 0; i < kMost && low != high; ++i) {
      t = std::clamp(t0 - low * (t1 - t0) / (high - low), std::min(t0, t1), std::max(t0, t1));
      const double off = aside(t);
      if (std::abs(off) <= tolerance::kRounding) break;
      if ((off > 0.0) == (high > 0.0)) {
        t1 = t;
        high = off;
        low /= 2;
      } else {
        t0 = t;
        low = off;
        high /= 2;
      }
    }
    return {c, t, (curves_[c](t) - from_).dot(along)};
  }

  const std::vector<PlaneCurve>& curves_;
  Vec2 from_;
  std::vector<double> turns_;
  std::vector<std::vector<Hit>> hits_;  // by ray
};

/// The longest run that begins at a ray.
Run longest_run(const Rays& rays, int ray, double aside) {
  constexpr double kJump = 0.25;  // of a curve: it goes on elsewhere
  Run longest;
  longest.rays = 0;
  for (const Hit& first : rays.nearest(ray, aside)) {
    Run run{first, first};
    for (; run.rays < rays.count(); ++run.rays) {
      const auto next = rays.nearest((ray + run.rays) % rays.count(), aside);
      const auto on = std::ranges::find_if(next, [&](const Hit& hit) {
        return hit.curve == first.curve && std::abs(hit.t - run.last.t) < kJump;
      });
      if (on == next.end()) break;
      run.last = *on;
    }
    if (run.rays > longest.rays) longest = run;
  }
  return longest;
}

/// All of them, one after the other; empty where a ray meets nothing.
std::vector<Run> runs_round(const Rays& rays, double aside) {
  int first = longest_run(rays, 0, aside).rays;  // where one ends another begins
  if (first == rays.count()) first = 0;
  std::vector<Run> runs;
  for (int at = 0; at < rays.count();) {
    Run run = longest_run(rays, (first + at) % rays.count(), aside);
    if (run.rays == 0) return {};
    run.rays = std::min(run.rays, rays.count() - at);
    at += run.rays;
    runs.push_back(run);
  }
  return runs;
}

class Joints {
 public:
  Joints(const std::vector<PlaneCurve>& curves, const Vec2& within, double tolerance)
      : curves_(curves), within_(within), tolerance_(tolerance) {}

  /// Whether a curve runs counter-clockwise.
  bool forward(const Hit& hit) const {
    return cross(curves_[hit.curve](hit.t) - within_, derivative(hit.curve, hit.t)) > 0.0;
  }
  /// Where one run goes over into the next: parameters of both curves.
  std::optional<std::pair<double, double>> between(const Hit& before, const Hit& after) const {
    const double end = forward(before) ? 1.0 : 0.0, start = forward(after) ? 0.0 : 1.0;
    const bool ends = is_near(before, end), starts = is_near(after, start);
    if (ends && starts &&
        (curves_[before.curve](end) - curves_[after.curve](start)).norm() <= tolerance_)
      return std::pair{end, start};
    return crossing(before, after);
  }

 private:
  Vec2 derivative(int curve, double t) const {
    constexpr double kStep = 1e-6;
    const double low = std::max(0.0, t - kStep), high = std::min(1.0, t + kStep);
    return (curves_[curve](high) - curves_[curve](low)) / (high - low);
  }
  /// Whether the curve ends between this ray and the next.
  bool is_near(const Hit& hit, double end) const {
    const Vec2 from = curves_[hit.curve](hit.t) - within_;
    const Vec2 to = curves_[hit.curve](end) - within_;
    return std::abs(std::atan2(cross(from, to), from.dot(to))) <= kRound / kRays;
  }
  /// By Newton's method.
  std::optional<std::pair<double, double>> crossing(const Hit& before, const Hit& after) const {
    constexpr int kMost = 20;
    double s = before.t, t = after.t;
    for (int i = 0; i < kMost; ++i) {
      const Vec2 off = curves_[after.curve](t) - curves_[before.curve](s);
      const Vec2 along = derivative(before.curve, s), beyond = derivative(after.curve, t);
      const double turn = cross(along, beyond);
      if (off.norm() <= tolerance::kRounding) break;
      if (turn == 0.0) return {};
      s = std::clamp(s + cross(off, beyond) / turn, 0.0, 1.0);
      t = std::clamp(t + cross(off, along) / turn, 0.0, 1.0);
    }
    const bool here = is_near({before.curve, before.t}, s) && is_near({after.curve, after.t}, t);
    if (!here || (curves_[after.curve](t) - curves_[before.curve](s)).norm() > tolerance_)
      return {};
    return std::pair{s, t};
  }

  const std::vector<PlaneCurve>& curves_;
  Vec2 within_;
  double tolerance_;
};

}  // namespace

std::vector<CellPiece> innermost_cell(const std::vector<PlaneCurve>& curves, const Vec2& within,
                                      double tolerance) {
  constexpr double kAside = 1e-3;  // of the tolerance
  const std::vector<Run> runs = runs_round(Rays(curves, within), kAside * tolerance);
  const Joints joints(curves, within, tolerance);
  std::vector<CellPiece> pieces;
  for (const Run& run : runs)
    pieces.push_back({run.first.curve, run.first.t, run.last.t});
  for (size_t i = 0; i < runs.size(); ++i) {
    const size_t next = (i + 1) % runs.size();
    const auto joint = joints.between(runs[i].last, runs[next].first);
    if (!joint) return {};
    pieces[i].to = joint->first;
    pieces[next].from = joint->second;
  }
  return pieces;
}

std::vector<CellPiece> reversed(std::vector<CellPiece> cell) {
  std::ranges::reverse(cell);
  for (CellPiece& piece : cell)
    std::swap(piece.from, piece.to);
  return cell;
}

Border part_of(Border border, const CellPiece& piece) {
  if (!piece.whole()) {
    border.curve = trimmed(border.curve, std::min(piece.from, piece.to),
                           std::max(piece.from, piece.to));
    border.edge_length.reset();
  }
  if (piece.from > piece.to) border.curve = reversed(border.curve);
  return border;
}

}  // namespace planish::brep
