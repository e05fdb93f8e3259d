#include "outline.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/id_vector.hpp>
#include <planish/geometry/box_tree.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

// A contour as a polygon of few corners that contains all within `reach` of it. It is simplified
// (Douglas and Peucker), then grown by the reach and by what simplifying may have cut off, with
// sharp corners, and cut at the contour's own box grown by the reach: so a part as long as the
// sheet still fits. The tolerance grows until the corners are few enough, as what nesting costs
// grows with their square.

namespace planish::nest_detail {
namespace {

using Ring = std::vector<Vec2>;

/// Corners first … last of an open chain that keep it within `tolerance` (Douglas and Peucker),
/// without the last.
void keep_corners(const Ring& points, std::size_t first, std::size_t last, double tolerance,
                  Ring& kept) {
  std::size_t farthest = first;
  double most = tolerance;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = planish::distance(points[i],
                                              {points[first], points[last % points.size()]});
    if (distance > most) {
      most = distance;
      farthest = i;
    }
  }
  if (farthest == first) {
    kept.push_back(points[first]);
    return;
  }
  keep_corners(points, first, farthest, tolerance, kept);
  keep_corners(points, farthest, last, tolerance, kept);
}

/// A ring of fewer corners; no point of either is farther than `tolerance` from the other.
Ring simplified(const Ring& ring, double tolerance) {
  const auto far = std::ranges::max_element(
      ring, {}, [&](const Vec2& p) { return (p - ring.front()).squaredNorm(); });
  const auto middle = static_cast<std::size_t>(far - ring.begin());
  if (middle == 0) return ring;
  Ring kept;
  keep_corners(ring, 0, middle, tolerance, kept);
  keep_corners(ring, middle, ring.size(), tolerance, kept);
  return kept;
}

Path path_of(const Ring& ring) {
  Path path = mapped(ring,
                     [&](const Vec2& p) { return IntPoint(in_units(p.x()), in_units(p.y())); });
  if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  return path;
}

Path rectangle(const Box2& box) {
  return path_of({box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}});
}

Path largest(const Paths& paths) {
  PLANISH_ASSERT(!paths.empty());
  return *std::ranges::max_element(paths, {}, [](const Path& p) { return ClipperLib::Area(p); });
}

/// The polygon grown by `reach`, corners kept sharp, without the holes that growing closes.
Path grown(const Path& path, double reach) {
  ClipperLib::ClipperOffset offset;
  offset.AddPath(path, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  Paths result;
  offset.Execute(result, std::ceil(reach / kUnit));
  return largest(result);
}

Path common(const Path& a, const Path& b) {
  ClipperLib::Clipper clipper;
  clipper.AddPath(a, ClipperLib::ptSubject, true);
  clipper.AddPath(b, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(ClipperLib::ctIntersection, result, ClipperLib::pftNonZero,
                  ClipperLib::pftNonZero);
  return largest(result);
}

Path cleaned(Path path) {
  ClipperLib::CleanPolygon(path);
  return path;
}

bool has_curves(const Loop& contour) {
  return !std::ranges::all_of(contour,
                              [](const Curve2& c) { return std::holds_alternative<Segment>(c); });
}

/// The box that far outwards. Outlines end there: a sharp corner that is grown may go on beyond.
Path limits_of(const Box2& box, double reach) { return rectangle(widened(box, reach)); }

/// The ring's neighbourhood, as polygons of ever fewer corners, until one has few enough.
Path neighbourhood(const Loop& contour, const Box2& box, double reach) {
  constexpr std::array kTolerances{0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0};  // mm
  constexpr double kCoarsest = 0.05;  // of the smaller size
  const Path limits = limits_of(box, reach);
  for (const double tolerance : kTolerances) {
    if (tolerance > kCoarsest * box.size().minCoeff()) break;
    // Half for the chords, half for the corners left out.
    const Ring ring = simplified(sampled(contour, 0.5 * tolerance), 0.5 * tolerance);
    if (ring.size() < 3 || ring.size() > 2 * kMostCorners) continue;
    const Path outline = cleaned(common(grown(path_of(ring), reach + tolerance), limits));
    if (outline.size() <= kMostCorners) return outline;
  }
  return limits;
}

}  // namespace

cInt in_units(double mm) { return std::llround(mm / kUnit); }

Path outline_around(const Loop& contour, double reach) {
  const Box2 box = bounds(contour);
  if (!has_curves(contour) && contour.size() <= kMostCorners) {
    Ring ring = mapped(contour, [&](const Curve2& curve) { return start_of(curve); });
    const Path outline = cleaned(
        reach > 0.0 ? common(grown(path_of(ring), reach), limits_of(box, reach)) : path_of(ring));
    if (outline.size() <= kMostCorners) return outline;
  }
  return neighbourhood(contour, box, reach);
}

}  // namespace planish::nest_detail
