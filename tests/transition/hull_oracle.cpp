#include "hull_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

struct Sampler {
  int fineness;
  std::vector<Vec2> points{};

  /// A quarter of an ellipse without its end.
  void quarter(const Vec2& centre, double rx, double ry, int number) {
    for (int i = 0; i < fineness; ++i) {
      const double t = 0.5 * pi * (number + i / double(fineness));
      points.emplace_back(centre + Vec2(rx * std::cos(t), ry * std::sin(t)));
    }
  }
  void rounded(double x, double y, double r) {
    const std::array<Vec2, 4> centres{Vec2(x, y), Vec2(-x, y), Vec2(-x, -y), Vec2(x, -y)};
    for (int i = 0; i < 4; ++i) {
      quarter(centres[i], r, r, i);
      const Vec2 end = centres[i] +
                       r * Vec2(std::cos(0.5 * pi * (i + 1)), std::sin(0.5 * pi * (i + 1)));
      const Vec2 next = centres[(i + 1) % 4];
      if ((next - centres[i]).norm() > 0.0) points.push_back(end);
    }
  }
  void operator()(const PolygonProfile& p) { points = p.corners; }
  void operator()(const EllipseProfile& e) {
    for (int i = 0; i < 4; ++i)
      quarter(Vec2::Zero(), e.rx, e.ry, i);
  }
  void operator()(const RoundedRectangleProfile& r) {
    if (r.radius > 0.0)
      return rounded(0.5 * r.width - r.radius, 0.5 * r.height - r.radius, r.radius);
    const double x = 0.5 * r.width, y = 0.5 * r.height;
    points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  }
  void operator()(const ObroundProfile& o) {
    rounded(0.5 * (o.length - o.width), 0.0, 0.5 * o.width);
  }
  void operator()(const SplineProfile& s) {
    const OracleSpline spline(s.points);
    for (std::size_t k = 0; k < spline.count(); ++k)
      for (int i = 0; i < fineness; ++i)
        points.push_back(spline.at(k, i / double(fineness))[0]);
  }
};

Vec2 round_tangent(double x, double y, double r, const Vec2& p) {
  const Vec2 centre(std::clamp(p.x(), -x, x), std::clamp(p.y(), -y, y));
  const Vec2 arm = (p - centre) / r;
  return Vec2(-arm.y(), arm.x()).normalized();
}

struct Tangent {
  Vec2 p;

  Vec2 operator()(const PolygonProfile& polygon) const {
    const auto& c = polygon.corners;
    double size = 0.0;
    for (const Vec2& q : c)
      size = std::max(size, (q - c.front()).norm());
    for (const Vec2& q : c)
      if ((p - q).norm() < 1e-8 * size) return Vec2::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    Vec2 along = Vec2::Zero();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Vec2 d = (c[(i + 1) % c.size()] - c[i]).normalized(), arm = p - c[i];
      const double distance = std::abs(d.x() * arm.y() - d.y() * arm.x());
      if (distance < nearest && arm.dot(d) > 0.0 && (c[(i + 1) % c.size()] - p).dot(d) > 0.0) {
        nearest = distance;
        along = d;
      }
    }
    return along;
  }
  Vec2 operator()(const EllipseProfile& e) const {
    return Vec2(-p.y() / (e.ry * e.ry), p.x() / (e.rx * e.rx)).normalized();
  }
  Vec2 operator()(const RoundedRectangleProfile& r) const {
    if (r.radius == 0.0) {
      Sampler sampler{1};
      sampler(r);
      return (*this)(PolygonProfile{sampler.points});
    }
    return round_tangent(0.5 * r.width - r.radius, 0.5 * r.height - r.radius, r.radius, p);
  }
  Vec2 operator()(const ObroundProfile& o) const {
    return round_tangent(0.5 * (o.length - o.width), 0.0, 0.5 * o.width, p);
  }
  Vec2 operator()(const SplineProfile& s) const {
    const OracleSpline spline(s.points);
    double least = std::numeric_limits<double>::infinity();
    Vec2 tangent = Vec2::Zero();
    for (std::size_t k = 0; k < spline.count(); ++k) {
      const auto squared = [&](double t) { return (spline.at(k, t)[0] - p).squaredNorm(); };
      double t = 0.0;
      for (int i = 0; i <= 16; ++i)
        if (squared(i / 16.0) < squared(t)) t = i / 16.0;
      if (squared(t) > 4.0 * least + 1.0) continue;
      for (int i = 0; i < 8; ++i) {
        const auto [point, rate] = spline.at(k, t);
        t = std::clamp(t + rate.dot(p - point) / rate.squaredNorm(), 0.0, 1.0);
      }
      if (squared(t) >= least) continue;
      least = squared(t);
      tangent = spline.at(k, t)[1].normalized();
    }
    return tangent;
  }
};

Vec3 area_vector(const std::vector<Vec3>& ring) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
  return sum;
}

Vec3 mean(const std::vector<Vec3>& ring) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : ring)
    sum += p;
  return sum / static_cast<double>(ring.size());
}

/// Of the corners of `other`, the one that the plane hinged at the edge a–b meets first from
/// outside; of those in one plane with it the first or, with `last`, the last as the ring runs.
std::size_t farthest_out(const Vec3& a, const Vec3& b, const Vec3& axis,
                         const std::vector<Vec3>& other, int wanted) {
  const Vec3 out = (b - a).cross(axis).normalized();
  std::size_t best = 0;
  double steepest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < other.size(); ++i) {
    const double slope = out.dot(other[i] - a) / axis.dot(other[i] - a);
    if (slope > steepest) {
      steepest = slope;
      best = i;
    }
  }
  const std::size_t n = other.size(), beside = wanted > 0 ? (best + 1) % n : (best + n - 1) % n;
  const double slope = out.dot(other[beside] - a) / axis.dot(other[beside] - a);
  constexpr double kSame = 1e-11;
  return slope > steepest - kSame ? beside : best;
}

double triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

}  // namespace

OracleSpline::OracleSpline(std::vector<Vec2> points)
    : points_(std::move(points)), seconds_(points_.size(), Vec2::Zero()) {
  const std::size_t n = points_.size();
  for (std::size_t i = 0; i < n; ++i)
    chords_.push_back((point(i + 1) - point(i)).norm());
  // The rows of the system are dominated by their diagonals two to one: each sweep halves the
  // error.
  for (int sweep = 0; sweep < 80; ++sweep)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      const double h = chords_[before], k = chords_[i];
      const Vec2 bend = (point(i + 1) - point(i)) / k - (point(i) - point(before)) / h;
      seconds_[i] = (6.0 * bend - h * seconds_[before] - k * seconds_[(i + 1) % n]) /
                    (2.0 * (h + k));
    }
}

std::array<Vec2, 2> OracleSpline::at(std::size_t i, double share) const {
  const double h = chords_[i], a = 1.0 - share, b = share;
  const Vec2 &p = point(i), &q = point(i + 1), &m = seconds_[i],
             &n = seconds_[(i + 1) % points_.size()];
  const double s = h * h / 6.0;
  return {a * p + b * q + s * ((a * a * a - a) * m + (b * b * b - b) * n),
          q - p + s * ((1.0 - 3.0 * a * a) * m + (3.0 * b * b - 1.0) * n)};
}

std::vector<Vec2> sampled_profile(const Profile& profile, int fineness) {
  Sampler sampler{fineness};
  std::visit(sampler, profile);
  return std::move(sampler.points);
}

std::vector<Vec3> sampled_in_space(const PlacedProfile& profile, int fineness) {
  std::vector<Vec3> points;
  for (const Vec2& p : sampled_profile(profile.profile, fineness))
    points.push_back(profile.frame.point(p));
  return points;
}

Vec2 tangent_at(const Profile& profile, const Vec2& p) { return std::visit(Tangent{p}, profile); }

double oracle_perimeter(const Profile& profile) {
  const auto sum = [&](int fineness) {
    const auto points = sampled_profile(profile, fineness);
    double length = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
      length += (points[(i + 1) % points.size()] - points[i]).norm();
    return length;
  };
  // Chords miss h² of the length and then h⁴.
  const double coarse = sum(100), middle = sum(200), fine = sum(400);
  const double first = middle + (middle - coarse) / 3.0, second = fine + (fine - middle) / 3.0;
  return second + (second - first) / 15.0;
}

double lateral_area(std::vector<Vec3> first, std::vector<Vec3> second) {
  const Vec3 towards = mean(second) - mean(first);
  for (auto* ring : {&first, &second})
    if (area_vector(*ring).dot(towards) < 0.0) std::ranges::reverse(*ring);
  const Vec3 up = area_vector(first).normalized(), down = -area_vector(second).normalized();
  double area = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Vec3 &a = first[i], &b = first[(i + 1) % first.size()];
    area += triangle(a, b, second[farthest_out(a, b, up, second, -1)]);
  }
  for (std::size_t i = 0; i < second.size(); ++i) {
    const Vec3 &a = second[i], &b = second[(i + 1) % second.size()];
    area += triangle(a, b, first[farthest_out(b, a, down, first, 1)]);
  }
  return area;
}

double oracle_area(const PlacedProfile& first, const PlacedProfile& second, int fineness) {
  const auto sum = [&](int parts) {
    return lateral_area(sampled_in_space(first, parts), sampled_in_space(second, parts));
  };
  const double coarse = sum(fineness), fine = sum(2 * fineness);
  return fine + (fine - coarse) / 3.0;
}

}  // namespace planish::test
