#pragma once

#include "support/sheets.hpp"

#include <functional>
#include <limits>
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

inline Frame& frame_of(Sheet& sheet, int face) {
  return std::get<Frame>(sheet.faces[FaceId{face}].surface);
}
inline Cylinder& cylinder_of(Sheet& sheet, int face) {
  return std::get<Cylinder>(std::get<Developable>(sheet.faces[FaceId{face}].surface));
}
inline Ruled::Knot knot(double u) { return {u, {u, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}; }
inline double middle_of_bend(const Sheet& sheet) {
  const Box2 box = parameter_box(sheet[FaceId{1}]);
  return 0.5 * (box.lo.x() + box.hi.x());
}
/// Gives face 2 that curve as its first border.
inline std::function<void(Sheet&)> with_border(Curve2 curve) {
  return [curve](Sheet& s) { s.faces[FaceId{2}].loops[0][0].curve = curve; };
}

/// A U channel: faces 0, 2, 4 are flanges, 1 and 3 bends.
inline std::vector<Damage> damages() {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
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
      {"size above 0", "face 1",
       [](Sheet& s) {
         s.faces[FaceId{1}].surface = Cylinder{{}, 0.0};
       }},
      {"size above 0", "face 1", [](Sheet& s) { s.faces[FaceId{1}].surface = Ruled{}; }},
      {"outer loop", "face 2", [](Sheet& s) { s.faces[FaceId{2}].loops.clear(); }},
      {"has borders", "face 2, loop 0", [](Sheet& s) { s.faces[FaceId{2}].loops[0].clear(); }},
      {"finite size", "face 0, loop 0, border 1",
       [=](Sheet& s) {
         s.faces.front().loops[0][1].curve = Segment{{0, 0}, {nan, 1}};
       }},
      {"finite size", "face 0, loop 0, border 1",
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
      {"of its kind", "face 1", [](Sheet& s) { s.bends.front().kind = BendKind::sharp; }},
      {"Sharp bends", "bend 2", [](Sheet& s) { s.bends.push_back({}); }},
      {"Angle and inside radius", "bend 1", [](Sheet& s) { s.bends.back().inside_radius = -0.1; }},
      {"Angle and inside radius", "bend 1",
       [=](Sheet& s) { s.bends.back().angle = Angle::radians(nan); }},
      {"names borders", "joint 0", [](Sheet& s) { s.joints[0].a.border = 99; }},
      {"names borders", "joint 0", [](Sheet& s) { s.joints[0].b.face = FaceId{-3}; }},
      {"one joint", "joint 4", [](Sheet& s) { s.joints.push_back(s.joints[2]); }},
      {"sharp joint", "joint 1", [](Sheet& s) { s.joints[1].sharp = BendId{0}; }},
      {"sharp joint", "joint 1", [](Sheet& s) { s.joints[1].sharp = BendId{5}; }},
      // Sizes
      {"thickness", "sheet", [](Sheet& s) { s.thickness = 1e300; }},
      {"thickness spread", "sheet", [=](Sheet& s) { s.thickness_spread = nan; }},
      {"volume", "sheet", [](Sheet& s) { s.volume = 0.0; }},
      {"volume", "sheet", [](Sheet& s) { s.volume = -1.0; }},
      {"volume", "sheet", [=](Sheet& s) { s.volume = nan; }},
      {"forms and mitres", "sheet", [=](Sheet& s) { s.forms_volume = nan; }},
      {"forms and mitres", "sheet", [=](Sheet& s) { s.mitres_volume = inf; }},
      // Surfaces
      {"right-handed", "face 0", [=](Sheet& s) { frame_of(s, 0).origin.x() = nan; }},
      {"right-handed", "face 0", [](Sheet& s) { frame_of(s, 0).x *= -1.0; }},
      {"right-handed", "face 2", [](Sheet& s) { frame_of(s, 2).z.setZero(); }},
      {"right-handed", "face 2", [](Sheet& s) { frame_of(s, 2).y *= 2.0; }},
      {"size above 0", "face 1", [=](Sheet& s) { cylinder_of(s, 1).frame.z.y() = nan; }},
      {"size above 0", "face 1", [=](Sheet& s) { cylinder_of(s, 1).radius = inf; }},
      {"size above 0", "face 1",
       [=](Sheet& s) {
         s.faces[FaceId{1}].surface = Ruled{{knot(0.0), knot(1.0)}};
         std::get<Ruled>(std::get<Developable>(s.faces[FaceId{1}].surface)).knots[1].b.x() = nan;
       }},
      {"size above 0", "face 1",
       [](Sheet& s) {
         s.faces[FaceId{1}].surface = Ruled{{knot(0.0), knot(1.0)}};
         std::get<Ruled>(std::get<Developable>(s.faces[FaceId{1}].surface)).knots[0].g.setZero();
       }},
      {"of its kind", "face 1", [](Sheet& s) { s.bends.front().kind = BendKind::cone; }},
      {"of its kind", "face 1", [](Sheet& s) { s.bends.front().kind = static_cast<BendKind>(99); }},
      // Borders
      {"finite size", "face 2, loop 0, border 0", with_border(Arc{{0, 0}, 0.0, 0.0, 1.0})},
      {"finite size", "face 2, loop 0, border 0", with_border(Arc{{0, 0}, -5.0, 0.0, 1.0})},
      {"finite size", "face 2, loop 0, border 0", with_border(Arc{{0, 0}, 5.0, 0.0, 100.0})},
      {"finite size", "face 2, loop 0, border 0", with_border(Arc{{0, 0}, 5.0, 1e300, 1.0})},
      {"finite size", "face 2, loop 0, border 0", with_border(Arc{{0, 0}, inf, 0.0, 1.0})},
      {"finite size", "face 2, loop 0, border 0", with_border(Segment{{0, 0}, {1e9, 0}})},
      {"finite size", "face 2, loop 0, border 0",
       with_border(CubicSpline{{{0, 0}, {1, 0}, {1e200, 0}, {3, 0}}})},
      {"finite size", "face 2, loop 0, border 0", with_border(CubicSpline{})},
      {"Depth and length", "face 0, loop 0, border 0",
       [=](Sheet& s) { s.faces.front().loops[0][0].edge_length = inf; }},
      {"starts where", "face 0, loop 0, border 0",
       [](Sheet& s) { s.faces.front().loops[0].erase(s.faces.front().loops[0].begin()); }},
      // Bends and marks
      {"press lines", "bend 0",
       [=](Sheet& s) {
         s.bends.front().press_lines = {{nan, Angle::degrees(45)}};
       }},
      {"press lines", "bend 0",
       [](Sheet& s) {
         s.bends.front().press_lines = {{1e9, Angle::degrees(45)}};
       }},
      {"press lines", "bend 0",
       [=](Sheet& s) {
         s.bends.front().press_lines = {{middle_of_bend(s), Angle::radians(nan)}};
       }},
      {"press lines", "bend 0",
       [](Sheet& s) {
         const double u = middle_of_bend(s);
         s.bends.front().press_lines = {{u, Angle::degrees(45)}, {u, Angle::degrees(45)}};
       }},
      {"is named by a joint", "bend 2",
       [](Sheet& s) {
         Bend bend;
         bend.kind = BendKind::sharp;
         s.bends.push_back(std::move(bend));
       }},
      {"outline is made of", "feature 0",
       [](Sheet& s) {
         s.features.push_back(
             {"pocket", FormSide::up, FaceId{0}, {{Border{CubicSpline{}}}}, {}, {}});
       }},
      {"A feature names", "feature 0",
       [](Sheet& s) {
         s.features.push_back({"pocket", FormSide::up, FaceId{8}, {}, {}, {}});
       }},
      {"A label names", "label 0",
       [](Sheet& s) {
         s.labels.push_back({FaceId{8}, {0, 0}, "A"});
       }},
  };
}

}  // namespace planish::test
