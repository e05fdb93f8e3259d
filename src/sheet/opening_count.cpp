// Compares the number of openings in a pattern with that of its solid (math.md#openings-and-genus):
// by Euler's formula the sheet's genus, handles and contours say how many holes a cut may leave;
// those that are missing or too many are then sought one by one to name their places.

#include "opening_count.hpp"

#include "curve_index.hpp"

#include <planish/base/union_find.hpp>

#include <algorithm>
#include <cmath>

// Openings as they should be, by Euler's formula, and as written (math.md#openings-and-genus). A
// sheet that lies flat without covering itself has no handles, so its contours less one for each
// piece are openings. Slits whose ends touch part something off as a closed cut does. Part of the
// certificate: counts come from the sheet's topology, never from the layout.

namespace planish::sheet_detail {
namespace {

/// Contours are merged and fitted on their way into the pattern, far more closely than this, mm.
constexpr double kSame = 1e-3;

Vec2 middle_of(const Loop& loop) {
  const Box2 box = bounds(loop);
  return (box.lo + box.hi) / 2;
}

/// Whether an opening as written is this loop: of its size, in its place.
bool is_same(const Loop& written, const Loop& loop) {
  const Box2 a = bounds(written);
  const Box2 b = bounds(loop);
  if ((a.lo - b.lo).norm() > kSame || (a.hi - b.hi).norm() > kSame) return false;
  return std::abs(std::abs(signed_area(written)) - std::abs(signed_area(loop))) <=
         kSame * length(loop);
}

const Contour* written_opening(const FlatPattern& pattern, const Loop& loop) {
  for (const Contour& opening : pattern.openings)
    if (is_same(opening.loop, loop)) return &opening;
  return nullptr;
}

/// The opening of the pattern that is this hole, larger or smaller.
const Contour* written_as(const FlatPattern& pattern, const Relaid& laid, FaceId face,
                          const FormedOpening& opening) {
  const Contour* pilot = written_opening(pattern, image_of_cut(laid, face, opening.pilot));
  return pilot ? pilot : written_opening(pattern, image_of_cut(laid, face, opening.through));
}

/// Slits that end on each other are one. Those that reach a contour part nothing off.
int closed_slits(const FlatPattern& pattern) {
  const int count = static_cast<int>(pattern.slits.size());
  if (count == 0) return 0;
  std::vector<Curve2> contours = pattern.outer.loop;
  for (const Contour& opening : pattern.openings)
    contours.insert(contours.end(), opening.loop.begin(), opening.loop.end());
  const CurveIndex index(std::move(contours));
  UnionFind chains(count + 1);  // the last: the contours
  for (int i = 0; i < count; ++i)
    for (const Vec2& end : {start_of(pattern.slits[i]), end_of(pattern.slits[i])}) {
      if (const auto hit = index.nearest(end); hit && hit->distance <= kSame)
        chains.unite(i, count);
      for (int j = 0; j < count; ++j)
        if (nearest(pattern.slits[j], end).distance <= kSame) chains.unite(i, j);
    }
  return chains.count() - 1;
}

/// Corners of the sheet, where borders and joints end.
int corner_count(const Topology& topology) {
  const int borders = static_cast<int>(topology.border_count());
  UnionFind ends(2 * borders);  // 2i: where border i starts, 2i + 1: where it ends
  for (const BorderId id : topology.borders()) {
    ends.unite(2 * index_of(id) + 1, 2 * index_of(topology.next(id)));
    if (const auto twin = topology.twin(id)) {
      ends.unite(2 * index_of(id), 2 * index_of(*twin) + 1);
      ends.unite(2 * index_of(id) + 1, 2 * index_of(*twin));
    }
  }
  return ends.count();
}

/// The contours of the sheet, formed ones too.
std::vector<std::vector<BorderId>> contours_of(const Topology& topology) {
  IdVector<BorderId, bool> seen(topology.border_count(), false);
  std::vector<std::vector<BorderId>> contours;
  for (const BorderId id : topology.borders()) {
    if (seen[id] || !topology.is_free(id)) continue;
    auto& contour = contours.emplace_back();
    for (BorderId at = id; !seen[at]; at = topology.along_contour(at).border) {
      seen[at] = true;
      contour.push_back(at);
    }
  }
  return contours;
}

int connected_pieces(const Sheet& sheet) {
  UnionFind pieces(static_cast<int>(sheet.faces.size()));
  for (const Joint& joint : sheet.joints)
    pieces.unite(index_of(joint.a.face), index_of(joint.b.face));
  return pieces.count();
}

/// Handles of the reference surface: what its Euler number misses for the contours that it has. A
/// sheet that lies flat without covering itself has none.
int handles_of(const Sheet& sheet, const Topology& topology, int contours) {
  const int borders = static_cast<int>(topology.border_count());
  int euler = corner_count(topology) - (borders - static_cast<int>(sheet.joints.size()));
  for (const Face& face : sheet.faces)
    euler += 2 - static_cast<int>(face.loops.size());
  return std::max(0, 2 * connected_pieces(sheet) - contours - euler);
}

/// The middle of a contour of the sheet, laid flat.
Vec2 middle_of_contour(const Sheet& sheet, const Topology& topology, const Relaid& laid,
                       const std::vector<BorderId>& contour) {
  Box2 box;
  for (const BorderId id : contour)
    for (const double t : {0.0, 0.25, 0.5, 0.75})
      box.add(laid.image(topology[id].face, point_at(sheet[topology[id]].curve, t)));
  return (box.lo + box.hi) / 2;
}

/// Contours of the sheet that are not found in the pattern.
void add_missing_contours(std::vector<Vec2>& missing, const Sheet& sheet, const Topology& topology,
                          const Relaid& laid, const FlatPattern& pattern,
                          const std::vector<std::vector<BorderId>>& contours) {
  const CurveIndex index(written_curves(pattern));
  constexpr double kNear = 0.05;  // mm: setbacks and kerfs are not looked at here
  for (const std::vector<BorderId>& contour : contours) {
    if (std::ranges::any_of(contour,
                            [&](BorderId id) { return sheet[topology[id]].feature.has_value(); }))
      continue;
    const BorderRef& first = topology[contour.front()];
    const auto hit = index.nearest(laid.image(first.face, point_at(sheet[first].curve, 0.5)));
    if (!hit || hit->distance > kNear)
      missing.push_back(middle_of_contour(sheet, topology, laid, contour));
  }
}

/// Openings within features that the pattern neither cuts nor lists.
void add_missing_in_forms(std::vector<Vec2>& missing, const Sheet& sheet, const Relaid& laid,
                          const FlatPattern& pattern) {
  for (const FeatureId id : sheet.features.ids()) {
    const FormedFeature& feature = sheet[id];
    const auto row = static_cast<size_t>(index_of(id));
    const FlatFeature* flat = row < pattern.features.size() ? &pattern.features[row] : nullptr;
    if (feature.lost_openings > 0 && flat && !flat->outlines.empty())
      missing.push_back(middle_of(flat->outlines.front()));
    if (flat && flat->uncut_openings > feature.own_openings) continue;  // listed, as was asked
    for (const FormedOpening& opening : feature.openings)
      if (!written_as(pattern, laid, feature.face, opening))
        missing.push_back(middle_of(image_of_cut(laid, feature.face, opening.through)));
    for (const BorderLoop& slit : feature.slits) {
      const Loop image = image_of_cut(laid, feature.face, slit);
      const Vec2 p = point_at(image[image.size() / 2], 0.5);
      const bool cut = std::ranges::any_of(
          pattern.slits, [&](const Curve2& c) { return nearest(c, p).distance <= kSame; });
      if (!cut) missing.push_back(p);
    }
  }
}

}  // namespace

std::vector<Curve2> written_curves(const FlatPattern& pattern) {
  std::vector<Curve2> curves = pattern.outer.loop;
  for (const Contour& opening : pattern.openings)
    curves.insert(curves.end(), opening.loop.begin(), opening.loop.end());
  curves.insert(curves.end(), pattern.slits.begin(), pattern.slits.end());
  return curves;
}

std::vector<const BorderLoop*> cuts_of(const FormedFeature& feature) {
  std::vector<const BorderLoop*> cuts;
  for (const FormedOpening& opening : feature.openings) {
    cuts.push_back(&opening.pilot);
    cuts.push_back(&opening.through);
  }
  for (const BorderLoop& slit : feature.slits)
    cuts.push_back(&slit);
  return cuts;
}

Loop image_of_cut(const Relaid& laid, FaceId face, const BorderLoop& cut) {
  return mapped(
      cut, [&](const Border& border) { return transformed(border.curve, laid.placement[face]); });
}

double area_cut_in_forms(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid) {
  double sum = 0.0;
  for (const FormedFeature& feature : sheet.features)
    for (const FormedOpening& opening : feature.openings)
      if (const Contour* written = written_as(pattern, laid, feature.face, opening))
        sum += std::abs(signed_area(written->loop));
  return sum;
}

OpeningCount counted_openings(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid) {
  const Topology topology(sheet);
  const auto contours = contours_of(topology);
  OpeningCount count;
  count.solid = sheet.genus;
  count.slits = closed_slits(pattern);
  count.pattern = static_cast<int>(pattern.openings.size()) + count.slits;
  for (const FlatFeature& feature : pattern.features)
    count.features += feature.uncut_openings;
  count.loops = handles_of(sheet, topology, static_cast<int>(contours.size()));
  if (count.lost().value_or(0) <= 0) return count;
  add_missing_in_forms(count.missing, sheet, laid, pattern);
  add_missing_contours(count.missing, sheet, topology, laid, pattern, contours);
  return count;
}

}  // namespace planish::sheet_detail
