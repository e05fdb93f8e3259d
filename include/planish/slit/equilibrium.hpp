#pragma once

#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <optional>
#include <vector>

namespace planish {

/// What acts on a strip besides its weight and its loads.
enum class HeldBy {
  panel,       ///< where the strip begins
  end,         ///< the other half, the second panel, or what holds a placed end
  ground,      ///< from below
  neighbours,  ///< strips that it presses
  wishes,      ///< anchors, seat curve and scan, which draw as springs do
};

/// What holds a strip, in newtons and N mm. In symmetric sheets that of the modelled half.
struct SlitReaction {
  int strip = 0;
  HeldBy end = HeldBy::panel;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< on the strip; the moment about `at`
  Vec3 at = Vec3::Zero();  ///< the middle of the first or last ridge; of others the middle of all
                           ///< places at which they act
};

/// How a sheet stands on the ground as one rigid body (math.md#standing).
struct SlitStanding {
  bool stands = false;
  Angle margin;                        ///< by which it may be tilted; negative: it falls over
  Vec3 centre_of_mass = Vec3::Zero();  ///< of the sheet and its loads, if these weigh anything
  std::vector<Vec2> support;           ///< (x, z), convex, counter-clockwise seen with x to the
                                       ///< right and z up; what touches the ground
};

/// What a sheet of a material does with its weight and loads.
struct SlitEquilibrium {
  std::vector<double> stress;                      ///< largest of each strip, N/mm²
  std::vector<std::optional<double>> kept_radius;  ///< smallest radius that each strip keeps when
                                                   ///< it is let go, mm; of strips that yield
  std::vector<bool> is_stable;                     ///< of each strip; empty if smoothness is wanted
  std::vector<SlitReaction> reactions;             ///< likewise
  std::optional<SlitStanding> standing;            ///< with weight or loads
};

/// How the whole sheet stands with its weight and loads on what it touches the ground with: the
/// lowest points of its skins, whatever their height. `design`: that of the folded sheet, with a
/// material. Empty if nothing pulls it down.
std::optional<SlitStanding> standing_of(const FoldedSlitSheet& folded, const SlitDesign& design);

}  // namespace planish
