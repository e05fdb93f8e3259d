#include "random_transition.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace planish::transitions {
namespace {

using Json = nlohmann::json;
using Vec3 = Eigen::Vector3d;

class Random {
 public:
  Random(std::uint64_t seed, int index)
      : engine_(seed * 1000003 + static_cast<std::uint64_t>(index)) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

 private:
  std::mt19937_64 engine_;
};

/// As people write lengths.
double rounded(double length) { return std::round(10.0 * length) / 10.0; }

/// Corners of an ellipse, so that it is convex, at uneven steps.
Json random_polygon(Random& random, double size) {
  const int corners = 3 + random.below(5);
  const double first = random.between(0.0, 2.0 * std::numbers::pi), flat = random.between(0.5, 1.0);
  Json polygon = Json::array();
  for (int i = 0; i < corners; ++i) {
    const double at = first + 2.0 * std::numbers::pi * (i + random.between(-0.25, 0.25)) / corners;
    polygon.push_back({rounded(size * std::cos(at)), rounded(size * flat * std::sin(at))});
  }
  return {{"polygon", polygon}};
}

Json random_profile(Random& random) {
  const double size = random.between(60.0, 250.0);
  switch (random.below(6)) {
    case 0:
      return {{"circle", {{"radius", rounded(size / 1.5)}}}};
    case 1:
      return {
          {"ellipse", {{"rx", rounded(size)}, {"ry", rounded(size * random.between(0.4, 0.95))}}}};
    case 2: {
      const double width = rounded(1.6 * size), height = rounded(size * random.between(0.7, 1.4));
      const double radius = rounded(std::min(width, height) * random.between(0.08, 0.4));
      return {{"rounded_rectangle", {{"width", width}, {"height", height}, {"radius", radius}}}};
    }
    case 3:
      return {
          {"obround",
           {{"length", rounded(2.0 * size)}, {"width", rounded(size * random.between(0.5, 1.2))}}}};
    default:
      return random_polygon(random, size);
  }
}

Vec3 vector_in(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

std::vector<Vec3> corners_of(const Json& end) {
  Vec3 origin = Vec3::Zero(), x = Vec3::UnitX(), z = Vec3::UnitZ();
  if (end.contains("frame")) {
    origin = vector_in(end["frame"]["origin"]);
    z = vector_in(end["frame"]["normal"]).normalized();
    x = vector_in(end["frame"]["x"]).normalized();
  }
  const Vec3 y = z.cross(x);
  std::vector<Vec3> corners;
  for (const Json& corner : end["profile"]["polygon"])
    corners.push_back(origin + corner[0].get<double>() * x + corner[1].get<double>() * y);
  return corners;
}

/// Area of the convex polygon of the points that lie in a plane with normal n.
double area_of(const std::vector<Vec3>& points, const Vec3& n) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points)
    centre += p / static_cast<double>(points.size());
  const Vec3 x = (points.front() - centre).normalized(), y = n.cross(x);
  std::vector<std::array<double, 3>> around;  // direction, coordinates
  for (const Vec3& p : points) {
    const double a = x.dot(p - centre), b = y.dot(p - centre);
    around.push_back({std::atan2(b, a), a, b});
  }
  std::ranges::sort(around);
  double twice = 0.0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto &one = around[i], &next = around[(i + 1) % around.size()];
    twice += one[1] * next[2] - next[1] * one[2];
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

Json random_transition(std::uint64_t seed, int index) {
  Random random(seed, index);
  constexpr double kThinnest = 0.05, kThickest = 6.0;
  const double share = random.between(0.0, 1.0);
  const double thickness = std::exp(std::lerp(std::log(kThinnest), std::log(kThickest), share));
  const double height = rounded(random.between(120.0, 500.0));
  const bool inclined = random.below(3) == 0, offset = random.below(2) == 0;
  const double a = inclined ? random.between(-0.4, 0.4) : 0.0;
  const double b = inclined ? random.between(-0.4, 0.4) : 0.0;
  Json transition{{"format", "planish/transition"},
                  {"version", 1},
                  {"thickness", std::round(1000.0 * thickness) / 1000.0},
                  {"press_lines", {{"max_angle", 15}}}};
  transition["from"] = {{"profile", random_profile(random)}};
  transition["to"] = {{"profile", random_profile(random)}};
  const double aside = offset ? rounded(random.between(-150.0, 150.0)) : 0.0;
  const double behind = offset ? rounded(random.between(-150.0, 150.0)) : 0.0;
  transition["to"]["frame"] = {
      {"origin", {aside, behind, height}}, {"normal", {a, b, 1.0}}, {"x", {1.0, 0.0, -a}}};
  return transition;
}

std::optional<double> perimeter_of(const Json& profile) {
  constexpr double kPi = std::numbers::pi;
  if (profile.contains("circle")) return 2.0 * kPi * profile["circle"]["radius"].get<double>();
  if (profile.contains("ellipse")) {
    const double rx = profile["ellipse"]["rx"], ry = profile["ellipse"]["ry"];
    const double most = std::max(rx, ry), ratio = std::min(rx, ry) / most;
    return 4.0 * most * std::comp_ellint_2(std::sqrt(1.0 - ratio * ratio));
  }
  if (profile.contains("rounded_rectangle")) {
    const Json& r = profile["rounded_rectangle"];
    const double width = r["width"], height = r["height"], radius = r["radius"];
    return 2.0 * (width + height) + (2.0 * kPi - 8.0) * radius;
  }
  if (profile.contains("obround")) {
    const double length = profile["obround"]["length"], width = profile["obround"]["width"];
    return 2.0 * std::abs(length - width) + kPi * std::min(length, width);
  }
  if (!profile.contains("polygon")) return std::nullopt;
  const std::vector<Vec3> corners = corners_of({{"profile", profile}});
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += (corners[(i + 1) % corners.size()] - corners[i]).norm();
  return sum;
}

std::optional<double> area_between(const Json& transition) {
  for (const char* end : {"from", "to"})
    if (!transition[end]["profile"].contains("polygon")) return std::nullopt;
  constexpr double kInPlane = 1e-7;  // mm
  std::vector<Vec3> points = corners_of(transition["from"]);
  const std::size_t first = points.size();
  for (const Vec3& p : corners_of(transition["to"]))
    points.push_back(p);
  double area = 0.0;
  std::vector<Vec3> normals;  // of the sides found
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        if (k < first || i >= first) continue;  // of one profile
        Vec3 n = (points[j] - points[i]).cross(points[k] - points[i]).normalized();
        std::vector<Vec3> inside;
        int above = 0, below = 0;
        for (const Vec3& p : points) {
          const double distance = n.dot(p - points[i]);
          if (distance > kInPlane)
            ++above;
          else if (distance < -kInPlane)
            ++below;
          else
            inside.push_back(p);
        }
        if (above > 0 && below > 0) continue;
        if (above > 0) n = -n;
        const bool known = std::ranges::any_of(
            normals, [&](const Vec3& m) { return (m - n).norm() < kInPlane; });
        if (known) continue;
        normals.push_back(n);
        area += area_of(inside, n);
      }
  return area;
}

}  // namespace planish::transitions
