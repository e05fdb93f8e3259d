#include "slit_drafts.hpp"

#include "slit/sample_sheets.hpp"

#include <planish/slit/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

SlitFile draft_file() {
  SlitFile file;
  file.design = test::small_chair();
  return file;
}

TEST(SlitDrafts, FollowADesignAndKeepTheLastThatWasRight) {
  SlitDrafts drafts;
  ASSERT_TRUE(drafts.follow(draft_file(), {}));
  EXPECT_EQ(drafts.now().strip_count(), 2);
  EXPECT_TRUE(drafts.scan_motion().isApprox(Eigen::Isometry3d::Identity()));
  SlitFile moved = draft_file();
  moved.design.leg_curve = {{{380, 0}, {380, 120}}};
  ASSERT_TRUE(drafts.follow(moved, {}));
  EXPECT_EQ(drafts.now().design().leg_curve.poles[0], Vec2(380, 0));
  SlitFile wrong = draft_file();
  wrong.design.leg_curve = {{{360, 0}, {360, 50}}};
  EXPECT_EQ(drafts.follow(wrong, {}).error().code, code::curve_too_short);
  EXPECT_EQ(drafts.now().design().leg_curve.poles[0], Vec2(380, 0));
}

TEST(SlitDrafts, MoveScansAsTheyDidFirst) {
  const SlitFile plain = draft_file();
  SlitDrafts straight;
  ASSERT_TRUE(straight.follow(plain, {}));
  SlitFile scanned = plain;
  scanned.align_scans = true;
  const auto folded = straight.now().folded();
  for (int s = 0; s < 2; ++s) {
    SlitScan scan{s, {}};
    for (const SlitRidge& ridge : (s == 0 ? folded.strips.front() : folded.strips.back()).ridges)
      for (const Vec3& p : ridge.folded)
        scan.points.push_back(p + Vec3(3, 0, 0));
    scanned.design.scans.push_back(scan);
  }
  SlitDrafts drafts;
  ASSERT_TRUE(drafts.follow(scanned, {}));
  const Eigen::Isometry3d motion = drafts.scan_motion();
  EXPECT_FALSE(motion.isApprox(Eigen::Isometry3d::Identity()));
  ASSERT_TRUE(drafts.follow(scanned, {}));
  EXPECT_TRUE(drafts.scan_motion().isApprox(motion)) << "once";
  // The session has the points where the motion takes them.
  const auto& points = drafts.now().scan(0);
  ASSERT_EQ(points.size(), scanned.design.scans[0].points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((points[i] - motion * scanned.design.scans[0].points[i]).norm(), 1e-9);
  ASSERT_TRUE(drafts.follow(plain, {}));
  EXPECT_TRUE(drafts.scan_motion().isApprox(Eigen::Isometry3d::Identity())) << "begun anew";
}

}  // namespace
}  // namespace planish::job
