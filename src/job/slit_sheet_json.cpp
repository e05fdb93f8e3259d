// The sheet of a slit file: strips side by side, or slits that are curves. Chains of points stay as
// they are, Bézier curves become chains within what a cutter can hold.
#include "slit_sheet_json.hpp"

#include "refusals.hpp"

#include <planish/base/id_vector.hpp>

namespace planish::job {
using namespace schema;
namespace {

constexpr int kMostStrips = 10000, kMostSlits = kMostStrips - 1, kMostEdgePoints = 10000,
              kMostEdgePoles = 64;
constexpr double kEdgeChord = 0.02;       // mm, within which curves are cut as lines
constexpr double kFarthestOnSheet = 1e7;  // mm
constexpr schema::Range kSheetLength{"a length above 0 and at most 1e7 mm", 0.0, kFarthestOnSheet,
                                     false};
constexpr schema::Range kSheetGap{"a length from 0 to 1e7 mm", 0.0, kFarthestOnSheet};
constexpr schema::Range kOnSheet{"a length from -1e7 to 1e7 mm", -kFarthestOnSheet,
                                 kFarthestOnSheet};

/// A slit, or a part of the outline.
Schema edge_schema() {
  const auto places = [](int most, const char* what) {
    return list(tuple(2, length(kOnSheet), "a place [along, across]")).of_length(2, most, what);
  };
  return by_key(
      "points",
      object({required(
          "points",
          places(kMostEdgePoints, "a list of 2 to 10000 points").said("joined by lines"))}),
      object({required("bezier",
                       places(kMostEdgePoles, "a list of 2 to 64 poles").said("its poles"))}));
}

Schema strip_schema() {
  return object(
      {required("width", length(kSheetLength)),
       optional("gap", length(kSheetGap).defaulting(0).said("to what lies on its left")),
       optional("left_start", length(kSheetLength).said("where its left slit begins")),
       optional("right_start", length(kSheetLength).said("where its right slit begins")),
       optional("left_end", length(kSheetLength).said("where its left slit ends, if not there")),
       optional("right_end", length(kSheetLength).said("where its right slit ends")),
       optional("end", length(kSheetLength).said("where it ends, along the sheet"))});
}

SlitStrip strip_at(const JsonPlace& place) {
  SlitStrip strip;
  strip.width = place["width"].length();
  strip.gap = place["gap"].length();
  strip.left_start = place["left_start"].maybe_length();
  strip.right_start = place["right_start"].maybe_length();
  strip.left_end = place["left_end"].maybe_length();
  strip.right_end = place["right_end"].maybe_length();
  strip.end = place["end"].maybe_length();
  return strip;
}

std::vector<SlitStrip> strips_at(const JsonPlace& sheet) {
  if (!sheet["strips"].is_list())
    return equal_strips(sheet["strips"].whole(), sheet["strip_width"].length());
  return mapped(sheet["strips"].items(), [&](const JsonPlace& strip) { return strip_at(strip); });
}

std::vector<Vec2> edge_at(const JsonPlace& place) {
  const bool is_curve = place.json().contains("bezier");
  auto places = mapped(place[is_curve ? "bezier" : "points"].items(),
                       [](const JsonPlace& point) { return point.plane_point(); });
  return is_curve ? chain_on({std::move(places)}, kEdgeChord) : places;
}

/// Whether strips lie between slits that are curves.
bool has_slit_curves(const JsonPlace& document) {
  const JsonPlace sheet = document["sheet"], outline = document["outline"];
  const bool is_cut = document["slits"].given();
  if (is_cut == (sheet.given() && sheet.json().contains("strips")))
    sheet.mistake(is_cut ? refuse::strips_and_slits : refuse::neither_strips_nor_slits);
  else if (!is_cut && outline.given())
    outline.mistake(refuse::outline_of_strips);
  else if (is_cut && sheet["width"].given() == outline.given())
    sheet.mistake(refuse::width_or_outline);
  return is_cut;
}

}  // namespace

/// A number of strips of equal width, a list of strips, or neither: strips between slits.
Schema slit_sheet_schema() {
  const auto with = [](std::vector<Field> strips) {
    strips.push_back(
        required("panel_height", length(kSheetLength).said("of the uncut part of the sheet")));
    strips.push_back(
        required("half_length", length(kSheetLength)
                                    .said("of the strips, from the panel to the symmetry "
                                          "plane, the free end or the second panel")));
    strips.push_back(optional("margin", length(kSheetGap).defaulting(0).said(
                                            "between the last strip and the sheet's right edge")));
    return object(std::move(strips));
  };
  return by_key(
      "strip_width",
      with({required("strips", whole(1, kMostStrips).said("how many")),
            required("strip_width", length(kSheetLength).said("of each"))}),
      by_key("strips",
             with({required(
                 "strips",
                 list(strip_schema()).of_length(1, kMostStrips, "a list of 1 to 10000 strips"))}),
             with({optional("width", length(kSheetLength)
                                         .said("across; that of the outline if there is "
                                               "one"))})));
}

std::vector<Field> slit_curve_fields() {
  return {
      optional("slits", list(edge_schema())
                            .of_length(1, kMostSlits, "a list of 1 to 9999 slits")
                            .said("curves between the strips, which begin and end anywhere")),
      optional("outline", list(edge_schema())
                              .of_length(1, kMostSlits, "a list of curves and chains")
                              .said("of a sheet with slits that are curves, in turn; lines join "
                                    "them"))};
}

/// Strips between curves are found when the whole file is read.
SlitSheet slit_sheet_at(const JsonPlace& document) {
  const JsonPlace place = document["sheet"];
  SlitSheet sheet;
  sheet.panel_height = place["panel_height"].length();
  sheet.half_length = place["half_length"].length();
  if (has_slit_curves(document)) {
    sheet.strips.resize(document["slits"].items().size() + 1);
  } else {
    sheet.strips = strips_at(place);
    sheet.margin = place["margin"].length();
  }
  return sheet;
}

CurvedSlits slit_curves_at(const JsonPlace& document) {
  if (!document["slits"].given()) return {};
  CurvedSlits curves{mapped(document["slits"].items(), edge_at), {}, 0.0};
  for (const JsonPlace& part : document["outline"].items())
    for (const Vec2& corner : edge_at(part))
      curves.outline.push_back(corner);
  curves.width = document["sheet"]["width"].maybe_length().value_or(0.0);
  return curves;
}

}  // namespace planish::job
