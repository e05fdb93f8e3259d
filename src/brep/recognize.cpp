#include "assembly.hpp"
#include "body.hpp"
#include "closed_forms.hpp"
#include "guarded.hpp"
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

/// Skin area as the neutral surface (K = ½) would measure it, so that the two skins compare.
double neutral_area(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins, Side side) {
  double sum = 0.0;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    if (skins.side[f] != side) continue;
    double share = 1.0;
    if (const auto* surface = std::get_if<Developable>(&model.faces[f].surface)) {
      double radius = outlines[f].u_scale;
      if (std::holds_alternative<Ruled>(*surface)) radius = 0.0;
      if (radius > 0) share = (radius - model.faces[f].sense * skins.thickness / 2) / radius;
    }
    sum += outlines[f].area * share;
  }
  return sum;
}

int outward_sharp_edges(const SolidModel& model, const Skins& skins, Side side) {
  return static_cast<int>(
      std::count_if(skins.sharp.begin(), skins.sharp.end(), [&](const SharpEdge& edge) {
        return !edge.concave && skins.side[model.edges[edge.edge].faces[0]] == side;
      }));
}

/// The skin that the pattern is drawn from: the one in one piece, then the one folded sharply
/// outwards least (its borders need no setting back), then the one with more material (openings and
/// rims are narrower there).
Side reference_side(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins) {
  if (skins.islands_first != skins.islands_second)
    return skins.islands_first < skins.islands_second ? Side::first : Side::second;
  const int first = outward_sharp_edges(model, skins, Side::first);
  const int second = outward_sharp_edges(model, skins, Side::second);
  if (first != second) return first < second ? Side::first : Side::second;
  constexpr double kClearly = 1.0 + 1e-6;  // sampling of outlines must not decide
  return neutral_area(model, outlines, skins, Side::second) >
                 kClearly * neutral_area(model, outlines, skins, Side::first)
             ? Side::second
             : Side::first;
}

/// Takes closed forms (bridges and lances attached at both ends) off both skins: they are
/// stretched, not bent. Large ones stay, so that the loop they make is refused by name.
bool drop_closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                       Skins& skins) {
  constexpr double kLargestShare = 0.25;  // of the skin
  bool dropped = false;
  for (const Side side : {Side::first, Side::second}) {
    const Groups groups = group_faces(model, outlines, skins, side);
    const std::vector<int> faces = closed_forms(model, outlines, groups);
    double area = 0.0;
    for (const int f : faces)
      area += outlines[f].area;
    const double whole = side == Side::first ? skins.area_first : skins.area_second;
    if (faces.empty() || area > kLargestShare * whole) continue;
    for (const int f : faces) {
      skins.side[f] = Side::none;
      for (const int partner : skins.partners[f])
        skins.side[partner] = Side::none;
    }
    dropped = true;
  }
  return dropped;
}

Result<Sheet> sheet_of_thickness(const SolidModel& model, const std::vector<Outline>& outlines,
                                 double thickness, double tolerance) {
  auto skins = find_skins(model, outlines, thickness, tolerance);
  if (!skins) return tl::unexpected(skins.error());
  drop_closed_forms(model, outlines, *skins);
  const Rim rim = find_rim(model, outlines, *skins);
  const Side side = reference_side(model, outlines, *skins);
  const Groups groups = group_faces(model, outlines, *skins, side);
  return assemble_sheet({model, outlines, *skins, rim, groups, side, kBorderTolerance});
}

/// Forms may hold this share of a sheet's volume; beyond, they are the body and the sheet is a part
/// of it.
constexpr double kFormed = 0.08;

/// How far the volume without forms and mitres may be off: slanted cuts hold or lack some. Where a
/// form could not be measured the whole of it goes into that, chamfers being small.
double volume_allowed(const Sheet& sheet) {
  constexpr double kMeasured = 0.02;
  constexpr double kChamfered = 0.05;
  if (sheet.forms_volume) return kMeasured;
  const bool formed = std::any_of(
      sheet.features.begin(), sheet.features.end(),
      [](const FormedFeature& feature) { return feature.kind != "chamfer"; });
  return formed ? kFormed : kChamfered;
}

/// Whether a sheet accounts for the solid it was seen in: it lies flat, it is wider than thick, and
/// it has the solid's volume as closely as what was seen on it allows.
Result<void> accounts_for_solid(const Sheet& sheet) {
  const auto pattern = flatten(sheet, {.allowance = ConstantK{0.5, "recognition"}});
  if (!pattern) return tl::unexpected(pattern.error());
  constexpr double kNarrowest = 1.3;  // mean width by thickness; wires and bars of square section
                                      // have 1
  const double width = 2 * pattern->area / pattern->perimeter;
  if (width < kNarrowest * sheet.thickness)
    return fail(ErrorCode::not_a_sheet,
                fmt::format("The body is {:.4g} mm thick but only {:.4g} mm wide on average: a "
                            "bar, wire or profile, not "
                            "a sheet.",
                            sheet.thickness, width));
  const double plain = *sheet.volume - sheet.mitres_volume - sheet.forms_volume.value_or(0.0);
  const double flat = pattern->area * sheet.thickness;
  const bool formed_too_much = std::abs(sheet.forms_volume.value_or(0.0)) > kFormed * *sheet.volume;
  if (formed_too_much || !(std::abs(flat / plain - 1.0) <= volume_allowed(sheet)))
    return fail(ErrorCode::not_a_sheet, fmt::format("A sheet of {:.4g} mm explains {:.1f} % of the "
                                                    "volume of the body; this is not a part made "
                                                    "of one sheet.",
                                                    sheet.thickness, 100 * flat / *sheet.volume));
  return {};
}

/// The likeliest thickness that accounts for the solid; when none does, what stood against the
/// first.
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
  return guarded(
      [&] {
        auto model = std::make_shared<const SolidModel>(
            read_solid(body.shape().solid, options.surface_tolerance));
        return recognize_model(std::move(model), options);
      },
      body.name());
}

}  // namespace planish
