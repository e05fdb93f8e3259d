#pragma once

#include <planish/geometry/mesh.hpp>
#include <planish/sheet/sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <array>
#include <vector>

namespace planish {

/// A ridge: its ends, left then right, on the flat sheet and in space, and the angle by which the
/// sheet is folded there. A positive angle turns the strip away from the sheet's front, whose
/// normal is along × across.
struct SlitRidge {
  std::array<Vec2, 2> flat;
  std::array<Vec3, 2> folded;
  Angle fold;
};

/// A strip as it is folded. quads[i] lies between ridges i and i+1: its frame takes flat
/// coordinates of the whole sheet to space, so folding is an isometry by construction.
struct FoldedStrip {
  std::vector<SlitRidge> ridges;
  std::vector<Frame> quads;
  /// Of each quad the flat corners of its left and of its right edge between its ridges, in their
  /// order along the strip; empty of strips whose edges are lines.
  std::vector<std::array<std::vector<Vec2>, 2>> borders = {};
  bool ends_directed = false;  ///< its end is held in its direction: all of the last quad is bent
                               ///< with the last ridge before it
};

/// From the corner where a strip ends to that of its neighbour on the right that faces it, mm;
/// negative if they overlap.
double gap_between(const FoldedStrip& left, const FoldedStrip& right);

/// A facet of a panel, between two parallel lines of the flat sheet at which a strip begins or
/// ends.
struct PanelFacet {
  std::array<Vec2, 4> corners;  ///< flat: bottom left, top left, top right, bottom right
  Frame frame;                  ///< flat coordinates to space
  int strip = -1;               ///< the strip that begins at its top; −1: none
  bool joined = true;           ///< to the facet before it
};

/// The folded sheet, or the modelled half of a symmetric one.
struct FoldedSlitSheet {
  double thickness = 0.0;
  double reach = 0.0;  ///< largest along of a strip; in symmetric sheets the symmetry line
  bool symmetric = true;
  std::vector<PanelFacet> panel;
  std::vector<FoldedStrip> strips;
  /// Where strips end: a second panel, or the uncut sheet beyond the ends of their slits, which in
  /// symmetric sheets goes on to the symmetry line; empty if they end elsewhere.
  std::vector<PanelFacet> second_panel = {};
};

/// Checks what all functions of a folded sheet rely on: numbers are finite, each strip has ridges
/// and a quad between any two, each facet of the panel refers to a strip or to none. Error:
/// `invalid_sheet`, with the rule that is broken; `where` names the item ("strip 3").
Result<void> check(const FoldedSlitSheet& folded);
/// Stops at an assertion that names the rule and the item.
void require_valid(const FoldedSlitSheet& folded);

/// The whole sheet, both halves of symmetric ones, as a Sheet: every quad and panel facet is a
/// face; ridges and the edges between a panel's facets are sharp bends if they fold by more than
/// rounding, else their faces are one flange. The reference surface is the middle surface, where
/// hinges take no allowance at K = ½: flattened with this K, the sheet is the one that was cut
/// (coordinates along, across). Borders carry edge numbers and lengths for `certify`; labels carry
/// the numbers of the strips. Strips that do not reach the symmetry plane leave a gap there, but
/// are joined nevertheless.
Sheet sheet_of(const FoldedSlitSheet& folded);

/// What a face of `sheet_of` is part of.
struct SlitPart {
  static constexpr int kPanel = -1, kSecondPanel = -2;
  int strip = kPanel;     ///< or one of the panels
  bool mirrored = false;  ///< beyond the symmetry line
  friend auto operator<=>(const SlitPart&, const SlitPart&) = default;
};
/// That of each face.
IdVector<FaceId, SlitPart> parts_of(const FoldedSlitSheet& folded);

/// Triangles of the mid-surface of the whole sheet, fronts counter-clockwise; corners on one ridge
/// are shared.
Mesh mesh_of(const FoldedSlitSheet& folded);

}  // namespace planish
