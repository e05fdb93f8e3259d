#include "folded.hpp"
#include "makers.hpp"
#include "refusals.hpp"
#include "slit_loads_json.hpp"
#include "slit_sheet_json.hpp"

#include <planish/job/slit_json.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/schema/text_file.hpp>
#include <planish/slit/scans.hpp>
#include <planish/slit/session.hpp>

#include <fmt/format.h>

#include <set>

namespace planish::job {
using namespace schema;
namespace {

constexpr auto kSlitsFormat = "planish/slits";
constexpr int kSlitsVersion = 1;

// What the library takes.
constexpr int kFewestRidges = 3, kMostRidges = 1000;
constexpr std::size_t kMostPoles = 64;
constexpr double kLargest = 1e7;  // mm
constexpr schema::Range kLength{"a length above 0 and at most 1e7 mm", 0.0, kLargest, false};
constexpr schema::Range kGap{"a length from 0 to 1e7 mm", 0.0, kLargest};
constexpr schema::Range kCoordinate{"a length from -1e7 to 1e7 mm", -kLargest, kLargest};
constexpr schema::Range kWeight{"a number from 0 to 10000", 0.0, 1e4};
constexpr schema::Range kLean{"an angle from -90 to 90", -90.0, 90.0};
constexpr schema::Range kDraft{"an angle above 0 and at most 85", 0.0, 85.0, false};

const Words<StripEdge> kSides{{"left", StripEdge::left}, {"right", StripEdge::right}};
const Words<EndAngle> kEndAngles{
    {"right_angle", EndAngle::right_angle}, {"level", EndAngle::level}, {"free", EndAngle::free}};
const Words<SlitObjective> kObjectives{{"energy", SlitObjective::energy},
                                       {"smooth", SlitObjective::smooth}};
const Words<MouldForm> kForms{{"ribs", MouldForm::ribs}, {"body", MouldForm::body}};
const Words<MouldSide> kMouldSides{
    {"ground", MouldSide::ground}, {"back", MouldSide::back}, {"front", MouldSide::front}};
const Words<double SlitWeights::*> kWeights{
    {"smooth", &SlitWeights::smooth},   {"spacing", &SlitWeights::spacing},
    {"anchors", &SlitWeights::anchors}, {"seat", &SlitWeights::seat},
    {"spread", &SlitWeights::spread},   {"scan", &SlitWeights::scan}};

Schema poles_schema() {
  return list(tuple(2, length(kCoordinate), "a pole [a, b]"))
      .of_length(2, kMostPoles, "a list of 2 to 64 poles")
      .said("its poles");
}

Field fit_field(std::string_view what) {
  return optional("fit",
                  flag().defaulting(false).said("scale it about its start " + std::string(what)));
}

Schema seat_schema() {
  return object({required("bezier", poles_schema()), fit_field("to the breadth of the strips")})
      .said("in the symmetry plane; the strips are drawn to it");
}

Schema leg_schema(std::string description) {
  return object(
             {required("bezier", poles_schema()), fit_field("until the sheet fits it"),
              optional("lean", angle(kLean).defaulting(0).said(
                                   "how far the panel is turned away from the sheet's front about "
                                   "the line through the ends of the curve; 90: level"))})
      .said(std::move(description));
}

Schema second_panel_schema() {
  return object({required("height", length(kLength).said("of the uncut part of the sheet there")),
                 required("leg_curve", leg_schema("in the ground plane, from the left"))})
      .said("at the far ends of the strips of a sheet that is not symmetric");
}

Schema mould_schema() {
  return object(
             {optional("form", words(kForms).defaulting("ribs").said(
                                   "ribs to be set on a board, or one body with side panels")),
              optional("side", words(kMouldSides)
                                   .defaulting("ground")
                                   .said("of the sheet that lies on the mould")),
              optional("up", space_direction().said(
                                 "in which the sheet is lifted off; found if left out")),
              optional("base", length(kLength).said("below its working surfaces, or else 20 mm")),
              optional("inset", length(kGap).said("of ribs' sides; found if left out")),
              optional("draft", angle(kDraft).defaulting(5).said(
                                    "quads that face up by less are left bare"))})
      .said("on which the sheet is laid");
}

Schema anchor_schema() {
  return object(
      {required("strip", whole()), required("ridge", whole()),
       required("at",
                space_point(kCoordinate).said("place that the end of the ridge should be near")),
       optional("side", words(kSides).defaulting("left").said("which end of the ridge"))});
}

Schema end_schema() {
  return object({required("strip", whole()), optional("position", space_point(kCoordinate)),
                 optional("direction", space_direction()), optional("across", space_direction())});
}

Schema scan_schema() {
  return object({optional("strip", whole().said("where it is left out, of any strip")),
                 required("points", any_of({list(space_point(kCoordinate)), text()},
                                           "a list of points [x, y, z] or the name of a file"))});
}

Schema weights_schema() {
  std::vector<Field> fields;
  for (const auto& [name, weight] : kWeights)
    fields.push_back(
        optional(std::string(name), number(kWeight).defaulting(SlitWeights{}.*weight)));
  return object(std::move(fields)).said("of the terms of the objective");
}

Schema make_slits_schema() {
  const SlitDesign usual;
  std::vector<Field> fields = header_fields(kSlitsFormat, kSlitsVersion);
  const auto add = [&](Field field) { fields.push_back(std::move(field)); };
  add(optional("units", units()));
  add(required("sheet", slit_sheet_schema()));
  add(required("thickness", length(kLength).said("of the sheet")));
  add(optional("symmetric", flag().defaulting(true).said("about the plane x = 0")));
  add(optional("min_inside_radius", length(kGap).defaulting(0).said("that is kept")));
  add(required("leg_curve", leg_schema("in the ground plane; the panel stands on it")));
  add(optional("second_panel", second_panel_schema()));
  add(optional("seat_curve", seat_schema()));
  add(optional("ridges",
               whole(kFewestRidges, kMostRidges).defaulting(usual.ridges).said("at first")));
  add(optional(
      "end_angle",
      words(kEndAngles).defaulting("right_angle").said("how strips meet the symmetry plane")));
  add(optional("objective", words(kObjectives)
                                .defaulting("energy")
                                .said("least of a strip: bending energy, or changes of folds")));
  for (const auto& some : {slit_curve_fields(), load_fields()})
    fields.insert(fields.end(), some.begin(), some.end());
  add(optional("ground", flag().defaulting(false).said("nothing goes below y = 0")));
  add(optional("weights", weights_schema()));
  add(optional("anchors", list(anchor_schema())));
  add(optional("ends", list(end_schema()).said("of the strips of a sheet that is not symmetric")));
  add(optional("scan", list(scan_schema()).said("measured points that strips are drawn to")));
  add(optional("subdivisions", whole(0, kMostSubdivisions).defaulting(0).said("of its quads")));
  add(optional("align_scan", flag().defaulting(false).said("first move the scans to the strips")));
  add(optional("kerf", length(kGap).defaulting(0).said("width of the slits; 0: lines")));
  add(optional("stop_hole", length(kGap).defaulting(0).said("diameter at the ends of slits")));
  add(optional("mould", mould_schema()));
  return object(std::move(fields)).said("A sheet with slits whose strips are bent into a form");
}

BezierCurve curve_at(const JsonPlace& place) {
  BezierCurve curve;
  for (const JsonPlace& pole : place["bezier"].items())
    curve.poles.push_back(pole.plane_point());
  return curve;
}

SlitAnchor anchor_at(const JsonPlace& place) {
  SlitAnchor anchor;
  anchor.strip = place["strip"].whole();
  anchor.ridge = place["ridge"].whole();
  anchor.side = place["side"].choice(kSides);
  anchor.at = place["at"].point();
  return anchor;
}

std::vector<StripEnd> ends_at(const JsonPlace& place, std::size_t strips) {
  std::vector<StripEnd> ends;
  std::set<int> given;
  for (const JsonPlace& item : place.items()) {
    const int strip = item["strip"].whole();
    if (strip >= static_cast<int>(strips)) {
      item["strip"].mistake(refuse::no_such_strip,
                            {{"strip", strip}, {"last", static_cast<int>(strips) - 1}});
      return ends;
    }
    if (!given.insert(strip).second) {
      item["strip"].mistake(refuse::strip_end_twice, {{"strip", strip}});
      return ends;
    }
    ends.resize(std::max(ends.size(), static_cast<std::size_t>(strip) + 1));
    StripEnd& end = ends[strip];
    if (item["position"].given()) end.position = item["position"].point();
    end.direction = item["direction"].direction();
    end.across = item["across"].direction();
  }
  return ends;
}

/// A scan with its points, or with the name of a file that has them.
struct ScanPlace {
  SlitScan scan;
  std::string file;
};

std::vector<ScanPlace> scans_at(const JsonPlace& place) {
  std::vector<ScanPlace> scans;
  for (const JsonPlace& item : place.items()) {
    const JsonPlace points = item["points"];
    ScanPlace scan;
    if (const JsonPlace strip = item["strip"]; strip.given()) scan.scan.strip = strip.whole();
    if (points.is_text())
      scan.file = points.text();
    else
      for (const JsonPlace& point : points.items())
        scan.scan.points.push_back(point.point());
    scans.push_back(std::move(scan));
  }
  return scans;
}

SecondPanel second_panel_at(const JsonPlace& document) {
  const JsonPlace place = document["second_panel"];
  if (document["symmetric"].yes()) place.mistake(refuse::panel_of_symmetric);
  const JsonPlace leg = place["leg_curve"];
  return {curve_at(leg), place["height"].length(), leg["lean"].angle(), leg["fit"].yes()};
}

MouldOptions mould_at(const JsonPlace& place) {
  MouldOptions mould;
  mould.form = place["form"].choice(kForms);
  mould.side = place["side"].choice(kMouldSides);
  mould.up = place["up"].direction();
  if (const auto base = place["base"].maybe_length()) mould.base = *base;
  mould.inset = place["inset"].maybe_length();
  mould.draft = place["draft"].angle();
  return mould;
}

SlitDesign design_at(const JsonPlace& place) {
  SlitDesign design;
  design.sheet = slit_sheet_at(place);
  design.sheet.thickness = place["thickness"].length();
  design.sheet.symmetric = place["symmetric"].yes();
  design.sheet.min_inside_radius = place["min_inside_radius"].length();
  design.leg_curve = curve_at(place["leg_curve"]);
  design.fit = place["leg_curve"]["fit"].yes();
  design.lean = place["leg_curve"]["lean"].angle();
  if (place["second_panel"].given()) design.second_panel = second_panel_at(place);
  if (place["seat_curve"].given()) design.seat_curve = curve_at(place["seat_curve"]);
  design.fit_seat = place["seat_curve"]["fit"].yes();
  design.ridges = place["ridges"].whole();
  design.end_angle = place["end_angle"].choice(kEndAngles);
  design.ground = place["ground"].yes();
  // Files from before there was a choice may weigh the smoothness, which is of one objective only.
  const JsonPlace smooth = place["weights"]["smooth"];
  design.objective = smooth.given() && !place["objective"].given()
                         ? SlitObjective::smooth
                         : place["objective"].choice(kObjectives);
  if (smooth.given() && design.objective == SlitObjective::energy)
    smooth.mistake(refuse::smooth_of_energy);
  for (const auto& [name, weight] : kWeights)
    design.weights.*weight = place["weights"][std::string(name)].number();
  for (const JsonPlace& anchor : place["anchors"].items())
    design.anchors.push_back(anchor_at(anchor));
  if (design.sheet.symmetric && place["ends"].given())
    place["ends"].mistake(refuse::ends_of_symmetric);
  else if (design.second_panel && place["ends"].given())
    place["ends"].mistake(refuse::ends_and_panel);
  design.ends = ends_at(place["ends"], design.sheet.strips.size());
  return design;
}

SlitFile file_at(const JsonPlace& place) {
  SlitFile file;
  file.design = design_at(place);
  file.subdivisions = place["subdivisions"].whole();
  file.align_scans = place["align_scan"].yes();
  if (file.align_scans && has_cloud(file.design))
    place["align_scan"].mistake(refuse::aligned_without_strips);
  file.kerf = place["kerf"].length();
  file.mould = mould_at(place["mould"]);
  file.stop_hole = place["stop_hole"].length();
  return file;
}

Result<SlitScan> read_scan(ScanPlace& place, const std::filesystem::path& path, LengthUnit unit) {
  const auto text = read_text(path, "scan");
  if (!text) return pass_on(text);
  auto points = parse_points(*text, path.string(), millimetres_in(unit));
  if (!points) return pass_on(points);
  place.scan.points = std::move(*points);
  return std::move(place.scan);
}

}  // namespace

const Schema& slits_schema() {
  static const Schema schema = make_slits_schema();
  return schema;
}

Result<SlitFile> parse_slits(const std::string& json, const std::string& name,
                             const std::optional<std::filesystem::path>& folder) {
  JsonReading reading(json, "slit file", name, slits_schema());
  const JsonPlace place(reading);
  SlitFile file = file_at(place);
  const std::string material = take_loads(place, file.design);
  const CurvedSlits curves = slit_curves_at(place);
  std::vector<ScanPlace> scans = scans_at(place["scan"]);
  file.units = reading.unit();
  if (reading.error()) return tl::unexpected(*reading.error());
  if (!curves.slits.empty()) {
    auto strips = strips_between(file.design.sheet, curves);
    if (!strips) return tl::unexpected(placed(strips.error(), name));
    file.design.sheet.strips = std::move(*strips);
  }
  if (auto read = take_material(material, folder, file.design); !read) return pass_on(read);
  for (ScanPlace& scan : scans) {
    if (scan.file.empty() || !folder) {
      file.design.scans.push_back(std::move(scan.scan));
      continue;
    }
    auto read = read_scan(scan, *folder / scan.file, file.units);
    if (!read) return pass_on(read);
    file.design.scans.push_back(std::move(*read));
  }
  return file;
}

// These must not be overwritten, even if the slit file has mistakes elsewhere.
std::vector<NamedFile> slit_files_of(const std::string& json) {
  std::vector<NamedFile> files;
  const Json document = Json::parse(json, nullptr, false);
  if (!document.is_object()) return files;
  if (const auto material = document.find("material");
      material != document.end() && material->is_string())
    files.push_back({material->get<std::string>(), "/material"});
  if (!document.contains("scan")) return files;
  std::size_t row = 0;
  for (const Json& scan : document["scan"]) {
    if (scan.is_object() && scan.contains("points") && scan["points"].is_string())
      files.push_back({scan["points"].get<std::string>(), fmt::format("/scan/{}/points", row)});
    ++row;
  }
  return files;
}

}  // namespace planish::job
