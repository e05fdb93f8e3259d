// The rules that every function of a sheet relies on, row by row, so that an error names the first
// row that breaks one. Nothing is mended here: what a file rounds is within the stated slack, or
// the sheet is refused.

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/places.hpp>
#include <planish/sheet/sheet.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

namespace planish {
namespace {

using Fault = std::optional<Error>;

/// The row that breaks a rule: in words, and where it stands in the value `Sheet`.
struct SheetRow {
  std::string where;
  std::string pointer;
};

SheetRow whole() { return {"sheet", ""}; }
SheetRow row_of(FaceId id) { return {fmt::format("face {}", index_of(id)), pointer_to(id)}; }
SheetRow row_of(BendId id) { return {fmt::format("bend {}", index_of(id)), pointer_to(id)}; }
SheetRow row_of(const BorderRef& ref) {
  return {fmt::format("face {}, loop {}, border {}", index_of(ref.face), ref.loop, ref.border),
          pointer_to(ref)};
}
/// A row of a list: "joint", 3, "/joints".
SheetRow row_of(const char* kind, std::size_t index, const char* list) {
  return {fmt::format("{} {}", kind, index), fmt::format("{}/{}", list, index)};
}

Error fault(std::string_view rule, const SheetRow& row) {
  return error_of({code::invalid_sheet, rule}, {{"row", place::pointer(row.pointer)}}, row.where);
}

/// With the face of the solid, to show it.
Error fault_at(std::string_view rule, const Sheet& sheet, FaceId face, const SheetRow& row) {
  Error error = fault(rule, row);
  if (const auto number = sheet[face].source_face) error.places.push_back(place::face(*number));
  return error;
}

/// Where a sheet may lie, and how large its bends may be, mm: a thousand kilometres.
constexpr double kFarthestFrame = 1e9;

bool in_reach(const Vec3& p) { return (p.array().abs() <= kFarthestFrame).all(); }

/// Axes of length 1, perpendicular and right-handed, but for what a file rounds.
bool regular(const Frame& frame) {
  constexpr double kSkew = tolerance::kWrittenDigits;
  return in_reach(frame.origin) && frame.x.allFinite() && frame.y.allFinite() &&
         frame.z.allFinite() && std::abs(frame.x.norm() - 1.0) <= kSkew &&
         std::abs(frame.z.norm() - 1.0) <= kSkew && std::abs(frame.x.dot(frame.z)) <= kSkew &&
         (frame.y - frame.z.cross(frame.x)).norm() <= kSkew;
}

bool regular(const Ruled& ruled) {
  const auto falls = [](const Ruled::Knot& a, const Ruled::Knot& b) { return !(a.u < b.u); };
  const auto sound = [](const Ruled::Knot& knot) {
    return std::isfinite(knot.u) && in_reach(knot.b) && knot.b_prime.allFinite() &&
           knot.g.allFinite() && knot.g_prime.allFinite() &&
           knot.b_prime.cross(knot.g).norm() > 0.0;
  };
  return ruled.knots.size() >= 2 && std::ranges::all_of(ruled.knots, sound) &&
         std::ranges::adjacent_find(ruled.knots, falls) == ruled.knots.end();
}

bool regular(const Developable& surface) {
  if (const auto* cylinder = std::get_if<Cylinder>(&surface))
    return regular(cylinder->frame) && cylinder->radius > 0.0 && cylinder->radius <= kFarthestFrame;
  if (const auto* cone = std::get_if<Cone>(&surface))
    return regular(cone->frame) && cone->half_angle > 0.0 &&
           cone->half_angle < 0.5 * std::numbers::pi;
  return regular(std::get<Ruled>(surface));
}

bool is_kind_of(BendKind kind, const Developable& surface) {
  switch (kind) {
    case BendKind::cylinder:
      return std::holds_alternative<Cylinder>(surface);
    case BendKind::cone:
      return std::holds_alternative<Cone>(surface);
    case BendKind::general:
      return std::holds_alternative<Ruled>(surface);
    case BendKind::sharp:
      return false;
  }
  return false;
}

bool is_length(double value) { return value >= 0.0 && value <= kFarthest; }
bool is_angle(Angle angle) { return angle.radians() >= 0.0 && std::isfinite(angle.radians()); }

Fault fault_of_sizes(const Sheet& sheet) {
  if (!(sheet.thickness > 0.0 && is_length(sheet.thickness)))
    return fault("The thickness of a sheet is a number above 0.", whole());
  if (!(sheet.reference_depth >= 0.0 && sheet.reference_depth <= sheet.thickness))
    return fault("The reference depth of a sheet is a number from 0 to the thickness.", whole());
  if (!is_length(sheet.thickness_spread))
    return fault("The thickness spread of a sheet is a number of at least 0.", whole());
  if (sheet.volume && !(*sheet.volume > 0.0 && std::isfinite(*sheet.volume)))
    return fault("The volume of a sheet, where it is known, is a number above 0.", whole());
  if (!std::isfinite(sheet.forms_volume.value_or(0.0)) || !std::isfinite(sheet.mitres_volume) ||
      !std::isfinite(sheet.pressed_volume))
    return fault("The volumes of forms and mitres are numbers.", whole());
  if (sheet.faces.empty()) return fault("A sheet has faces.", whole());
  for (const MeasuredOpening& opening : sheet.measured_openings)
    if (!sheet.has({opening.face, opening.loop, opening.border.value_or(0)}) ||
        !std::isfinite(opening.lacking) || !std::isfinite(opening.beyond) ||
        !std::isfinite(opening.intrusion))
      return fault("A measured opening is a loop of a face, its volumes are numbers.", whole());
  for (const MeasuredOutline& outline : sheet.measured_outlines)
    if (!sheet.has({outline.face, 0, 0}) || !outline.at.allFinite() ||
        !std::isfinite(outline.beyond) || !std::isfinite(outline.lacking))
      return fault("A measured outline is that of a face, its sizes are numbers.", whole());
  return {};
}

Fault fault_of_part(const Sheet& sheet, FaceId id) {
  const Face& face = sheet[id];
  const auto broken = [&](std::string_view rule) { return fault_at(rule, sheet, id, row_of(id)); };
  const auto* bend = std::get_if<BendId>(&face.part_of);
  const bool known = bend ? sheet.bends.has(*bend)
                          : sheet.flanges.has(std::get<FlangeId>(face.part_of));
  if (!known) return broken("A face names a flange or bend of its sheet.");
  const auto& faces = sheet.faces_of(face.part_of);
  if (std::ranges::count(faces, id) != 1)
    return broken("The flange or bend of a face lists it once.");
  const auto* surface = std::get_if<Developable>(&face.surface);
  if ((surface != nullptr) != (bend != nullptr))
    return broken("Flanges have plane faces, bends have developable ones.");
  if (surface ? face.sense != 1 && face.sense != -1 : face.sense != 1)
    return broken("The sense of a face is 1 or −1, that of a plane 1.");
  if (surface && !regular(*surface))
    return broken("The surface of a bend has a right-handed frame and a size above 0.");
  if (surface && !is_kind_of(sheet[*bend].kind, *surface))
    return broken("The faces of a bend lie on surfaces of its kind.");
  if (!surface && !regular(std::get<Frame>(face.surface)))
    return broken("The frame of a plane is right-handed, its axes of length 1.");
  return {};
}

/// The border of a loop that starts away from the end of the one before it.
std::optional<int> open_border(const Face& face, const BorderLoop& loop) {
  constexpr double kJoined = 0.1;  // mm: gaps of files are closed to a tenth of that and less
  const auto place = [&](const Vec2& uv) { return skin_point(face, uv); };
  for (int b = 0; b < std::ssize(loop); ++b) {
    const Border& before = loop[b == 0 ? loop.size() - 1 : b - 1];
    if (!((place(start_of(loop[b].curve)) - place(end_of(before.curve))).norm() <= kJoined))
      return b;
  }
  return {};
}

Fault fault_of_borders(const Sheet& sheet, FaceId id) {
  const Face& face = sheet[id];
  const auto broken = [&](std::string_view rule, const SheetRow& row) {
    return fault_at(rule, sheet, id, row);
  };
  if (face.loops.empty()) return broken("A face has an outer loop.", row_of(id));
  for (int l = 0; l < std::ssize(face.loops); ++l) {
    if (face.loops[l].empty())
      return broken("A loop has borders.", {fmt::format("face {}, loop {}", index_of(id), l),
                                            fmt::format("{}/loops/{}", pointer_to(id), l)});
    for (int b = 0; b < std::ssize(face.loops[l]); ++b) {
      const Border& border = face.loops[l][b];
      const BorderRef ref{id, l, b};
      if (!is_regular(border.curve))
        return broken("A border is a line, an arc or a spline of finite size.", row_of(ref));
      if (!std::isfinite(border.edge_depth) || !is_length(border.edge_length.value_or(0.0)))
        return broken("Depth and length of a border's edge are numbers.", row_of(ref));
      if (border.feature && !sheet.features.has(*border.feature))
        return broken("A border names a feature of its sheet.", row_of(ref));
    }
    if (const auto open = open_border(face, face.loops[l]))
      return broken("Each border of a loop starts where the one before ends.",
                    row_of(BorderRef{id, l, *open}));
  }
  return {};
}

bool are_press_lines_of(const Sheet& sheet, const Bend& bend) {
  if (bend.press_lines.empty()) return true;
  const Box2 box = parameter_box(sheet, bend);
  const double slack = tolerance::kWrittenDigits * (1.0 + box.size().x());
  const auto falls = [](const PressLine& a, const PressLine& b) { return !(a.u < b.u); };
  return std::ranges::all_of(bend.press_lines,
                             [&](const PressLine& line) {
                               return is_angle(line.angle) && line.u >= box.lo.x() - slack &&
                                      line.u <= box.hi.x() + slack;
                             }) &&
         std::ranges::adjacent_find(bend.press_lines, falls) == bend.press_lines.end();
}

Fault fault_of_lists(const Sheet& sheet) {
  const auto listed_by = [&](PartId part, const std::vector<FaceId>& faces) {
    return std::ranges::all_of(
        faces, [&](FaceId id) { return sheet.faces.has(id) && sheet[id].part_of == part; });
  };
  for (const FlangeId id : sheet.flanges.ids())
    if (sheet[id].faces.empty() || !listed_by(id, sheet[id].faces))
      return fault("A flange has faces, and each names it.",
                   row_of("flange", index_of(id), "/flanges"));
  for (const BendId id : sheet.bends.ids()) {
    const Bend& bend = sheet[id];
    const SheetRow where = row_of(id);
    if (!listed_by(id, bend.faces)) return fault("Each face of a bend names it.", where);
    if (bend.faces.empty() != (bend.kind == BendKind::sharp))
      return fault("Sharp bends have no faces, all others have.", where);
    if (!is_angle(bend.angle) || !(bend.inside_radius >= 0.0) ||
        bend.inside_radius > kFarthestFrame)
      return fault("Angle and inside radius of a bend are numbers of at least 0.", where);
    if (!are_press_lines_of(sheet, bend))
      return fault("The press lines of a bend are rulings of its faces, u growing.", where);
  }
  return {};
}

Fault fault_of_joints(const Sheet& sheet) {
  std::set<std::tuple<FaceId, int, int>> joined;
  std::set<BendId> folded;
  for (size_t j = 0; j < sheet.joints.size(); ++j) {
    const Joint& joint = sheet.joints[j];
    const SheetRow where = row_of("joint", j, "/joints");
    for (const BorderRef& ref : {joint.a, joint.b}) {
      if (!sheet.has(ref)) return fault("A joint names borders of its sheet.", where);
      if (!joined.emplace(ref.face, ref.loop, ref.border).second)
        return fault("A border belongs to one joint at most.", where);
    }
    if (!joint.sharp) continue;
    if (!sheet.bends.has(*joint.sharp) || !sheet[*joint.sharp].faces.empty())
      return fault("A sharp joint names a bend without faces.", where);
    folded.insert(*joint.sharp);
  }
  for (const BendId id : sheet.bends.ids())
    if (sheet[id].kind == BendKind::sharp && !folded.contains(id))
      return fault("A sharp bend is named by a joint.", row_of(id));
  return {};
}

bool drawable(const BorderLoop& borders) {
  return !borders.empty() && std::ranges::all_of(borders, [](const Border& border) {
    return is_regular(border.curve);
  });
}

Fault fault_of_features(const Sheet& sheet) {
  for (const FeatureId id : sheet.features.ids()) {
    const FormedFeature& feature = sheet[id];
    const SheetRow where = row_of("feature", index_of(id), "/features");
    if (!sheet.faces.has(feature.face)) return fault("A feature names a face of its sheet.", where);
    const bool cuts_drawable = std::ranges::all_of(feature.openings,
                                                   [](const FormedOpening& opening) {
                                                     return drawable(opening.pilot) &&
                                                            drawable(opening.through);
                                                   }) &&
                               std::ranges::all_of(feature.slits, drawable);
    for (const BorderLoop& loop : feature.outlines)
      for (const Border& border : loop)
        if (!is_regular(border.curve))
          return fault("An outline is made of lines, arcs and splines of finite size.", where);
    if (!cuts_drawable) return fault("What is cut in a feature has finite borders.", where);
    if (feature.own_openings < 0 || feature.lost_openings < 0)
      return fault("A feature counts its openings from 0.", where);
  }
  return {};
}

Fault fault_of_marks(const Sheet& sheet) {
  if (auto found = fault_of_features(sheet)) return found;
  for (size_t i = 0; i < sheet.labels.size(); ++i)
    if (!sheet.faces.has(sheet.labels[i].face) || !sheet.labels[i].at.allFinite())
      return fault("A label names a point on a face of its sheet.", row_of("label", i, "/labels"));
  return {};
}

Fault fault_of(const Sheet& sheet) {
  if (auto found = fault_of_sizes(sheet)) return found;
  for (const FaceId id : sheet.faces.ids()) {
    if (auto found = fault_of_part(sheet, id)) return found;
    if (auto found = fault_of_borders(sheet, id)) return found;
  }
  if (auto found = fault_of_lists(sheet)) return found;
  if (auto found = fault_of_joints(sheet)) return found;
  return fault_of_marks(sheet);
}

}  // namespace

Result<void> check(const Sheet& sheet) {
  if (auto found = fault_of(sheet)) return tl::unexpected(std::move(*found));
  return {};
}

void require_valid(const Sheet& sheet) {
  if (const auto found = fault_of(sheet)) rule_broken(found->where, found->message);
}

}  // namespace planish
