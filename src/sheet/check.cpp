#include <planish/sheet/sheet.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace planish {
namespace {

using Fault = std::optional<Error>;

Error fault(std::string rule, std::string where) {
  return {ErrorCode::invalid_sheet, std::move(rule), std::move(where)};
}

std::string name_of(FaceId id) { return fmt::format("face {}", index_of(id)); }
std::string name_of(const BorderRef& ref) {
  return fmt::format("face {}, loop {}, border {}", index_of(ref.face), ref.loop, ref.border);
}

bool finite(const Curve2& curve) {
  struct Finite {
    bool operator()(const Segment& s) const { return s.a.allFinite() && s.b.allFinite(); }
    bool operator()(const Arc& a) const {
      return a.center.allFinite() && std::isfinite(a.radius) && std::isfinite(a.start) &&
             std::isfinite(a.sweep);
    }
    bool operator()(const CubicSpline& s) const {
      return s.poles.size() >= 4 && s.poles.size() % 3 == 1 &&
             std::all_of(s.poles.begin(), s.poles.end(),
                         [](const Vec2& pole) { return pole.allFinite(); });
    }
  };
  return std::visit(Finite{}, curve);
}

bool regular(const Developable& surface) {
  if (const auto* cylinder = std::get_if<Cylinder>(&surface)) return cylinder->radius > 0.0;
  if (const auto* cone = std::get_if<Cone>(&surface))
    return cone->half_angle > 0.0 && cone->half_angle < 0.5 * std::numbers::pi;
  const auto& knots = std::get<Ruled>(surface).knots;
  const auto falls = [](const Ruled::Knot& a, const Ruled::Knot& b) { return !(a.u < b.u); };
  return knots.size() >= 2 && std::adjacent_find(knots.begin(), knots.end(), falls) == knots.end();
}

Fault fault_of_sizes(const Sheet& sheet) {
  if (!(sheet.thickness > 0.0 && std::isfinite(sheet.thickness)))
    return fault("The thickness of a sheet is a number above 0.", "sheet");
  if (!(sheet.reference_depth >= 0.0 && sheet.reference_depth <= sheet.thickness))
    return fault("The reference depth of a sheet is a number from 0 to the thickness.", "sheet");
  if (sheet.faces.empty()) return fault("A sheet has faces.", "sheet");
  return {};
}

Fault fault_of_part(const Sheet& sheet, FaceId id) {
  const Face& face = sheet[id];
  const auto* bend = std::get_if<BendId>(&face.part_of);
  const bool known = bend ? sheet.bends.has(*bend)
                          : sheet.flanges.has(std::get<FlangeId>(face.part_of));
  if (!known) return fault("A face names a flange or bend of its sheet.", name_of(id));
  const auto& faces = sheet.faces_of(face.part_of);
  if (std::count(faces.begin(), faces.end(), id) != 1)
    return fault("The flange or bend of a face lists it once.", name_of(id));
  const auto* surface = std::get_if<Developable>(&face.surface);
  if ((surface != nullptr) != (bend != nullptr))
    return fault("Flanges have plane faces, bends have developable ones.", name_of(id));
  if (surface ? face.sense != 1 && face.sense != -1 : face.sense != 1)
    return fault("The sense of a face is 1 or −1, that of a plane 1.", name_of(id));
  if (surface && !regular(*surface))
    return fault("The surface of a bend has a positive size.", name_of(id));
  return {};
}

Fault fault_of_borders(const Sheet& sheet, FaceId id) {
  const Face& face = sheet[id];
  if (face.loops.empty()) return fault("A face has an outer loop.", name_of(id));
  for (int l = 0; l < std::ssize(face.loops); ++l) {
    if (face.loops[l].empty())
      return fault("A loop has borders.", fmt::format("face {}, loop {}", index_of(id), l));
    for (int b = 0; b < std::ssize(face.loops[l]); ++b) {
      const Border& border = face.loops[l][b];
      const BorderRef ref{id, l, b};
      if (!finite(border.curve)) return fault("Border curves are finite.", name_of(ref));
      if (!std::isfinite(border.edge_depth) || (border.edge_length && !(*border.edge_length >= 0)))
        return fault("Depth and length of a border's edge are numbers.", name_of(ref));
      if (border.feature && !sheet.features.has(*border.feature))
        return fault("A border names a feature of its sheet.", name_of(ref));
    }
  }
  return {};
}

Fault fault_of_lists(const Sheet& sheet) {
  const auto listed_by = [&](PartId part, const std::vector<FaceId>& faces) {
    return std::all_of(faces.begin(), faces.end(),
                       [&](FaceId id) { return sheet.faces.has(id) && sheet[id].part_of == part; });
  };
  for (const FlangeId id : sheet.flanges.ids())
    if (sheet[id].faces.empty() || !listed_by(id, sheet[id].faces))
      return fault("A flange has faces, and each names it.",
                   fmt::format("flange {}", index_of(id)));
  for (const BendId id : sheet.bends.ids()) {
    const Bend& bend = sheet[id];
    const std::string where = fmt::format("bend {}", index_of(id));
    if (!listed_by(id, bend.faces)) return fault("Each face of a bend names it.", where);
    if (bend.faces.empty() != (bend.kind == BendKind::sharp))
      return fault("Sharp bends have no faces, all others have.", where);
    if (!(bend.angle.radians() >= 0.0 && std::isfinite(bend.angle.radians())) ||
        !(bend.inside_radius >= 0.0 && std::isfinite(bend.inside_radius)))
      return fault("Angle and inside radius of a bend are numbers of at least 0.", where);
  }
  return {};
}

Fault fault_of_joints(const Sheet& sheet) {
  std::set<std::tuple<FaceId, int, int>> joined;
  for (size_t j = 0; j < sheet.joints.size(); ++j) {
    const Joint& joint = sheet.joints[j];
    const std::string where = fmt::format("joint {}", j);
    for (const BorderRef& ref : {joint.a, joint.b}) {
      if (!sheet.has(ref)) return fault("A joint names borders of its sheet.", where);
      if (!joined.emplace(ref.face, ref.loop, ref.border).second)
        return fault("A border belongs to one joint at most.", where);
    }
    if (!joint.sharp) continue;
    if (!sheet.bends.has(*joint.sharp) || !sheet[*joint.sharp].faces.empty())
      return fault("A sharp joint names a bend without faces.", where);
  }
  return {};
}

bool drawable(const BorderLoop& borders) {
  return !borders.empty() && std::all_of(borders.begin(), borders.end(),
                                         [](const Border& border) { return finite(border.curve); });
}

Fault fault_of_features(const Sheet& sheet) {
  for (const FeatureId id : sheet.features.ids()) {
    const FormedFeature& feature = sheet[id];
    const std::string where = fmt::format("feature {}", index_of(id));
    if (!sheet.faces.has(feature.face)) return fault("A feature names a face of its sheet.", where);
    const bool cuts_drawable = std::all_of(feature.openings.begin(), feature.openings.end(),
                                           [](const FormedOpening& opening) {
                                             return drawable(opening.pilot) &&
                                                    drawable(opening.through);
                                           }) &&
                               std::all_of(feature.slits.begin(), feature.slits.end(), drawable);
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
      return fault("A label names a point on a face of its sheet.", fmt::format("label {}", i));
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

}  // namespace planish
