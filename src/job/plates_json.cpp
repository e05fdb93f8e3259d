#include "json_reading.hpp"

#include <planish/job/plates_json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::job {
namespace {

constexpr auto kFormat = "planish/plates";
constexpr int kVersion = 1;
constexpr Allowed kAperture{"an angle above 0 and below 180 degrees", 0.0, 180.0, false, false};
constexpr Allowed kTurn{"an angle from -360 to 360 degrees", -360.0, 360.0};

std::vector<Vec3> polygon_at(const JsonPlace& place) {
  std::vector<Vec3> corners;
  for (const JsonPlace& corner : place.items())
    corners.push_back(corner.point());
  return corners;
}

Plate plate_at(const JsonPlace& place) {
  place.keys({"id", "outline"}, {"holes"});
  Plate plate{place["id"].text(), polygon_at(place["outline"]), {}};
  for (const JsonPlace& hole : place["holes"].items())
    plate.holes.push_back(polygon_at(hole));
  return plate;
}

std::vector<Plate> plates_at(const JsonPlace& place) {
  std::vector<Plate> plates;
  for (const JsonPlace& item : place.items()) {
    Plate plate = plate_at(item);
    const auto same = std::find_if(plates.begin(), plates.end(),
                                   [&](const Plate& other) { return other.id == plate.id; });
    if (same != plates.end()) {
      item["id"].mistake(fmt::format("is \"{}\", as is that of plate {}: give each plate its own",
                                     plate.id, same - plates.begin()));
    }
    plates.push_back(std::move(plate));
  }
  return plates;
}

std::vector<std::string> ids_at(const JsonPlace& place) {
  std::vector<std::string> ids;
  for (const JsonPlace& item : place.items())
    ids.push_back(item.text());
  if (ids.size() > 2) {
    place.mistake(
        fmt::format("names {} plates: a bend joins two, ends free at one (one id) or "
                    "stands alone ([])",
                    ids.size()));
  } else if (ids.size() == 2 && ids[0] == ids[1]) {
    place.mistake(fmt::format("names \"{}\" twice: a bend joins two different plates", ids[0]));
  }
  return ids;
}

std::vector<int> edges_at(const JsonPlace& place) {
  std::vector<int> edges;
  for (const JsonPlace& item : place.items()) {
    const int edge = item.index();
    if (std::find(edges.begin(), edges.end(), edge) != edges.end())
      item.mistake(fmt::format("is {}, which stands in the list already", edge));
    edges.push_back(edge);
  }
  if (edges.empty()) place.mistake("is empty: leave the plate out to have its edges chosen");
  return edges;
}

void read_edges(BendRequest& bend, const JsonPlace& place) {
  for (const auto& [id, list] : place.members()) {
    const auto side = std::find(bend.between.begin(), bend.between.end(), id);
    if (side == bend.between.end()) {
      list.mistake(fmt::format("is no plate of this bend, which has {}",
                               bend.between.empty()
                                   ? std::string("none")
                                   : fmt::format("{}", fmt::join(bend.between, " and "))));
      return;
    }
    bend.edges[side - bend.between.begin()] = edges_at(list);
  }
}

void read_sizes(BendRequest& bend, const JsonPlace& place) {
  bend.inside_radius = place["inside_radius"].maybe_length(kAtLeastZero);
  if (const JsonPlace both = place["inside_radii"]; both.given()) {
    const auto radii = both.items(2, "two radii [left, right]");
    if (!radii.empty()) {
      bend.inside_radii = {radii[0].length(kAtLeastZero), radii[1].length(kAtLeastZero)};
    }
  }
  bend.aperture = place["aperture"].maybe_angle(kAperture);
  bend.slope = place["slope"].maybe_number();
  bend.apex = place["apex"].maybe_length();
  if (place["tangent_point"].given()) bend.tangent_point = place["tangent_point"].point();
  bend.trade_off = place["trade_off"].maybe_number(kAtLeastZero).value_or(bend.trade_off);
  bend.angle = place["angle"].maybe_angle(kTurn);
  bend.length = place["length"].maybe_length(kAboveZero);
}

// What cannot be meant together, whatever the plates are.
void check_together(const BendRequest& bend, const JsonPlace& place) {
  if (bend.inside_radius && bend.inside_radii)
    place["inside_radii"].mistake("stands beside inside_radius: give one of them");
  if (bend.angle && *bend.angle == Angle{})
    place["angle"].mistake(
        "is 0, which bends nothing: give the angle that the section turns, or leave the section "
        "out");
  if (bend.angle && bend.between.size() == 2)
    place["angle"].mistake(
        "belongs to a section with a free end; between two plates it follows "
        "from where they lie: leave it out");
  if (bend.between.size() < 2)
    for (const char* key : {"slope", "apex", "aperture", "tangent_point", "lateral"})
      if (place[key].given() && !place[key].is_text("auto") && !place[key].is_text("arc"))
        place[key].mistake(
            "belongs to a bend between two plates; a section has inside_radius or inside_radii, "
            "angle and ends "
            "at right angles to its axis: leave it out");
  if (bend.length && !bend.between.empty())
    place["length"].mistake(
        "belongs to a section without plates; beside a plate it follows from "
        "the plate's edges: leave it out");
}

BendRequest bend_at(const JsonPlace& place) {
  place.keys({"between"}, {"edges", "surface", "inside_radius", "inside_radii", "aperture", "slope",
                           "apex", "tangent_point", "lateral", "trade_off", "angle", "length"});
  BendRequest bend;
  bend.between = ids_at(place["between"]);
  read_edges(bend, place["edges"]);
  bend.surface = place["surface"].choice<SurfaceChoice>({{"auto", SurfaceChoice::automatic},
                                                         {"cylinder", SurfaceChoice::cylinder},
                                                         {"cone", SurfaceChoice::cone},
                                                         {"general", SurfaceChoice::general}},
                                                        bend.surface);
  bend.lateral = place["lateral"].choice<LateralBoundary>({{"auto", LateralBoundary::automatic},
                                                           {"straight", LateralBoundary::straight},
                                                           {"arc", LateralBoundary::arc},
                                                           {"corner", LateralBoundary::corner}},
                                                          bend.lateral);
  read_sizes(bend, place);
  check_together(bend, place);
  return bend;
}

}  // namespace

Result<PlatesFile> parse_plates(const std::string& json, const std::string& name) {
  JsonReading reading(json, "plates file", name);
  const JsonPlace file(reading);
  file.keys({"thickness", "plates"}, {"format", "version", "units", "k_factor", "bends", "root"});
  file.format(kFormat, kVersion);
  file.read_unit();
  PlatesFile plates;
  plates.units = reading.unit();
  plates.k_factor = file["k_factor"].maybe_number(kShare);
  PlateStructure& structure = plates.structure;
  structure.thickness = file["thickness"].length(kAboveZero);
  structure.plates = plates_at(file["plates"]);
  for (const JsonPlace& bend : file["bends"].items())
    structure.bends.push_back(bend_at(bend));
  if (file["root"].given()) structure.root = file["root"].text();
  if (structure.plates.empty() && structure.bends.empty())
    file["plates"].mistake("holds no plate, and there is no bend that could do without");
  if (reading.error()) return tl::unexpected(*reading.error());
  return plates;
}

}  // namespace planish::job
