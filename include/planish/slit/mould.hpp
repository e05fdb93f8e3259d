#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/mesh.hpp>
#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish {

/// The skin of the sheet that lies on the mould; `SlitRidge` defines the front. `ground`: the skin
/// that more of the strips' area turns to the ground.
enum class MouldSide { ground, back, front };

/// Separate ribs to be set on a board, or one body: the ribs and walls behind the panels on a base
/// plate.
enum class MouldForm { ribs, body };

struct MouldOptions {
  /// On the ground's side the mould holds the strips while they are pressed down.
  MouldSide side = MouldSide::ground;
  /// Direction in which the sheet is lifted off, from the base to the sheet. Default: up (y) on the
  /// ground's side, down on the other; leaned in steps of 5° (in symmetric sheets within the
  /// symmetry plane) if more than 2 % of the strips would hang free above others.
  std::optional<Vec3> up = {};
  double base = 20.0;  ///< from the lowest point of the working surfaces down to the base plane, mm
  /// How much narrower a rib is than its strip at least, on each side, mm. Default: the thickness,
  /// but no more than leaves a quarter of the width.
  std::optional<double> inset = {};
  Angle draft = Angle::degrees(5);  ///< quads that face `up` by less than this are left bare
  MouldForm form = MouldForm::ribs;
  /// The mould is for strips of this material that spring back: bent on it one by one, each is bent
  /// so far that it keeps its shape (overbend.hpp). Ribs of different strips then stand side by
  /// side, not where the strips are. Needs a yield stress, and ribs.
  std::optional<SlitMaterial> overbend = {};
};

/// A quad of a strip, counted over both halves of symmetric sheets, from one panel to the other.
struct StripQuad {
  int strip = 0;
  int quad = 0;
};

/// A body under one strip: its working surface, upright walls below the strip's long edges and
/// ends, and the base.
struct MouldRib {
  int strip = 0;
  int first_quad = 0;
  /// One plane facet per quad, in order; corners: left near, left far, right far, right near, with
  /// left and right as on the strip's modelled half.
  std::vector<std::array<Vec3, 4>> facets;
  std::vector<Vec2> footprint;  ///< on the base plane, counter-clockwise seen from the sheet
  Mesh mesh;                    ///< closed, outside counter-clockwise
};

/// A wall of one body behind an upright panel, half the thickness away: a prism.
struct MouldWall {
  std::vector<Vec2> footprint;     ///< as a rib's: along the panel, then back along its other side
  std::vector<Vec2> room;          ///< with space around it, in which no rib stands
  double bottom = 0.0, top = 0.0;  ///< heights of the panel's free edge and of the wall, along `up`
  Mesh mesh;                       ///< closed, down to the base plane
};

/// Ribs on a common base plane, placed on a board as their footprints show.
struct Mould {
  Frame base;                        ///< of the base plane, z towards the sheet
  MouldSide side = MouldSide::back;  ///< back or front
  std::vector<MouldRib> ribs;
  std::vector<StripQuad> bare;  ///< without a rib below; in one body, quad −1 is the panel's facet
                                ///< below the strip, where the panel leans
  std::vector<MouldWall> walls;   ///< of one body
  std::optional<Mesh> body = {};  ///< one body: ribs and walls on a plate; closed
  double volume = 0.0;            ///< mm³
};

/// The form on which the strips are laid. Every facet is parallel to its quad, half the thickness
/// away on the mould's side; neighbouring facets meet in a line below their ridge (a mitre), so the
/// sheet lies on all of them at once, its mid-surface where it was designed (math.md#mould). Where
/// a strip is too steep or overhangs it is left bare, and the part after that stands on a rib of
/// its own; the panel needs no support.
///
/// A mould can be cast, milled or printed without undercuts, and the sheet can be lifted off: every
/// rib stands upright on its base, which lies flat on the table even if the sheet's ground leans.
///
/// Where a strip lies over another its rib is cut off beside that one, as far off its edge as the
/// inset, tapering from ridge to ridge; quads of which less than a quarter of the width would be
/// left are bare. There the strip lies on the other one, or hangs free: of the directions tried the
/// first is taken in which next to nothing hangs, else that which carries most.
///
/// As one body (`MouldForm::body`) it has side panels too, as the paper's mould [slits 4.2]: behind
/// every upright panel a wall as deep as `base`, up to the panel's top or to where strips come down
/// over it; quads over a wall have no rib. Under panels that lean over the mould, or lie level,
/// ribs go on to the free edge; panels that lean away are left bare. Ribs and walls stand on a
/// plate half as thick as `base`, below the panels' free edges.
///
/// Errors: `bad_option` (options not finite or outside their range, an inset that leaves no width
/// of a strip, overbending without a yield stress or in one body), `radius_too_small` (a facet
/// between two mitres has no length: the sheet is too thick for the folds there),
/// `unsupported_shape` (no part of the strips faces `up`; a whole strip hangs above others, or
/// walls are in the way: choose another `up` or the other side). `where` names an option (JSON
/// pointer) or "strip i, quad j". Accuracy: rounding. Cost: O(quads · those above or below them)
/// for each lean tried.
Result<Mould> mould_of(const FoldedSlitSheet& folded, const MouldOptions& options = {});

/// All ribs in one mesh, each closed; or the one body.
Mesh mesh_of(const Mould& mould);

}  // namespace planish
