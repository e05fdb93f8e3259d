#include "mould_strips.hpp"

#include "sample_sheets.hpp"

#include <algorithm>

namespace planish::test {
namespace {

using namespace slit_detail;

Vec3 image(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

TEST(MouldStrips, RunThroughTheSymmetryPlaneWhereTheyMeetTheirImage) {
  const FoldedSlitSheet folded = solved(chair()).folded();
  const auto strips = mould_strips(folded, -1.0, nullptr);
  ASSERT_EQ(strips.size(), folded.strips.size());
  for (std::size_t i = 0; i < strips.size(); ++i) {
    ASSERT_EQ(strips[i].size(), 1u);
    const WholeStrip& whole = strips[i].front();
    const std::size_t quads = folded.strips[i].quads.size();
    ASSERT_EQ(whole.towards_mould.size(), 2 * quads);
    ASSERT_EQ(whole.ridges.size(), 2 * quads + 1);
    for (std::size_t k = 0; k < quads; ++k) {
      EXPECT_LT((whole.towards_mould[k] + folded.strips[i].quads[k].z).norm(), 1e-12);
      const std::size_t other = 2 * quads - 1 - k;
      EXPECT_LT((whole.towards_mould[other] - image(whole.towards_mould[k])).norm(), 1e-12);
      for (std::size_t side = 0; side < 2; ++side)
        EXPECT_LT((whole.ridges[2 * quads - k][side] - image(whole.ridges[k][side])).norm(), 1e-12);
    }
  }
}

TEST(MouldStrips, AreHalvesWhereTheyDoNot) {
  FoldedSlitSheet folded = solved(chair()).folded();
  for (auto& ridge : folded.strips[2].ridges)
    for (Vec3& p : ridge.folded)
      p.x() += 1.0;
  const auto strips = mould_strips(folded, 1.0, nullptr);
  ASSERT_EQ(strips[2].size(), 2u);
  EXPECT_EQ(strips[2][0].first, 0);
  EXPECT_EQ(strips[2][1].first, 10) << "quads are numbered from one panel to the other";
  EXPECT_EQ(strips[3].size(), 1u);
}

TEST(MouldStrips, GoOnUnderPanelsThatAreNotUprightInTheMould) {
  const FoldedSlitSheet folded = solved(chair()).folded();
  const Vec3 up = Vec3::UnitY(), leaning = Vec3(0.5, 1, 0).normalized();
  EXPECT_EQ(mould_strips(folded, -1.0, &up)[0].front().first, 0) << "the panel is upright";
  const WholeStrip strip = mould_strips(folded, -1.0, &leaning)[0].front();
  EXPECT_EQ(strip.first, -1);
  EXPECT_EQ(strip.towards_mould.size(), 22u) << "one before, one behind";
  const auto facet = std::ranges::find(folded.panel, 0, &PanelFacet::strip);
  ASSERT_NE(facet, folded.panel.end());
  EXPECT_LT((strip.towards_mould.front() + facet->frame.z).norm(), 1e-12);
  EXPECT_LT((strip.ridges.front()[0] - facet->frame.point(facet->corners[0])).norm(), 1e-9);
  EXPECT_LT((strip.ridges[1][0] - folded.strips[0].ridges[0].folded[0]).norm(), 1e-9);
}

}  // namespace
}  // namespace planish::test
