#include "support/sheets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using Corners = std::vector<Vec2>;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Distance of p from the side corners[i] → corners[i + 1] of a convex polygon, positive inside.
double inside(const Corners& corners, std::size_t i, const Vec2& p) {
  const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
  return cross((b - a).normalized(), p - a);
}

double depth(const Corners& corners, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i)
    least = std::min(least, inside(corners, i, p));
  return least;
}

/// A point of the sheet, in space (half-way between the skins) and in the flat pattern.
struct Sample {
  Vec3 folded;
  Vec2 flat;
};

/// A flange and the bend that leads to it (none for the first).
struct Plan {
  int parent = -1;
  int side = 0;  ///< of the parent
  double from = 0.0, to = 0.0;
  Turn turn;
  Corners corners;
  std::vector<Loop> openings;
  Frame frame;
  Isometry2 flat = Isometry2::Identity();
  std::vector<Sample> flange_samples, bend_samples;
  std::vector<int> sides_used;
};

class Planner {
 public:
  Planner(std::mt19937& random, int bends) : random_(random) {
    thickness_ = uniform(0.5, 3.0);
    spacing_ = 2.5;
    clearance_ = std::numbers::sqrt2 * spacing_ + 1.1 * thickness_;
    Plan root;
    root.corners = trapezoid(uniform(50, 120), uniform(40, 100));
    settle(root);
    plans_.push_back(root);
    for (int attempts = 40 * bends; attempts > 0 && int(plans_.size()) <= bends; --attempts)
      grow();
  }

  Sheet build() const;

 private:
  double uniform(double lo, double hi) {
    return lo +
           (hi - lo) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }
  int below(int n) { return std::min(n - 1, static_cast<int>(uniform(0, n))); }

  Corners trapezoid(double width, double height) {
    const double left = below(2) * uniform(0, 0.25) * width;
    const double right = below(2) * uniform(0, 0.25) * width;
    return {{0, 0}, {width, 0}, {width - right, height}, {left, height}};
  }

  void grow();
  void place(Plan& plan) const;
  void settle(Plan& plan);
  void pierce(Plan& plan);
  bool collides(const Plan& plan) const;
  bool near(const std::vector<Sample>& a, const std::vector<Sample>& b) const;

  Rim rim_of(const Plan& parent, int side, double from, double to) const {
    const Vec2 a = parent.corners[side];
    const Vec2 d = (parent.corners[(side + 1) % parent.corners.size()] - a).normalized();
    const Frame& f = parent.frame;
    return {{f.point(a + from * d), d.y() * f.x - d.x() * f.y, d.x() * f.x + d.y() * f.y, f.z},
            to - from,
            {},
            {}};
  }

  std::mt19937& random_;
  double thickness_, spacing_, clearance_;
  std::vector<Plan> plans_;
};

void Planner::grow() {
  Plan plan;
  plan.parent = below(static_cast<int>(plans_.size()));
  Plan& parent = plans_[plan.parent];
  plan.side = below(static_cast<int>(parent.corners.size()));
  if (std::ranges::count(parent.sides_used, plan.side) > 0) return;
  const Vec2 side = parent.corners[(plan.side + 1) % parent.corners.size()] -
                    parent.corners[plan.side];
  const double room = side.norm() - 2 * clearance_;
  if (room < 12) return;
  const double width = below(3) == 0 ? room : uniform(12, room);
  plan.from = clearance_ + uniform(0, room - width);
  plan.to = plan.from + width;
  plan.turn = {Angle::degrees(uniform(5, 150)), uniform(0.3, 5.0) * thickness_,
               below(2) == 0 ? BendDirection::up : BendDirection::down};
  plan.corners = trapezoid(width, uniform(12, 60));
  plan.sides_used = {0};
  place(plan);
  settle(plan);
  if (collides(plan)) return;
  parent.sides_used.push_back(plan.side);
  plans_.push_back(plan);
}

/// The new flange's place in space and in the flat pattern, and samples of its bend.
void Planner::place(Plan& plan) const {
  const Plan& parent = plans_[plan.parent];
  const Rim rim = rim_of(parent, plan.side, plan.from, plan.to);
  const Frame far = turned(rim.frame, plan.turn, thickness_);
  plan.frame = {far.origin + rim.length * far.y, -far.y, far.x, far.z};
  const double arc = plan.turn.angle.radians() * (plan.turn.inside_radius + 0.5 * thickness_);
  const Vec2 start = parent.flat * parent.frame.local2(rim.frame.origin);
  const Vec2 along = parent.flat.linear() *
                     Vec2(rim.frame.y.dot(parent.frame.x), rim.frame.y.dot(parent.frame.y));
  const Vec2 out(along.y(), -along.x());
  plan.flat.linear() << -along, out;
  plan.flat.translation() = start + rim.length * along + arc * out;

  const int rows = 1 + static_cast<int>(arc / spacing_);
  const int columns = 1 + static_cast<int>(rim.length / spacing_);
  for (int i = 0; i <= rows; ++i) {
    Turn part = plan.turn;
    part.angle = (double(i) / rows) * plan.turn.angle;
    const Frame f = turned(rim.frame, part, thickness_);
    for (int j = 0; j <= columns; ++j) {
      const double y = rim.length * j / columns;
      plan.bend_samples.push_back(
          {f.origin + y * f.y - 0.5 * thickness_ * f.z, start + y * along + arc * i / rows * out});
    }
  }
}

/// Openings and samples of a flange in its place.
void Planner::settle(Plan& plan) {
  for (int holes = below(3); holes > 0; --holes)
    pierce(plan);
  const double width = plan.corners[1].x(), height = plan.corners[2].y();
  const int columns = 1 + static_cast<int>(width / spacing_);
  const int rows = 1 + static_cast<int>(height / spacing_);
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const Vec2 p(width * j / columns, height * i / rows);
      if (depth(plan.corners, p) < -1e-9) continue;
      plan.flange_samples.push_back(
          {plan.frame.point(p) - 0.5 * thickness_ * plan.frame.z, plan.flat * p});
    }
}

/// Cuts one opening, on its own half of the flange so that two never meet.
void Planner::pierce(Plan& plan) {
  const double radius = uniform(1.0, 4.0), straight = below(2) * uniform(2.0, 8.0);
  const double share = plan.openings.empty() ? uniform(0.1, 0.45) : uniform(0.55, 0.9);
  const Vec2 center(share * plan.corners[1].x(), uniform(0.1, 0.9) * plan.corners[2].y());
  const double reach = radius + 0.5 * straight;
  if (depth(plan.corners, center) < reach + 1.5) return;
  if (std::abs(center.x() - 0.5 * plan.corners[1].x()) < reach + 0.5) return;
  plan.openings.push_back(
      straight == 0.0 ? circular_opening(center, radius)
                      : obround_opening(center, straight, radius, Angle::degrees(uniform(0, 180))));
}

bool Planner::near(const std::vector<Sample>& a, const std::vector<Sample>& b) const {
  for (const Sample& p : a)
    for (const Sample& q : b)
      if ((p.folded - q.folded).norm() < clearance_ || (p.flat - q.flat).norm() < clearance_)
        return true;
  return false;
}

/// A flange may be near the bend it sits on and the flange that bend starts from, nothing else.
bool Planner::collides(const Plan& plan) const {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    const Plan& other = plans_[i];
    const bool parent = static_cast<int>(i) == plan.parent;
    if (near(plan.flange_samples, other.bend_samples)) return true;
    if (near(plan.bend_samples, other.bend_samples)) return true;
    if (parent) continue;
    if (near(plan.flange_samples, other.flange_samples)) return true;
    if (near(plan.bend_samples, other.flange_samples)) return true;
  }
  return false;
}

Sheet Planner::build() const {
  SheetBuilder builder(thickness_);
  std::vector<FaceId> faces(plans_.size());
  std::vector<std::vector<int>> border_of_side(plans_.size());
  const auto child_on = [&](std::size_t parent, std::size_t side) -> const Plan* {
    for (const Plan& plan : plans_)
      if (plan.parent == static_cast<int>(parent) && plan.side == static_cast<int>(side))
        return &plan;
    return nullptr;
  };
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    const Plan& plan = plans_[i];
    Corners corners;
    for (std::size_t side = 0; side < plan.corners.size(); ++side) {
      const Vec2 a = plan.corners[side];
      const Vec2 d = (plan.corners[(side + 1) % plan.corners.size()] - a).normalized();
      corners.push_back(a);
      const Plan* child = child_on(i, side);
      border_of_side[i].push_back(static_cast<int>(corners.size()));
      if (child != nullptr) corners.insert(corners.end(), {a + child->from * d, a + child->to * d});
    }
    std::vector<Loop> loops{polygon(corners)};
    loops.insert(loops.end(), plan.openings.begin(), plan.openings.end());
    if (plan.parent < 0) {
      faces[i] = builder.flange(plan.frame, loops);
      continue;
    }
    const Rim rim = builder.rim(faces[plan.parent], border_of_side[plan.parent][plan.side]);
    faces[i] = builder.flange_behind(builder.bend(rim, plan.turn), loops);
  }
  return builder.finish();
}

}  // namespace

Sheet random_sheet(std::mt19937& random, int bends) { return Planner(random, bends).build(); }

}  // namespace planish::test
