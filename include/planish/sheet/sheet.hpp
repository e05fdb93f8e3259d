#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/developable.hpp>
#include <planish/geometry/frame.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// Index types: which row of the sheet's vectors is meant.
enum class FaceId : int {};
enum class FlangeId : int {};
enum class BendId : int {};
constexpr int index_of(FaceId id) { return static_cast<int>(id); }
constexpr int index_of(FlangeId id) { return static_cast<int>(id); }
constexpr int index_of(BendId id) { return static_cast<int>(id); }

/// One border curve of a face, in the (u, v) of the face's surface: mm on a plane; see
/// geometry/developable.hpp for bends. `edge` names the edge of the solid it came from (−1: none),
/// so that a certificate can measure against the solid.
struct Border {
  Curve2 curve;
  int edge = -1;
  double edge_depth = 0.0;   ///< how far below the reference skin that edge lies, mm (0, or the
                             ///< thickness)
  double edge_length = 0.0;  ///< length measured on the original edge, mm; 0 when not known
  int feature = -1;  ///< formed feature that the material goes on into beyond this border; −1: a
                     ///< cut
};
using BorderLoop = std::vector<Border>;

/// A piece of the sheet's reference surface: a plane region (of a flange) or a region of a
/// developable surface (of a bend). `sense` is +1 when the skin's outward normal (away from the
/// material) is the surface's normal, −1 when it is the opposite; planes always have +1 (their z).
/// Loops keep the face on their left seen from outside the material; loops[0] is the outer one.
struct Face {
  std::variant<Frame, Developable> surface;
  int sense = 1;
  std::vector<BorderLoop> loops;
  std::variant<FlangeId, BendId> part_of;
  int source_face = -1;  ///< face number in the solid (1-based, as `planish info` counts), −1: none
  std::vector<int> merged_faces;  ///< numbers of coplanar faces that became part of this one
};

/// Position of a border: loops[loop][border] of a face.
struct BorderRef {
  FaceId face{};
  int loop = 0;
  int border = 0;
  friend bool operator==(const BorderRef&, const BorderRef&) = default;
};

/// Two faces meeting along a border: the two borders are the same edge, run in opposite directions.
/// Smooth (`sharp` empty) or folded sharply, then `sharp` names a bend without faces.
struct Joint {
  BorderRef a;
  BorderRef b;
  std::optional<BendId> sharp;
};

/// A planar part: its coplanar faces, connected or bridged by bends.
struct Flange {
  std::vector<FaceId> faces;
};

enum class BendKind { cylinder, cone, general, sharp };

/// A ruling of a bend where the press brake strikes, and by how much; all of them make the bend.
struct PressLine {
  double u = 0.0;  ///< of the ruling, on the surface of the bend's faces
  Angle angle;
};

/// Everything that turns between two flanges about one developable surface.
struct Bend {
  BendKind kind = BendKind::cylinder;
  std::vector<FaceId> faces;   ///< empty for sharp bends
  Angle angle;                 ///< bend angle α > 0, the angle through which the sheet was turned
  double inside_radius = 0.0;  ///< mm; for cones at mid-length, for general bends the smallest of
                               ///< the middles of their rulings
  bool reference_inside = false;            ///< the reference skin is the inside (concave) one
  std::vector<PressLine> press_lines = {};  ///< u growing; empty: one in the middle, or rolled
};

/// What a maker saw that a flat pattern only outlines. Contours made of borders marked with the
/// feature are drawn, not cut; `outlines` adds loops that bound no material (a countersink's rim).
struct FormedFeature {
  std::string kind;  ///< "countersink", "slanted cut", "pocket", "chamfer", "formed" (emboss,
                     ///< louvre, lance, burr, boss)
  FaceId face{};     ///< face on which `outlines` are given
  std::vector<BorderLoop> outlines;  ///< in that face's (u, v)
  int source_face = -1;              ///< a face of the feature in the solid (1-based)
  Error at_rim;  ///< why there is no flat pattern when it reaches the outer contour
};

/// The name of a point of a face, for drawings and templates.
struct PointLabel {
  FaceId face{};
  Vec2 at;  ///< (u, v) on that face
  std::string text;
};

/// A sheet: one flat, inextensible region and the way it is folded. The reference surface is one of
/// its two skins, the other lies `thickness` towards the material; or it is a surface between them,
/// `reference_depth` below the skin it stands for. Where the neutral surface is that one, sharp
/// bends are hinges that take no allowance.
struct Sheet {
  double thickness = 0.0;         ///< mm
  double reference_depth = 0.0;   ///< mm, 0 to the thickness
  double thickness_spread = 0.0;  ///< largest − smallest distance of the skins found, mm
  double volume = 0.0;            ///< of the solid, mm³; 0 when there is none
  std::vector<Face> faces;
  std::vector<Joint> joints;
  std::vector<Flange> flanges;
  std::vector<Bend> bends;
  std::vector<FormedFeature> features;
  std::vector<PointLabel> labels;
  double forms_volume = 0.0;   ///< what the features add to the plain sheet (pockets: negative),
                               ///< mm³…
  bool forms_measured = true;  ///< …all of them, or only as far as could be told
  double mitres_volume = 0.0;  ///< what corners folded sharply hold more than a bend's arc, mm³
};

/// Outward unit normal of the reference surface at (u, v).
Vec3 outward_normal(const Face& face, const Vec2& uv);
/// Point of the reference surface at (u, v).
Vec3 skin_point(const Face& face, const Vec2& uv);

}  // namespace planish
