#include <planish/geometry/plane.hpp>
#include <planish/sheet/drawn_folds.hpp>

#include <cmath>
#include <utility>

// Outlines drawn up to the lines in which plates meet, so that `connect` can fold them there. Each
// border at a fold moves out, square to itself, to where the middle surfaces meet; its ends go
// along the borders beside it, except where these run along the fold. Corners that only divide a
// straight run are left out.

namespace planish {
namespace {

// mm: the smallest inside radius of which `connect` makes a bend.
constexpr double kSmallestRadius = 1e-3;
// Borders beside a fold that lean less than this against it (sine) run along it.
constexpr double kAlong = 0.5;
// Outlines that leave a line by less than this share of the chord run on along it.
constexpr double kOnLine = 1e-3;

using Key = std::tuple<int, int, int>;
Key key_of(const BorderRef& ref) { return {index_of(ref.face), ref.loop, ref.border}; }

/// From the border of a face to where the middle surfaces meet, for a turn of half the bend's
/// angle.
double height_of(const Sheet& sheet, const Bend& bend, bool sharp) {
  if (!sharp) return bend.inside_radius + 0.5 * sheet.thickness;
  const double to_middle = 0.5 * sheet.thickness - sheet.reference_depth;
  return bend.reference_inside ? to_middle : -to_middle;
}

/// Where the end of a border goes that moves by `beyond`, square to itself.
Vec2 moved_end(const Vec2& end, const Vec2& beyond, const Curve2& beside) {
  const auto* side = std::get_if<Segment>(&beside);
  if (side == nullptr) return end + beyond;
  const Vec2 way = (side->b - side->a).normalized();
  const double lean = way.dot(beyond.normalized());
  if (std::abs(lean) < kAlong) return end + beyond;
  return end + beyond.norm() / lean * way;
}

bool runs_on(const Vec2& a, const Vec2& b, const Vec2& c, double tolerance) {
  const Vec2 in = b - a, out = c - b;
  const double longer = std::max(in.norm(), out.norm());
  return std::abs(cross(in, out)) <= tolerance * longer;
}

}  // namespace

bool is_fold(const Bend& bend) {
  return bend.kind == BendKind::sharp ||
         (bend.kind == BendKind::cylinder && bend.inside_radius < kSmallestRadius);
}

ToFoldLines distances_to_fold_lines(const Sheet& sheet) {
  ToFoldLines distances;
  for (const Joint& joint : sheet.joints)
    for (const auto& [at, other] : {std::pair{joint.a, joint.b}, std::pair{joint.b, joint.a}}) {
      if (!std::holds_alternative<FlangeId>(sheet[at.face].part_of)) continue;
      const auto* bend = std::get_if<BendId>(&sheet[other.face].part_of);
      if (!joint.sharp && bend == nullptr) continue;
      const Bend& turned = sheet[joint.sharp ? *joint.sharp : *bend];
      if (!is_fold(turned)) continue;
      distances[key_of(at)] = height_of(sheet, turned, joint.sharp.has_value()) *
                              std::tan(0.5 * turned.angle.radians());
    }
  return distances;
}

std::vector<Curve2> drawn_to_fold_lines(const Sheet& sheet, FaceId face, int loop,
                                        const ToFoldLines& distances) {
  const BorderLoop& borders = sheet[face].loops[loop];
  const int n = static_cast<int>(borders.size());
  const auto curve = [&](int i) -> const Curve2& { return borders[(i + n) % n].curve; };
  std::vector<Curve2> drawn;
  for (int i = 0; i < n; ++i) {
    const auto found = distances.find({index_of(face), loop, i});
    const auto* line = std::get_if<Segment>(&curve(i));
    if (found == distances.end() || line == nullptr) {
      drawn.push_back(curve(i));
      continue;
    }
    const Vec2 along = (line->b - line->a).normalized();
    const Vec2 beyond = found->second * Vec2(along.y(), -along.x());
    const Vec2 a = moved_end(line->a, beyond, curve(i - 1));
    const Vec2 b = moved_end(line->b, beyond, curve(i + 1));
    drawn.insert(drawn.end(), {Segment{line->a, a}, Segment{a, b}, Segment{b, line->b}});
  }
  return drawn;
}

std::vector<Vec2> without_runs(std::vector<Vec2> corners, double chord) {
  for (std::size_t i = 0; i < corners.size() && corners.size() > 3;) {
    const std::size_t n = corners.size();
    if (!runs_on(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n], kOnLine * chord)) {
      ++i;
      continue;
    }
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    i = i > 0 ? i - 1 : 0;
  }
  return corners;
}

}  // namespace planish
