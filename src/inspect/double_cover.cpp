// Places that two parts of a sheet cover when it lies flat (math.md#overlap), each by itself:
// overlaps whose boxes come within reach of each other become one place, until none do. And the
// area of faces within a loop, to check what is cut there without using contours.

#include "regions.hpp"

#include <planish/base/assert.hpp>
#include <planish/inspect/double_cover.hpp>

#include <algorithm>
#include <cmath>

namespace planish {

using namespace inspect_detail;

namespace {

/// Overlaps that meet, and are one place.
struct Cover {
  std::vector<Place> parts;
  double area = 0.0;
  std::vector<Vec2> points;
  Box2 box;
};

void add_part(Cover& place, const Place& part) {
  if (std::ranges::find(place.parts, part) == place.parts.end()) place.parts.push_back(part);
}

void take(Cover& place, const Cover& other) {
  for (const Place& part : other.parts)
    add_part(place, part);
  place.area += other.area;
  place.points.insert(place.points.end(), other.points.begin(), other.points.end());
  place.box.add(other.box);
}

/// Boxes that come within `reach` of each other belong to one place.
std::vector<Cover> joined_places(std::vector<Cover> places, double reach) {
  const auto meet = [reach](const Box2& a, const Box2& b) {
    return ((a.lo.array() - reach) <= b.hi.array()).all() &&
           ((b.lo.array() - reach) <= a.hi.array()).all();
  };
  for (size_t i = 0; i < places.size(); ++i)
    for (size_t j = i + 1; j < places.size(); ++j)
      if (meet(places[i].box, places[j].box)) {
        take(places[i], places[j]);
        places.erase(places.begin() + static_cast<std::ptrdiff_t>(j));
        j = i;  // what did not meet it before may do so now
      }
  return places;
}

DoubleCover cover_of(const Cover& place) {
  const EnclosingRectangle box = smallest_rectangle(place.points);
  DoubleCover cover;
  const auto names = mapped(place.parts, [&](const Place& part) { return text_of(part); });
  cover.who = listed(names);
  cover.area = place.area;
  cover.size = box.size;
  cover.along = {std::cos(box.angle), std::sin(box.angle)};
  const Vec2 across = perpendicular(cover.along);
  Box2 extent;
  for (const Vec2& p : place.points)
    extent.add(Vec2(p.dot(cover.along), p.dot(across)));
  const Vec2 middle = (extent.lo + extent.hi) / 2;
  cover.middle = middle.x() * cover.along + middle.y() * across;
  for (const Place& part : place.parts)
    cover.parts.push_back(place::at(part, cover.middle));
  return cover;
}

}  // namespace

std::vector<DoubleCover> double_covers(const Sheet& sheet, const Layout& layout,
                                       const FlatPattern& pattern) {
  PLANISH_ASSERT(layout.images.size() == sheet.faces.size());
  const double clearance = contact_clearance(pattern);
  const Regions regions = regions_of(sheet, layout, 0.25 * clearance);
  std::vector<Cover> places;
  for (const Shared& shared : shared_areas(regions, clearance))
    for (const auto& ring : shared.overlap.outline) {
      Cover& place = places.emplace_back();
      add_part(place, part_place(pattern, shared.first));
      add_part(place, part_place(pattern, shared.second));
      place.area = std::abs(ring_area(ring));
      place.points = ring;
      for (const Vec2& p : ring)
        place.box.add(p);
    }
  std::vector<DoubleCover> covers;
  // Each was shrunk by the clearance.
  for (const Cover& place : joined_places(std::move(places), 4.0 * clearance))
    covers.push_back(cover_of(place));
  return covers;
}

SheetArea::SheetArea(const Sheet& sheet, const Layout& layout, const FlatPattern& pattern)
    : chord_(0.25 * contact_clearance(pattern)),
      polygons_(regions_of(sheet, layout, chord_).polygons) {
  for (const Polygon& polygon : polygons_) {
    Box2& box = boxes_.emplace_back();
    for (const Vec2& p : polygon.outer)
      box.add(p);
  }
}

double SheetArea::within(Polygon loop, const Box2& box) const {
  std::vector<Polygon> pair(2);
  pair[1] = std::move(loop);
  double sum = 0.0;
  for (size_t i = 0; i < polygons_.size(); ++i) {
    if (!boxes_[i].overlaps(box)) continue;
    pair[0] = polygons_[i];
    for (const Overlap& overlap : overlaps(pair, 0.0, 0.0))
      sum += overlap.area;
  }
  return sum;
}

double SheetArea::within(const Loop& loop, const std::vector<Loop>& without) const {
  const Polygon polygon = polygon_of({loop, {}}, chord_);
  const Box2 box = bounds(loop);
  std::vector<Polygon> others;
  for (const Loop& other : without)
    if (bounds(other).overlaps(box)) others.push_back(polygon_of({other, {}}, chord_));
  if (others.empty()) return within(polygon, box);
  return sum_of(inset_triangles(polygon, 0.0, others), [&](const auto& corners) {
    return within(Polygon{{corners.begin(), corners.end()}, {}}, box);
  });
}

}  // namespace planish
