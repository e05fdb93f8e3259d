#include "sample_sheets.hpp"
#include "sample_strips.hpp"

#include <planish/slit/codes.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <algorithm>
#include <set>
#include <utility>

// Sheets with a panel at both ends of their strips, and panels that lean.

namespace planish::test {
namespace {

SlitDesign uneven() {
  SlitDesign design = arcade();
  design.sheet.strips[1].end = 1150.0;
  design.sheet.strips[2].left_start = 220.0;
  design.leg_curve = {{{250, 0}, {290, 60}, {290, 130}, {240, 200}}};
  design.fit = true;
  design.lean = Angle::degrees(15);
  design.second_panel = SecondPanel{{{{-250, 40}, {-330, 250}}}, 120.0, Angle::degrees(-30), true};
  return design;
}

TEST(TwoPanels, HoldBothEndsOfEveryStrip) {
  for (const SlitDesign& design : {arcade(), uneven()}) {
    const SlitSession session = solved(design, 1);
    const FoldedSlitSheet folded = session.folded();
    for (int strip = 0; strip < session.strip_count(); ++strip) {
      EXPECT_EQ(session.state(strip).status, StripStatus::solved) << strip;
      EXPECT_LE(session.state(strip).gap, 1e-9 * 1200) << strip;
      const auto facet = std::ranges::find_if(
          folded.second_panel, [&](const PanelFacet& f) { return f.strip == strip; });
      ASSERT_NE(facet, folded.second_panel.end());
      for (std::size_t side = 0; side < 2; ++side) {
        const SlitRidge& last = folded.strips[strip].ridges.back();
        EXPECT_NEAR((last.folded[side] - facet->frame.point(facet->corners[1 + side])).norm(), 0.0,
                    1e-9 * 1200);
        EXPECT_NEAR((last.flat[side] - facet->corners[1 + side]).norm(), 0.0, 1e-12 * 1200);
      }
    }
  }
}

// Both panels are alike, so is the strip from each of them: its other half is its mirror image.
TEST(TwoPanels, ThatAreAlikeGiveAFormThatIsSymmetric) {
  const SlitSession session = solved(arcade());
  for (const FoldedStrip& strip : session.folded().strips) {
    const std::size_t last = strip.ridges.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
      for (std::size_t side = 0; side < 2; ++side) {
        const Vec3 p = strip.ridges[i].folded[side], q = strip.ridges[last - i].folded[side];
        EXPECT_NEAR((p - Vec3(-q.x(), q.y(), q.z())).norm(), 0.0, 1.0) << i;
      }
    EXPECT_NEAR(strip.ridges.front().fold.degrees(), strip.ridges.back().fold.degrees(), 0.5);
  }
}

std::set<std::pair<int, int>> lines_of(const Mesh& mesh) {
  std::set<std::pair<int, int>> lines;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      lines.insert(std::minmax({t[i], t[(i + 1) % 3]}));
  return lines;
}

TEST(TwoPanels, AreOneSheetWithTheStrips) {
  const FoldedSlitSheet folded = solved(uneven()).folded();
  const Sheet sheet = sheet_of(folded);
  const auto parts = parts_of(folded);
  ASSERT_EQ(parts.size(), sheet.faces.size());
  EXPECT_EQ(std::ranges::count_if(
                parts, [](const SlitPart& part) { return part.strip == SlitPart::kSecondPanel; }),
            3);
  // The whole rectangle of 180 by 200 + 1000 + 120.
  double area = 0.0;
  for (const FaceId id : sheet.faces.ids()) {
    std::vector<Vec2> corners;
    for (const Border& border : sheet[id].loops.front())
      corners.push_back(start_of(border.curve));
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
      twice += p.x() * q.y() - p.y() * q.x();
    }
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
  }
  EXPECT_NEAR(area, 180.0 * 1320.0, 1e-6);
  const Mesh mesh = mesh_of(folded);
  for (const auto& t : mesh.triangles) {
    const Vec3 u = mesh.points[t[1]] - mesh.points[t[0]], v = mesh.points[t[2]] - mesh.points[t[0]];
    EXPECT_GT(u.cross(v).norm(), 1e-3);  // none is flat beside a corner of a lower neighbour
  }
  // Euler: a disc with two slits in it.
  EXPECT_EQ(std::ssize(mesh.points) - std::ssize(lines_of(mesh)) + std::ssize(mesh.triangles), -1);
}

TEST(TwoPanels, OutOfReachAreRefused) {
  SlitDesign far = arcade();
  far.second_panel->leg_curve = {{{-800, 0}, {-800, 180}}};
  const auto refused = SlitSession::start(far);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::out_of_reach);  // 1100 mm apart, strips of 1000
  EXPECT_EQ(refused.error().where, "/second_panel");
  EXPECT_NE(refused.error().message.find("100 mm out of reach"), std::string::npos);

  SlitDesign both = arcade();
  both.ends.resize(1);
  both.ends[0].position = Vec3(0, 200, 0);
  EXPECT_EQ(SlitSession::start(both).error().code, code::bad_option);
  SlitDesign symmetric = arcade();
  symmetric.sheet.symmetric = true;
  EXPECT_EQ(SlitSession::start(symmetric).error().where, "/second_panel");
  SlitDesign beyond = arcade();
  beyond.sheet.strips[2].end = 1400.0;  // the free edge
  EXPECT_EQ(SlitSession::start(beyond).error().where, "/sheet/strips/2/end");
}

TEST(TwoPanels, MovedReopenTheStrips) {
  SlitSession session = solved(arcade());
  ASSERT_TRUE(session.set_design(session.design()));
  EXPECT_EQ(session.state(0).status, StripStatus::solved);
  SlitDesign moved = arcade();
  moved.second_panel->lean = Angle::degrees(10);
  ASSERT_TRUE(session.set_design(moved));
  EXPECT_EQ(session.state(0).status, StripStatus::open);
}

TEST(StripDerivatives, OfTheFoldIntoAPanelAreDifferences) {
  StripProblem problem = problem_with_everything(7);
  problem.far_facet = frame_from_axes({0, 0, 0}, Vec3(0.1, 0.9, 0.3).normalized(), {1, 0.2, 0.5});
  for (unsigned seed = 0; seed < 5; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.4);
    const auto [full, expected] = derivatives_of(problem, p);
    const Eigen::Index row = problem.base.quads - 2 + 1;  // after second differences and the mirror
    EXPECT_LE((full.row(row) - expected.row(row)).cwiseAbs().maxCoeff(),
              1e-6 * full.row(row).cwiseAbs().maxCoeff())
        << seed;
  }
}

TEST(LeaningPanel, LevelWithTheGroundStartsItsStripsThere) {
  SlitDesign design = chair();
  design.leg_curve = {{{700, 0}, {700, 360}}};
  design.lean = Angle::degrees(90);
  design.sheet.half_length = 700.0;
  const SlitSession session = solved(design);
  const FoldedSlitSheet folded = session.folded();
  for (int strip = 0; strip < session.strip_count(); ++strip) {
    EXPECT_EQ(session.state(strip).status, StripStatus::solved) << strip;
    const auto& first = folded.strips[strip].ridges.front().folded;
    EXPECT_NEAR((first[0] - Vec3(280, 0, 60 * strip)).norm(), 0.0, 1e-9);
    for (const Vec3& end : folded.strips[strip].ridges.back().folded) {
      EXPECT_NEAR(end.x(), 0.0, 1e-9 * 1120);
      EXPECT_GT(end.y(),
                100.0);  // the seat curve is at 300 and above: upwards, not into the ground
    }
  }
}

TEST(LeaningPanel, StaysOnItsSideOfTheSymmetryPlane) {
  SlitDesign design = chair();
  design.lean = Angle::degrees(90);  // 420 high, 360 from the plane
  const auto refused = SlitSession::start(design);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::invalid_input);
  design.lean = Angle::degrees(91);
  EXPECT_EQ(SlitSession::start(design).error().where, "/leg_curve/lean");
}

}  // namespace
}  // namespace planish::test
