#include "slit/sample_sheets.hpp"

#include <planish/slit/codes.hpp>
#include <planish/slit/scans.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace planish::test {
namespace {

/// Points on the strips of a folded sheet, half a millimetre off at most, those of all strips in
/// disorder and every second one on the other half; with points on the panel between them.
struct Cloud {
  explicit Cloud(const FoldedSlitSheet& sheet) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0), noise(-0.5, 0.5);
    const auto add = [&](Vec3 p, int strip) {
      p += Vec3(noise(random), noise(random), noise(random));
      if (points.size() % 2 == 0) p.x() = -p.x();
      points.push_back(p);
      strips.push_back(strip);
    };
    for (int s = 0; s < std::ssize(sheet.strips); ++s) {
      const auto& ridges = sheet.strips[s].ridges;
      for (int i = 0; i < 2000; ++i) {
        const double at = share(random) * static_cast<double>(ridges.size() - 1);
        const int row = std::min(static_cast<int>(at), static_cast<int>(ridges.size()) - 2);
        const double t = at - static_cast<double>(row), u = 0.02 + 0.96 * share(random);
        const auto on = [&](const SlitRidge& ridge) -> Vec3 {
          return (1.0 - u) * ridge.folded[0] + u * ridge.folded[1];
        };
        add((1.0 - t) * on(ridges[row]) + t * on(ridges[row + 1]), s);
      }
    }
    for (const PanelFacet& facet : sheet.panel)
      for (int i = 0; i < 500; ++i) {
        const double t = 0.02 + 0.9 * share(random), u = share(random);
        add(facet.frame.point((1.0 - t) * ((1.0 - u) * facet.corners[0] + u * facet.corners[3]) +
                              t * ((1.0 - u) * facet.corners[1] + u * facet.corners[2])),
            -1);
      }
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::ranges::shuffle(order, random);
    const auto old = *this;
    for (std::size_t i = 0; i < order.size(); ++i) {
      points[i] = old.points[order[i]];
      strips[i] = old.strips[order[i]];
    }
  }
  std::vector<Vec3> points;
  std::vector<int> strips;  ///< −1: of the panel
};

SlitDesign bent_chair() {
  SlitDesign known = chair();
  known.anchors = {{1, 5, StripEdge::left,
                    solved(chair()).folded().strips[1].ridges[5].folded[0] + Vec3(0, 25, 0)}};
  known.weights.anchors = 1.0;
  return known;
}

TEST(Scans, GivePointsToTheStripsOnWhichTheyLie) {
  const FoldedSlitSheet sheet = solved(bent_chair(), 1).folded();
  const Cloud cloud(sheet);
  const auto scans = by_strip(cloud.points, sheet);
  ASSERT_EQ(scans.size(), sheet.strips.size());
  std::size_t all = 0;
  for (const SlitScan& scan : scans) {
    const auto own = std::ranges::count(cloud.strips, *scan.strip);
    EXPECT_NEAR(static_cast<double>(scan.points.size()), static_cast<double>(own), 40.0);
    all += scan.points.size();
    for (const Vec3& p : scan.points)
      EXPECT_GT(p.x() * sheet.strips[0].ridges[0].folded[0].x(), 0.0) << "on the modelled half";
  }
  EXPECT_NEAR(static_cast<double>(all), 2000.0 * static_cast<double>(sheet.strips.size()), 40.0)
      << "and none of the panel";
}

TEST(Scans, LeaveOutWhatIsFar) {
  const FoldedSlitSheet sheet = solved(chair()).folded();
  const Vec3 near = sheet.strips[0].quads[3].point(
      0.5 * (sheet.strips[0].ridges[3].flat[0] + sheet.strips[0].ridges[4].flat[1]));
  EXPECT_EQ(by_strip({near, near + Vec3(0, 3000, 0)}, sheet, 100.0).front().points.size(), 1u);
  EXPECT_EQ(by_strip(std::vector<Vec3>(500'001, near), sheet).front().points.size(), 166'667u);
}

/// From the shape without a scan, a cloud of all strips leads as near to its points as scans do
/// that name their strips.
TEST(Scans, OfNoStripAreFollowed) {
  const FoldedSlitSheet sheet = solved(bent_chair(), 1).folded();
  const Cloud cloud(sheet);
  SlitDesign named = chair();
  named.weights.scan = 1.0;
  SlitDesign unnamed = named;
  unnamed.scans = {{std::nullopt, cloud.points}};
  for (int s = 0; s < std::ssize(sheet.strips); ++s) {
    SlitScan& scan = named.scans.emplace_back(SlitScan{s, {}});
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      if (cloud.strips[i] != s) continue;
      scan.points.push_back(cloud.points[i]);
      scan.points.back().x() = std::copysign(cloud.points[i].x(),
                                             sheet.strips[0].ridges[0].folded[0].x());
    }
  }
  const SlitSession wanted = solved(named);
  EXPECT_TRUE(has_cloud(unnamed));
  EXPECT_FALSE(has_cloud(named));
  auto session = SlitSession::start(unnamed);
  ASSERT_TRUE(session);
  ASSERT_TRUE(follow_scans(*session, unnamed, false));
  for (int s = 0; s < session->strip_count(); ++s) {
    EXPECT_GT(session->scan(s).size(), 1980u) << s;
    EXPECT_LE(session->scan(s).size(), 2000u) << s;
    EXPECT_LT(session->state(s).scan_distance, wanted.state(s).scan_distance + 0.5) << s;
  }
}

TEST(Scans, SayWhereNoPointIsNear) {
  SlitDesign design = chair();
  design.scans = {{std::nullopt, {Vec3(0, 1e6, 0)}}};
  auto session = SlitSession::start(design);
  ASSERT_TRUE(session);
  const auto followed = follow_scans(*session, design, false);
  ASSERT_FALSE(followed);
  EXPECT_EQ(followed.error().code, code::empty_scan);
}

}  // namespace
}  // namespace planish::test
