#include "assemble.hpp"

#include "joined_face.hpp"
#include "orientation.hpp"

#include <planish/base/assert.hpp>
#include <planish/sheet/builder.hpp>

#include <map>
#include <utility>

namespace planish::connect_detail {
namespace {

/// The border of a plate at which a bend joins it, by the indices of both.
using JointBorders = std::map<std::pair<int, int>, BorderRef>;

Result<JointBorders> add_plates(SheetBuilder& sheet, const Parts& parts, const Orientation& sides) {
  JointBorders borders;
  for (int plate = 0; plate < static_cast<int>(parts.plates.size()); ++plate) {
    auto made = plate_face(parts, plate, sides.plates[plate]);
    if (!made) return tl::unexpected(made.error());
    made->face.part_of = sheet.add_flange();
    const FaceId id = sheet.add_face(std::move(made->face));
    for (const auto& joint : made->joints)
      borders[{joint.plate, joint.bend}] = {id, joint.loop, joint.border};
  }
  return borders;
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

Result<Assembled> assembled(const Parts& parts) {
  SheetBuilder sheet(parts.thickness);
  const Orientation sides = orientation_of(parts);
  const auto borders = add_plates(sheet, parts, sides);
  if (!borders) return tl::unexpected(borders.error());
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
  if (!built) return tl::unexpected(built.error());
  made.sheet = std::move(*built);
  if (!parts.plates.empty()) made.root = made.plate_faces[parts.root];
  return made;
}

}  // namespace planish::connect_detail
