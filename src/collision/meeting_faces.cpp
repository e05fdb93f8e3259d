#include "block_tree.hpp"
#include "triangle_tree.hpp"

#include <planish/base/assert.hpp>
#include <planish/collision/meeting_faces.hpp>
#include <planish/sheet/folded_blocks.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

// Which faces of a folded sheet share room deeper than `depth` (math.md#self-intersection): a first
// look that may say too much but misses nothing. Boxes come first, then directions in which two
// hulls share too little for a ball, the sheet's own normals among them; only the rest is cut into
// convex blocks, shrunk by half the depth, and these are intersected. Blocks are made when first
// asked for, of flanges with few neighbours only near these.

namespace planish {

using namespace collision_detail;

namespace {

/// Of curved skins and borders; a share of the depth.
constexpr double kChordShare = 0.25;
/// A bend that turns by less cannot reach itself.
constexpr Angle kLeastTurn = Angle::degrees(180);

struct Interval {
  double low = HUGE_VAL, high = -HUGE_VAL;
};

Interval along(const Vec3& direction, const Block& hull) {
  Interval span;
  for (const Vec3& p : hull) {
    const double at = direction.dot(p);
    span.low = std::min(span.low, at);
    span.high = std::max(span.high, at);
  }
  return span;
}

/// How far a face reaches in a direction that may part it from others.
struct Reach {
  Vec3 direction;
  Interval span;
};

Vec3 normal_at(const Face& face, double u) { return outward_normal(face, {u, 0.0}); }

/// How far a face turns from its first ruling to its last.
double turn_of(const Face& face) {
  if (std::holds_alternative<Frame>(face.surface)) return 0.0;
  const Box2 box = parameter_box(face);
  if (!std::holds_alternative<Ruled>(std::get<Developable>(face.surface)))
    return box.hi.x() - box.lo.x();
  constexpr int kSteps = 64;
  double turn = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double step = (box.hi.x() - box.lo.x()) / kSteps;
    const Vec3 from = normal_at(face, box.lo.x() + i * step);
    const Vec3 to = normal_at(face, box.lo.x() + (i + 1) * step);
    turn += angle_between(from, to);
  }
  return turn;
}

/// Directions that may part a face from others: normals, and across the borders to its neighbours.
std::vector<Vec3> directions_of(const Sheet& sheet, FaceId id,
                                const std::vector<BorderRef>& joined) {
  const Face& face = sheet[id];
  if (const auto* plane = std::get_if<Frame>(&face.surface)) {
    std::vector<Vec3> directions{plane->z};
    for (const BorderRef& ref : joined) {
      const Curve2& curve = sheet[ref].curve;
      const Vec2 border = end_of(curve) - start_of(curve);
      directions.push_back((-border.y() * plane->x + border.x() * plane->y).normalized());
    }
    return directions;
  }
  const auto& surface = std::get<Developable>(face.surface);
  const Box2 box = parameter_box(face);
  std::vector<Vec3> directions;
  for (const double u : {box.lo.x(), box.hi.x()}) {
    const Vec3 normal = normal_at(face, u), ruling = ruling_on(surface, u);
    directions.insert(directions.end(), {normal, ruling, normal.cross(ruling)});
  }
  return directions;
}

class FaceSearch {
 public:
  FaceSearch(const Sheet& sheet, double depth)
      : sheet_(sheet), depth_(depth), trees_(sheet.faces.size()) {
    IdVector<FaceId, std::vector<BorderRef>> joined(sheet.faces.size());
    for (const Joint& joint : sheet.joints)
      for (const BorderRef& ref : {joint.a, joint.b})
        joined[ref.face].push_back(ref);
    for (const FaceId id : sheet.faces.ids()) {
      hulls_.push_back(hull_of(sheet, id, kChordShare * depth));
      auto& reaches = reaches_.emplace_back();
      for (const Vec3& direction : directions_of(sheet, id, joined[id]))
        reaches.push_back({direction, along(direction, hulls_.back())});
    }
  }

  std::vector<MeetingFaces> all() {
    std::vector<MeetingFaces> found;
    const auto keep = [&](FaceId a, FaceId b, const Box3& where) {
      if (!where.isEmpty()) found.push_back({{a, b}, where});
    };
    for (const FaceId id : sheet_.faces.ids())
      if (turn_of(sheet_[id]) > kLeastTurn.radians()) keep(id, id, blocks(id)->own_meetings());
    const std::vector<Box3> boxes = hull_boxes();
    const auto pairs = unparted_pairs(boxes);
    IdVector<FaceId, int> others(sheet_.faces.size());
    for (const auto& [a, b] : pairs)
      ++others[a], ++others[b];
    const auto blocks_near = [&](FaceId id, const Box3& box) {
      return others[id] <= kFewOthers && is_flange(id) ? blocks_within(id, box) : blocks(id);
    };
    for (const auto& [a, b] : pairs)
      keep(a, b, blocks_near(a, boxes[index_of(b)])->meetings(*blocks_near(b, boxes[index_of(a)])));
    return found;
  }

 private:
  /// Flanges that few others come near are cut into blocks there only, the rest once and whole.
  static constexpr int kFewOthers = 4;

  bool is_flange(FaceId id) const { return std::holds_alternative<Frame>(sheet_[id].surface); }

  std::vector<std::pair<FaceId, FaceId>> unparted_pairs(const std::vector<Box3>& boxes) const {
    std::vector<std::pair<FaceId, FaceId>> pairs;
    for (const auto& [i, j] : near_boxes(boxes, 0.0))
      if (!parted(FaceId{i}, FaceId{j})) pairs.emplace_back(FaceId{i}, FaceId{j});
    return pairs;
  }

  std::vector<Box3> hull_boxes() const {
    std::vector<Box3> result;
    for (const Block& hull : hulls_) {
      Box3& box = result.emplace_back();
      for (const Vec3& p : hull)
        box.extend(p);
    }
    return result;
  }

  /// Whether what they share in some direction is too narrow for a ball.
  bool parted(FaceId a, FaceId b) const {
    const auto clear_of = [&](const Block& hull) {
      return [&](const Reach& reach) {
        const Interval other = along(reach.direction, hull);
        return std::min(reach.span.high, other.high) - std::max(reach.span.low, other.low) < depth_;
      };
    };
    return std::ranges::any_of(reaches_[a], clear_of(hulls_[b])) ||
           std::ranges::any_of(reaches_[b], clear_of(hulls_[a]));
  }

  std::shared_ptr<const BlockTree> blocks_within(FaceId id, const std::optional<Box3>& box) const {
    return std::make_shared<BlockTree>(folded_blocks(
        sheet_, id, {.inset = 0.5 * depth_, .chord = kChordShare * depth_, .within = box}));
  }

  std::shared_ptr<const BlockTree> blocks(FaceId id) {
    auto& tree = trees_[index_of(id)];
    if (!tree) tree = blocks_within(id, {});
    return tree;
  }

  const Sheet& sheet_;
  double depth_;
  IdVector<FaceId, Block> hulls_;
  IdVector<FaceId, std::vector<Reach>> reaches_;
  std::vector<std::shared_ptr<const BlockTree>> trees_;  ///< by face; made when first asked for
};

}  // namespace

std::vector<MeetingFaces> meeting_faces(const Sheet& sheet, double depth) {
  PLANISH_ASSERT(depth > 0.0);
  require_valid(sheet);
  return FaceSearch(sheet, depth).all();
}

}  // namespace planish
