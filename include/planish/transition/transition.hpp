#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/progress.hpp>
#include <planish/geometry/mesh.hpp>
#include <planish/sheet/sheet.hpp>
#include <planish/transition/profile.hpp>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// Which face of the sheet the profiles are given for.
enum class SizesAre { inside, mid, outside };

/// Where the sheet is closed, on the first profile: in the middle of an edge, at a corner, or at
/// the share `parameter` (0 to 1) of its length from the start of edge 0, or of the curve.
struct SeamEdge {
  int edge = 0;
};
struct SeamCorner {
  int corner = 0;
};
struct SeamParameter {
  double parameter = 0.0;
};
using Seam = std::variant<SeamEdge, SeamCorner, SeamParameter>;

/// How each curved patch is pressed: by a number of lines, by the largest angle of a line, or by
/// the largest distance between lines along the wider profile. Lines by count or angle bend by
/// equal angles; lines by chord are equally spaced.
struct PressCount {
  int count = 1;
};
struct PressAngle {
  Angle largest = Angle::degrees(10.0);
};
struct PressChord {
  double largest = 0.0;  ///< mm
};
using Pressing = std::variant<std::monostate, PressCount, PressAngle, PressChord>;

/// One piece, two halves (the second seam opposite, at half the first profile's length), or a piece
/// for each side of the first profile.
enum class Division { one, two, per_side };

struct TransitionSpec {
  double thickness = 0.0;  ///< mm
  double k_factor = 0.5;   ///< where the neutral surface is
  PlacedProfile from, to;
  SizesAre sizes_are = SizesAre::mid;
  std::optional<Seam> seam;  ///< default: where the weld is shortest
  Division pieces = Division::one;
  Pressing pressing;  ///< default: rolled
};

enum class PatchKind { plane, cylinder, cone, general };

/// A part of the surface between two rulings: a plane (triangle or quadrilateral), a cylinder of
/// any section, whose rulings are parallel, a cone with its apex in a corner or anywhere, or a
/// developable between two curves.
struct TransitionPatch {
  PatchKind kind = PatchKind::plane;
  double area = 0.0;               ///< of the neutral surface, mm²
  std::array<double, 2> border{};  ///< lengths along both profiles, mm
  Angle turn;                      ///< between the normals at both ends, along the surface
};

/// A ruling that a template shows: between patches, at a seam, or a press line. Labels: corners of
/// the first profile are A, B, C …, of the second a, b, c …, points on curves are numbered along.
struct TrueLength {
  std::string from, to;
  std::array<Vec3, 2> points{};
  double length = 0.0;  ///< mm
  int piece = 0;
  std::string press;  ///< number of the press line, as in flat patterns: "B2.3"; empty for other
                      ///< rulings
};

/// A developable surface between two profiles, as sheets that lie flat.
struct Transition {
  /// One per piece. Their reference surface is the neutral one; flanges are the planes, bends the
  /// curved patches and the sharp folds, in the order of the profile. Labels name the ends of all
  /// true lengths.
  std::vector<Sheet> pieces;
  std::vector<TransitionPatch> patches;  ///< in the order of the profile; a patch divided by a seam
                                         ///< counts once
  std::vector<TrueLength> true_lengths;
  double area = 0.0;                   ///< of the neutral surface, mm²
  std::array<double, 2> perimeters{};  ///< of the neutral surface's borders on both profiles, mm
  /// The neutral surface, facing outwards: a closed ring without a seam; corners on one ruling are
  /// shared.
  Mesh mesh;
};

/// A piece prepared to become a solid: corners where cones or several folds meet are cut off if
/// their inside radius would be less than a tenth of the thickness, and the seam of a transition in
/// one piece is 0.01 mm open, so that its two edges are distinct.
struct FoldedPiece {
  Sheet sheet;
  double cut_area = 0.0;                       ///< of the neutral surface, mm²: what was cut off
  std::array<std::array<Vec3, 2>, 2> seams{};  ///< ends in space of its first and last ruling
  std::optional<std::array<Vec3, 2>> ridge = {};  ///< where both slopes of a roof meet, unjoined
};

struct TransitionOptions {
  /// Largest error of points of general developables, as a share of the profiles' extent.
  double tolerance = 1e-11;
  /// Largest distance of the mesh's facets from the surface, approximately; mm.
  double mesh_chord = 0.05;
};

/// The surface that bounds the opening between two convex profiles in two planes: the lateral
/// boundary of their convex hull (math.md#lateral-hull), made of planes, cones and general
/// developables whose tangent plane touches both profiles. Profiles are offset in their planes from
/// the face that they are given for to the neutral surface, so the surface meets an adjoining sheet
/// at its neutral surface. `where` of an error is the place of its cause in the request, written as
/// a JSON pointer ("/from/profile/polygon/2"). Errors (exit status 3): `invalid_input` (numbers not
/// finite, or sizes not positive), `too_few_corners`, `repeated_corner`, `self_crossing`,
/// `unknown_seam`. Errors (exit status 4): `profile_not_convex`, `profiles_meet` (they touch,
/// pierce each other or lie in one plane), `profile_hidden` (one crosses the other's plane, so that
/// a part of it is inside the hull), `radius_too_small` (thickness too large for a profile or a
/// bend). Error (exit status 2): `bad_option` (a tolerance or a chord is not positive). Error (exit
/// status 1): `cancelled`.
Result<Transition> make_transition(const TransitionSpec& spec,
                                   const TransitionOptions& options = {},
                                   const Progress& progress = {});

/// The same pieces, prepared to become solids. Errors: those of `make_transition`;
/// `radius_too_small` also where the thickness leaves too little between corners.
Result<std::vector<FoldedPiece>> folded_pieces(const TransitionSpec& spec,
                                               const TransitionOptions& options = {});

}  // namespace planish
