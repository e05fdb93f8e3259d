#pragma once

#include "convex.hpp"
#include "press_motion.hpp"

#include <planish/base/result.hpp>
#include <planish/brake/plan.hpp>
#include <planish/geometry/interval.hpp>
#include <planish/sheet/layout.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish::brake_detail {

/// A straight line that is pressed at once: of a bend, of several bends between the same two
/// bodies, or one press line of a bend.
struct BrakeLine {
  std::vector<BendId> bends;
  std::optional<int> press_line = {};  ///< of a bend with several: which, from 0
  BendKind kind = BendKind::cylinder;
  Vec2 origin = Vec2::Zero(), along = Vec2::UnitX();  ///< in the pattern; `along` is a unit vector
  std::vector<Interval> pieces;  ///< of material, along the line from the origin
  Angle angle;
  double inside_radius = 0.0;  ///< as drawn; of a sharp bend and of press lines what the V gives
  bool given_radius = true;    ///< whether it is as drawn
  double drawn_radius = 0.0;   ///< of the whole bend, mm
  bool is_large = false;       ///< over a V that leaves its radius (math.md#large-radii)
  std::optional<double> bump_pitch = {};  ///< between bumps of one bend, mm
  /// How far from its lower and its upper end a press line lies in the zone of another of its bend,
  /// which runs together with it there, mm.
  std::array<double, 2> overlapped = {};
  PressedBend bend;                ///< BA, K·T, T
  bool up = true;                  ///< the inside faces the viewer of the pattern
  bool reference_up = true;        ///< the reference skin is the inside
  std::array<int, 2> bodies = {};  ///< on the right of the line and on its left
  /// A hem is two lines at one place: the first bends it by `angle` as far as tools go, the second
  /// closes it to `closed`.
  std::optional<int> closes = {}, closed_by = {};
  Angle closed;

  Vec2 across() const { return {-along.y(), along.x()}; }  ///< to the left
  double from() const { return pieces.front().lo; }
  double to() const { return pieces.back().hi; }
  double length() const { return total(pieces); }  ///< of material
};

/// A straight free border in the pattern, from a to b, the material on its left.
struct FreeEdge {
  Vec2 a, b;
  bool in_opening = false;  ///< along the contour of an opening
};

/// A plane part of the sheet that no line divides.
struct Body {
  std::vector<FaceId> faces;
  std::optional<FlangeId> flange = {};  ///< the first that it belongs to
  std::vector<Convex> pieces;           ///< in the pattern
  std::vector<FreeEdge> edges;
};

/// What lies at a line and is bent there.
struct Zone {
  std::vector<Convex> pieces;   ///< (along, across) from the line's origin, |across| ≤ BA/2
  std::vector<FreeEdge> edges;  ///< in the pattern
};

/// A sheet cut at the lines where it is pressed: bodies in a tree whose branches are the lines.
struct Workpiece {
  double thickness = 0.0;
  std::vector<Body> bodies;
  std::vector<BrakeLine> lines;
  std::vector<Zone> zones;       ///< by line
  std::vector<LargeBend> large;  ///< those that are rolled take no stroke and stay flat
};

struct WorkpieceOptions {
  /// Inside radius of a fold that is drawn without one, and of what is pressed at a press line, mm.
  double air_radius = 1.0;
  /// How far hems are bent before they are closed; 0: they are lines like others.
  Angle before_closing = {};
  /// Bends of a radius that no usual V leaves.
  std::vector<LargeBend> large = {};
};

/// Bends between these angles are hems, unless their radius is large: bent as far as tools go, then
/// closed. What turns further than the drop of an open hem is a roll.
inline constexpr double kHemDegrees = 170.0, kRollDegrees = 225.0;
inline bool is_hem(Angle angle) {
  return angle.degrees() >= kHemDegrees && angle.degrees() <= kRollDegrees;
}

inline bool is_hem(const BrakeLine& line) { return !line.is_large && is_hem(line.angle); }

/// Errors: `no_straight_bend` (a general bend without press lines), `unsupported_shape` (lines that
/// close a loop of bodies and are not one line).
Result<Workpiece> workpiece_of(const Sheet& sheet, const Layout& layout,
                               const WorkpieceOptions& options = {});

/// Whether a body ends at a line.
bool touches(const BrakeLine& line, int body);
/// Whether a line is the given one, closes what that bends, or is closed by it.
bool is_same(const Workpiece& work, int line, int as);
/// Bodies that are reached from one without crossing a line.
std::vector<bool> reached_from(const Workpiece& work, int body, int without);

/// The material of a face in the pattern, without what forms fill.
std::vector<Convex> face_material(const Sheet& sheet, const Layout& layout, FaceId face);

}  // namespace planish::brake_detail
