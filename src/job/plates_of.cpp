#include <planish/geometry/curve.hpp>
#include <planish/job/plates_of.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/sheet/drawn_folds.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
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

/// A full circle.
std::optional<RoundHole> round_of(const Loop& loop,
                                  const std::function<Vec3(const Vec2&)>& to_space) {
  constexpr double kSame = 1e-6;  // mm
  const auto* first = std::get_if<Arc>(&loop.front());
  if (first == nullptr) return std::nullopt;
  double turned = 0.0;
  for (const Curve2& curve : loop) {
    const auto* arc = std::get_if<Arc>(&curve);
    if (arc == nullptr || (arc->center - first->center).norm() > kSame ||
        std::abs(arc->radius - first->radius) > kSame)
      return std::nullopt;
    turned += arc->sweep;
  }
  if (std::abs(std::abs(turned) - 2.0 * std::numbers::pi) > kSame) return std::nullopt;
  return RoundHole{to_space(first->center), first->radius};
}

/// Two half circles of one radius with straight edges between.
std::optional<SlotHole> slot_of(Loop loop, const std::function<Vec3(const Vec2&)>& to_space) {
  constexpr double kSame = 1e-6;  // mm, radians
  if (loop.size() != 4) return std::nullopt;
  if (std::holds_alternative<Segment>(loop.front()))
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  const auto *a = std::get_if<Arc>(&loop[0]), *b = std::get_if<Arc>(&loop[2]);
  if (!a || !b || !std::holds_alternative<Segment>(loop[1]) ||
      !std::holds_alternative<Segment>(loop[3]))
    return std::nullopt;
  const auto half = [](const Arc& arc) {
    return std::abs(std::abs(arc.sweep) - std::numbers::pi) <= kSame;
  };
  if (!half(*a) || !half(*b) || std::abs(a->radius - b->radius) > kSame) return std::nullopt;
  return SlotHole{to_space(a->center), to_space(b->center), 2.0 * a->radius};
}

/// What a hole is besides a polygon: made of segments and arcs.
std::optional<HoleShape> shape_of(const Loop& loop,
                                  const std::function<Vec3(const Vec2&)>& to_space) {
  const auto is = [](const auto* curve) { return curve != nullptr; };
  if (std::ranges::any_of(loop,
                          [&](const Curve2& c) { return is(std::get_if<CubicSpline>(&c)); }) ||
      std::ranges::none_of(loop, [&](const Curve2& c) { return is(std::get_if<Arc>(&c)); }))
    return std::nullopt;
  if (auto round = round_of(loop, to_space)) return *round;
  if (auto slot = slot_of(loop, to_space)) return *slot;
  if (loop.size() < 2) return std::nullopt;
  ArcHole hole;
  for (const Curve2& curve : loop) {
    hole.corners.push_back(to_space(start_of(curve)));
    hole.through.emplace_back();
    if (is(std::get_if<Arc>(&curve))) hole.through.back() = to_space(point_at(curve, 0.5));
  }
  return hole;
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

/// Whether a bend or a flange begins at a loop: only edges of polygons carry bends.
bool is_joined(const Sheet& sheet, FaceId face, int loop) {
  const auto is_on = [&](const BorderRef& ref) { return ref.face == face && ref.loop == loop; };
  return std::ranges::any_of(sheet.joints,
                             [&](const Joint& joint) { return is_on(joint.a) || is_on(joint.b); });
}

Plate plate_of(const Sheet& sheet, FaceId id, std::string name, const ToFoldLines& folds,
               double chord) {
  const std::vector<BorderLoop>& loops = sheet[id].loops;
  Plate plate{std::move(name), polygon_of(sheet, id, 0, folds, chord), {}, {}};
  const auto to_space = [&](const Vec2& p) { return in_the_middle(sheet, sheet[id], {p}).front(); };
  const auto add = [&](std::vector<Vec3> polygon, const Loop& curves, bool joined) {
    if (polygon.size() < 3) return;
    if (auto shape = joined ? std::nullopt : shape_of(curves, to_space)) {
      plate.shapes.emplace(plate.holes.size(), std::move(*shape));
      polygon.clear();
    }
    plate.holes.push_back(std::move(polygon));
  };
  for (int i = 1; i < std::ssize(loops); ++i)
    if (!goes_on(loops[i]))
      add(polygon_of(sheet, id, i, folds, chord), drawn_to_fold_lines(sheet, id, i, folds),
          is_joined(sheet, id, i));
  for (const FormedFeature& feature : sheet.features)
    for (const FormedOpening& opening : feature.openings)
      if (feature.face == id)
        add(pilot_of(sheet, id, opening, chord), mapped(opening.pilot, &Border::curve), false);
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

Json corner_json(const Vec3& p) {
  return Json::array({rounded(p.x()), rounded(p.y()), rounded(p.z())});
}

Json corners_json(const std::vector<Vec3>& polygon) { return json_array(polygon, corner_json); }

struct ShapeJson {
  Json operator()(const RoundHole& hole) const {
    return {{"circle", {{"at", corner_json(hole.at)}, {"radius", rounded(hole.radius)}}}};
  }
  Json operator()(const SlotHole& slot) const {
    return {{"slot",
             {{"from", corner_json(slot.from)},
              {"to", corner_json(slot.to)},
              {"width", rounded(slot.width)}}}};
  }
  Json operator()(const ArcHole& hole) const {
    Json path = Json::array({corner_json(hole.corners.front())});
    for (std::size_t i = 0; i < hole.corners.size(); ++i) {
      const Json to = corner_json(hole.corners[(i + 1) % hole.corners.size()]);
      if (hole.through[i])
        path.push_back({{"through", corner_json(*hole.through[i])}, {"to", to}});
      else if (i + 1 < hole.corners.size())
        path.push_back(to);
    }
    return {{"path", path}};
  }
};

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
    for (std::size_t h = 0; h < plate.holes.size(); ++h) {
      const auto shape = plate.shapes.find(h);
      one["holes"].push_back(shape == plate.shapes.end() ? corners_json(plate.holes[h])
                                                         : std::visit(ShapeJson(), shape->second));
    }
  }
  for (const BendRequest& bend : plates.bends) {
    Json& one = json["bends"].emplace_back(Json{{"between", bend.between}});
    if (bend.inside_radius) one["inside_radius"] = rounded(*bend.inside_radius);
  }
  return text_of(json);
}

}  // namespace planish::job
