#include "assemble.hpp"

#include "joined_face.hpp"
#include "orientation.hpp"
#include "refusals.hpp"
#include "tolerances.hpp"

#include <planish/base/assert.hpp>
#include <planish/sheet/builder.hpp>

#include <array>
#include <cmath>
#include <map>
#include <utility>

// Plates and fits become a Sheet. The reference skin is the inner one of the folds wherever that
// can be, since a fold's plates meet there in a line; from outside, a fold is found only if it
// takes both edges from corner to corner. A further stretch of a bend is a further face of the same
// bend. Borders are joined by the rows of the fits that share them, not by where they lie.

namespace planish::connect_detail {
namespace {

/// The border of a plate at which a bend joins it, by the indices of both.
using JointBorders = std::map<std::pair<int, int>, BorderRef>;

Result<JointBorders> add_plates(SheetBuilder& sheet, const Parts& parts, const Orientation& sides) {
  JointBorders borders;
  for (int plate = 0; plate < static_cast<int>(parts.plates.size()); ++plate) {
    auto made = plate_face(parts, plate, sides.plates[plate]);
    if (!made) return pass_on(made);
    made->face.part_of = sheet.add_flange();
    const FaceId id = sheet.add_face(std::move(made->face));
    for (const auto& joint : made->joints)
      borders[{joint.plate, joint.bend}] = {id, joint.loop, joint.border};
  }
  return borders;
}

// The reference skin is the inner one of folds where that can be: the other is the root's.
Orientation settled(Parts& parts) {
  Orientation sides = orientation_of(parts);
  int outer = 0;
  for (std::size_t b = 0; b < parts.fits.size(); ++b)
    if (parts.fits[b].fold) outer += sides.bends[b];
  if (outer > 0)
    for (auto* of : {&sides.plates, &sides.bends})
      for (int& side : *of)
        side = -side;
  for (std::size_t b = 0; b < parts.fits.size(); ++b)
    if (auto& fold = parts.fits[b].fold) fold->reference_inside = sides.bends[b] < 0;
  return sides;
}

// From its outer skin a fold is found only if it takes both edges from corner to corner.
Result<void> check_folds(const Parts& parts) {
  for (const BendFit& fit : parts.fits) {
    if (!fit.fold || fit.fold->reference_inside) continue;
    for (std::size_t side = 0; side < 2; ++side)
      if (!fit.fold->at_corner[side][0] || !fit.fold->at_corner[side][1])
        return fail(refuse::folds_both_ways,
                    {{"plate", place::plate(parts.ids[fit.report.plates[side]])},
                     {"least", kSmallestInsideRadius, unit::mm}});
  }
  return {};
}

void add_fold(SheetBuilder& sheet, const Parts& parts, BendId id, int bend,
              const JointBorders& borders) {
  const std::vector<int>& plates = parts.fits[bend].report.plates;
  std::array<BorderRef, 2> both;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto border = borders.find({plates[side], bend});
    PLANISH_ASSERT(border != borders.end());
    both[side] = border->second;
  }
  // The mitre outside holds more than the arc of material that bends to it.
  const Fold& fold = *parts.fits[bend].fold;
  const double turn = parts.fits[bend].report.angle.radians(), t = parts.thickness;
  sheet.join(both[0], both[1], id,
             (fold.high - fold.low) * t * t * (std::tan(0.5 * turn) - 0.5 * turn));
}

Bend bend_of(const FittedBend& fitted, int sense) {
  Bend bend;
  bend.kind = fitted.kind;
  bend.angle = fitted.angle;
  bend.inside_radius = fitted.inside_radius;
  bend.reference_inside = sense < 0;
  return bend;
}

/// Adds the face of a fit to its bend, which is `bends[…]` for a further stretch and a new one
/// otherwise.
BendId add_bend(SheetBuilder& sheet, const Parts& parts, int bend, int sense,
                const JointBorders& borders, const std::vector<BendId>& bends) {
  if (parts.fits[bend].fold) {
    const BendId fold = sheet.add_bend(bend_of(parts.fits[bend].report, sense));
    add_fold(sheet, parts, fold, bend, borders);
    return fold;
  }
  JoinedFace made = bend_face(parts, bend, sense);
  const auto& stretch_of = parts.fits[bend].stretch_of;
  const BendId id = stretch_of ? bends[*stretch_of]
                               : sheet.add_bend(bend_of(parts.fits[bend].report, sense));
  made.face.part_of = id;
  const FaceId face = sheet.add_face(std::move(made.face));
  for (const auto& joint : made.joints) {
    const auto plate = borders.find({joint.plate, joint.bend});
    PLANISH_ASSERT(plate != borders.end());
    sheet.join(plate->second, {face, 0, joint.border});
  }
  return id;
}

}  // namespace

Result<Assembled> assembled(Parts parts) {
  SheetBuilder sheet(parts.thickness);
  const Orientation sides = settled(parts);
  if (auto sound = check_folds(parts); !sound) return pass_on(sound);
  const auto borders = add_plates(sheet, parts, sides);
  if (!borders) return pass_on(borders);
  Assembled made;
  for (int plate = 0; plate < static_cast<int>(parts.plates.size()); ++plate)
    made.plate_faces.push_back(static_cast<FaceId>(plate));  // the first faces of the sheet
  for (int bend = 0; bend < static_cast<int>(parts.fits.size()); ++bend) {
    const auto& joint_of = parts.fits[bend].joint_of;
    made.bends.push_back(
        joint_of ? made.bends[joint_of->first]
                 : add_bend(sheet, parts, bend, sides.bends[bend], *borders, made.bends));
  }
  sheet.number_edges();
  auto built = std::move(sheet).build();
  if (!built) return pass_on(built);
  made.sheet = std::move(*built);
  if (!parts.plates.empty()) made.root = made.plate_faces[parts.root];
  return made;
}

}  // namespace planish::connect_detail
