#include "fit_check.hpp"

#include "assemble.hpp"
#include "joined_face.hpp"
#include "pair_search.hpp"
#include "sheets_meet.hpp"
#include "tolerances.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/layout.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::connect_detail {
namespace {

// A plate that loses less than this share of its area to its extensions keeps its size: rounding.
constexpr double kNothingLost = 1e-7;
// Parts of a pattern that share less than this share of the thickness in width only touch.
constexpr double kContact = 1e-3;

std::vector<Vec2> corners_of(const BorderLoop& loop) {
  std::vector<Vec2> corners;
  for (const Border& border : loop)
    corners.push_back(point_at(border.curve, 0.0));
  return corners;
}

double lost_area(const PlacedPlate& plate, const BorderLoop& extended) {
  double kept = 0.0;
  for (const Overlap& part : overlaps({{plate.outline, {}}, {corners_of(extended), {}}}, 0.0, 0.0))
    kept += part.area;
  return ring_area(plate.outline) - kept;
}

Error cuts(const std::string& id, double lost) {
  return {ErrorCode::overlap,
          fmt::format("the straight way from the edges of plate {} to the bend would cut off "
                      "{:.4g} mm² of the plate",
                      id, lost),
          {}};
}

Error run_into(const SheetsMeet& meet, const Parts& parts, int bend) {
  const BendFrame& frame = parts.fits[bend].report.frame;
  return {ErrorCode::plates_touch,
          fmt::format("the sheets of {:.4g} mm run into each other at ({:.6g}, {:.6g}, {:.6g}): "
                      "move the plates apart or cut them back there, to {:.4g} mm from the line "
                      "where their planes meet; plates that share an edge can be folded sharply "
                      "(inside_radius 0)",
                      parts.thickness, meet.at.x(), meet.at.y(), meet.at.z(),
                      tangent_distance(frame, kSmallestInsideRadius + 0.5 * parts.thickness)),
          {}};
}

}  // namespace

Result<void> check_on_plates(const Parts& parts, int bend) {
  for (const int plate : parts.fits[bend].report.plates) {
    const auto made = plate_face(parts, plate, 1);
    if (!made) return tl::unexpected(made.error());
    const bool joined = std::any_of(made->joints.begin(), made->joints.end(),
                                    [&](const auto& joint) { return joint.bend == bend; });
    if (!joined)
      return fail(ErrorCode::no_common_width,
                  fmt::format("the bend touches plate {} in a point only", parts.ids[plate]));
    if (parts.fits[bend].fold) continue;  // which cuts the plates back
    const double lost = lost_area(parts.plates[plate], made->face.loops.front());
    if (lost > kNothingLost * parts.plates[plate].area)
      return tl::unexpected(cuts(parts.ids[plate], lost));
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
    if (!made) return tl::unexpected(made.error());
    extended.push_back(parts.plates[plate]);
    for (int ring = 0; ring < extended.back().ring_count(); ++ring)
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
  if (!made) return tl::unexpected(made.error());
  FlattenOptions options;
  options.allowance = ConstantK{k_factor};
  options.root = made->root;
  const auto layout = lay_out(made->sheet, options);
  if (!layout) return tl::unexpected(layout.error());
  const double clearance = std::max(kContact * parts.thickness, 2.0 * options.curve_tolerance);
  std::vector<Polygon> faces;
  for (const FaceId face : made->sheet.faces.ids())
    faces.push_back(polygon_of(layout->region(face), 0.25 * clearance));
  const auto twice = overlaps(faces, clearance, clearance * clearance);
  if (twice.empty()) return {};
  return fail(ErrorCode::overlap,
              fmt::format("laid flat, the plates and the bend would cover each other by {:.4g} mm²",
                          twice.front().area));
}

}  // namespace planish::connect_detail
