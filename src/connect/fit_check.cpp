#include "fit_check.hpp"

#include "assemble.hpp"
#include "joined_face.hpp"

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

double lost_area(const PlacedPlate& plate, const BorderLoop& extended) {
  Polygon face;
  for (const Border& border : extended)
    face.outer.push_back(point_at(border.curve, 0.0));
  double kept = 0.0;
  for (const Overlap& part : overlaps({{plate.outline, {}}, face}, 0.0, 0.0))
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
    const double lost = lost_area(parts.plates[plate], made->face.loops.front());
    if (lost > kNothingLost * parts.plates[plate].area)
      return tl::unexpected(cuts(parts.ids[plate], lost));
  }
  return {};
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
