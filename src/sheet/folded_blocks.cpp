// Convex blocks that lie within the material of a folded sheet: flanges between their skins, bends
// between rulings that turn little. A block never leaves the material: outlines are taken at their
// outermost samples and shortened by the inset, and flanges end at the mitre where two of them meet
// sharply.

#include <planish/base/assert.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/folded_blocks.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

// A face's material as convex blocks, for tests of collision (math.md#self-intersection). Flanges
// are inset and triangulated; bends are halved until nearly flat and each block spans the outermost
// points between two rulings, so openings count as material and nothing that matters is missed.
// Beyond a mitre both flanges fill the same room, which is left out.

namespace planish {
namespace {

/// The largest turn of a bend within one block, radians; it bounds narrow bends, the chord wide
/// ones.
constexpr double kLargestTurn = 0.5;
/// Curved borders of bends are sampled at so many places a span; blocks take the outermost.
constexpr int kBorderSamples = 16;
/// A bend is halved this often before its turn is measured: a full turn has no direction.
constexpr int kFirstHalvings = 3;
/// Places within this share of a strip lie on one ruling.
constexpr double kSameRuling = 1e-9;
/// No bend needs more halvings; one that asks for them has a surface that is not regular.
constexpr int kMostHalvings = 14;

/// The heights of the skins over the reference surface, along the outward normal.
struct Skins {
  double lower, upper;
};

Skins skins_of(const Sheet& sheet, double inset) {
  return {sheet.reference_depth - sheet.thickness + inset, sheet.reference_depth - inset};
}

void add_corners(Block& block, const Face& face, const Vec2& uv, const Skins& skins) {
  const Vec3 normal = outward_normal(face, uv), point = skin_point(face, uv);
  block.push_back(point + skins.lower * normal);
  block.push_back(point + skins.upper * normal);
}

std::vector<Vec2> ring_of(const BorderLoop& loop, double chord) {
  Loop curves = mapped(loop, &Border::curve);
  return sampled(curves, chord);
}

/// The strip of a face that its own material and that of the face across a sharp bend fill both.
std::optional<Polygon> beyond_mitre(const Sheet& sheet, const Joint& joint, const BorderRef& own) {
  const Bend& bend = sheet.bends[*joint.sharp];
  const double below = bend.reference_inside ? sheet.reference_depth
                                             : sheet.thickness - sheet.reference_depth;
  const double half_angle = 0.5 * bend.angle.radians();
  const Curve2& curve = sheet[own].curve;
  const Vec2 a = start_of(curve), b = end_of(curve);
  const Vec2 along = (b - a).normalized();
  if (!(below > 0.0)) return std::nullopt;
  const Vec2 inwards = below * std::tan(half_angle) * perpendicular(along);
  return Polygon{{a, b, b + inwards, a + inwards}, {}};
}

std::vector<Polygon> beyond_mitres(const Sheet& sheet, FaceId face) {
  std::vector<Polygon> strips;
  for (const Joint& joint : sheet.joints) {
    if (!joint.sharp) continue;
    for (const BorderRef& own : {joint.a, joint.b})
      if (own.face == face)
        if (auto strip = beyond_mitre(sheet, joint, own)) strips.push_back(*strip);
  }
  return strips;
}

/// What a box covers of a plane, looked at along its normal.
Box2 seen_on(const Frame& plane, const Box3& box) {
  Box2 seen;
  for (int i = 0; i < 8; ++i)
    seen.add(plane.local2(box.corner(static_cast<Box3::CornerType>(i))));
  return seen;
}

std::vector<Block> blocks_of_flange(const Sheet& sheet, FaceId id, const BlockOptions& options) {
  const Face& face = sheet[id];
  Polygon polygon{ring_of(face.loops.front(), options.chord), {}};
  for (std::size_t i = 1; i < face.loops.size(); ++i)
    polygon.holes.push_back(ring_of(face.loops[i], options.chord));
  const Skins skins = skins_of(sheet, options.inset);
  std::optional<Box2> within;
  if (options.within) within = seen_on(std::get<Frame>(face.surface), *options.within);
  std::vector<Block> blocks;
  for (const auto& triangle :
       inset_triangles(polygon, options.inset, beyond_mitres(sheet, id), within)) {
    Block& block = blocks.emplace_back();
    for (const Vec2& corner : triangle)
      add_corners(block, face, corner, skins);
  }
  return blocks;
}

/// Rulings of a bend between which it is nearly flat.
class Rulings {
 public:
  Rulings(const Sheet& sheet, const Face& face, double chord)
      : face_(face), skins_(skins_of(sheet, 0.0)), chord_(chord), box_(parameter_box(face)) {
    at_.push_back(box_.lo.x());
    halve(box_.lo.x(), box_.hi.x(), 0);
  }
  const std::vector<double>& at() const { return at_; }

 private:
  void halve(double from, double to, int halvings) {
    if (halvings < kFirstHalvings || (halvings < kMostHalvings && !nearly_flat(from, to))) {
      const double middle = 0.5 * (from + to);
      halve(from, middle, halvings + 1);
      halve(middle, to, halvings + 1);
    } else {
      at_.push_back(to);
    }
  }
  bool nearly_flat(double from, double to) const {
    const Vec3 first = outward_normal(face_, {from, 0.0}), last = outward_normal(face_, {to, 0.0});
    const double turn = angle_between(first, last);
    double wide = 0.0;
    for (const double v : {box_.lo.y(), box_.hi.y()})
      for (const double height : {skins_.lower, skins_.upper})
        wide = std::max(wide, ((skin_point(face_, {to, v}) + height * last) -
                               (skin_point(face_, {from, v}) + height * first))
                                  .norm());
    return turn <= kLargestTurn && wide * turn <= 8.0 * chord_;
  }

  const Face& face_;
  Skins skins_;
  double chord_;
  Box2 box_;
  std::vector<double> at_;
};

std::vector<Vec2> places_on(const Curve2& curve) {
  int pieces = 1;
  if (const auto* spline = std::get_if<CubicSpline>(&curve))
    pieces = kBorderSamples * static_cast<int>(spline->poles.size() / 3);
  else if (std::holds_alternative<Arc>(curve))
    pieces = kBorderSamples;
  std::vector<Vec2> places;
  for (int i = 0; i <= pieces; ++i)
    places.push_back(point_at(curve, static_cast<double>(i) / pieces));
  return places;
}

/// Adds a stretch of a border to the strips between rulings that it passes.
void add_stretch(std::vector<std::vector<Vec2>>& strips, const std::vector<double>& rulings, Vec2 a,
                 Vec2 b) {
  if (a.x() > b.x()) std::swap(a, b);
  const auto strip_at = [&](double u) {
    const auto after = std::ranges::upper_bound(rulings, u);
    return std::clamp<std::ptrdiff_t>(after - rulings.begin() - 1, 0, std::ssize(strips) - 1);
  };
  const auto at = [&](double u) -> Vec2 {
    const double share = (u - a.x()) / (b.x() - a.x());
    return {u, share > 0.0 ? a.y() + std::min(share, 1.0) * (b.y() - a.y()) : a.y()};
  };
  for (auto i = strip_at(a.x()); i <= strip_at(b.x()); ++i) {
    strips[i].push_back(i == strip_at(a.x()) ? a : at(rulings[i]));
    strips[i].push_back(i == strip_at(b.x()) ? b : at(rulings[i + 1]));
  }
}

/// v of a border at two rulings, straight between them.
struct Rim {
  double from = 0.0, to = 0.0;
  double at(double share) const { return std::lerp(from, to, share); }
};

/// Below all points (`way` 1) or above them (−1): through the outermost at both ends, moved out.
/// The border may be oblique to the rulings, and near an apex even pass it within a strip, so it
/// does not do to take the outermost v of all.
Rim rim_of(const std::vector<Vec2>& points, double from, double to, double way) {
  const auto [left, right] = std::ranges::minmax(points, {}, [](const Vec2& p) { return p.x(); });
  const double first = left.x(), last = right.x(), same = kSameRuling * (to - from);
  const auto outermost_at = [&](double u) {
    double v = HUGE_VAL;
    for (const Vec2& p : points)
      if (std::abs(p.x() - u) <= same) v = std::min(v, way * p.y());
    return v;
  };
  const double start = outermost_at(first);
  const double slope = last - first > same ? (outermost_at(last) - start) / (last - first) : 0.0;
  double moved = 0.0;
  for (const Vec2& p : points)
    moved = std::min(moved, way * p.y() - start - slope * (p.x() - first));
  const auto v_at = [&](double u) { return way * (start + moved + slope * (u - first)); };
  return {v_at(from), v_at(to)};
}

/// What a face covers between two rulings: from its lower rim to its upper one.
struct Strip {
  double from = 0.0, to = 0.0;
  std::array<Rim, 2> rims;
};

/// What a face covers between one ruling and the next.
std::vector<Strip> strips_of(const Face& face, const std::vector<double>& rulings) {
  std::vector<std::vector<Vec2>> points(rulings.size() - 1);
  for (const Border& border : face.loops.front()) {
    const std::vector<Vec2> places = places_on(border.curve);
    for (std::size_t i = 1; i < places.size(); ++i)
      add_stretch(points, rulings, places[i - 1], places[i]);
  }
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double from = rulings[i], to = rulings[i + 1];
    if (points[i].empty() || from >= to) continue;
    strips.push_back(
        {from, to, {rim_of(points[i], from, to, 1.0), rim_of(points[i], from, to, -1.0)}});
  }
  return strips;
}

/// Edges of a bend's material along its rulings: at either rim, on either skin.
class BendEdges {
 public:
  BendEdges(const Face& face, const Skins& skins, std::vector<Strip> strips, double inset)
      : face_(face), heights_{skins.lower, skins.upper}, strips_(std::move(strips)) {
    for (Strip& strip : strips_)
      for (int end = 0; end < 2; ++end) {
        Rim& rim = strip.rims[end];
        rim.from += end == 0 ? inset : -inset;
        rim.to += end == 0 ? inset : -inset;
      }
    if (strips_.empty()) return;
    for (int edge = 0; edge < std::ssize(kept_); ++edge)
      kept_[edge] = {strips_.front().from + share_of(strips_.front(), edge, 0.0, inset),
                     strips_.back().to - share_of(strips_.back(), edge, 1.0, inset)};
  }

  std::vector<Block> blocks() const {
    std::vector<Block> blocks;
    for (const Strip& strip : strips_)
      if (Block block = block_of(strip); !block.empty()) blocks.push_back(std::move(block));
    return blocks;
  }

 private:
  Vec3 point(const Strip& strip, int edge, double u) const {
    const double v = strip.rims[edge / 2].at((u - strip.from) / (strip.to - strip.from));
    return skin_point(face_, {u, v}) + heights_[edge % 2] * outward_normal(face_, {u, v});
  }

  /// How far in u an edge of the strip's first (0) or last (1) ruling moves for `inset` mm straight
  /// across it: near an apex by more than far from it.
  double share_of(const Strip& strip, int edge, double ruling, double inset) const {
    if (inset <= 0.0) return 0.0;
    const double u = ruling == 0.0 ? strip.from : strip.to;
    const Vec3 along = ruling_on(std::get<Developable>(face_.surface), u);
    const Vec3 way = point(strip, edge, strip.to) - point(strip, edge, strip.from);
    const double across = (way - along.dot(way) * along).norm();
    return across > 0.0 ? inset / across * (strip.to - strip.from) : 0.0;
  }

  /// The corners at one ruling after those at the other, each below and above; empty if nothing of
  /// the strip remains.
  Block block_of(const Strip& strip) const {
    const bool low = strip.rims[0].from >= strip.rims[1].from;
    if (low && strip.rims[0].to >= strip.rims[1].to) return {};
    Block block;
    bool remains = false;
    const auto u_of = [&](int edge, double u) {
      return std::clamp(
          std::clamp(u, kept_[edge].first, std::max(kept_[edge].first, kept_[edge].second)),
          strip.from, strip.to);
    };
    for (int edge = 0; edge < 4; ++edge)
      remains |= u_of(edge, strip.from) < u_of(edge, strip.to) &&
                 kept_[edge].first < kept_[edge].second;
    if (!remains) return {};
    for (const double u : {strip.from, strip.to})
      for (int edge = 0; edge < 4; ++edge)
        block.push_back(point(strip, edge, u_of(edge, u)));
    return block;
  }

  const Face& face_;
  std::array<double, 2> heights_;
  std::vector<Strip> strips_;
  std::array<std::pair<double, double>, 4> kept_{};  ///< by edge: its u from … to
};

std::vector<Block> blocks_of_bend(const Sheet& sheet, FaceId id, const BlockOptions& options) {
  const Face& face = sheet[id];
  const std::vector<double> rulings = Rulings(sheet, face, options.chord).at();
  return BendEdges(face, skins_of(sheet, options.inset), strips_of(face, rulings), options.inset)
      .blocks();
}

bool is_flange(const Face& face) { return std::holds_alternative<Frame>(face.surface); }

}  // namespace

std::vector<Block> folded_blocks(const Sheet& sheet, FaceId face, const BlockOptions& options) {
  PLANISH_ASSERT(options.chord > 0.0 && options.inset >= 0.0);
  if (2.0 * options.inset >= sheet.thickness) return {};
  return is_flange(sheet[face]) ? blocks_of_flange(sheet, face, options)
                                : blocks_of_bend(sheet, face, options);
}

Block hull_of(const Sheet& sheet, FaceId face, double chord) {
  Block hull;
  if (is_flange(sheet[face])) {
    for (const Vec2& corner : ring_of(sheet[face].loops.front(), chord))
      add_corners(hull, sheet[face], corner, skins_of(sheet, 0.0));
  } else {
    for (const Block& block : blocks_of_bend(sheet, face, {.inset = 0.0, .chord = chord}))
      hull.insert(hull.end(), block.begin(), block.end());
  }
  return hull;
}

}  // namespace planish
