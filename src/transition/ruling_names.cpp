#include "ruling_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {
namespace {

std::string letter(int corner, char first) {
  const std::string rounds = corner < 26 ? "" : std::to_string(corner / 26);
  return std::string(1, static_cast<char>(first + corner % 26)) + rounds;
}

}  // namespace

std::array<std::string, 2> RulingNames::add(const std::array<Vec3, 2>& points,
                                            const std::string& press, int piece) {
  const auto known = std::ranges::find_if(lengths_, [&](const TrueLength& other) {
    return same(other.points[0], points[0]) && same(other.points[1], points[1]);
  });
  if (known != lengths_.end()) return {known->from, known->to};
  lengths_.push_back({name(0, points[0]), name(1, points[1]), points,
                      (points[1] - points[0]).norm(), piece, press});
  return {lengths_.back().from, lengths_.back().to};
}

std::string RulingNames::name(int side, const Vec3& p) {
  const Boundary& boundary = hull_.boundaries[side];
  for (const GivenCorner& corner : boundary.corners) {
    const Element& element = boundary.element(corner.element);
    if (same(element.curve(std::lerp(element.t0, element.t1, corner.at)).point, p))
      return letter(corner.number, side == 0 ? 'A' : 'a');
  }
  auto& known = points_[side];
  const auto found = std::ranges::find_if(known, [&](const Vec3& other) { return same(other, p); });
  const auto number = found - known.begin() + 1;
  if (found == known.end()) known.push_back(p);
  return fmt::format("{}{}", number, side == 0 ? "" : "'");
}

}  // namespace planish::transition_detail
