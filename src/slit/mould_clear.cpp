#include "mould_clear.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>

// Whether ribs stand apart, and where one comes up through the sheet (math.md#mould). Walls are
// upright, so footprints that are apart suffice for the first; for the second, facets and the skins
// of quads are laid over each other as seen from above, and where both are the facet must be lower.
// The height between two planes is linear, so the corners of what they share decide.

namespace planish::slit_detail {
namespace {

constexpr double kSharedArea = tolerance::kComputed;  // of the smallest area

/// A strip as files name it.
std::string where_of(int strip) { return "strip " + std::to_string(strip); }

/// Footprints of ribs, then of walls, that overlap.
tl::unexpected<Error> overlapping(const Overlap& overlap, const std::vector<MouldRib>& ribs,
                                  const Frame& base) {
  Facts facts{{"area", overlap.area, unit::mm2}};
  const auto add = [&](int footprint) {
    if (footprint >= std::ssize(ribs)) return false;
    const Place strip = place::strip(ribs[footprint].strip);
    if (facts.size() < 2 || *facts.back().place() != strip) facts.emplace_back("strip", strip);
    return true;
  };
  const bool first = add(overlap.first), second = add(overlap.second);
  const bool twice = second && facts.size() == 2;
  if (!overlap.outline.empty() && !overlap.outline.front().empty())
    facts.emplace_back("at", place::point(base.point(overlap.outline.front().front())));
  return fail(!first    ? refuse::walls_overlap
              : !second ? refuse::rib_overlaps_wall
              : twice   ? refuse::rib_overlaps_image
                        : refuse::ribs_overlap,
              facts, first ? where_of(ribs[overlap.first].strip) : "");
}

/// Regions seen from above: facets of ribs, quads of strips in the middle of their thickness, and
/// the area covered by their material at both skins, always at the height of the skin towards the
/// mould.
enum class Layer { rib, middle, skin };

/// A plane region as seen from above, and its plane.
struct Seen {
  Layer layer = Layer::rib;
  int strip = 0, quad = 0;
  Vec3 on = {};                    ///< in the base's frame
  Vec3 normal = {};                ///< likewise
  std::vector<Vec2> outline = {};  ///< counter-clockwise
  Box2 box = {};
};

Vec2 height_slope(const Seen& piece) { return -piece.normal.head<2>() / piece.normal.z(); }

double height_at(const Seen& piece, const Vec2& p) {
  return piece.on.z() + height_slope(piece).dot(p - piece.on.head<2>());
}

class View {
 public:
  View(const Frame& base, double offset) : base_(base), offset_(offset) {}

  void add(const MouldRib& rib) {
    for (int i = 0; i < std::ssize(rib.facets); ++i) {
      carried_.insert({rib.strip, rib.first_quad + i});
      see({Layer::rib, rib.strip, rib.first_quad + i}, rib.facets[i], rib.facets[i]);
    }
  }

  void add(const WholeStrip& strip, int number) {
    const auto skin = [&](int ridge, double sense) {
      return skin_ridge(strip, ridge, sense * offset_);
    };
    for (int quad = 0; quad < std::ssize(strip.towards_mould); ++quad) {
      const auto piece = [&](const std::array<Vec3, 2>& near, const std::array<Vec3, 2>& far) {
        return std::array<Vec3, 4>{near[0], far[0], far[1], near[1]};
      };
      const int own = strip.first + quad;
      const auto middle = piece(strip.ridges[quad], strip.ridges[quad + 1]),
                 below = piece(skin(quad, 1.0), skin(quad + 1, 1.0));
      see({Layer::middle, number, own}, middle, middle);
      see({Layer::skin, number, own}, below, below);
      see({Layer::skin, number, own}, below, piece(skin(quad, -1.0), skin(quad + 1, -1.0)));
    }
  }

  /// Facets and quads are convex, and so is what they share and where the rib is above.
  std::vector<RibThrough> through() const {
    std::vector<RibThrough> all;
    for (const Seen& rib : pieces_) {
      if (rib.layer != Layer::rib) continue;
      for (const Seen& strip : pieces_) {
        if (strip.layer == Layer::rib || !rib.box.overlaps(strip.box) || !matters(rib, strip))
          continue;
        const std::vector<Vec2> above = part_above(rib, strip);
        if (std::abs(ring_area(above)) <= kSharedArea * smallest_) continue;
        RibThrough one{{rib.strip, rib.quad}, {strip.strip, strip.quad}, above};
        for (const Vec2& p : above)
          if (const double height = height_at(rib, p) - height_at(strip, p); height > one.height)
            one.height = height, one.at = in_space(strip, p);
        all.push_back(std::move(one));
      }
    }
    return all;
  }

 private:
  /// Of what both cover, the part where the rib is higher.
  static std::vector<Vec2> part_above(const Seen& rib, const Seen& strip) {
    std::vector<Vec2> part = rib.outline;
    for (std::size_t i = 0; i < strip.outline.size() && !part.empty(); ++i) {
      const Vec2& from = strip.outline[i];
      const Vec2 along = strip.outline[(i + 1) % strip.outline.size()] - from,
                 out(along.y(), -along.x());
      part = clipped(part, out, out.dot(from));
    }
    constexpr double kHigher = 1e-6;  // mm
    // Both heights are linear: that of the strip over the rib's is slope · p + constant.
    const Vec2 slope = height_slope(strip) - height_slope(rib);
    const double constant = height_at(strip, Vec2::Zero()) - height_at(rib, Vec2::Zero());
    return part.empty() ? part : clipped(part, slope, -kHigher - constant);
  }

  Vec3 in_space(const Seen& piece, const Vec2& p) const {
    return base_.point(p) + height_at(piece, p) * base_.z;
  }

  /// The quad that a facet carries and the carried ones beside it are mitred to it. A bare quad
  /// beside it begins at its ridge, and may lead back below it.
  bool matters(const Seen& rib, const Seen& strip) const {
    if (rib.strip != strip.strip || std::abs(rib.quad - strip.quad) > 1)
      return strip.layer == Layer::skin;
    return strip.layer == Layer::middle && !carried_.contains({strip.strip, strip.quad});
  }

  void see(Seen piece, const std::array<Vec3, 4>& plane, const std::array<Vec3, 4>& outline) {
    const Vec3 normal = (plane[2] - plane[0]).cross(plane[3] - plane[1]).normalized();
    piece.on = base_.local(plane[0]);
    piece.normal = {normal.dot(base_.x), normal.dot(base_.y), normal.dot(base_.z)};
    constexpr double kUpright = 1e-3;  // radians: seen from above it is a line
    if (std::abs(piece.normal.z()) < kUpright) return;
    for (const Vec3& corner : outline)
      piece.outline.push_back(base_.local2(corner));
    if (ring_area(piece.outline) < 0.0) std::ranges::reverse(piece.outline);
    smallest_ = std::min(smallest_, ring_area(piece.outline));
    piece.box = box_of(piece.outline);
    pieces_.push_back(std::move(piece));
  }

  const Frame& base_;
  double offset_;
  double smallest_ = std::numeric_limits<double>::infinity();
  std::set<std::pair<int, int>> carried_;
  std::vector<Seen> pieces_;
};

}  // namespace

std::vector<RibThrough> ribs_through(const Mould& mould,
                                     const std::vector<std::vector<WholeStrip>>& strips,
                                     double offset) {
  View view(mould.base, offset);
  for (const MouldRib& rib : mould.ribs)
    view.add(rib);
  for (std::size_t i = 0; i < strips.size(); ++i)
    for (const WholeStrip& strip : strips[i])
      view.add(strip, static_cast<int>(i));
  return view.through();
}

tl::unexpected<Error> refused(const RibThrough& rib) {
  const bool own = rib.rib.strip == rib.strip.strip;
  return fail(own ? refuse::rib_through_own_strip : refuse::rib_through_strip,
              {{"strip", place::strip(rib.rib.strip)},
               {"other", place::strip(rib.strip.strip)},
               {"at", place::point(rib.at)}},
              where_of(rib.rib.strip));
}

Result<void> check_apart(const Mould& mould) {
  std::vector<Polygon> footprints;
  double smallest = std::numeric_limits<double>::infinity();
  for (const MouldRib& rib : mould.ribs) {
    if (!self_crossings(rib.footprint).empty())
      return fail(refuse::overhangs_itself, {{"strip", place::strip(rib.strip)}},
                  where_of(rib.strip));
    footprints.push_back({rib.footprint, {}});
    smallest = std::min(smallest, ring_area(rib.footprint));
  }
  for (const MouldWall& wall : mould.walls)
    footprints.push_back({wall.footprint, {}});
  for (const Overlap& overlap : overlaps(footprints, 0.0, kSharedArea * smallest))
    return overlapping(overlap, mould.ribs, mould.base);
  return {};
}

}  // namespace planish::slit_detail
