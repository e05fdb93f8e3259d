#include "corners.hpp"
#include "refusals.hpp"
#include "tangent_program.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The tangent line of least plate extension (math.md#least-extension). The area between runs and a
// line is linear in its slope and offset, so it is a linear program in two unknowns; for a slope
// the best offset lies at a bound, and what remains is convex and piecewise linear. The same bounds
// say which slopes and offsets are possible at all, for the messages.

namespace planish {
namespace {

using namespace connect_detail;

struct SideEnvelopes {
  std::vector<RunEnvelope> chains;
  std::array<CornerRange, 2> sides;
  explicit SideEnvelopes(const Corners& corners) {
    for (const auto& side : corners)
      chains.emplace_back(side);
    for (std::size_t i = 0; i < 2; ++i)
      sides[i] = {&chains[i], 0, static_cast<int>(corners[i].size()) - 1};
  }
};

double area_under(const std::vector<Vec2>& corners) {
  double area = 0.0;
  for (std::size_t j = 0; j + 1 < corners.size(); ++j)
    area += 0.5 * (corners[j].y() + corners[j + 1].y()) * (corners[j + 1].x() - corners[j].x());
  return area;
}

// ∫ (k x − q) dx over the ranges of both sides, as a linear function of (k, q).
Vec2 area_of_line(const Corners& corners) {
  Vec2 sum = Vec2::Zero();
  for (const auto& side : corners) {
    const double a = side.front().x(), b = side.back().x();
    sum += Vec2(0.5 * (b - a) * (b + a), -(b - a));
  }
  return sum;
}

double sign_of(EdgeKind kind) { return kind == EdgeKind::facing ? 1.0 : -1.0; }

tl::unexpected<Error> no_tangent_line(const Corners& corners, EdgeKind kind) {
  const auto slopes = feasible_slopes(corners, kind);
  if (!slopes) return fail(refuse::no_such_line);
  if (!std::isfinite(slopes->low)) return fail(refuse::no_line);
  return fail(refuse::no_line_of_slopes,
              {{"low", slopes->low, unit::none}, {"high", slopes->high, unit::none}});
}

// The largest (sign +1) or smallest slope.
std::optional<double> last_slope(const std::array<CornerRange, 2>& sides, EdgeKind kind,
                                 double size, double sign) {
  TangentCost cost;
  cost.linear = {-sign, 0.0};
  const auto best = cheapest_tangent(sides, kind, cost, {}, size);
  if (!best) return std::nullopt;
  return best->line.slope;
}

}  // namespace

double extension_area(const Corners& corners, EdgeKind kind, const TangentLine& line) {
  PLANISH_ASSERT(!corners[0].empty() && !corners[1].empty());
  const Vec2 of_line = area_of_line(corners);
  const double area = area_under(corners[0]) + area_under(corners[1]) -
                      of_line.dot(Vec2(line.slope, line.offset));
  return sign_of(kind) * area;
}

Result<SmallestExtension> smallest_extension(const Corners& corners, EdgeKind kind,
                                             const GivenLine& given) {
  PLANISH_ASSERT(!corners[0].empty() && !corners[1].empty());
  const SideEnvelopes envelopes(corners);
  TangentCost cost;
  cost.linear = -sign_of(kind) * area_of_line(corners);
  const auto best = cheapest_tangent(envelopes.sides, kind, cost, given, size_of(envelopes.sides));
  if (!best) return no_tangent_line(corners, kind);
  return SmallestExtension{best->line, std::max(0.0, extension_area(corners, kind, best->line))};
}

std::optional<Range> feasible_slopes(const Corners& corners, EdgeKind kind) {
  PLANISH_ASSERT(!corners[0].empty() && !corners[1].empty());
  if (kind == EdgeKind::averted)
    return Range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const SideEnvelopes envelopes(corners);
  const double size = size_of(envelopes.sides);
  const auto low = last_slope(envelopes.sides, kind, size, -1.0),
             high = last_slope(envelopes.sides, kind, size, 1.0);
  if (!low || !high) return std::nullopt;
  return Range{*low, *high};
}

std::optional<Range> feasible_offsets(const Corners& corners, EdgeKind kind, double slope) {
  Range range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const auto& side : corners)
    for (const Vec2& p : side) {
      const double at = slope * p.x();
      range.high = std::min(range.high, kind == EdgeKind::facing ? at : at - p.y());
      if (kind == EdgeKind::facing) range.low = std::max(range.low, at - p.y());
    }
  if (range.low > range.high) return std::nullopt;
  return range;
}

}  // namespace planish
