// Moves the borders of sharp bends that are seen from outside back to where the bend begins, T
// tan(α/2) from the corner (math.md#setback with r = 0), and cuts their neighbours at the moved
// line: the first that crosses it is trimmed, those passed shrink to points, so that every border
// keeps its index.

#include "set_back.hpp"

#include "refusals.hpp"

#include <planish/sheet/places.hpp>

#include <algorithm>
#include <cmath>

// Sharp bends whose reference skin is outside: borders are moved to where the bend begins,
// t·tan(α/2) into their faces (math.md#setback). From a moved border the loop is walked both ways
// to its first crossing with the new line; borders passed on the way shrink to points and keep
// their indices, so that all that names a border still does.

namespace planish::sheet_detail {
namespace {

/// The line that a border moves to: `distance` into its face.
struct MovedLine {
  Vec2 origin, direction, inwards;
  bool is_beyond(const Vec2& p) const { return (p - origin).dot(inwards) >= 0.0; }
};

MovedLine moved_line(const Curve2& border, double distance) {
  const Vec2 start = start_of(border);
  const Vec2 direction = (end_of(border) - start).normalized();
  const Vec2 inwards = perpendicular(direction);
  return {start + distance * inwards, direction, inwards};
}

/// The border `steps` along the loop from another.
Border& at(BorderLoop& loop, int border, int steps) {
  const int n = static_cast<int>(loop.size());
  return loop[((border + steps) % n + n) % n];
}

void recut(Border& border, const Curve2& curve) {
  border.curve = curve;
  border.edge_length.reset();
}

enum class Way { forward = 1, backward = -1 };

/// Walks away from the border to the first crossing with the line, cuts there and shrinks the
/// borders passed. Empty if no neighbour in the loop reaches the line.
std::optional<Vec2> cut_neighbours(BorderLoop& loop, int border, Way way, const MovedLine& line) {
  const int step = static_cast<int>(way);
  const bool forward = way == Way::forward;
  for (int k = 1; k < static_cast<int>(loop.size()); ++k) {
    Border& neighbour = at(loop, border, step * k);
    const std::vector<double> hits = crossings(neighbour.curve, line.origin, line.direction);
    const Vec2 far = forward ? end_of(neighbour.curve) : start_of(neighbour.curve);
    if (hits.empty() && !line.is_beyond(far)) continue;
    const double t = hits.empty() ? (forward ? 0.0 : 1.0) : (forward ? hits.front() : hits.back());
    const Vec2 corner = point_at(neighbour.curve, t);
    if (t > 0.0 && t < 1.0)
      recut(neighbour,
            forward ? trimmed(neighbour.curve, t, 1.0) : trimmed(neighbour.curve, 0.0, t));
    for (int passed = 1; passed < k; ++passed)
      recut(at(loop, border, step * passed), Segment{corner, corner});
    return corner;
  }
  return {};
}

/// Moves a straight border into its face. False if the face has no room for that.
bool moved_inwards(BorderLoop& loop, int border, double distance) {
  const MovedLine line = moved_line(loop[border].curve, distance);
  const auto end = cut_neighbours(loop, border, Way::forward, line);
  const auto start = cut_neighbours(loop, border, Way::backward, line);
  if (!end || !start || (*end - *start).dot(line.direction) <= 0.0) return false;
  recut(loop[border], Segment{*start, *end});
  return true;
}

bool outward(const Sheet& sheet, const Joint& joint) {
  return joint.sharp && !sheet[*joint.sharp].reference_inside;
}

}  // namespace

bool needs_setback(const Sheet& sheet) {
  return sheet.reference_depth == 0.0 && std::ranges::any_of(sheet.joints, [&](const Joint& joint) {
           return outward(sheet, joint);
         });
}

Result<Sheet> with_setback(const Sheet& sheet) {
  Sheet moved = sheet;
  for (const Joint& joint : sheet.joints) {
    if (!outward(sheet, joint)) continue;
    const double half_turn = sheet[*joint.sharp].angle.radians() / 2;
    const double setback = sheet.thickness * std::tan(half_turn);
    for (const BorderRef& ref : {joint.a, joint.b}) {
      Face& face = moved.faces[ref.face];
      const bool flat = std::holds_alternative<Frame>(face.surface);
      if (flat && moved_inwards(face.loops[ref.loop], ref.border, setback)) continue;
      return fail(refuse::no_room_for_setback,
                  {{"face", place_of(sheet, ref.face)},
                   {"bend", place_of(sheet, *joint.sharp)},
                   {"setback", setback, unit::mm},
                   {"angle", sheet[*joint.sharp].angle.degrees(), unit::degrees}},
                  text_of(place_of(sheet, ref.face)));
    }
  }
  return moved;
}

}  // namespace planish::sheet_detail
