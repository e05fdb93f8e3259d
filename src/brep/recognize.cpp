#include "assembly.hpp"
#include "body.hpp"
#include "closed_forms.hpp"
#include "guarded.hpp"
#include "reference_skin.hpp"
#include "refusals.hpp"
#include "solid_reader.hpp"
#include "thickness.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/brep/step.hpp>
#include <planish/sheet/rip.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

// A sheet in a solid. Likely thicknesses are tried in turn (thickness.cpp): skins grown, forms left
// out, faces grouped, the rest told apart as rim, and a sheet assembled. A reading counts only if
// it accounts for the solid: it lies flat, is wider than thick (math.md#plates-and-bars), and has
// the solid's volume within what its features allow (math.md#volume-identity). Without one the
// error is that of the first, likeliest reading.

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
    const double area = sum_of(faces, [&](int f) { return outlines[f].area; });
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

/// One way to see a sheet in a solid.
struct Reading {
  double thickness = 0.0;
  SkinStart start = SkinStart::largest;
};

/// The likeliest thicknesses; then the flat plate: the walls of a frame or of a grating may be
/// larger than its skins, and then the first readings take them for the sheet.
std::vector<Reading> readings_of(const SolidModel& model, const std::vector<Outline>& outlines,
                                 double tolerance) {
  auto readings = mapped(likely_thicknesses(model, outlines, tolerance),
                         [&](double thickness) { return Reading{thickness}; });
  if (const auto thickness = plate_thickness(model, outlines))
    readings.push_back({*thickness, SkinStart::largest_plane});
  return readings;
}

Result<Sheet> sheet_of(const Reading& reading, const SolidModel& model,
                       const std::vector<Outline>& outlines, double tolerance) {
  auto found = find_skins(model, outlines, reading.thickness, tolerance, reading.start);
  if (!found) return pass_on(found);
  const Skins skins = without_closed_forms(model, outlines, std::move(*found));
  const Rim rim = find_rim(model, outlines, skins);
  const Skin skin = reference_skin(model, outlines, skins);
  const Groups groups = group_faces(model, outlines, skins, skin);
  return assemble_sheet({model, outlines, skins, rim, groups, skin, kBorderTolerance});
}

/// Forms may have this share of a sheet's volume; beyond, they are the body and the sheet is only a
/// part of it.
constexpr double kFormed = 0.08;

/// Slanted cuts, and what is machined round openings, may have more of a short piece: they are
/// measured.
constexpr double kSlanted = 0.25;

/// The largest share for a sheet.
double formed_at_most(const Sheet& sheet) {
  const bool slanted = !sheet.features.empty() &&
                       std::ranges::all_of(sheet.features, [](const FormedFeature& feature) {
                         return feature.kind == "slanted cut";
                       });
  return slanted ? kSlanted : kFormed;
}

/// How far the volume without forms and mitres may be off: slanted cuts add or remove some. A form
/// that could not be measured counts in full, as chamfers are small.
double volume_allowed(const Sheet& sheet) {
  constexpr double kMeasured = 0.02;
  constexpr double kChamfered = 0.05;
  if (sheet.forms_volume) return kMeasured;
  const bool formed = std::ranges::any_of(sheet.features, [](const FormedFeature& feature) {
    return feature.kind != "chamfer" && feature.kind != "contact";
  });
  return formed ? kFormed : kChamfered;
}

/// Sides of the rectangle with the area and the circumference of an outline, shorter first: width
/// and length of a strip, straight or bent. What is rounder than a square counts as a square.
std::pair<double, double> strip_sides(const Loop& outline) {
  const double area = std::abs(signed_area(outline));
  const double quarter = length(outline) / 4;
  const double rest = std::sqrt(std::max(0.0, quarter * quarter - area));
  if (rest == 0.0) return {std::sqrt(area), std::sqrt(area)};
  return {quarter - rest, quarter + rest};
}

/// Whether the openings of a plate are its own matter: only the outline, with its openings filled,
/// tells plates from wires, square bars and blocks (math.md#plates-and-bars).
bool is_plate_outline(const Loop& outline, double thickness) {
  constexpr double kPlate = 3.0;   // width over thickness from which a plate needs no length
  constexpr double kLong = 5.0;    // length over thickness of a strip that is no block
  constexpr double kStrip = 1.3;   // width over thickness of any strip; of a square bar it is 1
  constexpr double kBar = 1.1;     // the same of a bar
  constexpr double kBarWidth = 5;  // mm: flat bars are at least as wide; what is narrower is wire
  const auto [width, length] = strip_sides(outline);
  if (width >= kPlate * thickness) return true;
  return length >= kLong * thickness && width >= (width >= kBarWidth ? kBar : kStrip) * thickness;
}

/// A plate is one whatever its outline and however much is cut out of it.
Result<void> is_wide_enough(const FlatPattern& pattern) {
  constexpr double kWide = 1.3;  // mean width over thickness: this is enough
  constexpr double kWeb = 0.5;   // the same: narrower webs are not cut
  const double width = 2 * pattern.area / pattern.perimeter;
  if (width >= kWide * pattern.thickness) return {};
  if (width >= kWeb * pattern.thickness && is_plate_outline(pattern.outer.loop, pattern.thickness))
    return {};
  return fail(refuse::too_narrow,
              {{"thickness", pattern.thickness, unit::mm}, {"width", width, unit::mm}});
}

/// The layout that recognition looks at.
FlattenOptions usual_layout() {
  // Forms are measured with their holes filled (`forms_volume`).
  return {.allowance = ConstantK{0.5, "recognition"}, .extruded = ExtrudedHoles::outline};
}

/// Whether a sheet accounts for the solid in which it was found: it lies flat, it is wider than
/// thick, and it has the solid's volume within what its features allow.
Result<void> accounts_for_solid(const Sheet& sheet) {
  const auto pattern = flatten(sheet, usual_layout());
  if (!pattern) return pass_on(pattern);
  if (auto wide = is_wide_enough(*pattern); !wide) return wide;
  const double plain = *sheet.volume - sheet.mitres_volume - sheet.forms_volume.value_or(0.0);
  const double flat = pattern->area * sheet.thickness;
  const double bored = sum_of(sheet.measured_openings, &MeasuredOpening::beyond);
  const double forms = sheet.forms_volume.value_or(0.0) + bored;
  const bool formed_too_much = std::abs(forms) > formed_at_most(sheet) * *sheet.volume ||
                               bored > kSlanted * *sheet.volume;
  if (formed_too_much || !(std::abs(flat / plain - 1.0) <= volume_allowed(sheet)))
    return fail(refuse::volume_unexplained, {{"thickness", sheet.thickness, unit::mm},
                                             {"share", 100 * flat / *sheet.volume, unit::percent}});
  return {};
}

/// What a closed sheet must pass that is opened by rips.
SheetCheck check_of_ripped(const RecognizeOptions& options) {
  return [&options](const Sheet& open) -> Result<void> {
    if (auto accounted = accounts_for_solid(open); !accounted || !options.passes) return accounted;
    return options.passes(open);
  };
}

/// The sheet of the likeliest reading that accounts for the solid; otherwise the error of the
/// first one tried.
Result<Sheet> likeliest_sheet(const SolidModel& model, const RecognizeOptions& options) {
  const std::vector<Outline> outlines = outlines_of(model);
  std::optional<Error> first;
  std::optional<Sheet> closed;
  const double tolerance = options.thickness_tolerance;
  for (const Reading& reading : readings_of(model, outlines, tolerance)) {
    auto sheet = sheet_of(reading, model, outlines, tolerance);
    if (sheet) sheet = ripped(std::move(*sheet), options.rip_edges);
    const auto accounted = sheet ? accounts_for_solid(*sheet) : pass_on(sheet);
    if (accounted) return sheet;
    if (first) continue;
    first = accounted.error();
    if (sheet && first->code == code::closed_loop) closed = std::move(*sheet);
  }
  if (closed)
    return tl::unexpected(loop_refusal(*closed, *first, usual_layout(), check_of_ripped(options)));
  if (first) return tl::unexpected(*first);
  return fail(refuse::no_opposite_faces);
}

Result<Recognized> recognize_model(std::shared_ptr<const SolidModel> model,
                                   const RecognizeOptions& options) {
  auto sheet = likeliest_sheet(*model, options);
  if (!sheet) return pass_on(sheet);
  Recognized result;
  result.sheet = std::move(*sheet);
  result.distance = [model](int edge, const Vec3& point) {
    return model->edges[edge - 1].curve.distance(point);
  };
  return result;
}

}  // namespace

Result<Recognized> recognize(const Body& body, const RecognizeOptions& options) {
  for (const auto& [name, value, measure] :
       {std::tuple{"surface", options.surface_tolerance, unit::mm},
        std::tuple{"thickness", options.thickness_tolerance, unit::none}})
    if (!(value > 0.0 && value <= kFarthest))
      return fail(refuse::tolerance_of_recognition,
                  {{"what", name}, {"tolerance", value, measure}});
  return guarded(
      [&] {
        auto model = std::make_shared<const SolidModel>(
            read_solid(body.shape().solid, options.surface_tolerance));
        return recognize_model(std::move(model), options);
      },
      body.name());
}

}  // namespace planish
