#include "sample_sheets.hpp"
#include "support/closed_mesh.hpp"

#include <planish/slit/mould.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace planish::test {
namespace {

Mould mould(const FoldedSlitSheet& folded, const MouldOptions& options = {}) {
  auto result = mould_of(folded, options);
  if (!result) throw std::runtime_error(result.error().message + " at " + result.error().where);
  return *result;
}

ErrorCode code_of(const FoldedSlitSheet& folded, const MouldOptions& options) {
  const auto result = mould_of(folded, options);
  EXPECT_FALSE(result);
  return result ? code::internal : result.error().code;
}

/// A quad of the whole sheet: a point of it and its front.
struct Quad {
  Vec3 on;
  Vec3 front;
};

std::vector<Quad> quads_of(const FoldedSlitSheet& folded, int strip) {
  const FoldedStrip& half = folded.strips[strip];
  std::vector<Quad> quads;
  for (std::size_t i = 0; i < half.quads.size(); ++i)
    quads.push_back({half.ridges[i].folded[0], half.quads[i].z});
  if (!folded.symmetric) return quads;
  for (std::size_t i = half.quads.size(); i-- > 0;) {
    const auto mirrored = [](Vec3 v) -> Vec3 { return {-v.x(), v.y(), v.z()}; };
    quads.push_back({mirrored(quads[i].on), mirrored(quads[i].front)});
  }
  return quads;
}

/// Every quad is carried or bare, and every facet half the thickness behind (or before) its quad.
void expect_on_the_skin(const FoldedSlitSheet& folded, const Mould& mould, double side) {
  std::set<std::pair<int, int>> seen;
  for (const MouldRib& rib : mould.ribs) {
    const auto quads = quads_of(folded, rib.strip);
    for (std::size_t i = 0; i < rib.facets.size(); ++i) {
      const int quad = rib.first_quad + static_cast<int>(i);
      EXPECT_TRUE(seen.emplace(rib.strip, quad).second);
      for (const Vec3& corner : rib.facets[i]) {
        const Quad& above = quads[quad];
        EXPECT_NEAR((corner - above.on).dot(above.front), side * 0.5 * folded.thickness, 1e-9)
            << rib.strip << ' ' << quad;
      }
    }
  }
  for (const StripQuad& bare : mould.bare)
    EXPECT_TRUE(seen.emplace(bare.strip, bare.quad).second);
  std::size_t all = 0;
  for (const FoldedStrip& strip : folded.strips)
    all += strip.quads.size() * (folded.symmetric ? 2 : 1);
  EXPECT_EQ(seen.size(), all);
}

/// Of upright prisms below the facets, cut along a diagonal.
double volume_below(const Mould& mould) {
  double sum = 0.0;
  for (const MouldRib& rib : mould.ribs)
    for (const auto& facet : rib.facets)
      for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
        const Vec3 p = mould.base.local(facet[a]), q = mould.base.local(facet[b]),
                   r = mould.base.local(facet[c]);
        const Vec2 u = (q - p).head<2>(), v = (r - p).head<2>();
        sum += 0.5 * std::abs(u.x() * v.y() - u.y() * v.x()) * (p.z() + q.z() + r.z()) / 3.0;
      }
  return sum;
}

/// A level strip of 200 × 50 at a height of 100, in two quads, thickness 6.
FoldedSlitSheet level() {
  FoldedSlitSheet folded;
  folded.thickness = 6.0;
  folded.reach = 200.0;
  folded.symmetric = false;
  FoldedStrip strip;
  Frame frame;
  frame.x = -Vec3::UnitX();
  frame.y = Vec3::UnitZ();
  frame.z = Vec3::UnitY();
  frame.origin = Vec3(0, 100, 0);
  for (const double along : {0.0, 80.0, 200.0})
    strip.ridges.push_back({{Vec2(along, 0), Vec2(along, 50)},
                            {frame.point({along, 0}), frame.point({along, 50})},
                            Angle()});
  strip.quads = {frame, frame};
  folded.strips = {strip};
  return folded;
}

TEST(Mould, OfALevelStripIsABlock) {
  const Mould block = mould(level(), {.base = 30.0, .inset = 4.0});
  ASSERT_EQ(block.ribs.size(), 1u);
  EXPECT_NEAR(block.volume, 200 * 42 * 30.0, 1e-6);
  EXPECT_NEAR(block.base.origin.y(), 100 - 3 - 30.0, 1e-9);
  for (const auto& facet : block.ribs[0].facets)
    for (const Vec3& corner : facet)
      EXPECT_NEAR(corner.y(), 97.0, 1e-12);
  expect_closed(block.ribs[0].mesh);
}

TEST(Mould, KeepsAQuarterOfAStripUnderASheetThatIsThicker) {
  FoldedSlitSheet thick = level();
  thick.thickness = 60.0;  // more than the strip's width
  EXPECT_NEAR(mould(thick, {.base = 30.0}).volume, 200 * 12.5 * 30.0, 1e-6);
  EXPECT_EQ(code_of(thick, {.inset = 60.0}), code::bad_option);
}

TEST(Mould, OnTheFrontStandsAboveTheSheet) {
  const Mould block = mould(level(), {.side = MouldSide::front, .base = 30.0, .inset = 0.0});
  EXPECT_NEAR(block.volume, 200 * 50 * 30.0, 1e-6);
  EXPECT_NEAR(block.base.origin.y(), 100 + 3 + 30.0, 1e-9);
  expect_on_the_skin(level(), block, 1.0);
}

TEST(Mould, LiesOnTheSideOfTheGround) {
  EXPECT_EQ(mould(level()).side, MouldSide::back);
  FoldedSlitSheet turned = level();
  for (FoldedStrip& strip : turned.strips) {
    for (SlitRidge& ridge : strip.ridges)
      std::swap(ridge.folded[0], ridge.folded[1]);
    for (Frame& quad : strip.quads)
      quad.z = -quad.z;
  }
  const Mould below = mould(turned);
  EXPECT_EQ(below.side, MouldSide::front);
  EXPECT_NEAR(below.base.z.y(), 1.0, 1e-12);
  expect_closed(mesh_of(below));
  EXPECT_GT(below.volume, 0.0);
  EXPECT_NEAR(below.volume, mould(level()).volume, 1e-6);
}

TEST(Mould, OfAChairLiesHalfTheThicknessBelowEveryQuad) {
  const auto folded = solved(chair(), 1).folded();
  const Mould ribs = mould(folded);
  EXPECT_GE(ribs.ribs.size(), 6u);
  expect_on_the_skin(folded, ribs, -1.0);
  expect_closed(mesh_of(ribs));
  EXPECT_GT(ribs.volume, 0.0);
  EXPECT_NEAR(ribs.volume, volume_below(ribs), 1e-9 * ribs.volume);
  // The seat is carried; only what is upright beside the legs is not.
  EXPECT_LT(ribs.bare.size(), 6u * 2 * 4);
}

TEST(Mould, IsMirroredWithTheSheet) {
  const auto folded = solved(chair()).folded();
  const Mould ribs = mould(folded);
  std::map<int, double> sums;  // a rib that ends beside another strip has its image beyond the
                               // plane
  for (const MouldRib& rib : ribs.ribs)
    for (const auto& facet : rib.facets)
      for (const Vec3& corner : facet)
        sums[rib.strip] += corner.x();
  for (const auto& [strip, sum] : sums)
    EXPECT_NEAR(sum, 0.0, 1e-6) << strip;
}

TEST(Mould, OfStripsWithFreeEndsLiesOnTheirSkin) {
  SlitDesign design = asymmetric();
  // Strip 2 bows out and comes back above itself: no rib can stand there, seen from any side.
  const auto bowed = solved(design).folded();
  const Mould around = mould(bowed, {.inset = 2.0});
  expect_on_the_skin(bowed, around, -1.0);
  EXPECT_TRUE(std::ranges::any_of(around.bare, [](StripQuad quad) { return quad.strip == 2; }));
  design.ends[2].direction = Vec3(1, 0, 0);
  const auto folded = solved(design).folded();
  const Mould ribs = mould(folded, {.inset = 2.0});
  expect_on_the_skin(folded, ribs, -1.0);
  expect_closed(mesh_of(ribs));
  EXPECT_NEAR(ribs.volume, volume_below(ribs), 1e-9 * ribs.volume);
}

TEST(Mould, GrowsByItsBase) {
  const auto folded = solved(chair()).folded();
  const Mould low = mould(folded, {.base = 10.0}), high = mould(folded, {.base = 60.0});
  double area = 0.0;
  for (const MouldRib& rib : low.ribs)
    for (std::size_t i = 0; i < rib.footprint.size(); ++i) {
      const Vec2 &a = rib.footprint[i], &b = rib.footprint[(i + 1) % rib.footprint.size()];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  EXPECT_NEAR(high.volume - low.volume, 50.0 * area, 1e-6 * high.volume);
}

/// Two level strips of 50, the second so far behind and above the first.
FoldedSlitSheet two_levels(double behind, double above) {
  FoldedSlitSheet folded = level();
  folded.strips.push_back(folded.strips.front());
  FoldedStrip& high = folded.strips.back();
  for (auto& ridge : high.ridges)
    for (Vec3& p : ridge.folded)
      p += Vec3(0, above, behind);
  for (Frame& quad : high.quads)
    quad.origin += Vec3(0, above, behind);
  return folded;
}

/// The same, the first strip as long as the second one's first quad.
FoldedSlitSheet over_a_shorter_one(double behind, double above) {
  FoldedSlitSheet folded = two_levels(behind, above);
  folded.strips.front().ridges.pop_back();
  folded.strips.front().quads.pop_back();
  return folded;
}

TEST(Mould, CutsARibOffBesideALowerStrip) {
  // Seen from above they overlap by 12. Ribs are 6, the thickness, off their own strip's edges and
  // off others': of the upper one's 50 mm 12 + 6 and 6 go.
  const FoldedSlitSheet folded = two_levels(38, 40);
  const Mould narrow = mould(folded);
  expect_on_the_skin(folded, narrow, -1.0);
  EXPECT_NEAR(narrow.base.z.y(), 1.0, 1e-12);
  EXPECT_TRUE(narrow.bare.empty());
  EXPECT_NEAR(narrow.volume, 200 * (38 * 20 + 26 * 60.0), 1e-6);
  // An inset that is given is kept where nothing is in the way.
  EXPECT_NEAR(mould(folded, {.inset = 2.0}).volume, 200 * (46 * 20 + (50 - 12 - 3 - 2) * 60.0),
              1e-6);
}

TEST(Mould, NarrowsARibOnlyWhereAnotherStripLies) {
  // The lower strip is as long as the upper one's first quad, 80 of 200: the rib has its whole
  // width from the second's far end on, and tapers to it in the second.
  const FoldedSlitSheet folded = over_a_shorter_one(38, 40);
  const Mould taper = mould(folded);
  ASSERT_EQ(taper.ribs.size(), 2u);
  EXPECT_NEAR(taper.volume, 80 * 38 * 20.0 + (80 * 26 + 120 * 0.5 * (26 + 38)) * 60.0, 1e-6);
}

TEST(Mould, LeavesWhatLiesOnAnotherStripWithoutARib) {
  // The upper strip lies on the lower one, as long as its first quad, over its whole width.
  const FoldedSlitSheet folded = over_a_shorter_one(0, 6);
  const Mould resting = mould(folded);
  ASSERT_EQ(resting.ribs.size(), 2u);
  ASSERT_EQ(resting.bare.size(), 1u);
  EXPECT_EQ(resting.bare.front().strip, 1);
  EXPECT_EQ(resting.bare.front().quad, 0);
  EXPECT_NEAR(resting.base.z.y(), 1.0, 1e-12);
}

TEST(Mould, RefusesOptionsOutOfRange) {
  for (const MouldOptions& options :
       {MouldOptions{.up = Vec3(0, 0, 0)}, MouldOptions{.base = 0.0},
        MouldOptions{.base = std::nan("")}, MouldOptions{.inset = -1.0},
        MouldOptions{.inset = 25.0}, MouldOptions{.draft = Angle::degrees(0)}})
    EXPECT_EQ(code_of(level(), options), code::bad_option);
}

TEST(Mould, RefusesASheetThatNothingCanBeLaidOn) {
  EXPECT_EQ(code_of(level(), {.up = Vec3(0, -1, 0)}), code::unsupported_shape);
  EXPECT_EQ(code_of(level(), {.up = Vec3(1, 0, 0)}), code::unsupported_shape);
}

TEST(Mould, LeansRatherThanLetAStripHang) {
  // The second strip is 80 higher and overlaps the first, of its first quad's length, by 45: too
  // little of it is left for a rib there. Leaned by a it passes beside the lower one as soon as
  // that hides no more than 1 − 1/4 of the width less the clearance.
  const FoldedSlitSheet folded = over_a_shorter_one(5, 80);
  const Mould leaning = mould(folded);
  EXPECT_TRUE(leaning.bare.empty());
  EXPECT_LT(leaning.base.z.y(), 1.0 - 1e-6);
  expect_on_the_skin(folded, leaning, -1.0);
  const Mould upright = mould(folded, {.up = Vec3::UnitY()});
  ASSERT_EQ(upright.bare.size(), 1u) << "a direction that is given is kept";
  EXPECT_EQ(upright.bare.front().strip, 1);
}

TEST(Mould, RefusesStripsAboveOneAnother) {
  FoldedSlitSheet folded = level();
  folded.strips.push_back(folded.strips.front());
  for (auto& ridge : folded.strips.back().ridges)
    for (Vec3& p : ridge.folded)
      p.y() += 40.0;
  EXPECT_EQ(code_of(folded, {.up = Vec3::UnitY()}), code::unsupported_shape);
}

TEST(Mould, RefusesFoldsTighterThanTheSheetIsThick) {
  FoldedSlitSheet folded = level();
  folded.thickness = 500.0;
  // Folded downwards: the facets below lose 250 · tan 20° = 91 mm on both sides of the ridge, the
  // first has 80.
  FoldedStrip& strip = folded.strips.front();
  const Angle fold = Angle::degrees(40);
  const auto turned = [&](double angle, const Vec3& about) {
    Frame frame = strip.quads[0];
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    frame.x = turn * frame.x;
    frame.z = turn * frame.z;
    frame.origin = about + turn * (strip.quads[0].origin - about);
    return frame;
  };
  strip.quads[1] = turned(fold.radians(), strip.ridges[1].folded[0]);
  for (std::size_t side = 0; side < 2; ++side)
    strip.ridges[2].folded[side] = strip.quads[1].point(strip.ridges[2].flat[side]);
  EXPECT_EQ(code_of(folded, {.inset = 0.0}), code::radius_too_small);
}

}  // namespace
}  // namespace planish::test
