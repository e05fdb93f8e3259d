#include "folded.hpp"
#include "makers.hpp"
#include "refusals.hpp"
#include "slit_loads_json.hpp"

#include <planish/job/slit_json.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/schema/text_file.hpp>
#include <planish/slit/session.hpp>
#include <planish/slit/slit_curves.hpp>

#include <fmt/format.h>

#include <set>

namespace planish::job {
using namespace schema;
namespace {

constexpr auto kSlitsFormat = "planish/slits";
constexpr int kSlitsVersion = 1;

// What the library takes.
constexpr int kMostStrips = 10000, kFewestRidges = 3, kMostRidges = 1000;
constexpr std::size_t kMostPoles = 64;
constexpr double kLargest = 1e7;    // mm
constexpr int kMostPoints = 10000;  // of a chain
constexpr double kChord = 0.02;     // mm, within which curves are cut as lines
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
              optional("base", length(kLength).said("below the lowest point of the mould's "
                                                    "working surfaces; 20 mm if left out")),
              optional("inset", length(kGap).said("by which a rib is narrower than its strip, on "
                                                  "each side; found if left out")),
              optional("draft", angle(kDraft).defaulting(5).said(
                                    "quads that face up by less are left bare"))})
      .said("on which the sheet is laid");
}

Schema strip_schema() {
  return object(
      {required("width", length(kLength)),
       optional("gap", length(kGap).defaulting(0).said(
                           "to the strip before it, or to the sheet's left edge")),
       optional("left_start", length(kLength).said("where its left slit begins")),
       optional("right_start", length(kLength).said("where its right slit begins")),
       optional("end", length(kLength).said(
                           "where it ends, along; panel_height + half_length if left out"))});
}

/// A slit, or a part of the outline.
Schema edge_schema() {
  return by_key("points",
                object({required("points", list(tuple(2, length(kCoordinate), "[along, across]"))
                                               .of_length(2, kMostPoints, "2 to 10000 points")
                                               .said("joined by lines"))}),
                object({required("bezier", poles_schema())}));
}

/// A number of strips of equal width, or a list of strips; without either, strips lie between
/// slits.
Schema slit_sheet_schema() {
  const auto with = [](std::vector<Field> strips) {
    strips.push_back(
        required("panel_height", length(kLength).said("of the uncut part of the sheet")));
    strips.push_back(required("half_length",
                              length(kLength).said("of the strips, from the panel to the symmetry "
                                                   "plane, the free end or the second panel")));
    strips.push_back(optional("margin", length(kGap).defaulting(0).said(
                                            "between the last strip and the sheet's right edge")));
    return object(std::move(strips));
  };
  return by_key(
      "strip_width",
      with({required("strips", whole(1, kMostStrips).said("how many")),
            required("strip_width", length(kLength).said("of each"))}),
      by_key("strips",
             with({required(
                 "strips",
                 list(strip_schema()).of_length(1, kMostStrips, "a list of 1 to 10000 strips"))}),
             with({optional("width", length(kLength).said("across; that of the outline if there is "
                                                          "one"))})));
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
  return object({required("strip", whole()),
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
  add(optional("slits", list(edge_schema())
                            .of_length(1, kMostStrips - 1, "a list of 1 to 9999 slits")
                            .said("curves between the strips, in place of strips of the sheet; "
                                  "each runs to where the strips end")));
  add(optional("outline", list(edge_schema())
                              .of_length(1, kMostStrips, "a list of curves and chains")
                              .said("of a sheet with slits that are curves, in turn; lines join "
                                    "them")));
  add(required("thickness", length(kLength).said("of the sheet")));
  add(optional("symmetric", flag().defaulting(true).said("about the plane x = 0")));
  add(optional("min_inside_radius",
               length(kGap).defaulting(0).said("to which the material may be bent")));
  add(required("leg_curve", leg_schema("in the ground plane; the panel stands on it")));
  add(optional("second_panel", second_panel_schema()));
  add(optional("seat_curve", seat_schema()));
  add(optional("ridges", whole(kFewestRidges, kMostRidges)
                             .defaulting(usual.ridges)
                             .said("number of quads in each strip at the start")));
  add(optional(
      "end_angle",
      words(kEndAngles).defaulting("right_angle").said("how strips meet the symmetry plane")));
  add(optional("objective", words(kObjectives)
                                .defaulting("energy")
                                .said("what a strip's shape has least of: bending energy, or "
                                      "changes of its folds")));
  for (Field& field : load_fields())
    add(std::move(field));
  add(optional("ground", flag().defaulting(false).said("nothing goes below y = 0")));
  add(optional("weights", weights_schema()));
  add(optional("anchors", list(anchor_schema())));
  add(optional("ends", list(end_schema()).said("of the strips of a sheet that is not symmetric")));
  add(optional("scan", list(scan_schema()).said("measured points that strips are drawn to")));
  add(optional(
      "subdivisions",
      whole(0, kMostSubdivisions).defaulting(0).said("how many times the quads are halved")));
  add(optional("align_scan", flag().defaulting(false).said("first move the scans to the strips")));
  add(optional("kerf", length(kGap).defaulting(0).said("width of the slits; 0: lines")));
  add(optional("stop_hole",
               length(kGap).defaulting(0).said("diameter at the ends of slits; 0: none")));
  add(optional("mould", mould_schema()));
  return object(std::move(fields)).said("A sheet with slits whose strips are bent into a form");
}

BezierCurve curve_at(const JsonPlace& place) {
  BezierCurve curve;
  for (const JsonPlace& pole : place["bezier"].items())
    curve.poles.push_back(pole.plane_point());
  return curve;
}

SlitStrip strip_at(const JsonPlace& place) {
  SlitStrip strip;
  strip.width = place["width"].length();
  strip.gap = place["gap"].length();
  strip.left_start = place["left_start"].maybe_length();
  strip.right_start = place["right_start"].maybe_length();
  strip.end = place["end"].maybe_length();
  return strip;
}

std::vector<SlitStrip> strips_at(const JsonPlace& sheet) {
  if (!sheet["strips"].is_list())
    return equal_strips(sheet["strips"].whole(), sheet["strip_width"].length());
  return mapped(sheet["strips"].items(), [&](const JsonPlace& strip) { return strip_at(strip); });
}

std::vector<Vec2> edge_at(const JsonPlace& place) {
  if (place.json().contains("bezier")) return chain_on(curve_at(place), kChord);
  return mapped(place["points"].items(),
                [](const JsonPlace& point) { return point.plane_point(); });
}

CurvedSlits slits_at(const JsonPlace& document) {
  CurvedSlits curves;
  for (const JsonPlace& slit : document["slits"].items())
    curves.slits.push_back(edge_at(slit));
  for (const JsonPlace& part : document["outline"].items())
    for (const Vec2& corner : edge_at(part))
      curves.outline.push_back(corner);
  if (!curves.slits.empty()) curves.width = document["sheet"]["width"].maybe_length().value_or(0.0);
  return curves;
}

/// Strips between curves are found when the whole file is read.
SlitSheet sheet_at(const JsonPlace& document) {
  const JsonPlace place = document["sheet"];
  SlitSheet sheet;
  sheet.panel_height = place["panel_height"].length();
  sheet.half_length = place["half_length"].length();
  const bool is_cut = document["slits"].given(),
             has_strips = place.given() && place.json().contains("strips");
  if (is_cut == has_strips) {
    place.mistake(has_strips ? refuse::strips_and_slits : refuse::neither_strips_nor_slits);
  } else if (has_strips) {
    sheet.strips = strips_at(place);
    sheet.margin = place["margin"].length();
    if (document["outline"].given()) document["outline"].mistake(refuse::outline_of_strips);
  } else {
    sheet.strips.resize(document["slits"].items().size() + 1);
    if (place["width"].given() == document["outline"].given())
      place.mistake(refuse::width_or_outline);
  }
  return sheet;
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
    ScanPlace scan{{item["strip"].whole(), {}}, {}};
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
  design.sheet = sheet_at(place);
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
  const CurvedSlits curves = slits_at(place);
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
