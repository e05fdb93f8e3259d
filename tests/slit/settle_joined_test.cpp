#include "settle_joined.hpp"

#include "sample_sheets.hpp"

#include <planish/slit/slit_curves.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

// Where the uncut sheet beyond slits that end in the middle of it comes to lie, against strips
// whose shape is known, differences, and sheets turned about.

namespace planish::test {
namespace {

using namespace slit_detail;

SlitDesign with_slits(SlitDesign design, double width, std::vector<std::vector<Vec2>> slits) {
  auto strips = strips_between(design.sheet, {std::move(slits), {}, width});
  if (!strips) throw std::runtime_error(strips.error().message);
  design.sheet.strips = *strips;
  return design;
}

/// Four strips over a bowed leg, joined before the symmetry plane.
SlitDesign joined_chair() {
  SlitDesign design = chair();
  design.seat_curve.reset();
  design.sheet.thickness = 2.0;
  design.leg_curve = {{{300, 0}, {312, 80}, {312, 160}, {300, 240}}};
  design.fit = true;
  return with_slits(design, 240.0,
                    {{{420, 60}, {820, 60}}, {{420, 120}, {850, 120}}, {{420, 180}, {830, 180}}});
}

/// Three strips, joined at a free end that is placed.
SlitDesign placed() {
  SlitDesign design = arcade();
  design.second_panel.reset();
  design.sheet.half_length = 600.0;
  design.leg_curve = {{{300, 0}, {310, 60}, {310, 120}, {300, 180}}};
  design.fit = true;
  design.ends.resize(3);
  design.ends[1].position = Vec3(-50, 350, 90);
  design.ends[1].direction = Vec3(-1, -0.3, 0);
  return with_slits(design, 180.0, {{{200, 60}, {700, 60}}, {{220, 120}, {690, 120}}});
}

/// What `solve` has found, as a snapshot of its own.
Snapshot settled(const SlitDesign& asked) {
  SlitDesign design = asked;
  if (design.fit) {
    const SlitSession session = solved(asked);
    design.leg_curve = session.design().leg_curve;
    design.fit = false;
  }
  Snapshot now;
  design.ends.resize(design.sheet.strips.size());
  now.design = std::make_shared<const SlitDesign>(design);
  now.panel = std::make_shared<const std::vector<PanelFacet>>(started(design).folded().panel);
  now.second_panel = std::make_shared<const std::vector<PanelFacet>>();
  for (std::size_t i = 0; i < design.sheet.strips.size(); ++i)
    now.slots.push_back(std::make_shared<const Slot>());
  for (const auto& [first, last] : joined_strips(design.sheet))
    now.joined.push_back({first, last, {}, std::vector<double>(last - first)});
  settle_joined(now, 0, {});
  return now;
}

/// Steps of moves, mm or radians.
JoinedEnds beside(const Snapshot& now, std::size_t move, double by) {
  const SlitSheet& sheet = now.design->sheet;
  const auto moves = moves_of(facets_of(sheet, now.joined[0]), sheet.symmetric);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(moves.size()));
  step[static_cast<Eigen::Index>(move)] = by;
  return moved(sheet, now.joined[0], sheet.symmetric, step);
}

DescentOptions finely() {
  return {200, 1e-14, [] { return false; }};
}

TEST(SettleJoined, SlopeIsThatOfTheEnergy) {
  SlitDesign design = joined_chair();
  design.material = SlitMaterial{210000, 0.3, 7.85, 235.0};
  design.gravity = true;
  const Snapshot now = settled(design);
  const JoinedEnds off = beside(now, 2, 0.05);
  const JoinedPlace at = joined_place(now, 0, off, finely());
  ASSERT_TRUE(at.met);
  ASSERT_EQ(at.slope.size(), 6);
  for (std::size_t k = 0; k < 6; ++k) {
    const double small = k < 2 ? 0.05 : 2e-4;
    const auto value = [&](double by) {
      return joined_place(at.now, 0, beside(at.now, k, by), finely()).value;
    };
    const double slope = (value(small) - value(-small)) / (2.0 * small);
    EXPECT_NEAR(at.slope[static_cast<Eigen::Index>(k)], slope,
                2e-4 * std::abs(slope) + 1e-7 * at.value)
        << k;
  }
}

TEST(SettleJoined, EnergyIsLeast) {
  const Snapshot now = settled(joined_chair());
  const double least = joined_place(now, 0, now.joined[0], finely()).value;
  for (std::size_t k = 0; k < 6; ++k)
    for (const double sign : {-1.0, 1.0}) {
      const double by = sign * (k < 2 ? 1.0 : 0.01);
      const JoinedPlace at = joined_place(now, 0, beside(now, k, by), finely());
      if (at.met) {
        EXPECT_GT(at.value, least) << k << ' ' << sign;
      }
    }
}

/// Equal strips over a straight leg bend as they would apart: like a strip that ends before the
/// plane at a right angle, on its own panel that much nearer to it.
TEST(SettleJoined, EqualStripsBendLikeOneThatIsShorter) {
  SlitDesign design = small_chair();
  design.ridges = 20;
  design = with_slits(design, 120.0, {{{420, 60}, {814, 60}}});
  const SlitSession joined = solved(design);
  SlitDesign shorter = small_chair();
  shorter.ridges = 20;
  shorter.sheet.half_length = 394.0;
  shorter.leg_curve = {{{290, 0}, {290, 120}}};
  const SlitSession apart = solved(shorter);
  // A fold into the facet is one ridge more, half of whose quad would belong to the one before.
  for (int strip = 0; strip < 2; ++strip)
    EXPECT_NEAR(joined.state(strip).energy, apart.state(strip).energy,
                3e-3 * apart.state(strip).energy);
  const FoldedSlitSheet folded = joined.folded();
  ASSERT_EQ(folded.second_panel.size(), 2u);
  EXPECT_NEAR((folded.second_panel[0].frame.z - folded.second_panel[1].frame.z).norm(), 0.0, 1e-6);
  for (const PanelFacet& facet : folded.second_panel)
    for (const std::size_t corner : {0u, 3u})
      EXPECT_NEAR(facet.frame.point(facet.corners[corner]).x(), 0.0, 1e-12 * 884);
}

TEST(SettleJoined, MirroredSheetGivesTheMirroredForm) {
  const SlitDesign design = joined_chair();
  SlitDesign turned = design;
  turned = with_slits(turned, 240.0,
                      {{{420, 60}, {830, 60}}, {{420, 120}, {850, 120}}, {{420, 180}, {820, 180}}});
  const SlitSession one = solved(design), other = solved(turned);
  for (int strip = 0; strip < 4; ++strip)
    EXPECT_NEAR(one.state(strip).energy, other.state(3 - strip).energy,
                1e-4 * one.state(strip).energy)
        << strip;
  // Of all together the least is sought, which shows an error of the place by its square.
  const auto least = [](const SlitDesign& of) {
    const Snapshot now = settled(of);
    return joined_place(now, 0, now.joined[0], finely()).value;
  };
  EXPECT_NEAR(least(design), least(turned), 1e-8 * least(design));
}

TEST(SettleJoined, PlacedEndIsMet) {
  const SlitSession session = solved(placed(), 1);
  const FoldedSlitSheet folded = session.folded();
  ASSERT_EQ(folded.second_panel.size(), 3u);
  const auto& last = folded.strips[1].ridges.back().folded;
  EXPECT_NEAR((0.5 * (last[0] + last[1]) - Vec3(-50, 350, 90)).norm(), 0.0, 1e-9 * 600);
  EXPECT_NEAR(folded.second_panel[1].frame.x.dot(Vec3(-1, -0.3, 0).normalized()), 1.0, 1e-12);
  for (int strip = 0; strip < 3; ++strip) {
    EXPECT_EQ(session.state(strip).status, StripStatus::solved);
    EXPECT_LE(session.state(strip).gap, 1e-9 * 600);
  }
}

std::set<std::pair<int, int>> sides_in(const Mesh& mesh) {
  std::set<std::pair<int, int>> sides;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sides.insert(std::minmax({t[i], t[(i + 1) % 3]}));
  return sides;
}

/// Triangles of one sheet share corners: a disc with a hole for each slit.
TEST(SettleJoined, IsOneSheetWithHolesWhereItIsSlit) {
  for (const auto& [design, slits] : {std::pair{joined_chair(), 6}, std::pair{placed(), 2}}) {
    const FoldedSlitSheet folded = solved(design).folded();
    const Mesh mesh = mesh_of(folded);
    EXPECT_EQ(std::ssize(mesh.points) - std::ssize(sides_in(mesh)) + std::ssize(mesh.triangles),
              1 - slits);
    const Sheet sheet = sheet_of(folded);
    EXPECT_EQ(parts_of(folded).size(), sheet.faces.size());
  }
}

TEST(SettleJoined, EditOfOneStripMovesItsRunOnly) {
  SlitDesign design = joined_chair();
  design = with_slits(design, 240.0,
                      {{{420, 60}, {820, 60}}, {{420, 120}, {884, 120}}, {{420, 180}, {830, 180}}});
  SlitSession session = solved(design);
  const FoldedSlitSheet before = session.folded();
  SlitDesign edited = design;
  edited.anchors.push_back({3, 5, StripEdge::left, Vec3(200, 560, 200)});
  ASSERT_TRUE(session.set_design(edited));
  ASSERT_TRUE(session.solve());
  const FoldedSlitSheet after = session.folded();
  for (int strip = 0; strip < 4; ++strip) {
    const double moved_by = (after.strips[strip].ridges.back().folded[0] -
                             before.strips[strip].ridges.back().folded[0])
                                .norm();
    if (strip < 2)
      EXPECT_EQ(moved_by, 0.0);
    else
      EXPECT_GT(moved_by, 0.01);
  }
}

/// With a panel at both ends it does not matter which is called the second.
TEST(SettleJoined, SecondPanelTurnedAboutGivesTheSameStrips) {
  SlitDesign one = arcade();
  one.second_panel->lean = Angle::degrees(15);
  one.sheet.half_length = 1000.0;
  SlitDesign other = arcade();
  other.lean = Angle::degrees(15);
  one = with_slits(one, 180.0, {{{230, 60}, {1150, 60}}, {{260, 120}, {1120, 120}}});
  other = with_slits(other, 180.0, {{{280, 60}, {1140, 60}}, {{250, 120}, {1170, 120}}});
  one.ridges = other.ridges = 16;
  const SlitSession a = solved(one), b = solved(other);
  for (int strip = 0; strip < 3; ++strip) {
    EXPECT_EQ(a.state(strip).status, StripStatus::solved);
    EXPECT_LE(a.state(strip).gap, 1e-9 * 1000);
    EXPECT_NEAR(a.state(strip).energy, b.state(2 - strip).energy, 5e-3 * a.state(strip).energy)
        << strip;
  }
}

TEST(SettleJoined, WhatIsNotJoinedIsRefused) {
  const auto refused = [](const SlitDesign& design) {
    const auto session = SlitSession::start(design);
    return session ? std::string("made") : session.error().message;
  };
  SlitDesign alone = chair();
  alone.sheet.strips[2].right_end = 800.0;
  EXPECT_NE(refused(alone).find("joins it to no neighbour"), std::string::npos);
  alone.sheet.strips[3].left_end = 810.0;
  EXPECT_NE(refused(alone).find("joins it to no neighbour"), std::string::npos);
  alone.sheet.strips[3].left_end = 800.0;
  EXPECT_EQ(refused(alone), "made");
  SlitDesign smooth = joined_chair();
  smooth.objective = SlitObjective::smooth;
  EXPECT_NE(refused(smooth).find("least energy"), std::string::npos);
  SlitDesign level = joined_chair();
  level.end_angle = EndAngle::level;
  EXPECT_NE(refused(level).find("right angle"), std::string::npos);
  SlitDesign gap = joined_chair();
  gap.coupling = SlitCoupling{0.003, {{0.0, 5.0}}};
  EXPECT_NE(refused(gap).find("uncut sheet joins them"), std::string::npos);
}

}  // namespace
}  // namespace planish::test
