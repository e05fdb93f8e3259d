#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/id_vector.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/developable.hpp>
#include <planish/geometry/frame.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// Indices into the sheet's lists.
enum class FaceId : int {};
enum class FlangeId : int {};
enum class BendId : int {};
enum class FeatureId : int {};
constexpr int index_of(FaceId id) { return static_cast<int>(id); }
constexpr int index_of(FlangeId id) { return static_cast<int>(id); }
constexpr int index_of(BendId id) { return static_cast<int>(id); }
constexpr int index_of(FeatureId id) { return static_cast<int>(id); }

/// The flange or the bend that a face is a part of.
using PartId = std::variant<FlangeId, BendId>;

/// One border curve of a face, in the (u, v) of the face's surface: mm on a plane; see
/// geometry/developable.hpp for bends.
struct Border {
  Curve2 curve;
  /// The number from 1 of the solid's edge that the border came from; in a sheet that was made, the
  /// border's own. A certificate measures against it. Empty for a border that closes a gap in the
  /// file.
  std::optional<int> edge = {};
  /// The number from 1 of the solid's face on this side of that edge: the face's own, or one that
  /// was merged into it. Empty: not known.
  std::optional<int> source_face = {};
  double edge_depth = 0.0;                 ///< of that edge below the reference surface, mm
  std::optional<double> edge_length = {};  ///< measured on that edge, mm; empty: not known
  std::optional<FeatureId> feature = {};   ///< into which the material continues beyond this border
};
using BorderLoop = std::vector<Border>;

/// A region of the sheet's reference surface: on a plane (of a flange) or on a developable surface
/// (of a bend). `sense` is +1 when the skin's outward normal (away from the material) is the
/// surface's normal, −1 when it is the opposite; planes always have +1 (their z). Loops keep the
/// face on their left seen from outside the material; loops[0] is the outer one.
struct Face {
  std::variant<Frame, Developable> surface;
  int sense = 1;
  std::vector<BorderLoop> loops;
  PartId part_of;
  std::optional<int> source_face = {};  ///< its number in the solid, from 1 as in `info`
  std::vector<int> merged_faces = {};   ///< numbers of coplanar faces that became part of this one
};

/// Position of a border: loops[loop][border] of a face.
struct BorderRef {
  FaceId face{};
  int loop = 0;
  int border = 0;
  friend bool operator==(const BorderRef&, const BorderRef&) = default;
};

/// Two faces meeting along a border: the two borders are the same edge, run in opposite directions.
/// Smooth if `sharp` is empty; else folded sharply, and `sharp` is a bend without faces.
struct Joint {
  BorderRef a;
  BorderRef b;
  std::optional<BendId> sharp = {};
  double mitre_volume = 0.0;  ///< what the corner holds beyond a bend's arc, mm³
};

/// A planar part: its coplanar faces, connected or bridged by bends.
struct Flange {
  std::vector<FaceId> faces;
};

enum class BendKind { cylinder, cone, general, sharp };

/// A ruling of a bend where the press brake strikes, and the angle there; together they make the
/// bend.
struct PressLine {
  double u = 0.0;  ///< of the ruling, on the surface of the bend's faces
  Angle angle;
};

/// Everything that turns between two flanges about one developable surface.
struct Bend {
  BendKind kind = BendKind::cylinder;
  std::vector<FaceId> faces;  ///< empty for sharp bends
  Angle angle;                ///< bend angle α > 0, the angle through which the sheet was turned
  /// mm; of a cone at mid-length, of a general bend the smallest in the middle of its rulings.
  double inside_radius = 0.0;
  bool reference_inside = false;            ///< the reference skin is the inside (concave) one
  std::vector<PressLine> press_lines = {};  ///< u growing; empty: one in the middle, or rolled
};

/// A fold along a line, of no radius, by an angle in radians; below 0 towards the reference skin.
Bend sharp_bend(double angle);

/// A hole through a formed feature (an extruded hole, a hole in an emboss), in the (u, v) of the
/// feature's face; both loops run clockwise (math.md#pilot-holes).
struct FormedOpening {
  BorderLoop pilot;    ///< what is cut before it is formed: `through`, or a smaller hole within
  BorderLoop through;  ///< the smallest section of its passage, projected
};

/// The side of the sheet on which a form shows: where it stands out, opens or is sunk in. `up` is
/// where the outward normal points; in a flat pattern, towards the eye.
enum class FormSide { both, up, down };
/// The same form seen from behind the sheet.
FormSide other_side(FormSide side);
/// "both", "up", "down".
std::string_view side_name(FormSide side);

/// A feature that a flat pattern only outlines. Contours made of borders marked with the feature
/// are drawn, not cut; `outlines` adds loops that are not borders of the material (a countersink's
/// rim).
/// What is cut within them stands in `openings` and `slits`.
struct FormedFeature {
  /// "countersink", "thread", "slanted cut", "pocket", "chamfer", "contact" (cut edges that touch
  /// in the solid), or "formed" (emboss, louvre, lance, burr, boss).
  std::string kind;
  FormSide side = FormSide::both;
  FaceId face{};                        ///< the face on which `outlines` are given
  std::vector<BorderLoop> outlines;     ///< in that face's (u, v)
  std::optional<int> source_face = {};  ///< a face of the feature in the solid, from 1
  Error at_rim;                         ///< the refusal if it reaches the outer contour
  std::vector<FormedOpening> openings = {};
  std::vector<BorderLoop> slits = {};  ///< free edges (of louvres, bridges): chains, not closed
  /// Openings of the solid that are the form's alone (the eye of a handle): no cut makes them.
  int own_openings = 0;
  int lost_openings = 0;              ///< openings of the solid there for which no cut was found
  std::vector<BorderRef> along = {};  ///< free borders that it follows (a slanted cut)
  /// Of a slanted cut: how far the solid reaches beyond what is cut, on the skin that the pattern
  /// does not follow, mm; below 0 where it ends within.
  std::optional<double> beyond_cut = {};
};

/// What a solid lacks at an opening of a plane face, measured on its walls: the certificate holds
/// what is cut there against it (math.md#opening-balance).
struct MeasuredOpening {
  FaceId face{};
  int loop = 0;
  double lacking = 0.0;    ///< between the skins, mm³
  double beyond = 0.0;     ///< of that, what lies around the cut: countersinks, chamfers, grooves
  double intrusion = 0.0;  ///< how far walls reach into the cut, seen along the normal, mm
  /// Of an opening that is a part of that loop, over faces: this border is of it, and only
  /// `intrusion` is known.
  std::optional<int> border = {};
};

/// What a solid is beside the outline of a plane face that is cut, seen along its normal.
struct MeasuredOutline {
  FaceId face{};
  Vec2 at = Vec2::Zero();  ///< (u, v) on that face of what reaches farthest
  double beyond = 0.0;     ///< how far it reaches beyond the outline, mm
  double lacking = 0.0;    ///< between the skins within it: rebates, recesses, chamfers, mm³
};

/// The name of a point of a face, for drawings and templates.
struct PointLabel {
  FaceId face{};
  Vec2 at;  ///< (u, v) on that face
  std::string text;
};

/// A sheet: one flat, inextensible region and the way it is folded. The reference surface is one of
/// its two skins, with the other `thickness` away through the material; or a surface between them,
/// `reference_depth` below that skin. If it is also the neutral surface, sharp bends are hinges
/// without allowance.
///
/// A value: makers build it (`SheetBuilder`), everything else only reads it, and relies on what
/// `check` guarantees.
struct Sheet {
  double thickness = 0.0;         ///< mm
  double reference_depth = 0.0;   ///< mm, 0 to the thickness
  double thickness_spread = 0.0;  ///< largest − smallest distance of the skins found, mm
  std::optional<double> volume;   ///< of the solid, mm³; empty: not measured, or no solid
  std::optional<int> genus;       ///< of the solid: its openings; empty: not known, or no solid
  IdVector<FaceId, Face> faces;
  std::vector<Joint> joints;
  IdVector<FlangeId, Flange> flanges;
  IdVector<BendId, Bend> bends;
  IdVector<FeatureId, FormedFeature> features;
  std::vector<MeasuredOpening> measured_openings;  ///< of a solid; those within planes
  std::vector<MeasuredOutline> measured_outlines;  ///< of a solid; those that the rim may overhang
  std::vector<PointLabel> labels;
  /// What the features add to the plain sheet (pockets: negative), mm³; empty if one of them cannot
  /// be measured.
  std::optional<double> forms_volume = 0.0;
  double pressed_volume = 0.0;  ///< of forms that have the sheet's thickness, mm³, coarse
  double mitres_volume = 0.0;   ///< what sharply folded corners hold beyond a bend's arc, mm³

  /// The item of an id. Ids and positions outside this sheet fail an assertion.
  const Face& operator[](FaceId id) const { return faces[id]; }
  const Flange& operator[](FlangeId id) const { return flanges[id]; }
  const Bend& operator[](BendId id) const { return bends[id]; }
  const FormedFeature& operator[](FeatureId id) const { return features[id]; }
  const Border& operator[](const BorderRef& ref) const;
  Border& operator[](const BorderRef& ref);

  /// Whether the face has that loop, and the loop that border.
  bool has(const BorderRef& ref) const;
  /// The faces of a flange or a bend; empty for a sharp bend.
  const std::vector<FaceId>& faces_of(PartId part) const;
};

/// Outward unit normal of the reference surface at (u, v).
Vec3 outward_normal(const Face& face, const Vec2& uv);
/// Point of the reference surface at (u, v).
Vec3 skin_point(const Face& face, const Vec2& uv);
Box2 bounds(const BorderLoop& loop);
/// Box of the outer loop in (u, v), and of those of all faces of a bend.
Box2 parameter_box(const Face& face);
Box2 parameter_box(const Sheet& sheet, const Bend& bend);
/// The middle of that box.
inline double middle_u(const Face& face) {
  const Box2 box = parameter_box(face);
  return 0.5 * (box.lo.x() + box.hi.x());
}

/// Checks what all functions of a sheet rely on: sizes are numbers in range, frames are
/// right-handed, every id exists, faces and their parts refer to each other, planes belong to
/// flanges and surfaces of a bend's kind to bends, loops are closed to 0.1 mm, no border is in two
/// joints, sharp joints and bends without faces refer to each other, press lines are rulings of
/// their bend. Error: `invalid_sheet`, with the rule that is broken; `where` names the item ("face
/// 3, loop 0, border 2"), the first place is its path in the value ("/faces/3/loops/0/borders/2").
/// O(borders).
Result<void> check(const Sheet& sheet);
/// Stops at an assertion that names the rule and the row: for functions that return no `Result`.
void require_valid(const Sheet& sheet);

}  // namespace planish
