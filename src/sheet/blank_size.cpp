// The smallest rectangle around a pattern at any angle, and the motion that lays the pattern along
// it. A blank that lies along an axis except for rounding is turned by whole quarters, so that its
// coordinates stay as they are, digit by digit.

#include <planish/base/assert.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

std::vector<Vec2> outline_points(const FlatPattern& pattern) {
  PLANISH_ASSERT(is_regular(pattern.outer.loop));
  return sampled(pattern.outer.loop, kImageTolerance);
}

// A blank that lies along an axis but for rounding is turned by quarters, which leaves every
// coordinate as it is.
constexpr double kRightAngle = std::numbers::pi / 2.0;
constexpr double kQuarter = 1e-9;  // rad

Eigen::Matrix2d turned_back(double angle) {
  const double quarters = std::round(angle / kRightAngle);
  double c = std::cos(angle), s = std::sin(angle);
  if (std::abs(angle - quarters * kRightAngle) < kQuarter) c = std::round(c), s = std::round(s);
  Eigen::Matrix2d turn;
  turn << c, s, -s, c;
  return turn;
}

}  // namespace

Vec2 blank_size(const FlatPattern& pattern) {
  if (pattern.outer.loop.empty()) return Vec2::Zero();
  return smallest_rectangle(outline_points(pattern)).size;
}

Isometry2 laid_by_blank(const FlatPattern& pattern) {
  Isometry2 laid = Isometry2::Identity();
  if (pattern.outer.loop.empty()) return laid;
  const std::vector<Vec2> points = outline_points(pattern);
  laid.linear() = turned_back(smallest_rectangle(points).angle);
  Vec2 corner = laid.linear() * points.front();
  for (const Vec2& point : points)
    corner = corner.cwiseMin(laid.linear() * point);
  laid.translation() = -corner;
  return laid;
}

}  // namespace planish
