#include "support/sheets.hpp"

#include <planish/sheet/certificate.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/topology.hpp>

#include <gtest/gtest.h>

#include <numbers>

// A certificate looks at the pattern as it is written, so every damage to that must show.

namespace planish::test {
namespace {

using std::numbers::pi;

FlatPattern flattened(const Sheet& sheet, const FlattenOptions& options = {}) {
  auto pattern = flatten(sheet, options);
  EXPECT_TRUE(pattern) << (pattern ? "" : pattern.error().message);
  return std::move(*pattern);
}

Certificate certified(const Sheet& sheet, const FlatPattern& pattern) {
  auto certificate = certify(sheet, pattern, edge_distance(sheet));
  EXPECT_TRUE(certificate) << (certificate ? "" : certificate.error().message);
  return certificate.value_or(Certificate{});
}

/// 50 | crease | 30, width 40, t 2. Its mitred corner holds t² (tan α/2 − α/2) more than an arc of
/// material, per length.
Sheet creased(double degrees, BendDirection direction) {
  const Angle angle = Angle::degrees(degrees);
  Sheet sheet = strip({Straight{50}, Crease{angle, direction}, Straight{30}}, 40, 2);
  const double half = 0.5 * angle.radians();
  sheet.mitres_volume = 40 * 4 * (std::tan(half) - half);
  return sheet;
}

const std::vector<Sheet>& samples() {
  static const std::vector<Sheet> sheets{l_bracket(),
                                         l_bracket_down(),
                                         z_profile(),
                                         hem(),
                                         turn_of_250(),
                                         two_turns_of_270(),
                                         rolled(),
                                         box(),
                                         cone_joined(),
                                         staircase(6),
                                         plate_with_holes(),
                                         hole_in_bend(6.0, 0.44),
                                         hole_across_bend(30.0, 0.44),
                                         slot_across_bend(),
                                         truncated_cone(30, 50, 40, Angle::degrees(300), 1.5),
                                         lofted_corner({}),
                                         creased(90.0, BendDirection::up),
                                         creased(60.0, BendDirection::down),
                                         creased(120.0, BendDirection::down)};
  return sheets;
}

TEST(Certificate, IsCleanForARightPatternWhateverItsKAndItsSide) {
  for (const Sheet& sheet : samples())
    for (const double k : {0.2, 0.44, 0.5})
      for (const UpSide up : {UpSide::reference, UpSide::other}) {
        const Certificate certificate = certified(
            sheet, flattened(sheet, {.allowance = ConstantK{k, "test"}, .up = up}));
        EXPECT_NEAR(*certificate.explained_ratio, 1.0, 1e-6);
        EXPECT_LT(*certificate.refold_deviation, 2e-3);
        EXPECT_LT(certificate.length_error, 1e-4);
      }
}

TEST(Certificate, NeedsNothingOfWhatThePatternWasMadeFrom) {
  for (const Sheet& sheet : samples()) {
    FlatPattern pattern = flattened(sheet);
    const Certificate before = certified(sheet, pattern);
    pattern.outer.origins.clear();
    for (Contour& opening : pattern.openings)
      opening.origins.clear();
    pattern.area = pattern.perimeter = pattern.closure = 0.0;
    const Certificate after = certified(sheet, pattern);
    EXPECT_EQ(after.volume_ratio, before.volume_ratio);
    EXPECT_EQ(after.refold_deviation, before.refold_deviation);
  }
}

TEST(Certificate, MeasuresTheAreaThatIsWritten) {
  const Sheet sheet = plate_with_holes();  // one hole is a circle of radius 5
  FlatPattern pattern = flattened(sheet);
  const double area = pattern.area;
  std::erase_if(pattern.openings, [](const Contour& opening) {
    return std::abs(signed_area(opening.loop) + pi * 25.0) < 1e-6;
  });
  ASSERT_EQ(pattern.openings.size(), 2u);
  EXPECT_NEAR(*certified(sheet, pattern).volume_ratio, (area + pi * 25.0) / area, 1e-9);
}

TEST(Certificate, MissesAnOpeningThatWasLost) {
  for (const Sheet& sheet : {plate_with_holes(), hole_in_bend(6.0, 0.44)}) {
    FlatPattern pattern = flattened(sheet);
    pattern.openings.pop_back();
    EXPECT_GT(*certified(sheet, pattern).refold_deviation, 1.0);
  }
}

TEST(Certificate, SeesAnOpeningThatNoBorderGave) {
  const Sheet sheet = l_bracket();
  FlatPattern pattern = flattened(sheet);
  pattern.openings.push_back({circular_opening({20, 20}, 3.0), {}});
  // The middle of the circle is 20 from the nearest edge.
  EXPECT_NEAR(*certified(sheet, pattern).refold_deviation, 20.0, 3.0);
}

TEST(Certificate, SeesAnOpeningThatNoBorderGaveBesideASharpBend) {
  // The band of the bend explains nothing that lies 15 from it.
  const Sheet sheet = creased(90.0, BendDirection::up);
  FlatPattern pattern = flattened(sheet);
  const Box2 box = bounds(pattern.outer.loop);
  const Vec2 middle = 0.5 * (box.lo + box.hi);
  for (const double side : {-15.0, 15.0}) {
    FlatPattern wrong = pattern;
    wrong.openings.push_back({circular_opening(middle + Vec2(side, 0.0), 3.0), {}});
    EXPECT_GT(*certified(sheet, wrong).refold_deviation, 10.0);
  }
}

TEST(Certificate, SeesAnOpeningInAnotherPlace) {
  const Sheet sheet = plate_with_holes();
  FlatPattern pattern = flattened(sheet);
  for (Contour& opening : pattern.openings)
    for (Curve2& curve : opening.loop)
      if (auto* arc = std::get_if<Arc>(&curve)) arc->center.x() += 0.3;
  EXPECT_NEAR(*certified(sheet, pattern).refold_deviation, 0.3, 0.05);
}

TEST(Certificate, SeesABendThatIsLaidOutWithAnotherAllowanceThanItStates) {
  // 90°, t 2: the flange behind the bend is off by π/2 · 2 · 0.1.
  const Sheet sheet = l_bracket();
  FlatPattern pattern = flattened(sheet, {.allowance = ConstantK{0.44, "test"}});
  pattern.bends.front().allowance.k_factor = 0.34;
  EXPECT_NEAR(*certified(sheet, pattern).refold_deviation, pi / 2 * 2.0 * 0.1, 1e-6);
}

TEST(Certificate, SeesACreaseThatIsLaidOutWithAnotherAllowanceThanItStates) {
  const Sheet sheet = creased(90.0, BendDirection::up);
  FlatPattern pattern = flattened(sheet);
  pattern.bends.front().allowance.allowance += 0.25;
  EXPECT_NEAR(*certified(sheet, pattern).refold_deviation, 0.25, 1e-6);
}

TEST(Certificate, SeesAWallInTheWrongPlace) {
  // The wall of a box whose corners lie beyond x moves by 0.4, with its outline.
  const Sheet sheet = box();
  FlatPattern pattern = flattened(sheet);
  const double limit = 0.9 * bounds(pattern.outer.loop).hi.x();
  const auto moved = [&](Vec2& p) {
    if (p.x() > limit) p.x() += 0.4;
  };
  for (Curve2& curve : pattern.outer.loop) {
    auto& line = std::get<Segment>(curve);
    moved(line.a);
    moved(line.b);
  }
  EXPECT_NEAR(*certified(sheet, pattern).refold_deviation, 0.4, 1e-6);
}

TEST(Certificate, SeesARootThatLiesElsewhere) {
  const Sheet sheet = l_bracket();
  FlatPattern pattern = flattened(sheet);
  pattern.root_placement = Eigen::Translation2d(0.2, 0.0) * pattern.root_placement;
  EXPECT_NEAR(*certified(sheet, pattern).refold_deviation, 0.2, 1e-6);
}

TEST(Certificate, RefusesAPatternThatLeavesOutABendOrItsContour) {
  const Sheet sheet = u_channel();
  FlatPattern pattern = flattened(sheet);
  pattern.bends.pop_back();
  const auto without_bend = certify(sheet, pattern, edge_distance(sheet));
  ASSERT_FALSE(without_bend);
  EXPECT_EQ(without_bend.error().code, code::pattern_wrong);
  EXPECT_NE(without_bend.error().message.find("B2"), std::string::npos);
  const auto empty = certify(sheet, FlatPattern{}, edge_distance(sheet));
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, code::pattern_wrong);
}

TEST(Certificate, KnowsWhatItCouldNotMeasure) {
  Sheet sheet = l_bracket();
  const FlatPattern pattern = flattened(sheet);
  sheet.volume.reset();
  const auto certificate = certify(sheet, pattern, {});
  ASSERT_TRUE(certificate);
  EXPECT_FALSE(certificate->volume_ratio);
  EXPECT_FALSE(certificate->explained_ratio);
  EXPECT_FALSE(certificate->refold_deviation);
}

TEST(Certificate, AsksForTheDistanceOfEachFreeBordersEdgeAndOfNoOther) {
  const Sheet sheet = l_bracket();
  const FlatPattern pattern = flatten(sheet).value();
  const Topology topology(sheet);
  for (const BorderId id : topology.borders()) {
    const int edge = *sheet[topology[id]].edge;
    const EdgeDistance off = [&](int asked, const Vec3&) { return asked == edge ? 0.37 : 0.0; };
    const auto certificate = certify(sheet, pattern, off);
    ASSERT_TRUE(certificate) << certificate.error().message;
    EXPECT_NEAR(*certificate->refold_deviation, topology.is_free(id) ? 0.37 : 0.0, 1e-6) << edge;
  }
}

}  // namespace
}  // namespace planish::test
