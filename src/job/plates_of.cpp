#include "drawn_folds.hpp"

#include <planish/geometry/curve.hpp>
#include <planish/job/plates_of.hpp>
#include <planish/schema/json_parts.hpp>

#include <algorithm>
#include <cmath>
#include <string>

// The flanges of a sheet as plates on its middle surface, which `connect` joins again
// (connect.md#a-first-file). Curves become chords, and corners nearer than a chord become one.
// Openings are those cut before forming: pilot holes stand for extruded ones. At folds the outlines
// go on to where the plates meet (drawn_folds.cpp).

namespace planish::job {
using namespace schema;
namespace {

/// Real borders, and samples of curves, lie closer than anyone cuts.
std::vector<Vec2> corners_of(const std::vector<Curve2>& loop, double chord) {
  std::vector<Vec2> corners;
  const auto add = [&](const Vec2& p) {
    if (corners.empty() || (p - corners.back()).norm() > chord) corners.push_back(p);
  };
  for (const Curve2& border : loop) {
    const std::vector<Vec2> points = sampled(border, chord);
    add(points.front());
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      if ((points[i] - points.back()).norm() > chord) add(points[i]);
  }
  while (corners.size() > 1 && (corners.back() - corners.front()).norm() <= chord)
    corners.pop_back();
  return corners;
}

std::vector<Vec3> in_the_middle(const Sheet& sheet, const Face& face,
                                const std::vector<Vec2>& polygon) {
  const double middle = sheet.reference_depth - 0.5 * sheet.thickness;
  return mapped(polygon, [&](const Vec2& uv) -> Vec3 {
    return skin_point(face, uv) + middle * outward_normal(face, uv);
  });
}

std::vector<Vec3> polygon_of(const Sheet& sheet, FaceId face, int loop, const ToFoldLines& folds,
                             double chord) {
  const std::vector<Curve2> curves = drawn_to_fold_lines(sheet, face, loop, folds);
  std::vector<Vec2> corners = corners_of(curves, chord);
  if (curves.size() > sheet[face].loops[loop].size())
    corners = without_runs(std::move(corners), chord);
  return in_the_middle(sheet, sheet[face], corners);
}

std::vector<Vec3> pilot_of(const Sheet& sheet, FaceId face, const FormedOpening& opening,
                           double chord) {
  const auto curves = mapped(opening.pilot, &Border::curve);
  return in_the_middle(sheet, sheet[face], corners_of(curves, chord));
}

/// Whether nothing is cut along a loop: the material goes on into a formed feature, as a flat
/// pattern shows it.
bool goes_on(const BorderLoop& loop) {
  return std::ranges::any_of(loop, [](const Border& border) { return border.feature.has_value(); });
}

Plate plate_of(const Sheet& sheet, FaceId id, std::string name, const ToFoldLines& folds,
               double chord) {
  const std::vector<BorderLoop>& loops = sheet[id].loops;
  Plate plate{std::move(name), polygon_of(sheet, id, 0, folds, chord), {}};
  for (int i = 1; i < std::ssize(loops); ++i)
    if (!goes_on(loops[i])) plate.holes.push_back(polygon_of(sheet, id, i, folds, chord));
  for (const FormedFeature& feature : sheet.features)
    for (const FormedOpening& opening : feature.openings)
      if (feature.face == id) plate.holes.push_back(pilot_of(sheet, id, opening, chord));
  std::erase_if(plate.holes, [](const auto& hole) { return hole.size() < 3; });
  return plate;
}

/// The bends between two faces of flanges, in the order of the sheet.
std::vector<BendRequest> requests_of(const Sheet& sheet,
                                     const IdVector<FaceId, std::string>& names) {
  IdVector<BendId, std::vector<std::string>> between(sheet.bends.size());
  const auto note = [&](const BorderRef& bend, const BorderRef& flange) {
    const auto* id = std::get_if<BendId>(&sheet[bend.face].part_of);
    if (id == nullptr || names[flange.face].empty()) return;
    auto& joined = between[*id];
    if (std::ranges::find(joined, names[flange.face]) == joined.end())
      joined.push_back(names[flange.face]);
  };
  for (const Joint& joint : sheet.joints) {
    if (joint.sharp) between[*joint.sharp] = {names[joint.a.face], names[joint.b.face]};
    note(joint.a, joint.b);
    note(joint.b, joint.a);
  }
  std::vector<BendRequest> requests;
  for (const BendId id : sheet.bends.ids())
    if (between[id].size() == 2) {
      BendRequest& request = requests.emplace_back(BendRequest{.between = between[id]});
      if (is_fold(sheet[id]))
        request.inside_radius = 0.0;
      else if (sheet[id].kind == BendKind::cylinder)
        request.inside_radius = sheet[id].inside_radius;
    }
  return requests;
}

double rounded(double value) {
  constexpr double kDigits = 1e6;                      // of a millimetre
  return std::round(value * kDigits) / kDigits + 0.0;  // not −0
}

Json corners_json(const std::vector<Vec3>& polygon) {
  return json_array(polygon, [&](const Vec3& p) {
    return Json::array({rounded(p.x()), rounded(p.y()), rounded(p.z())});
  });
}

}  // namespace

PlateStructure plates_of(const Sheet& sheet, const PlatesOfOptions& options) {
  require_valid(sheet);
  PlateStructure structure;
  structure.thickness = sheet.thickness;
  const ToFoldLines folds = distances_to_fold_lines(sheet);
  IdVector<FaceId, std::string> names(sheet.faces.size());
  for (const FlangeId flange : sheet.flanges.ids()) {
    const std::string number = std::to_string(index_of(flange) + 1);
    char letter = 'a';
    for (const FaceId face : sheet[flange].faces) {
      names[face] = sheet[flange].faces.size() > 1 ? number + letter++ : number;
      structure.plates.push_back(plate_of(sheet, face, names[face], folds, options.chord));
    }
  }
  if (options.with_bends) structure.bends = requests_of(sheet, names);
  return structure;
}

std::string plates_text(const PlateStructure& plates) {
  Json json = {{"format", "planish/plates"}, {"version", 1}, {"units", "mm"}};
  json["thickness"] = rounded(plates.thickness);
  json["plates"] = Json::array();
  for (const Plate& plate : plates.plates) {
    Json& one = json["plates"].emplace_back(
        Json{{"id", plate.id}, {"outline", corners_json(plate.outline)}});
    for (const auto& hole : plate.holes)
      one["holes"].push_back(corners_json(hole));
  }
  for (const BendRequest& bend : plates.bends) {
    Json& one = json["bends"].emplace_back(Json{{"between", bend.between}});
    if (bend.inside_radius) one["inside_radius"] = rounded(*bend.inside_radius);
  }
  return text_of(json);
}

}  // namespace planish::job
