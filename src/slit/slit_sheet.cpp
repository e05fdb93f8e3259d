#include <planish/base/assert.hpp>
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
  return strips.empty() ? 0.0 : width() - margin - strips.front().gap;
}

double SlitSheet::reach() const {
  double along = 0.0;
  for (int i = 0; i < static_cast<int>(strips.size()); ++i)
    along = std::max(along, end_of(i));
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

double SlitSheet::end_of(int strip) const {
  PLANISH_ASSERT(has_strip(strip));
  return strips[strip].end.value_or(panel_height + half_length);
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
