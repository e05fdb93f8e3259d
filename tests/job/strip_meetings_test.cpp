#include "strip_meetings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::job {
namespace {

/// Flat coordinates to space, turned by an angle about a line of the sheet: x = `at`, up from the
/// sheet; or y = `at`, the part beyond it over the rest.
Frame turned_about_x(double at, double angle) {
  const Vec3 along(std::cos(angle), 0, std::sin(angle));
  return frame_from_axes(Vec3(at, 0, 0) - at * along, along.cross(Vec3::UnitY()), along);
}
Frame turned_about_y(double at, double angle) {
  const Vec3 across(0, std::cos(angle), std::sin(angle));
  return frame_from_axes(Vec3(0, at, 0) - at * across, Vec3::UnitX().cross(across), Vec3::UnitX());
}

SlitRidge ridge_at(double along, double left, double right, const Frame& frame) {
  SlitRidge ridge;
  ridge.flat = {Vec2(along, left), Vec2(along, right)};
  for (int i = 0; i < 2; ++i)
    ridge.folded[i] = frame.point(ridge.flat[i]);
  return ridge;
}

/// A panel of 100 × 120 with two strips of 200, across 0 to 50 and 70 to 120. The half of strip 1
/// is folded over that of strip 0 by `over`; strip 0 stands up by `up` from its middle on.
SlitReport two_strips(double thickness, double over, double up) {
  const Frame flat, half = turned_about_y(60, over), standing = turned_about_x(200, up);
  SlitReport report;
  FoldedSlitSheet& folded = report.folded;
  folded.thickness = thickness;
  folded.reach = 300;
  folded.symmetric = false;
  folded.panel = {{{Vec2(0, 0), Vec2(100, 0), Vec2(100, 50), Vec2(0, 50)}, flat, 0},
                  {{Vec2(0, 50), Vec2(100, 50), Vec2(100, 60), Vec2(0, 60)}, flat, -1},
                  {{Vec2(0, 60), Vec2(100, 60), Vec2(100, 70), Vec2(0, 70)}, half, -1},
                  {{Vec2(0, 70), Vec2(100, 70), Vec2(100, 120), Vec2(0, 120)}, half, 1}};
  FoldedStrip first, second;
  first.ridges = {ridge_at(100, 0, 50, flat), ridge_at(200, 0, 50, flat),
                  ridge_at(300, 0, 50, standing)};
  first.quads = {flat, standing};
  second.ridges = {ridge_at(100, 70, 120, half), ridge_at(200, 70, 120, half),
                   ridge_at(300, 70, 120, half)};
  second.quads = {half, half};
  folded.strips = {first, second};
  return report;
}

std::vector<Finding> meetings_of(SlitReport report) {
  const Sheet sheet = sheet_of(report.folded);
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "test"};
  options.root = FaceId{0};
  options.keep_root = true;
  options.up = UpSide::reference;
  auto flat = flat_sheet(sheet, options);
  if (!flat) {
    ADD_FAILURE() << flat.error().message;
    return {};
  }
  report.layout = flat->layout;
  return strip_meetings(report, sheet);
}

constexpr double kRight = std::numbers::pi / 2, kFlatOn = 150.0 * std::numbers::pi / 180;

TEST(StripMeetings, AreNoneWhereStripsKeepApart) {
  EXPECT_TRUE(meetings_of(two_strips(2, 0, 0)).empty());
  EXPECT_TRUE(meetings_of(two_strips(2, kRight, 0)).empty());
  EXPECT_TRUE(meetings_of(two_strips(2, 0, kRight)).empty());
}

TEST(StripMeetings, AreSaidOnceWithTheirPlacesAndHowDeep) {
  // Strip 0 stands up through the half that leans over it, in thin and in thick sheet.
  for (const double thickness : {0.5, 2.0, 4.0}) {
    const auto found = meetings_of(two_strips(thickness, kFlatOn, kRight));
    ASSERT_EQ(found.size(), 1u) << thickness;
    EXPECT_NE(found[0].message.find("strip 1"), std::string::npos) << found[0].message;
    EXPECT_NE(found[0].message.find("strip 2"), std::string::npos) << found[0].message;
    ASSERT_EQ(found[0].at.size(), 2u);
    EXPECT_LT((found[0].at[0] - Vec2(250, 25)).norm(), 1e-6) << "the standing half of the first";
    EXPECT_NEAR(found[0].at[1].y(), 95.0, 1e-6) << "the middle of the second";
  }
}

}  // namespace
}  // namespace planish::job
