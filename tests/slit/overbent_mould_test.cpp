#include "overbent_mould.hpp"

#include "sample_sheets.hpp"
#include "support/closed_mesh.hpp"

#include <planish/geometry/mesh_volume.hpp>
#include <planish/slit/overbend.hpp>

#include <algorithm>
#include <cmath>

// Ribs for strips that spring back: each is that of its strip alone, all on one base.

namespace planish::test {
namespace {

const SlitMaterial kMild{210000.0, 0.3, 7.85, 235.0};

/// Ridges where neighbouring facets of a rib meet: the angles between them.
std::vector<double> angles_of(const MouldRib& rib) {
  std::vector<double> angles;
  const auto normal = [&](std::size_t i) -> Vec3 {
    const auto& f = rib.facets[i];
    return (f[1] - f[0]).cross(f[2] - f[1]).normalized();
  };
  for (std::size_t i = 0; i + 1 < rib.facets.size(); ++i)
    angles.push_back(std::acos(std::clamp(normal(i).dot(normal(i + 1)), -1.0, 1.0)));
  return angles;
}

TEST(OverbentMould, HasTheFoldsThatKeepTheWantedOnes) {
  const FoldedSlitSheet folded = solved(small_chair(), 1).folded();
  MouldOptions options;
  options.overbend = kMild;
  const auto mould = mould_of(folded, options);
  ASSERT_TRUE(mould) << mould.error().message;
  for (const MouldRib& rib : mould->ribs) {
    const FoldedStrip& strip = folded.strips[rib.strip];
    const int quads = static_cast<int>(strip.quads.size());
    const auto angles = angles_of(rib);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const int ridge = rib.first_quad + static_cast<int>(i) + 1,
                half = ridge <= quads ? ridge : 2 * quads - ridge;
      if (half == quads) continue;  // the symmetry plane
      const Angle kept = kept_fold(kMild, folded.thickness, bent_widths(strip, half),
                                   Angle::radians(angles[i]));
      EXPECT_NEAR(kept.radians(), std::abs(strip.ridges[half].fold.radians()), 1e-6)
          << rib.strip << ' ' << ridge;
    }
  }
}

TEST(OverbentMould, StandsSideBySideOnOneBase) {
  const FoldedSlitSheet folded = solved(chair()).folded();
  MouldOptions options;
  options.overbend = kMild;
  const auto mould = mould_of(folded, options);
  ASSERT_TRUE(mould) << mould.error().message;
  std::vector<std::array<double, 2>> across(6, {1e9, -1e9});
  double volume = 0.0;
  for (const MouldRib& rib : mould->ribs) {
    expect_closed(rib.mesh);
    volume += volume_of(rib.mesh);
    double lowest = 1e9;
    for (const Vec3& p : rib.mesh.points)
      lowest = std::min(lowest, (p - mould->base.origin).dot(mould->base.z));
    EXPECT_NEAR(lowest, 0.0, 1e-9);
    for (const Vec2& p : rib.footprint) {
      auto& range = across[rib.strip];
      range = {std::min(range[0], p.y()), std::max(range[1], p.y())};
    }
  }
  EXPECT_NEAR(volume, mould->volume, 1e-6 * volume);
  for (std::size_t i = 0; i + 1 < 6; ++i)
    EXPECT_NEAR(across[i + 1][0] - across[i][1], options.base, 1e-9);
}

TEST(OverbentMould, IsNotOneBody) {
  const FoldedSlitSheet folded = solved(small_chair()).folded();
  MouldOptions options;
  options.overbend = kMild;
  options.form = MouldForm::body;
  const auto refused = mould_of(folded, options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("one by one"), std::string::npos);
}

}  // namespace
}  // namespace planish::test
