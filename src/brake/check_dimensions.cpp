#include <planish/brake/check_dimensions.hpp>
#include <planish/geometry/curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

// What moves with a flange at a stroke is plane: all that is reached over bends that are not formed
// yet. Its far end is looked for in the flat pattern, and setbacks are added for what lies outside
// the tangent lines: up to 90° to the mould line, beyond to the plane that touches the bend. A bend
// made with another radius takes more or less of the sheet than lies between its tangent lines,
// half of it on either side.

namespace planish {
namespace {

constexpr double kAlongBend = 1.7e-3;  // sine of 0.1°
constexpr double kSameEnd = 0.01;      // mm
constexpr double kShortest = 1.0;      // mm: of an edge that a caliper's jaw touches
constexpr double kNowhere = -std::numeric_limits<double>::infinity();
constexpr double kSameAngle = 0.1;  // degrees

/// How far a plane region reaches along a direction.
struct Reach {
  double straight = kNowhere;  ///< of what is parallel to the bend line, setbacks included
  double any = kNowhere;
};

class Measuring {
 public:
  Measuring(const Sheet& sheet, const Layout& layout, const FlatPattern& flat,
            const FlattenOptions& laid)
      : sheet_(sheet), layout_(layout), flat_(flat), laid_(laid) {
    for (const Joint& joint : sheet_.joints) {
      joints_[key(joint.a)] = {&joint, joint.b};
      joints_[key(joint.b)] = {&joint, joint.a};
    }
  }

  /// Strokes are to be given in order.
  std::optional<CheckDimension> next(const Stroke& stroke) {
    for (const BendId bend : stroke.bends) {
      turned_[bend] += stroke.angle.degrees();
      if (makes_radius(stroke)) made_[bend] = stroke.radius_made;
    }
    std::optional<CheckDimension> shortest;
    for (const auto& [face, border] : sides_of(stroke.bends.front())) {
      const auto length = length_of(stroke, face, border);
      if (length && (!shortest || *length < shortest->length - kSameEnd))
        shortest = {std::get<FlangeId>(sheet_[face].part_of), *length};
    }
    return shortest;
  }

 private:
  using Key = std::tuple<FaceId, int, int>;
  static Key key(const BorderRef& ref) { return {ref.face, ref.loop, ref.border}; }

  /// Where flanges meet a bend.
  std::vector<std::pair<FaceId, BorderRef>> sides_of(BendId bend) const {
    std::vector<std::pair<FaceId, BorderRef>> sides;
    for (const Joint& joint : sheet_.joints)
      for (const auto& [own, other] : {std::pair{joint.a, joint.b}, std::pair{joint.b, joint.a}}) {
        const bool meets = joint.sharp ? *joint.sharp == bend
                                       : sheet_[other.face].part_of == PartId(bend);
        if (meets && std::holds_alternative<FlangeId>(sheet_[own.face].part_of))
          sides.emplace_back(own.face, own);
      }
    return sides;
  }

  /// How much less of the sheet a bend takes than lies between its tangent lines.
  double left_over(BendId bend, double radius) const {
    const auto taken = allowance_of_radius(sheet_, bend, radius, laid_);
    return taken ? layout_.allowance[bend].allowance - taken->allowance : 0.0;
  }

  /// From a tangent line to the outside; empty for a bend that has none, or is not finished.
  std::optional<double> setback(BendId id) const {
    const auto bend = std::ranges::find(flat_.bends, id, &FlatBend::bend);
    const auto turned = turned_.find(id);
    if (bend == flat_.bends.end() || turned == turned_.end()) return std::nullopt;
    const double angle = bend->angle.degrees();
    const bool round = bend->kind == BendKind::cylinder || bend->kind == BendKind::sharp;
    if (!round || turned->second < angle - kSameAngle) return std::nullopt;
    constexpr double kSquare = 90.0;
    const auto made = made_.find(id);
    const double radius = made == made_.end() ? sheet_[id].inside_radius : made->second;
    const double outside = radius + sheet_.thickness;
    const double beyond = angle < kSquare ? outside * std::tan(0.5 * bend->angle.radians())
                                          : outside;
    return beyond + 0.5 * left_over(id, radius);
  }

  /// The bend that is crossed at a joint.
  std::optional<BendId> crossed(const Joint& joint, FaceId to) const {
    if (joint.sharp) return joint.sharp;
    const auto* bend = std::get_if<BendId>(&sheet_[to].part_of);
    return bend ? std::optional(*bend) : std::nullopt;
  }

  /// Away from the face, across one of its borders.
  Vec2 outward(const BorderRef& border) const {
    const Vec2 along = derivative_at(layout_.image(border), 0.5).normalized();
    const bool seen = layout_.placement[border.face].linear().determinant() > 0.0;
    return seen ? Vec2(along.y(), -along.x()) : Vec2(-along.y(), along.x());
  }

  std::optional<double> length_of(const Stroke& stroke, FaceId face,
                                  const BorderRef& border) const {
    const auto own = setback(stroke.bends.front());
    if (!own) return std::nullopt;
    const Vec2 away = -outward(border);
    const double from = away.dot(point_at(layout_.image(border), 0.5));
    const Reach reach = reach_of(face, away, stroke.bends);
    if (reach.straight >= reach.any - kSameEnd) return reach.straight - from + *own;
    if (!stroke.gauge || away.dot(stroke.gauge_direction) <= 0.0) return std::nullopt;
    return away.dot(stroke.gauge->edge.a) - from + *own;
  }

  /// How far the region around a face goes on that lies in its plane.
  Reach reach_of(FaceId start, const Vec2& away, const std::vector<BendId>& pressed) const {
    Reach reach;
    std::vector<FaceId> left{start};
    std::set<FaceId> seen{start};
    while (!left.empty()) {
      const FaceId face = left.back();
      left.pop_back();
      const std::vector<Loop>& loops = layout_.images[face];
      for (int loop = 0; loop < std::ssize(loops); ++loop)
        for (int i = 0; i < std::ssize(loops[loop]); ++i) {
          const BorderRef border{face, loop, i};
          const auto joint = joints_.find(key(border));
          double beyond = 0.0;
          if (joint != joints_.end()) {
            const FaceId to = joint->second.second.face;
            const auto bend = crossed(*joint->second.first, to);
            if (!bend || !turned_.contains(*bend)) {
              if (seen.insert(to).second) left.push_back(to);
              continue;
            }
            if (std::ranges::count(pressed, *bend) > 0) continue;
            beyond = setback(*bend).value_or(kNowhere);
          }
          add(reach, border, away, beyond);
        }
    }
    return reach;
  }

  void add(Reach& reach, const BorderRef& border, const Vec2& away, double beyond) const {
    const Curve2& curve = layout_.image(border);
    const double end = std::max(away.dot(start_of(curve)), away.dot(end_of(curve)));
    reach.any = std::max({reach.any, end, away.dot(point_at(curve, 0.5))});
    const auto* segment = std::get_if<Segment>(&curve);
    if (!segment || outward(border).dot(away) <= 0.0) return;
    const Vec2 along = segment->b - segment->a;
    if (along.norm() < kShortest || std::abs(away.dot(along)) > kAlongBend * along.norm()) return;
    reach.straight = std::max(reach.straight, end + beyond);
  }

  const Sheet& sheet_;
  const Layout& layout_;
  const FlatPattern& flat_;
  const FlattenOptions& laid_;
  std::map<Key, std::pair<const Joint*, BorderRef>> joints_;
  std::map<BendId, double> turned_;  ///< by the strokes so far, degrees
  std::map<BendId, double> made_;    ///< inside radii
};

}  // namespace

std::vector<std::optional<CheckDimension>> check_dimensions(const Sheet& sheet,
                                                            const Layout& layout,
                                                            const FlatPattern& pattern,
                                                            const std::vector<Stroke>& strokes,
                                                            const FlattenOptions& laid) {
  if (sheet.faces.empty()) return std::vector<std::optional<CheckDimension>>(strokes.size());
  Measuring measuring(sheet, layout, pattern, laid);
  return mapped(strokes, [&](const Stroke& stroke) { return measuring.next(stroke); });
}

}  // namespace planish
