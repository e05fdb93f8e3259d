#include "assembly.hpp"
#include "body.hpp"
#include "closed_forms.hpp"
#include "guarded.hpp"
#include "reference_skin.hpp"
#include "solid_reader.hpp"
#include "thickness.hpp"

#include <planish/brep/step.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

using namespace brep;

/// Borders are fitted this closely, mm: far below what any machine cuts.
constexpr double kBorderTolerance = 1e-5;

/// The skins without closed forms (bridges and lances attached at both ends): those are stretched,
/// not bent. Large ones stay, so that the loop they form is refused as such.
Skins without_closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                           Skins skins) {
  constexpr double kLargestShare = 0.25;  // of the skin
  for (const Skin skin : {Skin::first, Skin::second}) {
    const Groups groups = group_faces(model, outlines, skins, skin);
    const std::vector<int> faces = closed_forms(model, outlines, groups);
    double area = 0.0;
    for (const int f : faces)
      area += outlines[f].area;
    const double whole = skin == Skin::first ? skins.area_first : skins.area_second;
    if (area > kLargestShare * whole) continue;
    for (const int f : faces) {
      skins.skin_of[f] = Skin::none;
      for (const int partner : skins.partners[f])
        skins.skin_of[partner] = Skin::none;
    }
  }
  return skins;
}

Result<Sheet> sheet_of_thickness(const SolidModel& model, const std::vector<Outline>& outlines,
                                 double thickness, double tolerance) {
  auto found = find_skins(model, outlines, thickness, tolerance);
  if (!found) return tl::unexpected(found.error());
  const Skins skins = without_closed_forms(model, outlines, std::move(*found));
  const Rim rim = find_rim(model, outlines, skins);
  const Skin skin = reference_skin(model, outlines, skins);
  const Groups groups = group_faces(model, outlines, skins, skin);
  return assemble_sheet({model, outlines, skins, rim, groups, skin, kBorderTolerance});
}

/// Forms may have this share of a sheet's volume; beyond, they are the body and the sheet is only a
/// part of it.
constexpr double kFormed = 0.08;

/// How far the volume without forms and mitres may be off: slanted cuts add or remove some. A form
/// that could not be measured counts in full, as chamfers are small.
double volume_allowed(const Sheet& sheet) {
  constexpr double kMeasured = 0.02;
  constexpr double kChamfered = 0.05;
  if (sheet.forms_volume) return kMeasured;
  const bool formed = std::any_of(
      sheet.features.begin(), sheet.features.end(),
      [](const FormedFeature& feature) { return feature.kind != "chamfer"; });
  return formed ? kFormed : kChamfered;
}

/// Whether a sheet accounts for the solid in which it was found: it lies flat, it is wider than
/// thick, and it has the solid's volume within what its features allow.
Result<void> accounts_for_solid(const Sheet& sheet) {
  const auto pattern = flatten(sheet, {.allowance = ConstantK{0.5, "recognition"}});
  if (!pattern) return tl::unexpected(pattern.error());
  constexpr double kNarrowest = 1.3;  // mean width over thickness; wires and bars of square section
                                      // have 1
  const double width = 2 * pattern->area / pattern->perimeter;
  if (width < kNarrowest * sheet.thickness)
    return fail(ErrorCode::not_a_sheet,
                fmt::format("The body is {:.4g} mm thick but only {:.4g} mm wide on average: a "
                            "bar, wire or profile, not a sheet.",
                            sheet.thickness, width));
  const double plain = *sheet.volume - sheet.mitres_volume - sheet.forms_volume.value_or(0.0);
  const double flat = pattern->area * sheet.thickness;
  const bool formed_too_much = std::abs(sheet.forms_volume.value_or(0.0)) > kFormed * *sheet.volume;
  if (formed_too_much || !(std::abs(flat / plain - 1.0) <= volume_allowed(sheet)))
    return fail(ErrorCode::not_a_sheet, fmt::format("A sheet of {:.4g} mm accounts for {:.1f} % of "
                                                    "the body's volume; the body is not made of "
                                                    "one sheet.",
                                                    sheet.thickness, 100 * flat / *sheet.volume));
  return {};
}

/// The sheet of the likeliest thickness that accounts for the solid; otherwise the error of the
/// first one tried.
Result<Sheet> likeliest_sheet(const SolidModel& model, const RecognizeOptions& options) {
  const std::vector<Outline> outlines = outlines_of(model);
  tl::unexpected<Error> first = fail(
      ErrorCode::not_a_sheet,
      "No two faces lie opposite each other with material between them; this is not a sheet.");
  bool tried = false;
  for (const double thickness : likely_thicknesses(model, outlines, options.thickness_tolerance)) {
    auto sheet = sheet_of_thickness(model, outlines, thickness, options.thickness_tolerance);
    if (sheet) {
      auto accounted = accounts_for_solid(*sheet);
      if (accounted) return sheet;
      sheet = tl::unexpected(accounted.error());
    }
    if (!tried) first = tl::unexpected(sheet.error());
    tried = true;
  }
  return first;
}

Result<Recognized> recognize_model(std::shared_ptr<const SolidModel> model,
                                   const RecognizeOptions& options) {
  auto sheet = likeliest_sheet(*model, options);
  if (!sheet) return tl::unexpected(sheet.error());
  Recognized result;
  result.sheet = std::move(*sheet);
  result.distance = [model](int edge, const Vec3& point) {
    return model->edges[edge].curve.distance(point);
  };
  return result;
}

}  // namespace

Result<Recognized> recognize(const Body& body, const RecognizeOptions& options) {
  for (const auto& [name, value] : {std::pair{"surface", options.surface_tolerance},
                                    std::pair{"thickness", options.thickness_tolerance}})
    if (!(value > 0.0 && value <= kFarthest))
      return fail(ErrorCode::bad_option,
                  fmt::format("The {} tolerance is {}; it must be above 0.", name, value));
  return guarded(
      [&] {
        auto model = std::make_shared<const SolidModel>(
            read_solid(body.shape().solid, options.surface_tolerance));
        return recognize_model(std::move(model), options);
      },
      body.name());
}

}  // namespace planish
