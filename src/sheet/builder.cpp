#include <planish/base/assert.hpp>
#include <planish/sheet/builder.hpp>

// The one way to make a sheet. Ids are given in the order of adding and both directions of each
// reference are set together, so faces and their flange or bend agree. `build` runs the checks of
// check.cpp; no sheet leaves without them.

namespace planish {

SheetBuilder::SheetBuilder(double thickness, double reference_depth) {
  sheet_.thickness = thickness;
  sheet_.reference_depth = reference_depth;
}

FlangeId SheetBuilder::add_flange() { return sheet_.flanges.push_back({}); }

BendId SheetBuilder::add_bend(Bend bend) {
  PLANISH_ASSERT(bend.faces.empty());
  return sheet_.bends.push_back(std::move(bend));
}

FaceId SheetBuilder::add_face(Face face) {
  const PartId part = face.part_of;
  const FaceId id = sheet_.faces.push_back(std::move(face));
  if (const auto* flange = std::get_if<FlangeId>(&part))
    sheet_.flanges[*flange].faces.push_back(id);
  else
    sheet_.bends[std::get<BendId>(part)].faces.push_back(id);
  return id;
}

void SheetBuilder::join(const BorderRef& a, const BorderRef& b, std::optional<BendId> sharp,
                        double mitre_volume) {
  PLANISH_ASSERT(sheet_.has(a) && sheet_.has(b));
  PLANISH_ASSERT(!sharp || sheet_[*sharp].faces.empty());
  sheet_.joints.push_back({a, b, sharp, mitre_volume});
  sheet_.mitres_volume += mitre_volume;
}

FeatureId SheetBuilder::add_feature(FormedFeature feature) {
  PLANISH_ASSERT(sheet_.faces.has(feature.face));
  return sheet_.features.push_back(std::move(feature));
}

void SheetBuilder::add_opening(const MeasuredOpening& opening) {
  PLANISH_ASSERT(sheet_.has({opening.face, opening.loop, opening.border.value_or(0)}));
  sheet_.measured_openings.push_back(opening);
}

void SheetBuilder::add_outline(const MeasuredOutline& outline) {
  PLANISH_ASSERT(sheet_.has({outline.face, 0, 0}));
  sheet_.measured_outlines.push_back(outline);
}

void SheetBuilder::add_label(PointLabel label) {
  PLANISH_ASSERT(sheet_.faces.has(label.face));
  sheet_.labels.push_back(std::move(label));
}

void SheetBuilder::number_edges() {
  int edge = 0;
  for (Face& face : sheet_.faces)
    for (BorderLoop& loop : face.loops)
      for (Border& border : loop)
        border.edge = ++edge;
  for (const Joint& joint : sheet_.joints)
    sheet_[joint.b].edge = sheet_[joint.a].edge;
}

void SheetBuilder::add_form_volume(std::optional<double> volume) {
  if (!volume)
    sheet_.forms_volume.reset();
  else if (sheet_.forms_volume)
    *sheet_.forms_volume += *volume;
}

Result<Sheet> SheetBuilder::build() && {
  if (auto right = check(sheet_); !right) return tl::unexpected(std::move(right.error()));
  return std::move(sheet_);
}

}  // namespace planish
