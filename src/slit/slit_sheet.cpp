#include <planish/base/assert.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <algorithm>

namespace planish {

double SlitSheet::width() const {
  double across = margin;
  for (const SlitStrip& strip : strips)
    across += strip.gap + strip.width;
  return across;
}

double SlitSheet::breadth() const {
  if (strips.empty()) return 0.0;
  return sides_at_end(static_cast<int>(strips.size()) - 1)[1] - sides_at_end(0)[0];
}

double SlitSheet::reach() const {
  double along = 0.0;
  for (int i = 0; i < static_cast<int>(strips.size()); ++i)
    along = std::max(along, strips[i].left_end || strips[i].right_end ? far_line() : end_of(i));
  return along;
}

double SlitSheet::left_of(int strip) const {
  PLANISH_ASSERT(has_strip(strip));
  double across = strips[strip].gap;
  for (int i = 0; i < strip; ++i)
    across += strips[i].gap + strips[i].width;
  return across;
}

std::array<double, 2> SlitSheet::start_of(int strip) const {
  PLANISH_ASSERT(has_strip(strip));
  const SlitStrip& row = strips[strip];
  return {row.left_start.value_or(panel_height), row.right_start.value_or(panel_height)};
}

std::array<double, 2> SlitSheet::ends_of(int strip) const {
  PLANISH_ASSERT(has_strip(strip));
  const SlitStrip& row = strips[strip];
  const double end = row.end.value_or(far_line());
  return {row.left_end.value_or(row.right_end.value_or(end)),
          row.right_end.value_or(row.left_end.value_or(end))};
}

bool SlitSheet::joins_next(int strip) const {
  return has_strip(strip) && has_strip(strip + 1) && strips[strip].right_end &&
         strips[strip + 1].left_end;
}

double SlitSheet::end_of(int strip) const { return std::ranges::max(ends_of(strip)); }

std::array<double, 2> SlitSheet::sides_at_end(int strip) const {
  const auto& edges = strips[strip].edges;
  const double left = left_of(strip), right = left + strips[strip].width;
  return {edges[0].empty() ? left : edges[0].back().y(),
          edges[1].empty() ? right : edges[1].back().y()};
}

double SlitSheet::width_at_end(int strip) const {
  const auto [left, right] = sides_at_end(strip);
  return right - left;
}

std::array<double, 2> SlitSheet::edge_lengths(int strip) const {
  const auto start = start_of(strip), end = ends_of(strip);
  std::array<double, 2> lengths{};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<Vec2>& edge = strips[strip].edges[side];
    if (edge.empty()) lengths[side] = end[side] - start[side];
    for (std::size_t i = 0; i + 1 < edge.size(); ++i)
      lengths[side] += (edge[i + 1] - edge[i]).norm();
  }
  return lengths;
}

double SlitSheet::area_of(int strip) const {
  const auto start = start_of(strip), end = ends_of(strip);
  const double left = left_of(strip);
  auto edges = strips[strip].edges;
  if (edges[0].empty()) edges[0] = {{start[0], left}, {end[0], left}};
  if (edges[1].empty()) {
    const double right = left + strips[strip].width;
    edges[1] = {{start[1], right}, {end[1], right}};
  }
  std::vector<Vec2> ring = edges[0];
  ring.insert(ring.end(), edges[1].rbegin(), edges[1].rend());
  double twice = 0.0;
  for (const Segment& side : sides_of(ring))
    twice += cross(side.a, side.b);
  return 0.5 * twice;
}

double SlitMaterial::rigidity(double thickness) const {
  return young * thickness * thickness * thickness / (12.0 * (1.0 - poisson * poisson));
}

double SlitMaterial::stress(double thickness, double curvature) const {
  return 0.5 * young * thickness * curvature / (1.0 - poisson * poisson);
}

double SlitMaterial::kept_curvature(double thickness, double curvature) const {
  PLANISH_ASSERT(yield.has_value());
  const double first = curvature * *yield / stress(thickness, curvature);  // at which it yields
  if (!(curvature > first)) return 0.0;
  const double share = first / curvature;
  return curvature - 0.5 * first * (3.0 - share * share);
}

std::vector<SlitStrip> equal_strips(int count, double width) {
  constexpr int kMostEqual = 10'000;  // as in files
  PLANISH_ASSERT(count <= kMostEqual);
  std::vector<SlitStrip> strips(std::max(0, count));
  for (SlitStrip& strip : strips)
    strip.width = width;
  return strips;
}

}  // namespace planish
