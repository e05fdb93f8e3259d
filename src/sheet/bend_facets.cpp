// Cuts a bend along rulings into strips that are nearly flat, by equal turns of the normal: as many
// as the allowed turn and the allowed chord error take. Borders are sampled where they cross a
// ruling and between, so that a strip's material is what lies between pairs of sides (even-odd),
// trapezoid by trapezoid. The strips cover the bend and share their rulings exactly; one isometry
// for each puts it into space.

#include "bend_facets.hpp"

#include "feature_borders.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

// A bend cut along rulings into facets of equal turn. Rulings are placed by the turn of the normal,
// sampled along u, and not by u, which is no measure on a general surface. A border is sampled so
// that chords keep to their tolerance, and with a corner on each ruling that it crosses; a facet is
// what lies between neighbouring corners of two sides, trapezoid by trapezoid, so notches and
// openings need no Boolean operation.

namespace planish::sheet_detail {
namespace {

using tolerance::kComputed;

}  // namespace

BendFacets::BendFacets(const Sheet& sheet, const Layout& layout, BendId bend,
                       const FacetOptions& options)
    : sheet_(sheet),
      face_(sheet[sheet[bend].faces.front()]),
      development_(*layout.development[bend]),
      placement_(layout.placement[sheet[bend].faces.front()]),
      chord_(options.chord) {
  const Box2 range = parameter_box(sheet, sheet[bend]);
  lo_ = range.lo.x();
  hi_ = range.hi.x();
  v_lo_ = range.lo.y();
  v_hi_ = range.hi.y();
  place_rulings(options);
  for (int strip = 0; strip < count(); ++strip)
    normals_.push_back(outward_normal(face_, {u_of_strip(strip), 0.0}));
  sides_.resize(static_cast<size_t>(count()));
  polygons_.resize(static_cast<size_t>(count()));
  edges_.resize(static_cast<size_t>(count()));
}

void BendFacets::place_rulings(const FacetOptions& options) {
  constexpr int kSamples = 64;
  const auto& surface = std::get<Developable>(face_.surface);
  std::vector<double> turned{0.0};
  Vec3 before = normal_on(surface, lo_);
  for (int i = 1; i <= kSamples; ++i) {
    const double u = std::lerp(lo_, hi_, i / double(kSamples));
    const Vec3 here = normal_on(surface, u);
    turned.push_back(turned.back() + angle_between(before, here));
    before = here;
    for (const double v : {v_lo_, v_hi_})
      speed_ = std::max(speed_, development_.jacobian({u, v}).col(0).norm());
  }
  const double whole = turned.back(), radius = speed_ * (hi_ - lo_) / whole;
  const double by_chord = 2.0 * std::acos(std::max(0.0, 1.0 - options.chord / radius));
  const int strips = std::max(
      1,
      static_cast<int>(std::ceil(whole / std::min(by_chord, options.most.radians()) - kComputed)));
  rulings_.push_back(lo_);
  size_t above = 1;
  for (int i = 1; i < strips; ++i) {
    const double wanted = whole * i / strips;
    while (turned[above] < wanted)
      ++above;
    const double share = (wanted - turned[above - 1]) / (turned[above] - turned[above - 1]);
    rulings_.push_back(std::lerp(lo_, hi_, (static_cast<double>(above - 1) + share) / kSamples));
  }
  rulings_.push_back(hi_);
}

Segment BendFacets::ruling(int i) const {
  const double u = rulings_[i];
  return {image({u, v_lo_}), image({u, v_hi_})};
}

double BendFacets::turn(int from, int to) const {
  const Vec3 axis = ruling_on(std::get<Developable>(face_.surface), rulings_[std::max(from, to)]);
  const Vec3 a = normal(from), b = normal(to);
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

int BendFacets::strip_at(double u) const {
  const auto above = std::upper_bound(rulings_.begin() + 1, rulings_.end() - 1, u);
  return static_cast<int>(above - rulings_.begin()) - 1;
}

int BendFacets::beside(FaceId id, double u) const {
  double middle = 0.0;
  const BorderLoop& loop = sheet_[id].loops.front();
  for (const Border& border : loop)
    middle += start_of(border.curve).x() / static_cast<double>(loop.size());
  const double aside = tolerance::kAside * (hi_ - lo_);
  return strip_at(u + (middle > u ? aside : -aside));
}

Eigen::Isometry3d BendFacets::in_space(int strip, double depth) const {
  const auto& surface = std::get<Developable>(face_.surface);
  const Vec2 uv(u_of_strip(strip), 0.5 * (v_lo_ + v_hi_));
  const Vec2 at = image(uv);
  const Eigen::Matrix2d jacobian = placement_.linear() * development_.jacobian(uv);
  const Vec2 along = jacobian.col(1).normalized();
  const double side = jacobian.determinant() > 0.0 ? 1.0 : -1.0;
  const Vec3 ruling = ruling_on(surface, uv.x()), up = side * normal_on(surface, uv.x());
  // The pattern's frame with y along the ruling and z up, and the same frame in space.
  Eigen::Matrix3d flat, space;
  flat << Vec3(along.y(), -along.x(), 0.0), Vec3(along.x(), along.y(), 0.0), Vec3::UnitZ();
  space << ruling.cross(up), ruling, up;
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  placed.linear() = space * flat.transpose();
  const Vec3 middle = skin_point(face_, uv) - depth * outward_normal(face_, uv);
  placed.translation() = middle - placed.linear() * Vec3(at.x(), at.y(), 0.0);
  return placed;
}

/// Parameters between which chords deviate from a curve by at most `chord_`.
void BendFacets::add_stops(const Curve2& curve, std::vector<double>& stops) const {
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    // Over a turn h the second derivative is at most radius · h², measured on the surface.
    const double radius = std::max(speed_, 1.0) * arc->radius;
    const int parts = static_cast<int>(
        std::ceil(std::abs(arc->sweep) * std::sqrt(radius / (8.0 * chord_))));
    for (int i = 1; i < parts; ++i)
      stops.push_back(i / double(parts));
  }
  const auto* spline = std::get_if<CubicSpline>(&curve);
  if (!spline) return;
  const size_t pieces = spline->poles.size() / 3;
  for (size_t i = 0; i < pieces; ++i) {
    double second = 0.0;  // difference of poles, measured on the surface
    for (size_t k = 3 * i; k < 3 * i + 2; ++k) {
      const Vec2 d = spline->poles[k] - 2.0 * spline->poles[k + 1] + spline->poles[k + 2];
      second = std::max(second, std::hypot(speed_ * d.x(), d.y()));
    }
    // A cubic's second derivative is at most six times that; a chord over h deviates by h²/8 of it.
    const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(0.75 * second / chord_))));
    for (int k = 0; k < parts; ++k)
      stops.push_back((static_cast<double>(i) + k / double(parts)) / static_cast<double>(pieces));
  }
  std::erase(stops, 0.0);
}

std::vector<Vec2> BendFacets::sampled_in_strips(const Curve2& curve) const {
  std::vector<double> stops;
  for (const double u : rulings_)
    for (const double t : crossings(curve, Vec2(u, 0.0), Vec2(0.0, 1.0)))
      if (t > 0.0 && t < 1.0) stops.push_back(t);
  add_stops(curve, stops);
  std::ranges::sort(stops);
  std::vector<Vec2> points{start_of(curve)};
  for (size_t i = 0; i < stops.size(); ++i) {
    if (i > 0 && stops[i] - stops[i - 1] < tolerance::kRounding) continue;
    Vec2 p = point_at(curve, stops[i]);
    // A crossing lies on its ruling, not beside it.
    const auto near = std::ranges::lower_bound(rulings_, p.x() - kComputed * (hi_ - lo_));
    if (near != rulings_.end() && std::abs(*near - p.x()) <= kComputed * (hi_ - lo_)) p.x() = *near;
    points.push_back(p);
  }
  points.push_back(end_of(curve));
  return points;
}

void BendFacets::add_loop(FaceId id, int loop, const std::vector<bool>& joined) {
  const Face& face = sheet_[id];
  const BorderLoop& borders = face.loops[loop];
  const auto form = outlined_form(face, loop, joined);
  for (size_t i = 0; i < borders.size(); ++i) {
    const int number = static_cast<int>(borders_.size());
    const std::vector<Vec2> points = sampled_in_strips(borders[i].curve);
    for (size_t k = 1; k < points.size(); ++k) {
      const Vec2 &a = points[k - 1], &b = points[k];
      const int strip = strip_at(0.5 * (a.x() + b.x()));
      if (!joined[i]) edges_[strip].push_back({{image(a), image(b)}, number});
      if (a.x() != b.x() && !form)
        sides_[strip].push_back(a.x() < b.x() ? UvSegment{a, b} : UvSegment{b, a});
    }
    if (!joined[i])
      borders_.push_back({{id, loop, static_cast<int>(i)}, feature_at(borders[i], form)});
  }
}

void BendFacets::close() {
  for (int strip = 0; strip < count(); ++strip) {
    const std::vector<UvSegment>& sides = sides_[strip];
    // Between neighbouring corners, the region between two sides, one above the other, is a
    // trapezoid.
    std::vector<double> corners;
    for (const UvSegment& side : sides) {
      corners.push_back(side.a.x());
      corners.push_back(side.b.x());
    }
    std::ranges::sort(corners);
    for (size_t i = 1; i < corners.size(); ++i) {
      const double from = corners[i - 1], to = corners[i];
      if (to - from <= tolerance::kRounding * (hi_ - lo_)) continue;
      std::vector<std::array<double, 2>> heights;  // of the sides across, at both ends
      for (const UvSegment& side : sides) {
        if (side.a.x() > from || side.b.x() < to) continue;
        const auto at = [&](double u) {
          return std::lerp(side.a.y(), side.b.y(), (u - side.a.x()) / (side.b.x() - side.a.x()));
        };
        heights.push_back({at(from), at(to)});
      }
      std::ranges::sort(heights, {}, [](const auto& h) { return h[0] + h[1]; });
      for (size_t k = 0; k + 1 < heights.size(); k += 2) {
        const auto &low = heights[k], &high = heights[k + 1];
        std::vector<Vec2> ring{image({from, low[0]}), image({to, low[1]}), image({to, high[1]}),
                               image({from, high[0]})};
        if (ring_area(ring) < 0.0) std::ranges::reverse(ring);
        polygons_[strip].push_back({std::move(ring), {}});
      }
    }
  }
}

}  // namespace planish::sheet_detail
