#include "fit_check.hpp"

#include "assemble.hpp"
#include "joined_face.hpp"
#include "pair_search.hpp"
#include "refusals.hpp"
#include "sheets_meet.hpp"
#include "tolerances.hpp"

#include <planish/geometry/curve.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/layout.hpp>

#include <algorithm>
#include <optional>
#include <utility>

// What a bend must not do to its plates: cut into them, leave them no common width, come round
// their back without room, or cover itself when laid flat. Each is measured on the finished outline
// and sheet instead of being derived from the fit, so a mistake of the fit is found. A way through
// a plate is found between its crossings of the outline, as between these it lies on one side.

namespace planish::connect_detail {
namespace {

// Within this share of the plate's extent of its outline a place is on it.
constexpr double kOnOutline = 1e-7;

std::vector<Vec2> corners_of(const BorderLoop& loop) {
  return mapped(loop, [&](const Border& border) { return point_at(border.curve, 0.0); });
}

bool is_edge(const std::vector<Vec2>& ring, const Segment& way) {
  return std::ranges::any_of(
      sides_of(ring), [&](const Segment& side) { return side.a == way.a && side.b == way.b; });
}

// Where the way from a to b runs through the plate: between its crossings of the outline it is on
// one side of it.
std::optional<Vec2> within(const PlacedPlate& plate, const Segment& way) {
  const std::vector<Vec2>& ring = plate.outline;
  const auto& [a, b] = way;
  std::vector<double> cuts{0.0, 1.0};
  for (const Segment& side : sides_of(ring)) {
    const Vec2 along = side.b - side.a;
    const double share = cross(side.a - a, along) / cross(b - a, along);
    if (share > 0.0 && share < 1.0) cuts.push_back(share);
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Vec2 middle = a + 0.5 * (cuts[i] + cuts[i + 1]) * (b - a);
    if (inside({ring}, middle) && distance_to_ring(ring, middle) > kOnOutline * plate.extent)
      return middle;
  }
  return std::nullopt;
}

// A place where the extended outline runs through the plate, which loses what is beyond.
std::optional<Vec2> cut_place(const PlacedPlate& plate, const std::vector<Vec2>& extended) {
  for (const Segment& way : sides_of(extended)) {
    if (is_edge(plate.outline, way)) continue;
    if (const auto at = within(plate, way)) return at;
  }
  return std::nullopt;
}

Error run_into(const SheetsMeet& meet, const Parts& parts, int bend) {
  const BendFrame& frame = parts.fits[bend].report.frame;
  Facts facts = mapped(parts.fits[bend].report.plates, [&](int plate) {
    return Fact("plate", place::at(place::plate(parts.ids[plate]), meet.at));
  });
  facts.emplace_back("at", place::point(meet.at));
  facts.emplace_back("thickness", parts.thickness, unit::mm);
  facts.emplace_back(
      "least", tangent_distance(frame, kSmallestInsideRadius + 0.5 * parts.thickness), unit::mm);
  return error_of(refuse::sheets_run_into_each_other, facts);
}

}  // namespace

Result<void> check_on_plates(const Parts& parts, int bend) {
  if (!parts.fits[bend].fold) {
    const JoinedFace face = bend_face(parts, bend, 1);
    for (const Border& border : face.face.loops.front())
      if (!is_regular(border.curve)) return fail(refuse::nearly_parallel, plates_of(parts, bend));
  }
  for (const int plate : parts.fits[bend].report.plates) {
    const auto made = plate_face(parts, plate, 1);
    if (!made) return pass_on(made);
    const bool joined = std::ranges::any_of(made->joints,
                                            [&](const auto& joint) { return joint.bend == bend; });
    if (!joined) return fail(refuse::touches_in_point, {{"plate", place::plate(parts.ids[plate])}});
    if (parts.fits[bend].fold) continue;  // which cuts the plates back
    const PlacedPlate& placed = parts.plates[plate];
    if (const auto at = cut_place(placed, corners_of(made->face.loops.front())))
      return fail(refuse::cuts_plate, plate_at(parts.ids[plate], placed.frame.point(*at)));
  }
  // A bend round the back leaves the plates as near each other in front as they are.
  if (parts.fits[bend].report.edge_kind == EdgeKind::averted) return check_room(parts, bend);
  return {};
}

Result<void> check_room(const Parts& parts, int bend) {
  const FittedBend& report = parts.fits[bend].report;
  std::vector<PlacedPlate> extended;
  for (const int plate : report.plates) {
    const auto made = plate_face(parts, plate, 1);
    if (!made) return pass_on(made);
    extended.push_back(parts.plates[plate]);
    for (int ring = 0; ring < extended.back().ring_count(); ++ring)
      if (extended.back().is_polygon(ring))
        (ring == 0 ? extended.back().outline
                   : extended.back().holes[ring - 1]) = corners_of(made->face.loops[ring]);
  }
  const auto meet = sheets_meet(extended[0], extended[1], report.frame, parts.thickness);
  if (!meet) return {};
  return tl::unexpected(run_into(*meet, parts, bend));
}

Result<void> check_flat(const Parts& parts, int bend, double k_factor) {
  const std::vector<int>& rows = parts.fits[bend].report.plates;
  Parts alone{parts.thickness, {}, {}, {parts.fits[bend]}, 0};
  for (const int plate : rows) {
    alone.plates.push_back(parts.plates[plate]);
    alone.ids.push_back(parts.ids[plate]);
  }
  alone.fits.front().report.plates = {0, 1};
  const auto made = assembled(alone);
  if (!made) return pass_on(made);
  const FlattenOptions options{.allowance = ConstantK{k_factor}, .root = made->root};
  const auto layout = lay_out(made->sheet, options);
  if (!layout) {
    Error error = layout.error();
    error.places.clear();  // which are of a sheet that nobody sees
    return fail(std::move(error));
  }
  const double clearance = std::max(kContact * parts.thickness, 2.0 * options.curve_tolerance);
  const auto faces = mapped(made->sheet.faces.ids(), [&](FaceId face) {
    return polygon_of(layout->region(face), 0.25 * clearance);
  });
  const auto twice = overlaps(faces, clearance, clearance * clearance);
  if (twice.empty()) return {};
  Facts facts = plates_of(parts, bend);
  facts.emplace_back("area", twice.front().area, unit::mm2);
  return fail(refuse::covers_itself, facts);
}

Result<void> check_in_front(const Parts& parts, const std::vector<int>& rows, const BendFit& fit) {
  if (fit.report.edge_kind == EdgeKind::facing) return {};
  if (fit.report.passed_over) return tl::unexpected(fit.report.passed_over->why);
  return fail(refuse::no_room_in_front, mapped(rows, [&](int plate) {
                return Fact("plate", place::plate(parts.ids[static_cast<std::size_t>(plate)]));
              }));
}

}  // namespace planish::connect_detail
