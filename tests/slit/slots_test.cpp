#include "sample_sheets.hpp"

#include <planish/sheet/slots.hpp>

#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

FlatPattern flattened(const SlitDesign& design) {
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "test"};
  auto pattern = flatten(sheet_of(solved(design).folded()), options);
  if (!pattern) throw std::runtime_error(pattern.error().message);
  return *pattern;
}

FlatPattern cut(const FlatPattern& pattern, const SlotOptions& options) {
  auto result = cut_slits(pattern, options);
  if (!result) throw std::runtime_error(result.error().message);
  return *result;
}

TEST(SlitSheetSlots, ChairHasFiveSlitsInsideTheSheet) {
  const FlatPattern flat = flattened(chair());
  const FlatPattern lines = cut(flat, {});
  EXPECT_EQ(lines.slits.size(), 5u);
  EXPECT_TRUE(lines.openings.empty());
  EXPECT_EQ(lines.outer.loop.size(), 4u);
  EXPECT_NEAR(lines.perimeter, 2 * (1768 + 360) + 5 * 928.0, 1e-6);
  const FlatPattern slots = cut(flat, {.kerf = 2.0, .stop_hole = 6.0});
  EXPECT_EQ(slots.openings.size(), 5u);
  const double angle = std::asin(1.0 / 3.0);
  EXPECT_NEAR(slots.area,
              1768 * 360.0 - 5 * (2 * (928 - 2 * std::sqrt(8.0)) +
                                  2 * (pi * 9 - 0.5 * 9 * (2 * angle - std::sin(2 * angle)))),
              1e-5);
  for (const FlatBend& bend : slots.bends)
    for (const Segment& line : bend.lines)
      EXPECT_LE((line.b - line.a).norm(), 422.0);
}

TEST(SlitSheetSlots, StripsWithFreeEndsOpenTheOuterContour) {
  const SlitDesign design = asymmetric();
  const FlatPattern flat = flattened(design);
  const FlatPattern lines = cut(flat, {});
  // From 200 to the end of strip 0 at 500, and from 200 to that of strip 3 at 480; between the
  // others there are gaps.
  EXPECT_NEAR(lines.area, flat.area, 1e-6);
  EXPECT_EQ(lines.slits.size(), 2u);
  EXPECT_TRUE(lines.openings.empty());
  EXPECT_NEAR(flat.perimeter - lines.perimeter, 300.0 + 280.0, 1e-6);
  const FlatPattern slots = cut(flat, {.kerf = 1.0});
  EXPECT_TRUE(slots.openings.empty());
  // Each slot with its round end, and a quarter beside the longer strip where it opens.
  EXPECT_NEAR(slots.area, flat.area - (580.0 + 2 * (pi / 8 + pi / 16)), 1e-6);
}

}  // namespace
}  // namespace planish::test
