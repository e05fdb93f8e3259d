#pragma once

#include <planish/geometry/region.hpp>
#include <planish/sheet/allowance.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace planish {

enum class UpSide { automatic, reference, other };

/// What is cut of holes through formed features: the hole that is pierced before forming, the one
/// that is there afterwards, or nothing, free edges of the forms included.
enum class ExtrudedHoles { pilot, through, outline };

/// Fitting tolerance for images of borders that are neither lines nor arcs, mm.
inline constexpr double kImageTolerance = 1e-4;

struct FlattenOptions {
  AllowanceRule allowance = ConstantK{};
  std::vector<std::pair<BendId, double>> bend_k = {};  ///< K of single bends; overrides `allowance`
  /// Inside radii, mm, that single bends are made with instead of the drawn ones, between flanges
  /// in the same planes (math.md#made-flat).
  std::vector<std::pair<BendId, double>> made_radius = {};
  /// The face that stays where it is; default: the largest face of a flange.
  std::optional<FaceId> root = std::nullopt;
  /// Keeps the pattern in the coordinates of the root face; otherwise the longest bend line lies
  /// along x and the pattern's lower left corner at the origin.
  bool keep_root = false;
  UpSide up = UpSide::automatic;  ///< automatic: the side seen from which more bends go up
  ExtrudedHoles extruded = ExtrudedHoles::pilot;
  double curve_tolerance = kImageTolerance;
  double merge_tolerance = 1e-5;    ///< mm: recognition of lines, arcs, circles
  double closure_tolerance = 0.01;  ///< mm: a cycle of joints that closes within this can lie flat
};

/// How a sheet lies in the plane: each bend developed once at its neutral surface, each face
/// placed, each border imaged. Flat pattern, facets, checks and drawings all read this. It
/// describes the sheet as laid: with sharp bends set back if the reference skin is outside, before
/// slits are cut.
///
/// The coordinates are those of the flat pattern, mm. A pattern that shows the sheet from its other
/// side has placements that reflect.
struct Layout {
  FaceId root{};          ///< the face that the tree grew from
  std::vector<int> tree;  ///< the joints kept: a spanning tree, longest joints first
  IdVector<BendId, BendAllowance> allowance;
  IdVector<BendId, std::optional<Development>> development;  ///< empty for sharp bends
  IdVector<FaceId, double> neutral_offset;     ///< neutral surface from the reference surface, mm
  IdVector<FaceId, Isometry2> placement;       ///< developed plane → flat pattern
  IdVector<FaceId, std::vector<Loop>> images;  ///< of the borders, by loop
  double closure = 0.0;  ///< largest mismatch met where joints close a cycle, mm

  const Curve2& image(const BorderRef& ref) const;
  const Loop& outline(FaceId face) const { return images[face].front(); }
  /// Outline and openings of a face, in the flat pattern.
  Region region(FaceId face) const;

  /// Image of a point of a face, given by its (u, v); exact.
  Vec2 develop(const Sheet& sheet, FaceId face, const Vec2& uv) const;
  /// (u, v) of the point of a face whose image is p: the inverse of `develop`.
  Vec2 fold(const Sheet& sheet, FaceId face, const Vec2& p) const;

  /// Whether the pattern's viewer looks at the reference skin.
  bool shows_reference(const Sheet& sheet) const;

  /// Moves the whole layout; a reflection shows the sheet from its other side.
  void move(const Isometry2& motion);
};

/// Lays the faces out from the root, whose coordinates they take: each bend developed at its
/// neutral surface, each face placed by border trihedrons (math.md#border-trihedron) over a tree of
/// the longest joints. Errors: `closed_loop` (a cycle of joints does not close; sheet/rip.hpp
/// finds the rips), `not_a_sheet` (joints do not lead to every face), `no_such_face` (the root),
/// `bad_option` (a tolerance, a bend of `bend_k`), those of `bend_allowance` and of `check`.
Result<Layout> lay_out(const Sheet& sheet, const FlattenOptions& options = {});

/// What a bend takes of the flat sheet if it is drawn with another inside radius. Errors: those of
/// `bend_allowance`.
Result<BendAllowance> allowance_of_radius(const Sheet& sheet, BendId bend, double radius,
                                          const FlattenOptions& options = {});

}  // namespace planish
