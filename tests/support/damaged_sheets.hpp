#pragma once

#include "support/sheets.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

// Everything that can be wrong with a sheet, done to a U channel: whoever is given one has to say
// so.

namespace planish::test {

/// One broken rule of `check`.
struct Damage {
  std::string rule;   ///< part of what `check` says
  std::string where;  ///< the row that it names
  std::function<void(Sheet&)> inflict;
};

/// A U channel: faces 0, 2, 4 are flanges, 1 and 3 bends.
inline std::vector<Damage> damages() {
  const double nan = std::nan("");
  return {
      {"thickness", "sheet", [](Sheet& s) { s.thickness = 0.0; }},
      {"thickness", "sheet", [=](Sheet& s) { s.thickness = nan; }},
      {"reference depth", "sheet", [](Sheet& s) { s.reference_depth = 2.0 * s.thickness; }},
      {"has faces", "sheet", [](Sheet& s) { s.faces.clear(); }},
      {"names a flange or bend", "face 2",
       [](Sheet& s) { s.faces[FaceId{2}].part_of = FlangeId{9}; }},
      {"names a flange or bend", "face 1",
       [](Sheet& s) { s.faces[FaceId{1}].part_of = BendId{-1}; }},
      {"lists it once", "face 0", [](Sheet& s) { s.flanges.front().faces.push_back(FaceId{0}); }},
      {"lists it once", "face 4", [](Sheet& s) { s.flanges.back().faces.clear(); }},
      {"plane faces", "face 0",
       [](Sheet& s) {
         s.faces.front().surface = Cylinder{{}, 5.0};
       }},
      {"sense", "face 0", [](Sheet& s) { s.faces.front().sense = -1; }},
      {"sense", "face 1", [](Sheet& s) { s.faces[FaceId{1}].sense = 0; }},
      {"positive size", "face 1",
       [](Sheet& s) {
         s.faces[FaceId{1}].surface = Cylinder{{}, 0.0};
       }},
      {"positive size", "face 1", [](Sheet& s) { s.faces[FaceId{1}].surface = Ruled{}; }},
      {"outer loop", "face 2", [](Sheet& s) { s.faces[FaceId{2}].loops.clear(); }},
      {"has borders", "face 2, loop 0", [](Sheet& s) { s.faces[FaceId{2}].loops[0].clear(); }},
      {"finite", "face 0, loop 0, border 1",
       [=](Sheet& s) {
         s.faces.front().loops[0][1].curve = Segment{{0, 0}, {nan, 1}};
       }},
      {"finite", "face 0, loop 0, border 1",
       [](Sheet& s) {
         s.faces.front().loops[0][1].curve = CubicSpline{{{0, 0}, {1, 1}}};
       }},
      {"Depth and length", "face 0, loop 0, border 0",
       [](Sheet& s) { s.faces.front().loops[0][0].edge_length = -1.0; }},
      {"names a feature", "face 0, loop 0, border 0",
       [](Sheet& s) { s.faces.front().loops[0][0].feature = FeatureId{0}; }},
      {"A flange has faces", "flange 3", [](Sheet& s) { s.flanges.push_back({}); }},
      {"Each face of a bend", "bend 0",
       [](Sheet& s) { s.bends.front().faces.push_back(FaceId{77}); }},
      {"Sharp bends", "bend 0", [](Sheet& s) { s.bends.front().kind = BendKind::sharp; }},
      {"Angle and inside radius", "bend 1", [](Sheet& s) { s.bends.back().inside_radius = -0.1; }},
      {"Angle and inside radius", "bend 1",
       [=](Sheet& s) { s.bends.back().angle = Angle::radians(nan); }},
      {"names borders", "joint 0", [](Sheet& s) { s.joints[0].a.border = 99; }},
      {"names borders", "joint 0", [](Sheet& s) { s.joints[0].b.face = FaceId{-3}; }},
      {"one joint", "joint 4", [](Sheet& s) { s.joints.push_back(s.joints[2]); }},
      {"sharp joint", "joint 1", [](Sheet& s) { s.joints[1].sharp = BendId{0}; }},
      {"sharp joint", "joint 1", [](Sheet& s) { s.joints[1].sharp = BendId{5}; }},
      {"A feature names", "feature 0",
       [](Sheet& s) {
         s.features.push_back({"pocket", FaceId{8}, {}, {}, {}});
       }},
      {"A label names", "label 0",
       [](Sheet& s) {
         s.labels.push_back({FaceId{8}, {0, 0}, "A"});
       }},
  };
}

}  // namespace planish::test
