#pragma once

#include <planish/geometry/mesh.hpp>
#include <planish/sheet/sheet.hpp>

#include <array>
#include <vector>

namespace planish {

/// Two faces of a sheet whose material meets when it is folded.
struct MeetingFaces {
  std::array<FaceId, 2> faces{};  ///< the smaller first; equal for a face that meets itself
  Box3 where;                     ///< all places where they do lie in this box
};

/// The faces of the folded sheet that share balls of more than `depth` mm in diameter, if cut edges
/// are square to the sheet and bends have neither openings nor notches: a first, fast look. Where
/// it finds nothing, the folded sheet does not run through itself; what it finds, the solid must
/// confirm (math.md#self-intersection). Formed features are left out. Requires a valid sheet and
/// depth > 0. Cost: near-linear in the faces where few of them are near one another.
std::vector<MeetingFaces> meeting_faces(const Sheet& sheet, double depth);

}  // namespace planish
