#include "json_reading.hpp"

#include <planish/job/slit_json.hpp>
#include <planish/job/text_file.hpp>

#include <fmt/format.h>

#include <set>

namespace planish::job {
namespace {

constexpr auto kFormat = "planish/slits";
constexpr int kVersion = 1;
constexpr int kMostSubdivisions = 6;

BezierCurve curve_at(const JsonPlace& place) {
  place.keys({"bezier"});
  BezierCurve curve;
  for (const JsonPlace& pole : place["bezier"].items()) {
    const auto xy = pole.items(2, "a pole [a, b]");
    if (!xy.empty()) curve.poles.emplace_back(xy[0].length(), xy[1].length());
  }
  return curve;
}

SlitStrip strip_at(const JsonPlace& place) {
  place.keys({"width"}, {"gap", "left_start", "right_start", "end"});
  SlitStrip strip;
  strip.width = place["width"].length(kAboveZero);
  strip.gap = place["gap"].maybe_length(kAtLeastZero).value_or(0.0);
  strip.left_start = place["left_start"].maybe_length();
  strip.right_start = place["right_start"].maybe_length();
  strip.end = place["end"].maybe_length();
  return strip;
}

/// A number of strips with one width, or a list of strips.
std::vector<SlitStrip> strips_at(const JsonPlace& sheet) {
  std::vector<SlitStrip> strips;
  if (sheet["strip_width"].given()) {
    const int count = sheet["strips"].index();
    constexpr int kMost = 10000;
    if (count < 1 || count > kMost) {
      sheet["strips"].mistake(fmt::format("is {}; it must be from 1 to {}", count, kMost));
      return strips;
    }
    return equal_strips(count, sheet["strip_width"].length(kAboveZero));
  }
  for (const JsonPlace& strip : sheet["strips"].items())
    strips.push_back(strip_at(strip));
  return strips;
}

SlitSheet sheet_at(const JsonPlace& place) {
  place.keys({"strips", "panel_height", "half_length"}, {"strip_width", "margin"});
  SlitSheet sheet;
  sheet.strips = strips_at(place);
  sheet.panel_height = place["panel_height"].length(kAboveZero);
  sheet.half_length = place["half_length"].length(kAboveZero);
  sheet.margin = place["margin"].maybe_length(kAtLeastZero).value_or(0.0);
  return sheet;
}

SlitAnchor anchor_at(const JsonPlace& place) {
  place.keys({"strip", "ridge", "at"}, {"side"});
  SlitAnchor anchor;
  anchor.strip = place["strip"].index();
  anchor.ridge = place["ridge"].index();
  anchor.side = place["side"].choice<Side>({{"left", Side::left}, {"right", Side::right}},
                                           Side::left);
  anchor.at = place["at"].point();
  return anchor;
}

SlitWeights weights_at(const JsonPlace& place) {
  SlitWeights weights;
  if (!place.given()) return weights;
  place.keys({}, {"smooth", "spacing", "anchors", "seat", "spread", "scan"});
  const auto read = [&](const char* key, double& weight) {
    weight = place[key].maybe_number().value_or(weight);
  };
  read("smooth", weights.smooth);
  read("spacing", weights.spacing);
  read("anchors", weights.anchors);
  read("seat", weights.seat);
  read("spread", weights.spread);
  read("scan", weights.scan);
  return weights;
}

std::vector<StripEnd> ends_at(const JsonPlace& place, std::size_t strips) {
  std::vector<StripEnd> ends;
  std::set<int> given;
  for (const JsonPlace& item : place.items()) {
    item.keys({"strip"}, {"position", "direction", "across"});
    const int strip = item["strip"].index();
    if (strip >= static_cast<int>(strips)) {
      item["strip"].mistake(
          fmt::format("is {}; the sheet has strips 0 to {}", strip, static_cast<int>(strips) - 1));
      return ends;
    }
    if (!given.insert(strip).second) {
      item["strip"].mistake(fmt::format("is {}, whose end is given already", strip));
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

/// Scans, each with the name of its file, or with its points.
struct ScanPlace {
  SlitScan scan;
  std::string file;
};

std::vector<ScanPlace> scans_at(const JsonPlace& place) {
  std::vector<ScanPlace> scans;
  for (const JsonPlace& item : place.items()) {
    item.keys({"strip", "points"});
    ScanPlace scan{{item["strip"].index(), {}}, {}};
    if (item["points"].is_list())
      for (const JsonPlace& point : item["points"].items())
        scan.scan.points.push_back(point.point());
    else
      scan.file = item["points"].text();
    scans.push_back(std::move(scan));
  }
  return scans;
}

SlitFile file_at(const JsonPlace& place, std::vector<ScanPlace>& scans) {
  place.keys({"thickness", "sheet", "leg_curve"},
             {"format", "version", "units", "symmetric", "ridges", "subdivisions", "seat_curve",
              "anchors", "scan", "align_scan", "weights", "end_angle", "ends", "min_inside_radius",
              "kerf", "stop_hole"});
  place.format(kFormat, kVersion);
  place.read_unit();
  SlitFile file;
  SlitDesign& design = file.design;
  design.sheet = sheet_at(place["sheet"]);
  design.sheet.thickness = place["thickness"].length(kAboveZero);
  design.sheet.symmetric = place["symmetric"].given() ? place["symmetric"].yes() : true;
  design.sheet
      .min_inside_radius = place["min_inside_radius"].maybe_length(kAtLeastZero).value_or(0.0);
  design.leg_curve = curve_at(place["leg_curve"]);
  if (place["seat_curve"].given()) design.seat_curve = curve_at(place["seat_curve"]);
  if (place["ridges"].given()) design.ridges = place["ridges"].index();
  design.end_angle = place["end_angle"].choice<EndAngle>({{"right_angle", EndAngle::right_angle},
                                                          {"level", EndAngle::level},
                                                          {"free", EndAngle::free}},
                                                         EndAngle::right_angle);
  design.weights = weights_at(place["weights"]);
  for (const JsonPlace& anchor : place["anchors"].items())
    design.anchors.push_back(anchor_at(anchor));
  if (design.sheet.symmetric && place["ends"].given())
    place["ends"].mistake(
        "is given, but strips of symmetric sheets end at the symmetry plane: leave it out, or set "
        "symmetric to false");
  design.ends = ends_at(place["ends"], design.sheet.strips.size());
  scans = scans_at(place["scan"]);
  if (place["subdivisions"].given()) file.subdivisions = place["subdivisions"].index();
  if (file.subdivisions > kMostSubdivisions)
    place["subdivisions"].mistake(
        fmt::format("is {}; {} are the most, which divide each quad in {}", file.subdivisions,
                    kMostSubdivisions, 1 << kMostSubdivisions));
  file.align_scans = place["align_scan"].given() && place["align_scan"].yes();
  file.kerf = place["kerf"].maybe_length(kAtLeastZero).value_or(0.0);
  file.stop_hole = place["stop_hole"].maybe_length(kAtLeastZero).value_or(0.0);
  return file;
}

Result<SlitScan> read_scan(ScanPlace& place, const std::filesystem::path& path, LengthUnit unit) {
  const auto text = read_text(path, "scan");
  if (!text) return tl::unexpected(text.error());
  auto points = parse_points(*text, path.string(), millimetres_in(unit));
  if (!points) return tl::unexpected(points.error());
  place.scan.points = std::move(*points);
  return std::move(place.scan);
}

}  // namespace

Result<SlitFile> parse_slits(const std::string& json, const std::string& name,
                             const std::filesystem::path& folder) {
  JsonReading reading(json, "slit file", name);
  std::vector<ScanPlace> scans;
  SlitFile file = file_at(JsonPlace(reading), scans);
  file.units = reading.unit();
  if (reading.error()) return tl::unexpected(*reading.error());
  for (ScanPlace& place : scans) {
    if (place.file.empty()) {
      file.design.scans.push_back(std::move(place.scan));
      continue;
    }
    auto scan = read_scan(place, folder / place.file, file.units);
    if (!scan) return tl::unexpected(scan.error());
    file.design.scans.push_back(std::move(*scan));
  }
  return file;
}

std::vector<std::filesystem::path> point_files_of(const std::string& json,
                                                  const std::filesystem::path& folder) {
  JsonReading reading(json, "slit file", {});
  std::vector<ScanPlace> scans;
  file_at(JsonPlace(reading), scans);
  std::vector<std::filesystem::path> files;
  for (const ScanPlace& place : scans)
    if (!place.file.empty()) files.push_back(folder / place.file);
  return files;
}

}  // namespace planish::job
