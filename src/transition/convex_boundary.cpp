#include "convex_boundary.hpp"

#include "periodic_spline.hpp"

#include <planish/geometry/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <tuple>

namespace planish::transition_detail {
namespace {

constexpr double kPi = std::numbers::pi;
/// Corners that turn by less (sine) are straight on, edges shorter than this share of the extent
/// none.
constexpr double kNoCorner = 1e-9;

using PlaneCurve = std::function<PlanePoint(double)>;

double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A piece in the profile's own plane, run counter-clockwise.
struct PlanePiece {
  PlaneCurve curve;
  double t0 = 0.0, t1 = 1.0;
  bool straight = false;
  int source = 0;
  double period = 0.0;
  std::vector<double> knots;
  double circle_radius = 0.0;  ///< 0: no circle
  Vec2 circle_centre = Vec2::Zero();
  std::vector<GivenEdge> edges;      ///< that it is made of
  std::vector<GivenCorner> corners;  ///< at its start and within
};

PlanePiece straight(const Vec2& a, const Vec2& b, int source) {
  PlanePiece piece;
  piece.curve = [a, d = Vec2(b - a)](double t) -> PlanePoint {
    return {a + t * d, d, Vec2::Zero(), Vec2::Zero()};
  };
  piece.straight = true;
  piece.source = source;
  return piece;
}

/// The curve set off to the right by d: outwards of one that runs counter-clockwise. Its third
/// derivative is not needed by anybody and left zero.
PlaneCurve set_off(PlaneCurve curve, double d) {
  if (d == 0.0) return curve;
  return [curve = std::move(curve), d](double t) -> PlanePoint {
    const auto [c, first, second, third] = curve(t);
    const double speed = first.norm(), turning = cross2(first, second);
    const Vec2 tangent = first / speed, outward(tangent.y(), -tangent.x());
    const double rate = turning / (speed * speed);  // of the tangent's angle
    const double speed_rate = first.dot(second) / speed;
    const double rate_rate = cross2(first, third) / (speed * speed) -
                             2.0 * rate * speed_rate / speed;
    const double new_speed = speed + d * rate;
    return {c + d * outward, new_speed * tangent,
            (speed_rate + d * rate_rate) * tangent - new_speed * rate * outward, Vec2::Zero()};
  };
}

PlaneCurve ellipse(double rx, double ry, const Vec2& centre) {
  return [=](double t) -> PlanePoint {
    const double c = std::cos(t), s = std::sin(t);
    return {
        centre + Vec2(rx * c, ry * s), {-rx * s, ry * c}, {-rx * c, -ry * s}, {rx * s, -ry * c}};
  };
}

/// The part of a circle or ellipse from one azimuth to the next, 90° further.
PlanePiece quarter(double rx, double ry, const Vec2& centre, double outwards, double from,
                   int source) {
  PlanePiece piece;
  const bool round = rx == ry;
  piece.curve = round ? ellipse(rx + outwards, rx + outwards, centre)
                      : set_off(ellipse(rx, ry, centre), outwards);
  piece.t0 = from;
  piece.t1 = from + 0.5 * kPi;
  piece.source = source;
  piece.period = 2.0 * kPi;
  if (round) {
    piece.circle_radius = rx + outwards;
    piece.circle_centre = centre;
  }
  return piece;
}

class Shaper {
 public:
  Shaper(double outwards, std::string pointer)
      : outwards_(outwards), pointer_(std::move(pointer)) {}

  using Pieces = Result<std::vector<PlanePiece>>;

  Pieces operator()(const PolygonProfile& polygon) const {
    std::vector<Vec2> corners = polygon.corners;
    const int n = static_cast<int>(corners.size());
    if (auto sound = check_polygon(corners); !sound) return tl::unexpected(sound.error());
    const bool reversed = ring_area(corners) < 0.0;
    if (reversed) std::reverse(corners.begin(), corners.end());
    const auto given_corner = [&](int i) { return reversed ? n - 1 - i : i; };
    if (auto convex = check_convex(corners, given_corner); !convex)
      return tl::unexpected(convex.error());
    std::vector<int> turns;  // corners at which it does not go straight on
    for (int i = 0; i < n; ++i)
      if (turn_at(corners, i) > kNoCorner) turns.push_back(i);
    std::vector<Vec2> turning;
    for (const int i : turns)
      turning.push_back(corners[index(i)]);
    const std::vector<Vec2> moved = mitred(turning);
    std::vector<PlanePiece> pieces;
    for (std::size_t k = 0; k < turns.size(); ++k) {
      const std::size_t next = (k + 1) % turns.size();
      const Vec2 given = turning[next] - turning[k];
      PlanePiece piece = straight(moved[k], moved[next], static_cast<int>(k));
      const auto share = [&](int i) {
        return (corners[index(i % n)] - turning[k]).norm() / given.norm();
      };
      const int last = turns[next] + (turns[next] <= turns[k] ? n : 0);
      for (int i = turns[k]; i < last; ++i) {
        const int corner = given_corner(i % n);
        piece.edges.push_back({reversed ? given_corner((i + 1) % n) : corner, 0, share(i),
                               i + 1 == last ? 1.0 : share(i + 1)});
        piece.corners.push_back({corner, 0, share(i)});
      }
      if ((moved[next] - moved[k]).dot(given) <= 0.0)
        return fail(ErrorCode::radius_too_small,
                    fmt::format("edge {} is {:.4g} mm long, too short for the thickness: the "
                                "neutral surface lies {:.4g} mm "
                                "within the polygon that is given",
                                piece.edges.front().number, given.norm(), -outwards_),
                    pointer_ + "/polygon");
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  Pieces operator()(const EllipseProfile& e) const {
    const std::string key = e.rx == e.ry ? "/circle" : "/ellipse";
    if (auto sound = check_sizes({e.rx, e.ry}, key); !sound) return tl::unexpected(sound.error());
    const double tightest = std::min(e.rx * e.rx / e.ry, e.ry * e.ry / e.rx);
    if (auto fits = check_radius(tightest, key); !fits) return tl::unexpected(fits.error());
    std::vector<PlanePiece> pieces;
    for (int i = 0; i < 4; ++i)
      pieces.push_back(quarter(e.rx, e.ry, Vec2::Zero(), outwards_, 0.5 * kPi * i, 0));
    return pieces;
  }

  Pieces operator()(const RoundedRectangleProfile& r) const {
    const std::string key = "/rounded_rectangle";
    if (auto sound = check_sizes({r.width, r.height}, key); !sound)
      return tl::unexpected(sound.error());
    if (!(r.radius >= 0.0) || !std::isfinite(r.radius) ||
        2.0 * r.radius > std::min(r.width, r.height))
      return fail(
          ErrorCode::invalid_input,
          fmt::format(
              "the radius is {:.6g} mm; it must be from 0 to half of the shorter side, {:.6g} mm",
              r.radius, 0.5 * std::min(r.width, r.height)),
          pointer_ + key + "/radius");
    const double x = 0.5 * r.width, y = 0.5 * r.height;
    if (r.radius == 0.0) return (*this)(PolygonProfile{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}});
    if (auto fits = check_radius(r.radius, key); !fits) return tl::unexpected(fits.error());
    return rounded(x - r.radius, y - r.radius, r.radius, {0, 1, 2, 3});
  }

  Pieces operator()(const ObroundProfile& o) const {
    const std::string key = "/obround";
    if (auto sound = check_sizes({o.length, o.width}, key); !sound)
      return tl::unexpected(sound.error());
    if (o.length < o.width)
      return fail(ErrorCode::invalid_input,
                  fmt::format("the length of {:.6g} mm, over both half circles, is less than the "
                              "width of {:.6g} mm",
                              o.length, o.width),
                  pointer_ + key + "/length");
    const double radius = 0.5 * o.width;
    if (auto fits = check_radius(radius, key); !fits) return tl::unexpected(fits.error());
    return rounded(0.5 * o.length - radius, 0.0, radius, {0, -1, 1, -1});
  }

  Pieces operator()(const SplineProfile& given) const {
    std::vector<Vec2> points = given.points;
    if (auto sound = check_polygon(points, "/spline"); !sound) return tl::unexpected(sound.error());
    if (ring_area(points) < 0.0) std::reverse(points.begin(), points.end());
    const PeriodicSpline spline(points);
    if (auto convex = check_convex(spline, points); !convex) return tl::unexpected(convex.error());
    const PlaneCurve curve = set_off(spline, outwards_);
    std::vector<PlanePiece> pieces;
    constexpr int kParts = 4;  // of a piece of the spline: none turns by more than 90°
    const auto& knots = spline.knots();
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
      for (int part = 0; part < kParts; ++part) {
        PlanePiece piece;
        piece.curve = curve;
        piece.t0 = std::lerp(knots[k], knots[k + 1], part / double(kParts));
        piece.t1 = std::lerp(knots[k], knots[k + 1], (part + 1) / double(kParts));
        piece.period = knots.back();
        piece.knots = knots;
        pieces.push_back(std::move(piece));
      }
    return pieces;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  Result<void> check_sizes(std::initializer_list<double> sizes, const std::string& key) const {
    for (const double size : sizes)
      if (!(size > 0.0) || !std::isfinite(size))
        return fail(ErrorCode::invalid_input,
                    fmt::format("a size is {:.6g} mm; it must be above 0", size), pointer_ + key);
    return {};
  }

  Result<void> check_radius(double tightest, const std::string& key) const {
    if (tightest + outwards_ > kNoCorner * tightest) return {};
    return fail(ErrorCode::radius_too_small,
                fmt::format("the thickness is too large: the neutral surface lies {:.4g} mm within "
                            "the profile that is given, "
                            "whose smallest radius is {:.4g} mm",
                            -outwards_, tightest),
                pointer_ + key);
  }

  Result<void> check_polygon(const std::vector<Vec2>& corners,
                             const std::string& key = "/polygon") const {
    const int n = static_cast<int>(corners.size());
    if (n < 3)
      return fail(ErrorCode::too_few_corners,
                  fmt::format("there are {} points; a profile needs three", n), pointer_ + key);
    double size = 0.0;
    for (const Vec2& p : corners) {
      if (!p.allFinite())
        return fail(ErrorCode::invalid_input, "a coordinate is not a finite number",
                    pointer_ + key);
      size = std::max(size, (p - corners.front()).norm());
    }
    for (int i = 0; i < n; ++i)
      if ((corners[index(i)] - corners[index((i + 1) % n)]).norm() <= kNoCorner * size)
        return fail(ErrorCode::repeated_corner,
                    fmt::format("points {} and {} lie at the same place, ({:.6g}, {:.6g})", i,
                                (i + 1) % n, corners[index(i)].x(), corners[index(i)].y()),
                    fmt::format("{}{}/{}", pointer_, key, (i + 1) % n));
    if (const auto at = self_crossings(corners); !at.empty())
      return fail(ErrorCode::self_crossing,
                  fmt::format("the profile crosses itself at ({:.6g}, {:.6g})", at.front().x(),
                              at.front().y()),
                  pointer_ + key);
    if (std::abs(ring_area(corners)) <= kNoCorner * size * size)
      return fail(ErrorCode::invalid_input, "the profile encloses no area", pointer_ + key);
    return {};
  }

  /// Sine of the angle by which a polygon turns to the left at a corner.
  static double turn_at(const std::vector<Vec2>& corners, int i) {
    const int n = static_cast<int>(corners.size());
    const Vec2 in = (corners[index(i)] - corners[index((i + n - 1) % n)]).normalized();
    const Vec2 out = (corners[index((i + 1) % n)] - corners[index(i)]).normalized();
    return cross2(in, out);
  }

  template <typename Given>
  Result<void> check_convex(const std::vector<Vec2>& corners, const Given& given) const {
    const int n = static_cast<int>(corners.size());
    for (int i = 0; i < n; ++i) {
      const Vec2 in = (corners[index(i)] - corners[index((i + n - 1) % n)]).normalized();
      const Vec2 out = (corners[index((i + 1) % n)] - corners[index(i)]).normalized();
      if (cross2(in, out) >= -kNoCorner && in.dot(out) > -1.0 + kNoCorner) continue;
      return fail(ErrorCode::profile_not_convex,
                  fmt::format("the profile is not convex at corner {}, ({:.6g}, {:.6g}), where it "
                              "turns inwards by {:.4g}°: "
                              "divide it into convex ones",
                              given(i), corners[index(i)].x(), corners[index(i)].y(),
                              std::atan2(-cross2(in, out), in.dot(out)) * 180.0 / kPi),
                  fmt::format("{}/polygon/{}", pointer_, given(i)));
    }
    return {};
  }

  Result<void> check_convex(const PeriodicSpline& spline, const std::vector<Vec2>& points) const {
    const auto& knots = spline.knots();
    constexpr int kSamples = 32;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
      for (int i = 0; i <= kSamples; ++i) {
        const PlanePoint at = spline(std::lerp(knots[k], knots[k + 1], i / double(kSamples)));
        const double turning = cross2(at.first, at.second), speed = at.first.norm();
        if (speed > 0.0 && turning > kNoCorner * speed * speed * speed / knots.back()) {
          if (turning / (speed * speed * speed) * -outwards_ < 1.0 - kNoCorner) continue;
          return check_radius(speed * speed * speed / turning, "/spline");
        }
        return fail(ErrorCode::profile_not_convex,
                    fmt::format("the spline is not convex at ({:.6g}, {:.6g}), between points {} "
                                "and {}: move or add points",
                                at.point.x(), at.point.y(), k, (k + 1) % points.size()),
                    fmt::format("{}/spline/{}", pointer_, k));
      }
    return {};
  }

  /// Every edge moved outwards, corners where they meet.
  std::vector<Vec2> mitred(const std::vector<Vec2>& corners) const {
    const int n = static_cast<int>(corners.size());
    std::vector<Vec2> moved;
    for (int i = 0; i < n; ++i) {
      const Vec2 in = (corners[index(i)] - corners[index((i + n - 1) % n)]).normalized();
      const Vec2 out = (corners[index((i + 1) % n)] - corners[index(i)]).normalized();
      const Vec2 bisector = Vec2(in.y() + out.y(), -in.x() - out.x());
      moved.push_back(corners[index(i)] + 2.0 * outwards_ / bisector.squaredNorm() * bisector);
    }
    return moved;
  }

  /// Straight sides 2x and 2y long with quarter circles between; edges are numbered from below.
  std::vector<PlanePiece> rounded(double x, double y, double radius,
                                  const std::array<int, 4>& edges) const {
    const double r = radius + outwards_;
    const std::array<Vec2, 4> centres{Vec2(x, -y), Vec2(x, y), Vec2(-x, y), Vec2(-x, -y)};
    std::vector<PlanePiece> pieces;
    int source = 0;
    for (int i = 0; i < 4; ++i) {
      const Vec2 &last = centres[index((i + 3) % 4)], &centre = centres[index(i)];
      const Vec2 outward(std::cos(0.5 * kPi * (i - 1)), std::sin(0.5 * kPi * (i - 1)));
      if ((centre - last).norm() > kNoCorner * (x + y + radius)) {
        pieces.push_back(straight(last + r * outward, centre + r * outward, ++source));
        pieces.back().edges = {{edges[index(i)], 0, 0.0, 1.0}};
      }
      pieces.push_back(quarter(radius, radius, centre, outwards_, 0.5 * kPi * (i - 1), 0));
      // Half circles of an obround are one curve.
      const bool goes_on = i > 0 && (centre - last).norm() <= kNoCorner * (x + y + radius);
      pieces.back().source = goes_on ? source : ++source;
    }
    return pieces;
  }

  double outwards_;
  std::string pointer_;
};

Element placed(const PlanePiece& piece, const Frame& frame, bool turned) {
  Element element;
  const auto to_space = [frame](const Vec2& v) -> Vec3 {
    return v.x() * frame.x + v.y() * frame.y;
  };
  element.curve = [curve = piece.curve, origin = frame.origin, to_space,
                   turned](double t) -> SpaceCurvePoint {
    const PlanePoint p = curve(turned ? -t : t);
    const Vec3 first = to_space(p.first);
    return {origin + to_space(p.point), turned ? Vec3(-first) : first, to_space(p.second)};
  };
  element.t0 = turned ? -piece.t1 : piece.t0;
  element.t1 = turned ? -piece.t0 : piece.t1;
  element.straight = piece.straight;
  element.source = piece.source;
  element.period = piece.period;
  element.knots = piece.knots;
  if (turned) {
    std::reverse(element.knots.begin(), element.knots.end());
    for (double& t : element.knots)
      t = -t;
  }
  if (piece.circle_radius > 0.0)
    element.circle = Circle{frame.point(piece.circle_centre), piece.circle_radius};
  return element;
}

Vec3 tangent(const Element& element, double t) { return element.curve(t).derivative.normalized(); }

}  // namespace

Result<Boundary> boundary_of(const PlacedProfile& profile, double outwards, const Vec3& towards,
                             const std::string& pointer) {
  auto pieces = std::visit(Shaper(outwards, pointer), profile.profile);
  if (!pieces) return tl::unexpected(pieces.error());
  Boundary boundary;
  const bool turned = profile.frame.z.dot(towards) < 0.0;
  boundary.turned = turned;
  boundary.axis = turned ? Vec3(-profile.frame.z) : profile.frame.z;
  const int n = static_cast<int>(pieces->size());
  for (int i = 0; i < n; ++i) {
    const auto& piece = (*pieces)[turned ? n - 1 - i : i];
    boundary.elements.push_back(placed(piece, profile.frame, turned));
    for (GivenEdge edge : piece.edges) {
      if (turned) std::tie(edge.from, edge.to) = std::pair{1.0 - edge.to, 1.0 - edge.from};
      edge.element = i;
      boundary.edges.push_back(edge);
    }
    for (GivenCorner corner : piece.corners) {
      // Turned round, a piece ends where it began.
      const bool at_end = turned && corner.at == 0.0;
      corner.element = at_end ? (i + 1) % n : i;
      corner.at = turned && !at_end ? 1.0 - corner.at : corner.at;
      boundary.corners.push_back(corner);
    }
  }
  for (int i = 0; i < n; ++i) {
    const Element &before = boundary.element(i - 1), &after = boundary.element(i);
    boundary.corner.push_back(tangent(before, before.t1).cross(tangent(after, after.t0)).norm() >
                              kNoCorner);
  }
  return boundary;
}

}  // namespace planish::transition_detail
