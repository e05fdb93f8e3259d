#include "connect_pairs/random_pairs.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace planish::pairs {
namespace {

constexpr double kPi = std::numbers::pi;

/// The same numbers with every standard library.
class Random {
 public:
  Random(std::uint64_t seed, int index)
      : engine_(seed * 1'000'003 + static_cast<std::uint64_t>(index)) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>(between(0.0, n)); }
  bool once_in(int n) { return below(n) == 0; }

 private:
  std::mt19937_64 engine_;
};

using Outline = std::vector<Vec2>;

Outline rectangle(Random& random) {
  const double w = random.between(40, 240), h = random.between(30, 160);
  return {{0, 0}, {w, 0}, {w, h}, {0, h}};
}

Outline trapezoid(Random& random) {
  Outline outline = rectangle(random);
  const double w = outline[1].x();
  outline[0].x() += random.between(-0.3, 0.3) * w;
  outline[1].x() += random.between(-0.3, 0.3) * w;
  outline[1].y() += random.between(0.0, 0.3) * outline[2].y();
  return outline;
}

// Corners about a centre, at growing azimuths; all on an ellipse, or at distances of their own.
Outline about_centre(Random& random, int corners, double least) {
  const double rx = random.between(30, 120), ry = random.between(30, 90);
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double azimuth = 2.0 * kPi * (i + random.between(0.0, 0.7)) / corners;
    const double share = random.between(least, 1.0);
    outline.emplace_back(share * rx * std::cos(azimuth), share * ry * std::sin(azimuth));
  }
  return outline;
}

Outline notched(Random& random) {
  const Outline r = rectangle(random);
  const double w = r[2].x(), h = r[2].y();
  const double a = random.between(0.15, 0.45) * w, b = random.between(0.55, 0.85) * w;
  const double depth = random.between(0.2, 0.7) * h;
  if (random.once_in(3)) return {{0, 0}, {b, 0}, {b, depth}, {w, depth}, {w, h}, {0, h}};
  return {{0, 0}, {a, 0}, {a, depth}, {b, depth}, {b, 0}, {w, 0}, {w, h}, {0, h}};
}

Outline outline_of(Random& random) {
  switch (random.below(6)) {
    case 0:
    case 1:
      return rectangle(random);
    case 2:
      return trapezoid(random);
    case 3:
      return about_centre(random, 3 + random.below(6), 1.0);
    case 4:
      return about_centre(random, 5 + random.below(6), 0.4);
    default:
      return notched(random);
  }
}

Outline turned(Outline outline, double angle) {
  for (Vec2& p : outline)
    p = {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
         std::sin(angle) * p.x() + std::cos(angle) * p.y()};
  return outline;
}

// Moved so that its lowest corner is `height` above the x axis, its middle at x = `middle`.
Outline placed(Outline outline, double middle, double height) {
  double left = outline[0].x(), right = left, low = outline[0].y();
  for (const Vec2& p : outline) {
    left = std::min(left, p.x());
    right = std::max(right, p.x());
    low = std::min(low, p.y());
  }
  for (Vec2& p : outline)
    p += Vec2(middle - 0.5 * (left + right), height - low);
  return outline;
}

Plate plate_of(const std::string& id, const Outline& outline, const Vec3& x, const Vec3& y) {
  Plate plate{id, {}, {}};
  for (const Vec2& p : outline)
    plate.outline.push_back(p.x() * x + p.y() * y);
  return plate;
}

Eigen::Matrix3d any_rotation(Random& random) {
  const double u = random.between(0, 1), v = 2.0 * kPi * random.between(0, 1),
               w = 2.0 * kPi * random.between(0, 1);
  return Eigen::Quaterniond(std::sqrt(u) * std::cos(w), std::sqrt(1 - u) * std::sin(v),
                            std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w))
      .toRotationMatrix();
}

void move(Plate& plate, const Eigen::Matrix3d& rotation, const Vec3& by) {
  for (Vec3& p : plate.outline)
    p = rotation * p + by;
}

// The direction of a plate that leans at the angle β to one along y, both along x.
Vec3 leaning(double beta) { return {0.0, std::cos(beta), std::sin(beta)}; }

std::vector<Plate> beside_a_line(Random& random) {
  const double beta = random.between(12, 168) * kPi / 180.0;
  const bool aligned = random.once_in(3);
  std::vector<Plate> plates;
  for (const bool first : {true, false}) {
    const double turn = aligned || random.once_in(3) ? 0.0 : random.between(-0.6, 0.6);
    const double shift = aligned ? 0.0 : random.between(-60, 60);
    const Outline outline = placed(turned(outline_of(random), turn), shift, random.between(4, 60));
    plates.push_back(
        plate_of(first ? "A" : "B", outline, Vec3::UnitX(), first ? Vec3::UnitY() : leaning(beta)));
  }
  if (random.once_in(3)) {  // the edges are skew
    const Eigen::AngleAxisd twist(random.between(-0.3, 0.3), any_rotation(random) * Vec3::UnitX());
    move(plates[1], twist.toRotationMatrix(), Vec3::Zero());
  }
  return plates;
}

std::vector<Plate> anywhere(Random& random) {
  std::vector<Plate> plates;
  for (const char* id : {"A", "B"})
    plates.push_back(
        plate_of(id, placed(outline_of(random), 0.0, -40.0), Vec3::UnitX(), Vec3::UnitY()));
  const double away = random.between(60, 180);
  move(plates[1], any_rotation(random), away * (any_rotation(random) * Vec3::UnitX()));
  return plates;
}

std::vector<Plate> over_each_other(Random& random) {
  std::vector<Plate> plates;
  for (const char* id : {"A", "B"}) {
    const double turn = random.once_in(2) ? 0.0 : random.between(-kPi, kPi);
    const Outline outline = placed(turned(outline_of(random), turn), random.between(-30, 30),
                                   random.between(-30, 30));
    plates.push_back(plate_of(id, outline, Vec3::UnitX(), Vec3::UnitY()));
  }
  move(plates[1], Eigen::Matrix3d::Identity(), random.between(7, 90) * Vec3::UnitZ());
  return plates;
}

// A corner or an edge (two corners) of B lies at one of A.
std::vector<Plate> meeting(Random& random, bool edge) {
  std::vector<Plate> plates;
  const double beta = random.between(20, 160) * kPi / 180.0;
  Outline a = outline_of(random), b = outline_of(random);
  if (edge) {
    b = rectangle(random);
    const Vec2 along = a[1] - a[0];
    a = turned(a, -std::atan2(along.y(), along.x()));
    b[1].x() = b[2].x() = along.norm();
  } else {
    a = turned(a, random.between(-0.6, 0.6));
    b = turned(b, random.between(-0.6, 0.6));
  }
  const Vec2 from_a = a[0], from_b = b[0];
  for (Vec2& p : a)
    p -= from_a;
  for (Vec2& p : b)
    p -= from_b;
  plates.push_back(plate_of("A", a, Vec3::UnitX(), Vec3::UnitY()));
  plates.push_back(plate_of("B", b, Vec3::UnitX(), leaning(beta)));
  return plates;
}

}  // namespace

RandomPair random_pair(std::uint64_t seed, int index) {
  Random random(seed, index);
  RandomPair pair;
  const auto lie = [&](const char* how, std::vector<Plate> plates) {
    pair.how = how;
    pair.structure.plates = std::move(plates);
  };
  const int way = random.below(20);
  if (way < 12)
    lie("beside a line", beside_a_line(random));
  else if (way < 15)
    lie("anywhere", anywhere(random));
  else if (way < 17)
    lie("over each other", over_each_other(random));
  else if (way < 18)
    lie("at an edge", meeting(random, true));
  else
    lie("at a corner", meeting(random, false));
  pair.structure.thickness = random.between(0.5, 6.0);
  const Eigen::Matrix3d rotation = any_rotation(random);
  const Vec3 by(random.between(-500, 500), random.between(-500, 500), random.between(-500, 500));
  for (Plate& plate : pair.structure.plates) {
    if (random.once_in(2)) std::ranges::reverse(plate.outline);
    move(plate, rotation, by);
  }
  return pair;
}

}  // namespace planish::pairs
