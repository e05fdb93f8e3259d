#include "bend_dimensions.hpp"

#include <planish/base/text.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Running dimensions to the bend lines: one number for each, its distance from the edge of the
// pattern. Where lines are closer than letters are high, the numbers move apart and a bent line
// leads to each.

namespace planish::drawing {
namespace {

constexpr double kAlongAxis = 1e-6;     // sine
constexpr double kSameDistance = 5e-3;  // mm: half of what is written
constexpr double kDistanceText = 2.8;   // size, mm
constexpr double kDistanceGap = 3.4;    // between numbers, mm
constexpr double kLineBegin = 1.5, kLineKink = 3.0, kLineEnd = 5.0,
                 kNumberAt = 5.8;  // from the pattern, mm

void keep_each_once(std::vector<double>& all) {
  std::ranges::sort(all);
  const auto [first, last] = std::ranges::unique(
      all, [](double a, double b) { return b - a < kSameDistance; });
  all.erase(first, last);
}

/// The numbers along one edge. `at` gives the place on the page, from the distance along the edge
/// on the page and the distance from the edge, mm.
template <typename Place>
void write_distances(Page& page, const std::vector<double>& distances,
                     const std::vector<double>& lines, const std::vector<double>& numbers,
                     const schema::Units& units, double turned, const Place& at) {
  const Ink thin{.stroke = kPageGrey, .width = 0.15};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    page.lines({{at(lines[i], kLineBegin), at(lines[i], kLineKink), at(numbers[i], kLineEnd)}},
               thin);
    page.text(at(numbers[i], kNumberAt), units.short_text(distances[i]),
              {.size = kDistanceText,
               .anchor = turned > 0.0 ? TextAnchor::end : TextAnchor::start,
               .turned = turned});
  }
}

bool is_upright(const Segment& line) {
  return std::abs((line.b - line.a).normalized().x()) < kAlongAxis;
}
bool is_level(const Segment& line) {
  return std::abs((line.b - line.a).normalized().y()) < kAlongAxis;
}

}  // namespace

bool is_dimensioned(const Segment& line) { return is_upright(line) || is_level(line); }

BendDistances bend_distances(const FlatPattern& flat) {
  const Box2 box = bounds(flat.outer.loop);
  BendDistances distances;
  for (const FlatBend& bend : flat.bends)
    for (const Segment& line : bend.lines)
      if (is_upright(line))
        distances.from_left.push_back(line.a.x() - box.lo.x());
      else if (is_level(line))
        distances.from_below.push_back(line.a.y() - box.lo.y());
  keep_each_once(distances.from_left);
  keep_each_once(distances.from_below);
  return distances;
}

std::vector<double> spread(std::vector<double> wanted, double gap, double low, double high) {
  if (wanted.empty() || static_cast<double>(wanted.size() - 1) * gap > high - low) return {};
  double least = low;
  for (double& place : wanted) {
    place = std::max(place, least);
    least = place + gap;
  }
  double most = high;
  for (auto place = wanted.rbegin(); place != wanted.rend(); ++place) {
    *place = std::min(*place, most);
    most = *place - gap;
  }
  return wanted;
}

std::size_t dimension_bends(Page& page, const FlatPattern& flat, const Fit& fit,
                            const schema::Units& units) {
  constexpr double kBeyond = 8.0;  // mm: that numbers may stand beyond the pattern
  constexpr double kDown = 1.0;    // mm: half the height of a number
  const BendDistances distances = bend_distances(flat);
  const Box2 box = bounds(flat.outer.loop);
  const Vec2 low = fit(box.lo), high = fit(box.hi);  // the page's y runs down
  const auto across = mapped(distances.from_left,
                             [&](double d) { return low.x() + fit.scale() * d; });
  // Upwards on the page.
  const auto upwards = mapped(distances.from_below, [&](double d) { return fit.scale() * d; });
  const auto below = spread(across, kDistanceGap, low.x() - kBeyond, high.x() + kBeyond);
  const auto beside = spread(upwards, kDistanceGap, -kBeyond, low.y() - high.y() + kBeyond);
  if (!below.empty())
    write_distances(page, distances.from_left, across, below, units, 0.5 * std::numbers::pi,
                    [&](double x, double away) {
                      return Vec2(x + (away == kNumberAt ? kDown : 0.0), low.y() + away);
                    });
  if (!beside.empty())
    write_distances(page, distances.from_below, upwards, beside, units, 0.0,
                    [&](double y, double away) {
                      return Vec2(high.x() + away, low.y() - y + (away == kNumberAt ? kDown : 0.0));
                    });
  return (below.empty() ? across.size() : 0) + (beside.empty() ? upwards.size() : 0);
}

}  // namespace planish::drawing
