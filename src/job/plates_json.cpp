#include "makers.hpp"
#include "refusals.hpp"

#include <planish/job/plates_json.hpp>
#include <planish/schema/json_reading.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace planish::job {
using namespace schema;
namespace {

constexpr auto kPlatesFormat = "planish/plates";
constexpr int kPlatesVersion = 1;
constexpr schema::Range kAperture{"an angle above 0 and below 180 degrees", 0.0, 180.0, false,
                                  false};
constexpr schema::Range kTurn{"an angle from -360 to 360 degrees", -360.0, 360.0};

const Words<SurfaceChoice> kSurfaces{{"auto", SurfaceChoice::automatic},
                                     {"cylinder", SurfaceChoice::cylinder},
                                     {"cone", SurfaceChoice::cone},
                                     {"general", SurfaceChoice::general}};
const Words<LateralBoundary> kBoundaries{{"auto", LateralBoundary::automatic},
                                         {"straight", LateralBoundary::straight},
                                         {"arc", LateralBoundary::arc},
                                         {"corner", LateralBoundary::corner}};

Schema polygon() { return list(space_point()); }

Schema hole_schema() {
  const Schema size = length(kAboveZero),
               arc = object({required("through", space_point()), required("to", space_point())});
  return any_of(
      {polygon(),
       one_key(
           {optional("circle", object({required("at", space_point()), required("radius", size)})),
            optional("slot", object({required("from", space_point()), required("to", space_point()),
                                     required("width", size)})
                                 .said("with round ends about two points")),
            optional("path", list(any_of({space_point(), arc}, "a corner, or an arc to one"))
                                 .said("corners, and arcs to corners through a point"))})},
      "a list of corners, a circle, a slot or a path");
}

Schema plate_schema() {
  return object(
      {required("id", text().said("name of the plate, different for each")),
       required("outline", polygon().said("corners in space, in one plane")),
       optional("holes",
                list(hole_schema()).said("each as corners, or as a circle, a slot or a path"))});
}

Schema edges_schema() {
  return list(whole()).of_length(1, std::numeric_limits<std::size_t>::max(),
                                 "a list of at least 1 edge (leave the plate out to have its edges "
                                 "chosen)");
}

Schema bend_schema() {
  return object(
      {required("between", list(text()).said("ids of the plates: two, one (the other end is free) "
                                             "or none (a section by itself)")),
       optional("edges", map(edges_schema())
                             .said("consecutive edges that the bend uses, by plate "
                                   "id; edge i runs from corner i to i + 1")),
       optional("surface", words(kSurfaces).defaulting("auto").said("of the bend")),
       optional("inside_radius",
                length(kAtLeastZero).said("of a cylinder; of a cone at mid-length")),
       optional("inside_radii", tuple(2, length(kAtLeastZero), "two radii [left, right]")
                                    .said("of a cone, at both ends")),
       optional("aperture", angle(kAperture).said("of a cone")),
       optional("slope", number().said("of the tangent lines, y over x")),
       optional("apex",
                length().said("of a cone, along the intersection line of the plates' planes")),
       optional("tangent_point",
                space_point().said(
                    "of a general bend: where the tangents at both ends of its outer arc meet")),
       optional("lateral", words(kBoundaries)
                               .defaulting("auto")
                               .said("lateral boundaries: how the bend ends at its sides")),
       optional("trade_off", number(kAtLeastZero)
                                 .defaulting(BendRequest{}.trade_off)
                                 .said("how much longer a bend may be for being wider")),
       optional("angle", angle(kTurn).said("through which a section with a free end turns")),
       optional("length", length(kAboveZero).said("of a section without plates"))});
}

Schema defaults_schema() {
  return object(
             {optional("inside_radius", length(kAtLeastZero).said("of cylinders and cones")),
              optional("lateral", words(kBoundaries).said("lateral boundaries")),
              optional("trade_off",
                       number(kAtLeastZero).said("how much longer a bend may be for being wider"))})
      .said("for every bend between two plates that gives nothing else");
}

Schema make_plates_schema() {
  std::vector<Field> fields = header_fields(kPlatesFormat, kPlatesVersion);
  fields.push_back(optional("units", units()));
  fields.push_back(
      optional("k_factor", number(kShare).said("of every bend, unless an option sets K; "
                                               "0.44 if left out")));
  fields.push_back(required("thickness", length(kAboveZero).said("of the sheet")));
  fields.push_back(required("plates", list(plate_schema())));
  fields.push_back(optional(
      "bends", list(bend_schema()).said("if left out, the program finds which plates to join")));
  fields.push_back(optional("defaults", defaults_schema()));
  fields.push_back(
      optional("largest_span",
               length(kAboveZero).said("longest way from plate to plate that a bend bridges")));
  fields.push_back(optional(
      "trim", flag().said("whether plates that touch are cut back so that bends fit between them; "
                          "if left out, where all of them touch")));
  fields.push_back(optional("root", text().said("id of the plate that stays where it is")));
  return object(std::move(fields)).said("Plates in space to be joined by bends");
}

std::vector<Vec3> polygon_at(const JsonPlace& place) {
  return mapped(place.items(), [&](const JsonPlace& corner) { return corner.point(); });
}

/// The path ends where it began, also if its last arc says so.
ArcHole path_at(const JsonPlace& place) {
  ArcHole hole;
  std::optional<Vec3> through;
  bool closed = false;
  for (const JsonPlace& item : place.items()) {
    through.reset();
    if (!item.is_list()) through = item["through"].point();
    const Vec3 to = item.is_list() ? item.point() : item["to"].point();
    if (!hole.corners.empty()) hole.through.push_back(through);
    closed = !hole.corners.empty() && to == hole.corners.front();
    if (!closed) hole.corners.push_back(to);
  }
  if (!closed) hole.through.emplace_back();
  return hole;
}

HoleShape shape_at(const JsonPlace& place) {
  if (const JsonPlace circle = place["circle"]; circle.given())
    return RoundHole{circle["at"].point(), circle["radius"].length()};
  if (const JsonPlace slot = place["slot"]; slot.given())
    return SlotHole{slot["from"].point(), slot["to"].point(), slot["width"].length()};
  return path_at(place["path"]);
}

Plate plate_at(const JsonPlace& place) {
  Plate plate{place["id"].text(), polygon_at(place["outline"]), {}, {}};
  for (const JsonPlace& hole : place["holes"].items()) {
    if (!hole.is_list()) plate.shapes.emplace(plate.holes.size(), shape_at(hole));
    plate.holes.push_back(hole.is_list() ? polygon_at(hole) : std::vector<Vec3>());
  }
  return plate;
}

std::vector<Plate> plates_at(const JsonPlace& place) {
  std::vector<Plate> plates;
  for (const JsonPlace& item : place.items()) {
    Plate plate = plate_at(item);
    const auto same = std::ranges::find(plates, plate.id, &Plate::id);
    if (same != plates.end()) {
      item["id"].mistake(
          refuse::same_plate_id,
          {{"id", plate.id},
           {"other", place::pointer(fmt::format("/plates/{}", same - plates.begin()))}});
    }
    plates.push_back(std::move(plate));
  }
  return plates;
}

std::vector<std::string> ids_at(const JsonPlace& place) {
  auto ids = mapped(place.items(), [&](const JsonPlace& item) { return item.text(); });
  if (ids.size() > 2) {
    place.mistake(refuse::many_plates_of_bend, {{"count", ids.size()}});
  } else if (ids.size() == 2 && ids[0] == ids[1]) {
    place.mistake(refuse::bend_to_itself, {{"plate", planish::place::plate(ids[0])}});
  }
  return ids;
}

std::vector<int> edges_at(const JsonPlace& place) {
  std::vector<int> edges;
  for (const JsonPlace& item : place.items()) {
    const int edge = item.whole();
    if (std::ranges::find(edges, edge) != edges.end())
      item.mistake(refuse::edge_listed_twice, {{"edge", edge}});
    edges.push_back(edge);
  }
  return edges;
}

void read_edges(BendRequest& bend, const JsonPlace& place) {
  for (const auto& [id, list] : place.members()) {
    const auto side = std::ranges::find(bend.between, id);
    if (side == bend.between.end()) {
      list.mistake(
          refuse::not_of_this_bend,
          {{"known", bend.between.empty() ? std::string("none")
                                          : fmt::format("{}", fmt::join(bend.between, " and "))}});
      return;
    }
    bend.edges[side - bend.between.begin()] = edges_at(list);
  }
}

BendDefaults defaults_at(const JsonPlace& place) {
  BendDefaults defaults;
  defaults.inside_radius = place["inside_radius"].maybe_length();
  if (place["lateral"].given()) defaults.lateral = place["lateral"].choice(kBoundaries);
  defaults.trade_off = place["trade_off"].maybe_number().value_or(defaults.trade_off);
  return defaults;
}

/// A radius is left open only where nothing of a cone or of the tangent lines is given, from which
/// it follows.
OpenKeys open_keys(const BendRequest& bend, const JsonPlace& place) {
  OpenKeys open;
  open.trade_off = !place["trade_off"].given();
  open.lateral = bend.between.size() == 2 && !place["lateral"].given();
  open.inside_radius = !bend.inside_radius && !bend.inside_radii && !bend.aperture && !bend.slope &&
                       !bend.apex && !bend.tangent_point && bend.surface != SurfaceChoice::general;
  return open;
}

void take_defaults(PlateStructure& structure, const std::vector<OpenKeys>& open) {
  const BendDefaults& defaults = structure.defaults;
  for (std::size_t b = 0; b < std::min(structure.bends.size(), open.size()); ++b) {
    BendRequest& bend = structure.bends[b];
    if (open[b].trade_off) bend.trade_off = defaults.trade_off;
    if (open[b].lateral) bend.lateral = defaults.lateral;
    if (open[b].inside_radius) bend.inside_radius = defaults.inside_radius;
  }
}

void read_sizes(BendRequest& bend, const JsonPlace& place) {
  bend.inside_radius = place["inside_radius"].maybe_length();
  if (const JsonPlace both = place["inside_radii"]; both.given()) {
    const auto radii = both.items();
    if (radii.size() == 2) bend.inside_radii = {radii[0].length(), radii[1].length()};
  }
  bend.aperture = place["aperture"].maybe_angle();
  bend.slope = place["slope"].maybe_number();
  bend.apex = place["apex"].maybe_length();
  if (place["tangent_point"].given()) bend.tangent_point = place["tangent_point"].point();
  bend.trade_off = place["trade_off"].number();
  bend.angle = place["angle"].maybe_angle();
  bend.length = place["length"].maybe_length();
}

// Properties that exclude each other, whatever the plates are.
void check_together(const BendRequest& bend, const JsonPlace& place) {
  if (bend.inside_radius && bend.inside_radii) place["inside_radii"].mistake(refuse::two_radii);
  if (bend.angle && *bend.angle == Angle{}) place["angle"].mistake(refuse::angle_of_nothing);
  if (bend.angle && bend.between.size() == 2) place["angle"].mistake(refuse::angle_follows);
  if (bend.between.size() < 2)
    for (const char* key : {"slope", "apex", "aperture", "tangent_point", "lateral"})
      if (place[key].given() && place[key].text() != "auto" && place[key].text() != "arc")
        place[key].mistake(refuse::key_of_joins);
  if (bend.length && !bend.between.empty()) place["length"].mistake(refuse::length_follows);
}

BendRequest bend_at(const JsonPlace& place) {
  BendRequest bend;
  bend.between = ids_at(place["between"]);
  read_edges(bend, place["edges"]);
  bend.surface = place["surface"].choice(kSurfaces);
  bend.lateral = place["lateral"].choice(kBoundaries);
  read_sizes(bend, place);
  check_together(bend, place);
  return bend;
}

}  // namespace

const Schema& plates_schema() {
  static const Schema schema = make_plates_schema();
  return schema;
}

PlateStructure with_options(const PlatesFile& file, const JoinOptions& options) {
  PlateStructure structure = file.structure;
  BendDefaults& defaults = structure.defaults;
  if (options.inside_radius) defaults.inside_radius = options.inside_radius;
  defaults.lateral = options.lateral.value_or(defaults.lateral);
  defaults.trade_off = options.trade_off.value_or(defaults.trade_off);
  if (options.largest_span) structure.largest_span = options.largest_span;
  if (options.trim) structure.trim = options.trim;
  take_defaults(structure, file.open);
  return structure;
}

Result<PlatesFile> parse_plates(const std::string& json, const std::string& name) {
  JsonReading reading(json, "plates file", name, plates_schema());
  const JsonPlace file(reading);
  PlatesFile plates;
  plates.units = reading.unit();
  plates.k_factor = file["k_factor"].maybe_number();
  PlateStructure& structure = plates.structure;
  structure.thickness = file["thickness"].length();
  structure.plates = plates_at(file["plates"]);
  structure.defaults = defaults_at(file["defaults"]);
  for (const JsonPlace& bend : file["bends"].items())
    plates.open.push_back(open_keys(structure.bends.emplace_back(bend_at(bend)), bend));
  take_defaults(structure, plates.open);
  structure.largest_span = file["largest_span"].maybe_length();
  if (file["trim"].given()) structure.trim = file["trim"].yes();
  structure.root = file["root"].text();
  if (structure.plates.empty() && structure.bends.empty())
    file["plates"].mistake(refuse::nothing_to_join);
  if (reading.error()) return tl::unexpected(*reading.error());
  return plates;
}

}  // namespace planish::job
