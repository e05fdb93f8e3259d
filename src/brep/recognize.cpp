#include "assembly.hpp"
#include "body.hpp"
#include "closed_forms.hpp"
#include "divided_skin.hpp"
#include "guarded.hpp"
#include "model_places.hpp"
#include "reference_skin.hpp"
#include "refusals.hpp"
#include "solid_reader.hpp"
#include "thickness.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/text.hpp>
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

/// The skins without closed forms (bridges, lances attached at both ends, beads, louvres): those
/// are stretched, not bent.
Skins without_closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                           Skins skins) {
  const Rim rim = find_rim(model, outlines, skins);
  const auto take = [&](int f) {
    if (skins.skin_of[f] != Skin::none)
      skins.pressed_volume += outlines[f].area * skins.thickness / 2;
    skins.skin_of[f] = Skin::none;
  };
  for (const Skin skin : {Skin::first, Skin::second}) {
    const Groups groups = group_faces(model, outlines, skins, skin);
    for (const int f : closed_forms(model, outlines, groups, rim)) {
      take(f);
      std::ranges::for_each(skins.partners[f], take);
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
/// larger than its skins, and then the first readings take them for the sheet; then the plate most
/// of which is milled, of the thickness that its rim has.
std::vector<Reading> readings_of(const SolidModel& model, const std::vector<Outline>& outlines,
                                 const RecognizeOptions& options) {
  if (options.thickness)
    return {{*options.thickness, SkinStart::largest},
            {*options.thickness, SkinStart::largest_plane},
            {*options.thickness, SkinStart::milled}};
  auto readings = mapped(likely_thicknesses(model, outlines, options.thickness_tolerance),
                         [&](double thickness) { return Reading{thickness}; });
  if (const auto thickness = plate_thickness(model, outlines))
    readings.push_back({*thickness, SkinStart::largest_plane});
  for (const double thickness : milled_thicknesses(model, outlines, options.thickness_tolerance))
    readings.push_back({thickness, SkinStart::milled});
  return readings;
}

bool is_formed(const FormedFeature& feature) { return feature.kind == "formed"; }

/// How far the solid reaches beyond the outline that is cut, mm.
double beyond_outline(const Sheet& sheet) {
  double most = 0.0;
  for (const MeasuredOutline& outline : sheet.measured_outlines)
    most = std::max(most, outline.beyond);
  return most;
}

/// Along which skin a sheet is read: the one that is the reference as a rule, or the other.
enum class Along { reference, other };

Result<Sheet> sheet_of(const Reading& reading, const SolidModel& model,
                       const std::vector<Outline>& outlines, double tolerance,
                       Along along = Along::reference) {
  auto found = find_skins(model, outlines, reading.thickness, tolerance, reading.start);
  if (!found) return pass_on(found);
  Skins skins = without_closed_forms(model, outlines, std::move(*found));
  const Skin reference = reference_skin(model, outlines, skins);
  const Skin skin = along == Along::other ? other_skin(reference) : reference;
  skins = without_divided(model, outlines, std::move(skins), skin);
  const Rim rim = find_rim(model, outlines, skins);
  const Groups groups = group_faces(model, outlines, skins, skin);
  // What is left of them hangs on bends, and no outline goes round all pieces.
  if (const auto divided = divided_flanges(model, skins, groups); !divided.empty())
    return fail(refuse::flange_divided, {{"face", face_place(model, divided.front().face)},
                                         {"face", face_place(model, divided.front().piece)}});
  auto sheet = assemble_sheet({model, outlines, skins, rim, groups, skin, kBorderTolerance});
  if (!sheet || reading.start != SkinStart::milled) return sheet;
  // What stands out of a rim belongs to a body that only has one.
  if (const auto form = std::ranges::find_if(sheet->features, is_formed);
      form != sheet->features.end())
    return fail(refuse::beyond_sheet,
                {{"face", face_place(model, form->source_face.value_or(1) - 1)},
                 {"thickness", sheet->thickness, unit::mm}});
  return sheet;
}

/// Forms may have this share of a sheet's volume; beyond, they are the body and the sheet is only a
/// part of it.
constexpr double kFormed = 0.08;

/// What is pressed from the sheet at its own thickness may add as much as was there, and hold half
/// of the body.
constexpr double kStretched = 0.5;
constexpr double kPressed = 0.5;

/// Slanted cuts, and what is machined round openings, may have more of a short piece: they are
/// measured.
constexpr double kSlanted = 0.25;

/// The same of what is machined off, in recesses or beside outlines: beyond, the part is milled
/// from a plate, if that is stated, and has at least half of it.
constexpr double kMachined = 0.15;
constexpr double kMilled = 0.5;

/// How much forms may add to a sheet or take off, mm³.
double formed_at_most(const Sheet& sheet) {
  const bool slanted = !sheet.features.empty() &&
                       std::ranges::all_of(sheet.features, [](const FormedFeature& feature) {
                         return feature.kind == "slanted cut";
                       });
  const double pressed = std::min(sheet.pressed_volume, kPressed * *sheet.volume);
  return (slanted ? kSlanted : kFormed) * *sheet.volume + kStretched * pressed;
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

/// Length over thickness of a strip that is no block.
constexpr double kLong = 5.0;

/// Whether the openings of a plate are its own matter: only the outline, with its openings filled,
/// tells plates from wires, square bars and blocks (math.md#plates-and-bars).
bool is_plate_outline(const Loop& outline, double thickness) {
  constexpr double kPlate = 3.0;   // width over thickness from which a plate needs no length
  constexpr double kStrip = 1.3;   // width over thickness of any strip; of a square bar it is 1
  constexpr double kBar = 1.1;     // the same of a bar
  constexpr double kBarWidth = 5;  // mm: flat bars are at least as wide; what is narrower is wire
  const auto [width, length] = strip_sides(outline);
  if (width >= kPlate * thickness) return true;
  return length >= kLong * thickness && width >= (width >= kBarWidth ? kBar : kStrip) * thickness;
}

/// What a person sees of the width: of what has openings, the mean of its webs.
double width_seen(const FlatPattern& pattern) {
  return pattern.openings.empty() ? strip_sides(pattern.outer.loop).first
                                  : 2 * pattern.area / pattern.perimeter;
}

/// A plate is one whatever its outline and however much is cut out of it.
bool is_wide_enough(const FlatPattern& pattern) {
  constexpr double kWide = 1.3;  // mean width over thickness: this is enough
  constexpr double kWeb = 0.5;   // the same: narrower webs are not cut
  const double width = 2 * pattern.area / pattern.perimeter;
  if (width >= kWide * pattern.thickness) return true;
  return width >= kWeb * pattern.thickness &&
         is_plate_outline(pattern.outer.loop, pattern.thickness);
}

/// The layout that recognition looks at.
FlattenOptions usual_layout() {
  // Forms are measured with their holes filled (`forms_volume`).
  return {.allowance = ConstantK{0.5, "recognition"}, .extruded = ExtrudedHoles::outline};
}

/// Why a sheet does not account for the solid in which it was found.
struct Doubts {
  std::optional<Error> narrow = {};  ///< it is hardly wider than thick
  bool is_strip = false;             ///< but long
  std::optional<Error> milled = {};  ///< more is machined off than from other sheets
  std::optional<Error> wrong = {};   ///< it does not lie flat, or has not the volume of the solid
                                     ///< within what its features allow

  const std::optional<Error>& first() const { return narrow ? narrow : wrong ? wrong : milled; }
  /// Whether it would be a sheet if its thickness were stated.
  bool may_be_stated() const { return (is_strip || (milled && !narrow)) && !wrong; }
};

Doubts doubts_about(const Sheet& sheet) {
  const auto pattern = flatten(sheet, usual_layout());
  if (!pattern) return {.wrong = pattern.error()};
  Doubts doubts;
  if (!is_wide_enough(*pattern)) {
    doubts.is_strip = strip_sides(pattern->outer.loop).second >= kLong * sheet.thickness;
    doubts.narrow = error_of(
        doubts.is_strip ? refuse::too_narrow : refuse::a_block,
        {{"thickness", sheet.thickness, unit::mm}, {"width", width_seen(*pattern), unit::mm}});
  }
  const double plain = *sheet.volume - sheet.mitres_volume - sheet.forms_volume.value_or(0.0);
  const double flat = pattern->area * sheet.thickness;
  const double bored = sum_of(sheet.measured_openings, &MeasuredOpening::beyond);
  const double machined = sum_of(sheet.measured_outlines, &MeasuredOutline::lacking);
  const double forms = sheet.forms_volume.value_or(0.0) + bored + machined;
  const double off = std::max(-forms, machined);
  const bool formed = std::ranges::any_of(sheet.features, is_formed);
  if (off > std::max(kMachined * flat, formed_at_most(sheet)))
    doubts.milled = error_of(refuse::milled_off, {{"thickness", sheet.thickness, unit::mm},
                                                  {"share", 100 * off / flat, unit::percent}});
  const bool formed_too_much = (formed ? std::abs(forms) : forms) > formed_at_most(sheet) ||
                               off > kMilled * flat || bored > kSlanted * *sheet.volume;
  if (formed_too_much || !(std::abs(flat / plain - 1.0) <= volume_allowed(sheet)))
    doubts.wrong = error_of(refuse::volume_unexplained,
                            {{"thickness", sheet.thickness, unit::mm},
                             {"share", 100 * flat / *sheet.volume, unit::percent}});
  return doubts;
}

/// The sheets of one solid that were tried, and what came of them.
class Trials {
 public:
  explicit Trials(const RecognizeOptions& options) : options_(options) {}

  /// Whether it is the sheet of the solid.
  bool accept(const Result<Sheet>& sheet) {
    Doubts doubts = sheet ? doubts_about(*sheet) : Doubts{.wrong = sheet.error()};
    if (options_.thickness) {
      doubts.narrow.reset();
      doubts.milled.reset();
    }
    if (!doubts.first()) return true;
    if (doubts.may_be_stated()) note_stated(sheet->thickness, doubts);
    if (first_) return false;
    first_ = doubts.first();
    is_narrow_ = doubts.is_strip;
    if (sheet && first_->code == code::closed_loop) closed_ = *sheet;
    return false;
  }

  /// The error of the first, with what would help; `opened` judges a closed sheet that rips open.
  Error refusal(const SheetCheck& opened) const {
    if (closed_) return loop_refusal(*closed_, *first_, usual_layout(), opened);
    Error why = is_narrow_
                    ? *first_
                    : milled_.value_or(first_.value_or(error_of(refuse::no_opposite_faces, {})));
    if (!is_narrow_ && !milled_) return why;
    for (const double thickness : stated_) {
      const std::string text = trimmed_number(thickness, 4);
      Told change = tell("Take it for a sheet of {thickness}",
                         {{"thickness", thickness, unit::mm}});
      why.remedies.push_back(
          {"thickness", text, std::move(change.sentence), std::move(change.named)});
    }
    return why;
  }

 private:
  void note_stated(double thickness, const Doubts& doubts) {
    if (std::ranges::count(stated_, thickness) == 0) stated_.push_back(thickness);
    if (!doubts.narrow && !milled_) milled_ = doubts.milled;
  }

  const RecognizeOptions& options_;
  std::optional<Error> first_;
  std::optional<Sheet> closed_;
  std::optional<Error> milled_;  ///< of the first that is a sheet but for what is machined off
  bool is_narrow_ = false;
  std::vector<double> stated_;  ///< thicknesses of which it would be a sheet, if they were stated
};

/// Whether a sheet along the other skin has what one lacks at its edges: then it is larger.
bool lacks_less(const Sheet& other, const Sheet& sheet) {
  if (beyond_outline(other) >= beyond_outline(sheet) || doubts_about(other).wrong) return false;
  const auto larger = flatten(other, usual_layout()), smaller = flatten(sheet, usual_layout());
  return larger && smaller && larger->area > smaller->area;
}

/// What a closed sheet must pass that is opened by rips.
SheetCheck check_of_ripped(const RecognizeOptions& options) {
  return [&options](const Sheet& open) -> Result<void> {
    if (const Doubts doubts = doubts_about(open); doubts.first())
      return tl::unexpected(*doubts.first());
    return options.passes ? options.passes(open) : Result<void>();
  };
}

/// The sheet of the likeliest reading that accounts for the solid, along the other skin if this one
/// lacks what is milled off at its edges, and that one less of it; otherwise the error of the first
/// one tried.
Result<Sheet> likeliest_sheet(const SolidModel& model, const RecognizeOptions& options) {
  constexpr double kLacking = 1e-3;  // mm
  const std::vector<Outline> outlines = outlines_of(model);
  Trials trials(options);
  for (const Reading& reading : readings_of(model, outlines, options)) {
    auto sheet = sheet_of(reading, model, outlines, options.thickness_tolerance);
    if (sheet) sheet = ripped(std::move(*sheet), options.rip_edges);
    if (!trials.accept(sheet)) continue;
    if (beyond_outline(*sheet) <= kLacking) return sheet;
    auto other = sheet_of(reading, model, outlines, options.thickness_tolerance, Along::other);
    if (other) other = ripped(std::move(*other), options.rip_edges);
    return other && lacks_less(*other, *sheet) ? other : sheet;
  }
  return tl::unexpected(trials.refusal(check_of_ripped(options)));
}

/// The sheet of a solid. A general bend may be so near a cone that its splines are taken for cones,
/// which do not lie a thickness apart: what is no sheet is read again, more finely.
Result<Recognized> recognize_solid(const TopoDS_Solid& solid, const RecognizeOptions& options) {
  constexpr double kFiner = 0.1;
  auto model = std::make_shared<const SolidModel>(read_solid(solid, options.surface_tolerance));
  auto sheet = likeliest_sheet(*model, options);
  if (!sheet) {
    auto finer = std::make_shared<const SolidModel>(
        read_solid(solid, kFiner * options.surface_tolerance));
    if (std::ranges::equal(model->faces, finer->faces, same_kind)) return pass_on(sheet);
    auto again = likeliest_sheet(*finer, options);
    if (!again) return pass_on(sheet);
    sheet = std::move(again);
    model = std::move(finer);
  }
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
  return guarded([&] { return recognize_solid(body.shape().solid, options); }, body.name());
}

}  // namespace planish
