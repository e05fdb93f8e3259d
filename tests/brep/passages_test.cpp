#include "passages.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

struct Cut {
  std::vector<double> radii;  ///< of its chains, from their length
  std::vector<double> areas;  ///< of what they enclose, seen along the plane's normal
};

/// Passages of the forms in a plate of 2 mm.
Cut cut_of(const std::vector<Turned>& forms, int reference) {
  const Recognised seen = recognised(plate(2, {100, 60}, forms), 2, reference);
  const Frame plane = std::get<Frame>(seen.model.faces[reference].surface);
  Cut cut;
  for (const RimPart& part : seen.rim.parts) {
    const bool turned = std::ranges::any_of(part.faces, [&](int f) {
      return !std::holds_alternative<Frame>(seen.model.faces[f].surface);
    });
    if (!turned) continue;
    for (const auto& chain : passages(seen.view(), part, plane)) {
      double length = 0.0, area = 0.0;
      for (const CoEdge& use : chain) {
        const SpaceCurve& curve = seen.model.edges[use.edge].curve;
        length += curve.length();
        for (int i = 0; i < 720; ++i) {
          const auto at = [&](int k) {
            return plane.local2(curve.point(curve.t0 + (curve.t1 - curve.t0) * k / 720.0));
          };
          const Vec2 a = at(i), b = at(i + 1);
          area += (use.forward ? 0.5 : -0.5) * (a.x() * b.y() - a.y() * b.x());
        }
      }
      cut.radii.push_back(length / (2 * pi));
      cut.areas.push_back(area);
    }
  }
  return cut;
}

TEST(Passages, AreWhereAFormIsNarrowest) {
  // Its throat is at the top of the collar, in the middle, at the bottom.
  for (const std::vector<Vec2>& inside :
       {std::vector<Vec2>{{2.5, 6}, {3, 0}}, std::vector<Vec2>{{3.5, 6}, {2.5, 3}, {3.2, 0}},
        std::vector<Vec2>{{3, 6}, {2.5, 0}}}) {
    std::vector<Vec2> profile{{5, 2}, {5, 6}};
    profile.insert(profile.end(), inside.begin(), inside.end());
    for (const int reference : {0, 1}) {
      const Cut cut = cut_of({{{30, 30}, profile}}, reference);
      ASSERT_EQ(cut.radii.size(), 1u);
      EXPECT_NEAR(cut.radii[0], 2.5, 1e-9);
      EXPECT_NEAR(cut.areas[0], -pi * 6.25, 1e-2) << "clockwise: the sheet is on its left";
    }
  }
}

TEST(Passages, AreThoseOfSmallFormsToo) {
  // Areas of a few square millimetres, and walls that have none.
  for (const int reference : {0, 1}) {
    const Cut cut = cut_of({{{30, 30}, {{1.6, 2}, {1.6, 6}, {1.2, 6}, {1, 0}}}}, reference);
    ASSERT_EQ(cut.radii.size(), 1u);
    EXPECT_NEAR(cut.radii[0], 1, 1e-9);
  }
}

TEST(Passages, OfCollarsAreFoundForEachByItself) {
  const Cut cut = cut_of(
      {{{30, 30}, {{5, 2}, {5, 6}, {3, 6}, {2, 0}}}, {{70, 30}, {{6, 2}, {6, 5}, {4, 5}, {3, 0}}}},
      1);
  ASSERT_EQ(cut.radii.size(), 2u);
  EXPECT_NEAR(std::min(cut.radii[0], cut.radii[1]), 2, 1e-9);
  EXPECT_NEAR(std::max(cut.radii[0], cut.radii[1]), 3, 1e-9);
}

TEST(Passages, AreNoneWhereNothingPasses) {
  EXPECT_TRUE(cut_of({{{30, 30}, {{5, 2}, {4, 1}, {0, 1}}}}, 0).radii.empty());
}

}  // namespace
}  // namespace planish::brep::test
