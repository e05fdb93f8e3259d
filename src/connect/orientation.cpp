#include "orientation.hpp"

namespace planish::connect_detail {
namespace {

// +1 if the bend's normal at a side is that of the plate there, −1 if it is the opposite.
int alignment(const Parts& parts, int bend, int side, int plate) {
  const BendSurface& surface = parts.fits[bend].surface;
  const Vec3 normal = normal_on(surface.mid, surface.azimuth(side));
  return normal.dot(parts.plates[plate].frame.z) > 0.0 ? 1 : -1;
}

// The side of a bend on which a plate lies.
std::optional<int> side_of(const Parts& parts, int bend, int plate) {
  for (int side = 0; side < 2; ++side)
    if (parts.plate_of(bend, side) == plate) return side;
  return std::nullopt;
}

}  // namespace

Orientation orientation_of(const Parts& parts) {
  Orientation result{std::vector<int>(parts.plates.size(), 0),
                     std::vector<int>(parts.fits.size(), 1)};
  if (parts.plates.empty()) return result;
  std::vector<bool> known(parts.fits.size(), false);
  std::vector<int> open{parts.root};
  result.plates[parts.root] = 1;
  while (!open.empty()) {
    const int plate = open.back();
    open.pop_back();
    for (int bend = 0; bend < static_cast<int>(parts.fits.size()); ++bend) {
      const auto side = side_of(parts, bend, plate);
      if (known[bend] || !side) continue;
      known[bend] = true;
      result.bends[bend] = result.plates[plate] * alignment(parts, bend, *side, plate);
      const auto other = parts.plate_of(bend, 1 - *side);
      if (!other) continue;
      result.plates[*other] = result.bends[bend] * alignment(parts, bend, 1 - *side, *other);
      open.push_back(*other);
    }
  }
  return result;
}

bool has_two_sides(const Parts& parts) {
  const Orientation sides = orientation_of(parts);
  for (int bend = 0; bend < static_cast<int>(parts.fits.size()); ++bend)
    for (int side = 0; side < 2; ++side)
      if (const auto plate = parts.plate_of(bend, side))
        if (sides.plates[*plate] * alignment(parts, bend, side, *plate) != sides.bends[bend])
          return false;
  return true;
}

}  // namespace planish::connect_detail
