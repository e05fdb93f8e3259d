#pragma once

#include "skins.hpp"

namespace planish::brep {

/// Skin faces that make one flange or one bend: they lie on one plane or one developable surface
/// and are connected, or bridge the same two flanges.
struct Group {
  std::vector<int> faces;
  bool flange = false;
  int leader = 0;  ///< the largest face; its surface represents all
};

/// Two groups meeting along an edge of the solid.
struct GroupJoint {
  int edge = 0;
  int a = 0;
  int b = 0;
  bool sharp = false;
};

struct Groups {
  std::vector<Group> rows;
  std::vector<int> of_face;        ///< −1 for faces of other sides
  std::vector<GroupJoint> joints;  ///< also those inside one group (a == b)
};

/// Groups one skin. Groups are in the order of their first face.
Groups group_faces(const SolidModel& model, const std::vector<Outline>& outlines,
                   const Skins& skins, Skin skin);

}  // namespace planish::brep
