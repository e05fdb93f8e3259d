#include "sample_sheets.hpp"

#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

// Sheets of any kind: whatever the optimiser finds, the sheet is not stretched, and strips end
// where they must or are reported with at least the shortfall that nothing could avoid.

namespace planish::test {
namespace {

struct RandomSheet {
  SlitDesign design;
  bool sound = false;  ///< the random leg curve fits
};

RandomSheet random_sheet(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto between = [&](double low, double high) { return low + (high - low) * unit(random); };
  RandomSheet result;
  SlitDesign& design = result.design;
  SlitSheet& sheet = design.sheet;
  sheet.symmetric = unit(random) < 0.7;
  sheet.thickness = between(1, 3);
  sheet.panel_height = between(100, 400);
  const int strips = 1 + static_cast<int>(random() % 5);
  for (int i = 0; i < strips; ++i)
    sheet.strips.push_back(
        {.width = between(20, 70), .gap = unit(random) < 0.3 ? between(0, 10) : 0.0});
  const double distance = between(200, 500), slope = between(-0.6, 0.6), width = sheet.width();
  sheet.half_length = distance * between(1.02, 1.5);
  const Vec2 along(std::sin(slope), std::cos(slope)), from(distance, 0);
  design.leg_curve = {
      {from,
       from + 0.5 * width * along + between(-0.05, 0.05) * width * Vec2(along.y(), -along.x()),
       from + width * along}};
  design.ridges = 6 + static_cast<int>(random() % 8);
  if (sheet.symmetric && unit(random) < 0.5) {
    const double height = sheet.panel_height + between(-50, 50);
    design.seat_curve = BezierCurve{{{height, 0},
                                     {height + between(-50, 50), 0.5 * width},
                                     {height + between(-100, 200), 1.05 * width}}};
  }
  if (!sheet.symmetric)
    for (int i = 0; i < strips; ++i) {
      const double turned = between(0, std::numbers::pi),
                   far = sheet.half_length * between(0.5, 0.9);
      StripEnd end;
      if (unit(random) < 0.8)
        end.position = Vec3(distance - far * std::sin(turned),
                            sheet.panel_height + far * std::cos(turned),
                            sheet.left_of(i) + between(0, 20));
      if (unit(random) < 0.6)
        end.direction = Vec3(-std::sin(1.3 * turned), std::cos(1.3 * turned), between(-0.3, 0.3));
      design.ends.push_back(end);
    }
  result.sound = SlitSession::start(design).has_value();
  return result;
}

/// In symmetric sheets no corner gets nearer to the plane than its side is long.
double least_shortfall(const FoldedStrip& strip) {
  double least = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
    least = std::max(least,
                     std::abs(strip.ridges.front().folded[side].x()) -
                         (strip.ridges.back().flat[side] - strip.ridges.front().flat[side]).norm());
  return least;
}

RC_GTEST_PROP(AnySlitSheet, IsNotStretchedAndEndsWhereItMust, ()) {
  const RandomSheet random = random_sheet(*rc::gen::arbitrary<unsigned>());
  RC_PRE(random.sound);
  const SlitSession session = solved(random.design);
  const FoldedSlitSheet folded = session.folded();
  const double size = random.design.sheet.reach();
  for (int i = 0; i < session.strip_count(); ++i) {
    const FoldedStrip& strip = folded.strips[i];
    for (std::size_t r = 0; r + 1 < strip.ridges.size(); ++r)
      for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b < 2; ++b)
          RC_ASSERT(std::abs((strip.ridges[r].folded[a] - strip.ridges[r + 1].folded[b]).norm() -
                             (strip.ridges[r].flat[a] - strip.ridges[r + 1].flat[b]).norm()) <=
                    1e-12 * size);
    const StripState& state = session.state(i);
    if (state.status == StripStatus::out_of_reach) {
      // Out of reach by nothing: its end is there, and points backwards.
      RC_ASSERT(state.shortfall == state.gap || (state.shortfall == 0.0 && state.gap < 1e-9));
      if (random.design.sheet.symmetric)
        RC_ASSERT(state.shortfall >= least_shortfall(strip) - 1e-9 * size);
    } else {
      RC_ASSERT(state.gap <= 1e-9 * size);
      if (random.design.sheet.symmetric) RC_ASSERT(least_shortfall(strip) <= 1e-9 * size);
    }
  }
}

}  // namespace
}  // namespace planish::test
