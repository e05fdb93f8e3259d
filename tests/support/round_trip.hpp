#pragma once

#include <planish/brep/step.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// Sheet → solid → STEP → recognise → flatten must give what flattening the sheet gives. For the
// tests of brep and of what is above it.

namespace planish::test {

/// What two flat patterns of one part have in common wherever they lie and whichever skin was seen.
struct Traits {
  double area = 0.0, perimeter = 0.0;
  Vec2 size = Vec2::Zero();
  size_t openings = 0;
  std::vector<std::array<double, 3>> bends;  // angle, inside radius, length; sorted
};

inline Traits traits_of(const FlatPattern& pattern) {
  Traits traits{pattern.area, pattern.perimeter, {}, pattern.openings.size(), {}};
  traits.size = smallest_rectangle(sampled(pattern.outer.loop, 0.001)).size;
  for (const FlatBend& bend : pattern.bends)
    traits.bends.push_back({std::round(bend.angle.degrees() * 1e4) / 1e4,
                            std::round(bend.inside_radius * 1e4) / 1e4, bend.length});
  std::ranges::sort(traits.bends);
  return traits;
}

inline Recognized recognized_again(const Sheet& sheet) {
  const auto step = folded_solid_step(sheet, "part");
  EXPECT_TRUE(step.has_value()) << (step ? "" : step.error().message);
  if (!step) return {};
  const auto file = read_step_text(*step, "part.step");
  EXPECT_TRUE(file.has_value()) << (file ? "" : file.error().message);
  if (!file) return {};
  EXPECT_EQ(file->bodies.size(), 1u);
  auto result = recognize(file->bodies.front());
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
  return result ? std::move(*result) : Recognized{};
}

/// `tolerance` is relative; `volume` of the sheet is compared where it is known.
inline void expect_round_trip(const Sheet& sheet, double tolerance = 1e-6) {
  const FlattenOptions options{.allowance = ConstantK{0.44, "test"}};
  const auto before = flatten(sheet, options);
  ASSERT_TRUE(before);
  const Recognized again = recognized_again(sheet);
  if (again.sheet.faces.empty()) return;
  EXPECT_NEAR(again.sheet.thickness, sheet.thickness, 1e-6 * sheet.thickness);
  if (sheet.volume) {
    EXPECT_NEAR(*again.sheet.volume, *sheet.volume, 1e-6 * *sheet.volume);
  }
  const auto after = flatten(again.sheet, options);
  ASSERT_TRUE(after) << after.error().message;
  const Traits a = traits_of(*before);
  const Traits b = traits_of(*after);
  EXPECT_NEAR(b.area, a.area, tolerance * a.area);
  EXPECT_NEAR(b.perimeter, a.perimeter, tolerance * a.perimeter);
  EXPECT_LT((b.size - a.size).norm(), tolerance * a.size.norm());
  EXPECT_EQ(b.openings, a.openings);
  ASSERT_EQ(b.bends.size(), a.bends.size());
  // The radius of a skin of a general bend is recognised by steps between rulings, and at its ends
  // by a parabola through three of them.
  constexpr double kBySteps = 5e-4;
  const bool by_steps = std::ranges::any_of(
      before->bends, [](const FlatBend& bend) { return bend.kind == BendKind::general; });
  const double stepped = by_steps ? kBySteps * sheet.thickness : 0.0;
  const std::array relative{tolerance, by_steps ? kBySteps : tolerance, tolerance};
  const std::array least{1e-3, 1e-3 + stepped, 1e-3};
  for (size_t i = 0; i < a.bends.size(); ++i)
    for (size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(b.bends[i][k], a.bends[i][k], least[k] + relative[k] * a.bends[i][k]);
  const auto certificate = certify(again.sheet, *after, again.distance);
  ASSERT_TRUE(certificate);
  // In the file the skins of a general bend are fitted within 1e-3 mm.
  const double fitted = by_steps ? 1e-3 / sheet.thickness : 0.0;
  EXPECT_NEAR(*certificate->explained_ratio, 1.0, 1e-5 + fitted);
  EXPECT_LT(*certificate->refold_deviation, 1e-3);
  EXPECT_LT(certificate->length_error, 1e-3);
}

}  // namespace planish::test
