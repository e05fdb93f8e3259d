// Takes a closed outline out of a pattern: the contours are cut where they cross it, and what stays
// outside is joined by stretches of the outline, run clockwise, from where one path enters it to
// where the next leaves. Paths must alternate between entering and leaving around the outline, or
// nothing is cut. Bend lines lose what lies within. Area and perimeter are measured anew.

#include "contour.hpp"
#include "measure.hpp"
#include "refusals.hpp"
#include "spurs.hpp"
#include "trim_bend.hpp"

#include <planish/geometry/minimum.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/cutout.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace planish {

using namespace sheet_detail;

namespace {

/// A stretch of a contour outside the cutout, from its outline to its outline.
struct Stretch {
  Contour curves;
  double from = 0.0, to = 0.0;  ///< where it starts and ends on the outline
};

void append(Contour& to, const Contour& from, size_t i, double t0, double t1) {
  to.loop.push_back(t0 <= 0.0 && t1 >= 1.0 ? from.loop[i] : trimmed(from.loop[i], t0, t1));
  to.origins.push_back(i < from.origins.size() ? from.origins[i] : std::vector<Origin>{});
}

double root(const Curve2& curve, const Cutout& cutout, double a, double b) {
  const bool inside = cutout.distance(point_at(curve, a)) < 0.0;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (a + b) / 2;
    ((cutout.distance(point_at(curve, middle)) < 0.0) == inside ? a : b) = middle;
  }
  return (a + b) / 2;
}

/// Parameters where the curve crosses the cutout's outline, ascending.
std::vector<double> crossings_of(const Curve2& curve, const Cutout& cutout) {
  Box2 box = bounds(curve);
  const double reach = cutout.half.norm();
  box.lo.array() -= reach;
  box.hi.array() += reach;
  if (((cutout.middle.array() < box.lo.array()) || (cutout.middle.array() > box.hi.array())).any())
    return {};
  constexpr int kFewest = 64;
  const double smallest = cutout.half.minCoeff();
  const int steps = std::clamp(static_cast<int>(2 * length(curve) / smallest), kFewest, 1 << 16);
  const auto at = [&](int i) { return static_cast<double>(i) / steps; };
  const auto off = [&](double t) { return cutout.distance(point_at(curve, t)); };
  std::vector<double> found;
  double last = off(0.0);
  for (int i = 1; i <= steps; ++i) {
    const double next = off(at(i));
    if ((last < 0.0) != (next < 0.0)) {
      found.push_back(root(curve, cutout, at(i - 1), at(i)));
    } else if (last >= 0.0 && next >= 0.0) {
      constexpr int kCuts = 45;
      const double middle = least_at(off, at(i - 1), at(i), 2, kCuts);
      if (off(middle) < 0.0) {
        found.push_back(root(curve, cutout, at(i - 1), middle));
        found.push_back(root(curve, cutout, middle, at(i)));
      }
    }
    last = next;
  }
  return found;
}

/// How far along the outline a point of it lies, clockwise.
double clockwise_place(const Loop& outline, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity(), place = 0.0, before = 0.0;
  for (const Curve2& curve : outline) {
    const Nearest hit = nearest(curve, p);
    if (hit.distance < best) {
      best = hit.distance;
      place = before + hit.t * length(curve);
    }
    before += length(curve);
  }
  return place;
}

/// The stretches of one contour outside. Empty if it is all outside, or all inside.
std::vector<Stretch> paths_of(const Contour& contour, const Cutout& cutout, const Loop& outline) {
  std::vector<Stretch> paths;
  bool open = false;  // in a stretch whose start is known
  Contour head;       // before the first crossing: it belongs to the last stretch
  const auto to_current = [&](size_t i, double t0, double t1) {
    append(open ? paths.back().curves : head, contour, i, t0, t1);
  };
  bool outside = cutout.distance(start_of(contour.loop.front())) >= 0.0;
  for (size_t i = 0; i < contour.loop.size(); ++i) {
    double from = 0.0;
    for (const double t : crossings_of(contour.loop[i], cutout)) {
      const double place = clockwise_place(outline, point_at(contour.loop[i], t));
      if (outside) {
        if (t > from) to_current(i, from, t);
        if (open) paths.back().to = place;
        if (!open) paths.push_back({{}, -1.0, place});
        open = false;
      } else {
        paths.push_back({{}, place, 0.0});
        open = true;
      }
      outside = !outside;
      from = t;
    }
    if (outside && from < 1.0) to_current(i, from, 1.0);
  }
  if (paths.empty()) return paths;
  // What was met before the first crossing follows the last stretch.
  if (paths.front().from < 0.0) {
    const double to = paths.front().to;
    paths.erase(paths.begin());
    if (paths.empty()) return paths;
    Stretch& last = paths.back();
    last.curves.loop.insert(last.curves.loop.end(), head.loop.begin(), head.loop.end());
    last.curves.origins.insert(last.curves.origins.end(), head.origins.begin(), head.origins.end());
    last.to = to;
  }
  return paths;
}

/// How near two places of the outline are one, mm.
constexpr double kOnePlace = 1e-6;

/// The outline from one place to another, clockwise; all of it from a place to itself.
Loop along_outline(const Loop& outline, double from, double to) {
  const double whole = length(outline);
  double left = to - from;
  if (left < kOnePlace) left = std::min(left + whole, whole);
  Loop part;
  for (size_t i = 0, laps = 0; left > 0.0 && laps < 2 * outline.size() + 1;
       i = (i + 1) % outline.size(), ++laps) {
    const double size = length(outline[i]);
    if (from >= size) {
      from -= size;
      continue;
    }
    const double end = std::min(size, from + left);
    if (end > from) part.push_back(trimmed(outline[i], from / size, end / size));
    left -= end - from;
    from = 0.0;
  }
  return part;
}

tl::unexpected<Error> covered_twice(const Cutout& cutout) {
  return fail(refuse::relief_parts_nothing, {{"at", place::point(cutout.middle)}});
}

/// Joins the stretches along the outline to closed contours.
Result<std::vector<Contour>> joined_along(std::vector<Stretch> paths, const Cutout& cutout,
                                          const Loop& outline) {
  std::vector<std::pair<double, int>> ends;  // starts as i, ends as −1 − i
  for (int i = 0; i < std::ssize(paths); ++i) {
    ends.emplace_back(paths[i].from, i);
    ends.emplace_back(paths[i].to, -1 - i);
  }
  std::ranges::sort(ends);
  // A slit leaves and enters at one place: out along its left bank, back along the other, from
  // where the outline goes on clockwise.
  for (size_t k = 0; k < ends.size(); ++k) {
    auto &here = ends[k], &after = ends[(k + 1) % ends.size()];
    if (here.second < 0 && after.second >= 0 && std::abs(after.first - here.first) < kOnePlace) {
      std::swap(here, after);
      ++k;
    }
  }
  std::vector<int> next(paths.size(), -1);
  for (size_t k = 0; k < ends.size(); ++k) {
    const int here = ends[k].second, after = ends[(k + 1) % ends.size()].second;
    if ((here < 0) == (after < 0)) return covered_twice(cutout);
    if (here < 0) next[-1 - here] = after;
  }
  std::vector<Contour> contours;
  std::vector<bool> used(paths.size(), false);
  for (int first = 0; first < std::ssize(paths); ++first) {
    if (used[first]) continue;
    Contour& contour = contours.emplace_back();
    for (int at = first; !used[at]; at = next[at]) {
      used[at] = true;
      const Stretch& path = paths[at];
      contour.loop.insert(contour.loop.end(), path.curves.loop.begin(), path.curves.loop.end());
      contour.origins.insert(contour.origins.end(), path.curves.origins.begin(),
                             path.curves.origins.end());
      for (Curve2& curve : along_outline(outline, path.to, paths[next[at]].from)) {
        contour.loop.push_back(std::move(curve));
        contour.origins.emplace_back();
      }
    }
  }
  return contours;
}

/// The parts of a line outside the cutout, which is convex.
std::vector<Segment> outside(const Segment& line, const Cutout& cutout) {
  const std::vector<double> found = crossings_of(line, cutout);
  const bool starts = cutout.distance(line.a) < 0.0, ends = cutout.distance(line.b) < 0.0;
  if (found.empty()) return starts ? std::vector<Segment>{} : std::vector<Segment>{line};
  std::vector<Segment> parts;
  if (!starts) parts.push_back({line.a, point_at(line, found.front())});
  if (!ends) parts.push_back({point_at(line, found.back()), line.b});
  return parts;
}

/// Whether the middle of a cutout that no contour enters lies in the material.
bool in_material(const std::vector<Contour>& contours, const Cutout& cutout) {
  const auto rings = mapped(contours, [&](const Contour& contour) {
    return sampled(contour.loop, cutout.half.minCoeff() / 2);
  });
  return inside(rings, cutout.middle);
}

/// Slits end at the cutout.
std::vector<Curve2> left_of_slits(const std::vector<Curve2>& slits, const Cutout& cutout) {
  std::vector<Curve2> left;
  for (const Curve2& slit : slits) {
    const auto* line = std::get_if<Segment>(&slit);
    if (line == nullptr) {
      left.push_back(slit);
      continue;
    }
    const std::vector<Segment> parts = outside(*line, cutout);
    left.insert(left.end(), parts.begin(), parts.end());
  }
  return left;
}

}  // namespace

double Cutout::distance(const Vec2& p) const {
  const Vec2 d = p - middle;
  const Vec2 local(d.dot(along), cross(along, d));
  const int corner = local.y() >= 0.0 ? (local.x() >= 0.0 ? 0 : 1) : (local.x() < 0.0 ? 2 : 3);
  const double radius = corner == sharp_corner ? 0.0 : corner_radius;
  const Vec2 q = local.cwiseAbs() - half + Vec2::Constant(radius);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

Loop Cutout::outline() const {
  const Vec2 across = perpendicular(along);
  const double turned = std::atan2(along.y(), along.x());
  Loop loop;
  for (int corner = 0; corner < 4; ++corner) {
    const double radius = corner == sharp_corner ? 0.0 : corner_radius;
    const Vec2 inner = half - Vec2::Constant(radius);
    const double x = corner == 0 || corner == 3 ? 1.0 : -1.0, y = corner < 2 ? 1.0 : -1.0;
    const Vec2 centre = middle + x * inner.x() * along + y * inner.y() * across;
    const double start = turned + corner * std::numbers::pi / 2;
    const auto on = [&](double angle) {
      return Vec2(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    };
    if (!loop.empty()) loop.push_back(Segment{end_of(loop.back()), on(start)});
    if (radius > 0.0)
      loop.push_back(Arc{centre, radius, start, std::numbers::pi / 2});
    else if (loop.empty())
      loop.push_back(Segment{centre, centre});
  }
  loop.push_back(Segment{end_of(loop.back()), start_of(loop.front())});
  std::erase_if(loop, [](const Curve2& curve) { return length(curve) <= 0.0; });
  return loop;
}

Result<FlatPattern> without_cutout(FlatPattern pattern, const Cutout& cutout, double tolerance) {
  const Loop outline = reversed(cutout.outline());
  std::vector<Contour> kept;
  std::vector<Stretch> paths;
  const auto take = [&](Contour& contour) {
    std::vector<Stretch> more = paths_of(contour, cutout, outline);
    const bool inside = cutout.distance(start_of(contour.loop.front())) < 0.0;
    if (more.empty() && !inside) kept.push_back(std::move(contour));
    for (Stretch& path : more)
      paths.push_back(std::move(path));
  };
  take(pattern.outer);
  for (Contour& opening : pattern.openings)
    take(opening);
  if (!paths.empty()) {
    auto made = joined_along(std::move(paths), cutout, outline);
    if (!made) return pass_on(made);
    for (const Contour& contour : *made)
      kept.push_back(joined_contour(contour, tolerance));
  } else if (in_material(kept, cutout)) {
    const std::vector<std::vector<Origin>> none(outline.size());
    kept.push_back(joined_contour({outline, none}, tolerance));
  }
  pattern.outer = {};
  pattern.openings.clear();
  for (Contour& contour : kept) {
    if (signed_area(contour.loop) < 0.0) {
      pattern.openings.push_back(std::move(contour));
    } else {
      if (!pattern.outer.loop.empty()) return covered_twice(cutout);
      pattern.outer = std::move(contour);
    }
  }
  if (pattern.outer.loop.empty()) return covered_twice(cutout);
  for (FlatBend& bend : pattern.bends)
    trim_bend(bend, [&](const Segment& line) { return outside(line, cutout); });
  pattern.slits = left_of_slits(pattern.slits, cutout);
  measure(pattern);
  return pattern;
}

FlatPattern with_slits_drawn_once(FlatPattern pattern, double tolerance) {
  const auto take = [&](Contour& contour) {
    WithoutSpurs left = without_spurs(contour, tolerance);
    if (left.slits.empty() || left.contour.loop.empty()) return;
    std::erase_if(left.slits, [](const Segment& slit) { return length(slit) < kShortestSlit; });
    pattern.slits.insert(pattern.slits.end(), left.slits.begin(), left.slits.end());
    contour = std::move(left.contour);
  };
  take(pattern.outer);
  for (Contour& opening : pattern.openings)
    take(opening);
  measure(pattern);
  return pattern;
}

}  // namespace planish
