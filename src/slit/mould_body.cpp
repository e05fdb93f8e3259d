#include "mould_body.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/mesh_volume.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

// The mould as one body (math.md#mould): ribs, walls behind upright panels, a plate. Walls are
// bands behind the panel as seen from above, as high as the panel or as strips over them allow. The
// plate's top is the triangulation of what stands on it, and as a triangulation leaves out corners
// between others on a line, those are divided in again: the body is closed because every part
// shares its corners, and that is checked.

namespace planish::slit_detail {
namespace {

constexpr double kTouching = tolerance::kComputed;

/// The facets of a panel in space: points where they meet, at the free edge, and how high each
/// reaches.
struct Standing {
  std::vector<Vec3> free_edge;      ///< one more than facets
  std::vector<Vec3> towards_mould;  ///< by facet
  double top = std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
};

Vec3 itself(const Vec3& v) { return v; }

/// The panel, or its mirror image.
Standing standing(const std::vector<PanelFacet>& panel, const WallSetting& setting,
                  Vec3 (*seen_as)(const Vec3&)) {
  Standing all;
  for (const PanelFacet& facet : panel) {
    const auto at = [&](std::size_t corner) {
      return seen_as(facet.frame.point(facet.corners[corner]));
    };
    const auto height = [&](std::size_t corner) { return at(corner).dot(setting.plan.z); };
    all.free_edge.push_back(at(0));
    all.towards_mould.push_back(setting.sign * seen_as(facet.frame.z));
    all.top = std::min({all.top, height(1), height(2)});
    all.bottom = std::min({all.bottom, height(0), height(3)});
  }
  all.free_edge.push_back(seen_as(panel.back().frame.point(panel.back().corners[3])));
  return all;
}

bool is_upright(const Standing& panel, const Vec3& up) {
  return std::ranges::all_of(panel.towards_mould, [&](const Vec3& normal) {
    return std::abs(normal.dot(up)) <= kUprightPanel;
  });
}

/// The strip between two offsets from the panel.
std::vector<Vec2> band(const Standing& panel, const Frame& plan, double from, double to) {
  std::vector<Vec2> near, far;
  for (int i = 0; i < std::ssize(panel.free_edge); ++i) {
    const Vec3 step = mitre(panel.towards_mould, i);
    near.push_back(plan.local2(panel.free_edge[i] + from * step));
    far.push_back(plan.local2(panel.free_edge[i] + to * step));
  }
  near.insert(near.end(), far.rbegin(), far.rend());
  if (ring_area(near) < 0.0) std::ranges::reverse(near);
  return near;
}

Result<MouldWall> wall_behind(const Standing& panel, const WallSetting& setting) {
  MouldWall wall;
  wall.footprint = band(panel, setting.plan, setting.offset, setting.offset + setting.depth);
  // Facets under strips lie half the thickness off them: they keep clear of the wall, and of the
  // panel that hangs before it, by more.
  wall.room = band(panel, setting.plan, -3.0 * setting.offset,
                   3.0 * setting.offset + setting.depth);
  wall.bottom = panel.bottom;
  wall.top = panel.top;
  if (self_crossings(wall.footprint).empty() && self_crossings(wall.room).empty()) return wall;
  return fail(refuse::wall_through_itself, {{"depth", setting.depth, unit::mm}});
}

std::vector<Vec2> seen(const std::array<Vec3, 2>& near, const std::array<Vec3, 2>& far,
                       const Frame& plan) {
  return {plan.local2(near[0]), plan.local2(far[0]), plan.local2(far[1]), plan.local2(near[1])};
}

/// The lowest that the skin of a quad comes over a footprint.
std::optional<double> lowest_over(const std::vector<Vec2>& footprint, const WholeStrip& strip,
                                  int quad, const WallSetting& setting) {
  const auto near = skin_ridge(strip, quad, setting.offset),
             far = skin_ridge(strip, quad + 1, setting.offset);
  const Polygon over{seen(near, far, setting.plan), {}};
  const double area = std::abs(ring_area(over.outer));
  const Vec3& normal = strip.towards_mould[quad];
  const double lean = normal.dot(setting.plan.z);
  if (std::abs(lean) <= kUprightPanel || !(area > 0.0)) return std::nullopt;
  std::optional<double> lowest;
  for (const Overlap& overlap : overlaps({{footprint, {}}, over}, 0.0, kTouching * area))
    for (const auto& ring : overlap.outline)
      for (const Vec2& p : ring) {
        const Vec2 away = p - setting.plan.local2(near[0]);
        const double height = near[0].dot(setting.plan.z) -
                              (away.x() * normal.dot(setting.plan.x) +
                               away.y() * normal.dot(setting.plan.y)) /
                                  lean;
        lowest = std::min(lowest.value_or(height), height);
      }
  return lowest;
}

/// Points of the plate by their place, as a triangulation gives them back.
class PlateCorners {
 public:
  PlateCorners(const Mesh& mesh, const Frame& plan) : plan_(plan), mesh_(mesh) {}

  void add(int point) {
    const Vec2 p = plan_.local2(mesh_.points[point]);
    by_x_.emplace(p.x(), point);
    extent_ = std::max({extent_, std::abs(p.x()), std::abs(p.y())});
  }

  std::optional<int> at(const Vec2& p) const {
    constexpr double kGrid = 1e-8;  // of the extent; the triangulation moves corners less
    const double near = kGrid * extent_;
    std::optional<int> found;
    double least = near;
    for (auto i = by_x_.lower_bound(p.x() - near); i != by_x_.end() && i->first <= p.x() + near;
         ++i)
      if (const double away = (plan_.local2(mesh_.points[i->second]) - p).norm(); away <= least)
        least = away, found = i->second;
    return found;
  }

 private:
  const Frame& plan_;
  const Mesh& mesh_;
  std::multimap<double, int> by_x_;
  double extent_ = 0.0;
};

/// A part's mesh without its underside, its lower half of points on the plate.
void stand(Mesh& body, const Mesh& part, const Frame& plan, double plate) {
  const int first = static_cast<int>(body.points.size()),
            below = static_cast<int>(part.points.size()) / 2;
  for (std::size_t i = 0; i < part.points.size(); ++i)
    body.points.push_back(part.points[i] + (static_cast<int>(i) < below ? 0.0 : plate) * plan.z);
  for (const auto& t : part.triangles)
    if (std::ranges::any_of(t, [&](int corner) { return corner < below; }))
      body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

using Triangles = std::vector<std::array<int, 3>>;

/// Divides the triangle at the line from a ring's corner to a later one, so that it has the corners
/// between them too, which lie on that line. False if there is no such triangle.
bool divide(Triangles& triangles, const std::vector<int>& line) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t side = 0; side < 3; ++side) {
      const int from = triangles[i][side], to = triangles[i][(side + 1) % 3],
                opposite = triangles[i][(side + 2) % 3];
      const bool forwards = from == line.front() && to == line.back();
      if (!forwards && !(from == line.back() && to == line.front())) continue;
      std::vector<int> run = line;
      if (!forwards) std::ranges::reverse(run);
      triangles[i] = {run[0], run[1], opposite};
      for (std::size_t k = 1; k + 1 < run.size(); ++k)
        triangles.push_back({run[k], run[k + 1], opposite});
      return true;
    }
  return false;
}

/// A triangulation leaves out corners that lie on the straight line between others.
bool take_corners_between(Triangles& triangles, const std::vector<int>& ring) {
  std::set<int> used;
  for (const auto& t : triangles)
    used.insert(t.begin(), t.end());
  const auto first = std::ranges::find_if(ring, [&](int point) { return used.contains(point); });
  if (first == ring.end()) return false;
  std::vector<int> line{*first};
  const std::size_t start = static_cast<std::size_t>(first - ring.begin());
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    const int point = ring[(start + i) % ring.size()];
    line.push_back(point);
    if (!used.contains(point)) continue;
    if (line.size() > 2 && !divide(triangles, line)) return false;
    line = {point};
  }
  return true;
}

/// The plate's top around what stands on it; empty if parts of that touch.
std::optional<Triangles> triangles_around(const std::vector<Vec2>& rim,
                                          const std::vector<std::vector<Vec2>>& standing,
                                          const PlateCorners& corners) {
  Triangles triangles;
  for (const auto& triangle : inset_triangles({rim, standing}, 0.0)) {
    std::array<int, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = corners.at(triangle[i]);
      if (!found) return std::nullopt;
      t[i] = *found;
    }
    const Vec2 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
    if (planish::cross(u, v) < 0.0) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  for (const auto& footprint : standing) {
    std::vector<int> ring;
    for (const Vec2& p : footprint) {
      const auto found = corners.at(p);
      if (!found) return std::nullopt;
      ring.push_back(*found);
    }
    if (!take_corners_between(triangles, ring)) return std::nullopt;
  }
  return triangles;
}

tl::unexpected<Error> touching() { return fail(refuse::not_one_body); }

}  // namespace

Result<std::vector<MouldWall>> walls_of(const FoldedSlitSheet& folded, const WallSetting& setting) {
  std::vector<Standing> panels;
  if (!folded.panel.empty()) panels.push_back(standing(folded.panel, setting, itself));
  // In symmetric sheets it is not one that stands.
  if (!folded.symmetric && !folded.second_panel.empty())
    panels.push_back(standing(folded.second_panel, setting, itself));
  if (folded.symmetric && !panels.empty())
    panels.push_back(standing(folded.panel, setting, mirrored));
  std::vector<MouldWall> walls;
  for (const Standing& panel : panels) {
    if (!is_upright(panel, setting.plan.z)) continue;
    auto wall = wall_behind(panel, setting);
    if (!wall) return pass_on(wall);
    walls.push_back(std::move(*wall));
  }
  return walls;
}

bool is_over(const std::vector<MouldWall>& walls, const WholeStrip& strip, int quad,
             const WallSetting& setting) {
  const Polygon own{seen(strip.ridges[quad], strip.ridges[quad + 1], setting.plan), {}};
  const double smallest = kTouching * std::abs(ring_area(own.outer));
  const Box2 box = box_of(own.outer);
  return std::ranges::any_of(walls, [&](const MouldWall& wall) {
    return box.overlaps(box_of(wall.room)) &&
           !overlaps({{wall.room, {}}, own}, 0.0, smallest).empty();
  });
}

Result<void> raise(std::vector<MouldWall>& walls,
                   const std::vector<std::vector<WholeStrip>>& strips, const WallSetting& setting) {
  constexpr double kLeast = 0.25;
  for (MouldWall& wall : walls) {
    const double height = wall.top - wall.bottom;
    for (const auto& parts : strips)
      for (const WholeStrip& strip : parts)
        for (int quad = 0; quad < std::ssize(strip.towards_mould); ++quad)
          if (const auto lowest = lowest_over(wall.footprint, strip, quad, setting))
            wall.top = std::min(wall.top, *lowest);
    if (wall.top - wall.bottom < kLeast * height)
      return fail(refuse::no_room_for_wall,
                  {{"left", wall.top - wall.bottom, unit::mm}, {"height", height, unit::mm}});
  }
  return {};
}

double lowest_of_panels(const FoldedSlitSheet& folded, const Vec3& up) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto* panel : {&folded.panel, &folded.second_panel})
    for (const PanelFacet& facet : *panel)
      for (const Vec2& corner : facet.corners) {
        const Vec3 p = facet.frame.point(corner);
        lowest = std::min({lowest, p.dot(up), folded.symmetric ? mirrored(p).dot(up) : p.dot(up)});
      }
  return lowest;
}

Mesh wall_mesh(const MouldWall& wall, const Frame& base) {
  Mesh mesh;
  const int count = static_cast<int>(wall.footprint.size());
  const double top = wall.top - base.origin.dot(base.z);
  for (const Vec2& p : wall.footprint)
    mesh.points.push_back(base.point(p) + top * base.z);
  for (const Vec2& p : wall.footprint)
    mesh.points.push_back(base.point(p));
  // The footprint is a band: corner i faces corner n − 1 − i.
  for (int i = 0; i + 1 < count / 2; ++i) {
    const int across = count - 1 - i;
    for (const auto& t : {std::array{i, i + 1, across}, std::array{i + 1, across - 1, across}}) {
      mesh.triangles.push_back(t);
      mesh.triangles.push_back({count + t[0], count + t[2], count + t[1]});
    }
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    mesh.triangles.push_back({i, count + i, count + next});
    mesh.triangles.push_back({i, count + next, next});
  }
  return mesh;
}

Result<Mesh> body_of(const Mould& mould, double plate, double beyond) {
  Mesh body;
  const Frame& plan = mould.base;
  Box2 box;
  std::vector<std::vector<Vec2>> standing;
  const auto add = [&](const Mesh& part, const std::vector<Vec2>& footprint) {
    stand(body, part, plan, plate);
    standing.push_back(footprint);
    for (const Vec2& p : footprint)
      box.add(p);
  };
  for (const MouldRib& rib : mould.ribs)
    add(rib.mesh, rib.footprint);
  for (const MouldWall& wall : mould.walls)
    add(wall.mesh, wall.footprint);
  const Vec2 lo = box.lo - Vec2(beyond, beyond), hi = box.hi + Vec2(beyond, beyond);
  const std::vector<Vec2> rim{lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}};
  const int top = static_cast<int>(body.points.size()), bottom = top + 4;
  for (const double height : {plate, 0.0})
    for (const Vec2& p : rim)
      body.points.push_back(plan.point(p) + height * plan.z);
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    body.triangles.push_back({top + i, bottom + i, bottom + next});
    body.triangles.push_back({top + i, bottom + next, top + next});
  }
  body.triangles.push_back({bottom, bottom + 2, bottom + 1});
  body.triangles.push_back({bottom, bottom + 3, bottom + 2});
  PlateCorners corners(body, plan);
  for (int i = 0; i < bottom; ++i)
    if (std::abs(plan.local(body.points[i]).z() - plate) <= kTouching * (hi - lo).norm())
      corners.add(i);
  const auto top_of_plate = triangles_around(rim, standing, corners);
  if (!top_of_plate) return touching();
  body.triangles.insert(body.triangles.end(), top_of_plate->begin(), top_of_plate->end());
  if (!open_sides(body).empty()) return touching();
  return body;
}

}  // namespace planish::slit_detail
