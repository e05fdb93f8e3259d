// Profiles as rings of elements in their own plane, moved outwards by the distance of the neutral
// surface (math.md#neutral-profiles): edges in parallel, corners to where they meet, curves by
// their normals. A profile must stay convex and turn once.

#include "plane_profile.hpp"

#include "profile_check.hpp"
#include "refusals.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// A profile in its plane, set outwards: polygons with mitred corners, curves as offsets of their
// quarters, splines as they are. Each edge remembers which of the given edges and corners lie on
// it, as shares of its length, so that a report speaks of what was given. Straight corners lie
// within elements and are none.

namespace planish::transition_detail {
namespace {

using std::numbers::pi;

using Elements = Result<std::vector<PlaneElement>>;

/// Every edge moved outwards, corners where they meet.
std::vector<Vec2> mitred(const std::vector<Vec2>& corners, double outwards) {
  std::vector<Vec2> moved;
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
    const auto [in, out] = turn_at(corners, i);
    const Vec2 bisector = Vec2(in.y() + out.y(), -in.x() - out.x());
    moved.push_back(corners[i] + 2.0 * outwards / bisector.squaredNorm() * bisector);
  }
  return moved;
}

/// A polygon run counter-clockwise, and the corners at which it turns.
struct ConvexPolygon {
  std::vector<Vec2> corners;
  bool reversed = false;   ///< relative to the input
  std::vector<int> turns;  ///< rows of corners

  int count() const { return static_cast<int>(corners.size()); }
  int given_corner(int i) const { return reversed ? count() - 1 - i : i; }
};

Result<ConvexPolygon> convex(const PolygonProfile& given, const std::string& place) {
  if (auto sound = check_polygon(given.corners, place); !sound) return pass_on(sound);
  ConvexPolygon polygon{given.corners, ring_area(given.corners) < 0.0, {}};
  if (polygon.reversed) std::ranges::reverse(polygon.corners);
  const auto number = [&](int i) { return polygon.given_corner(i); };
  if (auto sound = check_convex(polygon.corners, number, place); !sound) return pass_on(sound);
  for (int i = 0; i < polygon.count(); ++i)
    if (turn_at(polygon.corners, i).sine() > kNoCorner) polygon.turns.push_back(i);
  return polygon;
}

/// The given edges and corners from turn k to the next, as shares of that length.
void add_given(PlaneElement& plane_element, const ConvexPolygon& polygon, std::size_t k,
               double length) {
  const int n = polygon.count();
  const int first = polygon.turns[k], next = polygon.turns[(k + 1) % polygon.turns.size()];
  const int last = next + (next <= first ? n : 0);
  const auto share = [&](int i) {
    return (polygon.corners[i % n] - polygon.corners[first]).norm() / length;
  };
  for (int i = first; i < last; ++i) {
    const int corner = polygon.given_corner(i % n);
    const int edge = polygon.reversed ? polygon.given_corner((i + 1) % n) : corner;
    plane_element.edges.push_back({edge, 0, share(i), i + 1 == last ? 1.0 : share(i + 1)});
    plane_element.corners.push_back({corner, 0, share(i)});
  }
}

/// Straight sides 2x and 2y long with quarter circles between; edges are numbered from below.
std::vector<PlaneElement> rounded(double x, double y, double radius, double outwards,
                                  const std::array<int, 4>& edges) {
  const double r = radius + outwards;
  const std::array<Vec2, 4> centres{Vec2(x, -y), Vec2(x, y), Vec2(-x, y), Vec2(-x, -y)};
  std::vector<PlaneElement> plane_elements;
  int source = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec2 &last = centres[(i + 3) % 4], &centre = centres[i];
    const Vec2 outward(std::cos(0.5 * pi * (i - 1)), std::sin(0.5 * pi * (i - 1)));
    const bool side = (centre - last).norm() > kNoCorner * (x + y + radius);
    if (side) {
      plane_elements.push_back(straight(last + r * outward, centre + r * outward, ++source));
      plane_elements.back().edges = {{edges[i], 0, 0.0, 1.0}};
    }
    plane_elements.push_back(quarter(radius, radius, centre, outwards, 0.5 * pi * (i - 1), 0));
    // Half circles of an obround are one curve.
    const bool goes_on = i > 0 && !side;
    plane_elements.back().source = goes_on ? source : ++source;
  }
  return plane_elements;
}

/// A ridge, there and back, or an apex. It stays where it is: it has no outside.
std::vector<PlaneElement> ridge(const std::vector<Vec2>& corners) {
  if (corners.size() == 1) return {standing(corners.front())};
  std::vector<PlaneElement> sides;
  for (int i = 0; i < 2; ++i) {
    sides.push_back(straight(corners[i], corners[1 - i], i));
    sides.back().edges = {{i, 0, 0.0, 1.0}};
    sides.back().corners = {{i, 0, 0.0}};
  }
  return sides;
}

struct Shaper {
  double outwards = 0.0;
  const std::string& pointer;

  Facts thin_edge(const std::string& polygon, int edge, double length) const {
    return {{"corner", edge + 1},
            {"length", length, unit::mm},
            {"inwards", -outwards, unit::mm},
            {"edge", place::pointer(polygon + "/" + std::to_string(edge))}};
  }

  Elements operator()(const PolygonProfile& given) const {
    const std::string place = pointer + "/polygon";
    if (given.corners.size() == 1 || given.corners.size() == 2) {
      if (auto sound = check_ridge(given.corners, place); !sound) return pass_on(sound);
      return ridge(given.corners);
    }
    const auto polygon = convex(given, place);
    if (!polygon) return pass_on(polygon);
    const auto turning = mapped(polygon->turns, [&](int i) { return polygon->corners[i]; });
    const std::vector<Vec2> moved = mitred(turning, outwards);
    std::vector<PlaneElement> plane_elements;
    for (std::size_t k = 0; k < turning.size(); ++k) {
      const std::size_t next = (k + 1) % turning.size();
      const Vec2 edge = turning[next] - turning[k];
      PlaneElement plane_element = straight(moved[k], moved[next], static_cast<int>(k));
      add_given(plane_element, *polygon, k, edge.norm());
      if ((moved[next] - moved[k]).dot(edge) <= 0.0)
        return fail(refuse::thicker_than_edge,
                    thin_edge(place, plane_element.edges.front().number, edge.norm()), place);
      plane_elements.push_back(std::move(plane_element));
    }
    return plane_elements;
  }

  Elements operator()(const EllipseProfile& e) const {
    const std::string place = pointer + (e.rx == e.ry ? "/circle" : "/ellipse");
    if (auto sound = check_sizes({e.rx, e.ry}, place); !sound) return pass_on(sound);
    const double tightest = std::min(e.rx * e.rx / e.ry, e.ry * e.ry / e.rx);
    if (auto fits = check_radius(tightest, outwards, place); !fits) return pass_on(fits);
    std::vector<PlaneElement> plane_elements;
    for (int i = 0; i < 4; ++i)
      plane_elements.push_back(quarter(e.rx, e.ry, Vec2::Zero(), outwards, 0.5 * pi * i, 0));
    return plane_elements;
  }

  Elements operator()(const RoundedRectangleProfile& r) const {
    const std::string place = pointer + "/rounded_rectangle";
    if (auto sound = check_sizes({r.width, r.height}, place); !sound) return pass_on(sound);
    const double most = 0.5 * std::min(r.width, r.height);
    if (!(r.radius >= 0.0) || !std::isfinite(r.radius) || r.radius > most)
      return fail(refuse::radius_too_large, {{"radius", r.radius, unit::mm},
                                             {"most", most, unit::mm},
                                             {"field", place::pointer(place + "/radius")}});
    const double x = 0.5 * r.width, y = 0.5 * r.height;
    if (r.radius == 0.0) return (*this)(PolygonProfile{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}});
    if (auto fits = check_radius(r.radius, outwards, place); !fits) return pass_on(fits);
    return rounded(x - r.radius, y - r.radius, r.radius, outwards, {0, 1, 2, 3});
  }

  Elements operator()(const ObroundProfile& o) const {
    const std::string place = pointer + "/obround";
    if (auto sound = check_sizes({o.length, o.width}, place); !sound) return pass_on(sound);
    if (o.length < o.width)
      return fail(refuse::obround_too_short, {{"length", o.length, unit::mm},
                                              {"width", o.width, unit::mm},
                                              {"field", place::pointer(place + "/length")}});
    const double radius = 0.5 * o.width;
    if (auto fits = check_radius(radius, outwards, place); !fits) return pass_on(fits);
    return rounded(0.5 * o.length - radius, 0.0, radius, outwards, {0, -1, 1, -1});
  }

  Elements operator()(const SplineProfile& given) const {
    const std::string place = pointer + "/spline";
    std::vector<Vec2> points = given.points;
    if (auto sound = check_polygon(points, place); !sound) return pass_on(sound);
    if (ring_area(points) < 0.0) std::ranges::reverse(points);
    const PeriodicSpline spline(points);
    if (auto sound = check_convex(spline, outwards, place); !sound) return pass_on(sound);
    const PlaneCurve curve = set_off(spline, outwards);
    const auto& knots = spline.knots();
    constexpr int kParts = 4;  // of a plane_element of the spline: none turns by more than 90°
    std::vector<PlaneElement> plane_elements;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
      for (int part = 0; part < kParts; ++part) {
        PlaneElement& plane_element = plane_elements.emplace_back();
        plane_element.curve = curve;
        plane_element.t0 = std::lerp(knots[k], knots[k + 1], part / double(kParts));
        plane_element.t1 = std::lerp(knots[k], knots[k + 1], (part + 1) / double(kParts));
        plane_element.period = knots.back();
        plane_element.knots = knots;
      }
    return plane_elements;
  }
};

}  // namespace

Result<std::vector<PlaneElement>> elements_of(const Profile& profile, double outwards,
                                              const std::string& pointer) {
  return std::visit(Shaper{outwards, pointer}, profile);
}

}  // namespace planish::transition_detail
