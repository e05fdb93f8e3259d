#include "support/sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

const Border& border_of(const Sheet& sheet, const BorderRef& ref) { return sheet[ref]; }

Vec3 point(const Face& face, const Vec2& uv) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  return surface != nullptr ? point_on(*surface, uv) : std::get<Frame>(face.surface).point(uv);
}

Vec3 normal(const Face& face, const Vec2& uv) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  return surface != nullptr ? Vec3(face.sense * normal_on(*surface, uv.x()))
                            : std::get<Frame>(face.surface).z;
}

Vec3 end_point(const Sheet& sheet, const BorderRef& ref, double t) {
  return point(sheet[ref.face], point_at(border_of(sheet, ref).curve, t));
}

Vec3 end_normal(const Sheet& sheet, const BorderRef& ref, double t) {
  return normal(sheet[ref.face], point_at(border_of(sheet, ref).curve, t));
}

void expect_loops_closed_and_oriented(const Sheet& sheet) {
  for (const Face& face : sheet.faces)
    for (std::size_t l = 0; l < face.loops.size(); ++l) {
      Loop loop;
      for (const Border& border : face.loops[l])
        loop.push_back(border.curve);
      for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_LT((end_of(loop[i]) - start_of(loop[(i + 1) % loop.size()])).norm(), 1e-9);
      EXPECT_GT(face.sense * signed_area(loop) * (l == 0 ? 1 : -1), 0.0);
    }
}

void expect_joints_to_match(const Sheet& sheet) {
  for (const Joint& joint : sheet.joints) {
    EXPECT_LT((end_point(sheet, joint.a, 0) - end_point(sheet, joint.b, 1)).norm(), 1e-9);
    EXPECT_LT((end_point(sheet, joint.a, 1) - end_point(sheet, joint.b, 0)).norm(), 1e-9);
    EXPECT_EQ(border_of(sheet, joint.a).edge, border_of(sheet, joint.b).edge);
    EXPECT_NEAR(*border_of(sheet, joint.a).edge_length,
                (end_point(sheet, joint.a, 1) - end_point(sheet, joint.a, 0)).norm(), 1e-9);
    EXPECT_NEAR(*border_of(sheet, joint.b).edge_length, *border_of(sheet, joint.a).edge_length,
                1e-9);
    const double turned = std::acos(
        std::clamp(end_normal(sheet, joint.a, 0).dot(end_normal(sheet, joint.b, 1)), -1.0, 1.0));
    EXPECT_NEAR(turned, joint.sharp ? sheet[*joint.sharp].angle.radians() : 0.0, 1e-7);
  }
}

/// What sheet.hpp asks of every sheet, and what the builders promise besides.
void expect_sound(const Sheet& sheet) {
  expect_loops_closed_and_oriented(sheet);
  expect_joints_to_match(sheet);
  EXPECT_EQ(sheet.faces.size(), sheet.joints.size() + 1) << "a tree";
  EXPECT_GT(*sheet.volume, 0.0);
  std::map<int, int> uses;
  for (const Face& face : sheet.faces)
    for (const BorderLoop& loop : face.loops)
      for (const Border& border : loop)
        ++uses[border.edge.value()];
  std::size_t shared = 0;
  for (const auto& [edge, count] : uses)
    shared += count == 2 ? 1 : 0;
  EXPECT_EQ(shared, sheet.joints.size());
}

TEST(SupportSheets, KeepTheContractOfSheet) {
  expect_sound(l_bracket());
  expect_sound(l_bracket_down());
  expect_sound(staircase(3));
  expect_sound(hem());
  expect_sound(two_turns_of_270());
  expect_sound(box({}, BendDirection::down));
  expect_sound(plate_with_holes());
  expect_sound(ring(20, 10, 1));
  expect_sound(truncated_cone(20, 40, 50, Angle::degrees(300), 1.5));
  for (BendDirection direction : {BendDirection::up, BendDirection::down}) {
    ConeJoint joint;
    joint.turn.direction = direction;
    expect_sound(cone_joined(joint));
    Opened part;
    part.turn.direction = direction;
    expect_sound(hole_in_bend(5, 0.44, part));
    expect_sound(strip({Straight{20}, Crease{Angle::degrees(70), direction}, Straight{20}}, 10, 1));
  }
}

TEST(SupportSheets, WithInterruptedBendsHaveMoreJointsThanATree) {
  for (BendDirection direction : {BendDirection::up, BendDirection::down}) {
    Opened part;
    part.turn.direction = direction;
    for (const Sheet& sheet :
         {slot_across_bend(12, part), hole_across_bend(20, 0.4, part), slot_into_bend(12, part)}) {
      expect_loops_closed_and_oriented(sheet);
      expect_joints_to_match(sheet);
      EXPECT_EQ(sheet.joints.size(), sheet.faces.size() == 4 ? 4u : 3u);
    }
  }
}

TEST(SupportSheets, HaveTheVolumeOfTheirClosedForm) {
  EXPECT_NEAR(*l_bracket().volume, 2 * 40 * (80 + pi / 2 * 4), 1e-9);
  EXPECT_NEAR(*l_bracket_down().volume, *l_bracket().volume, 1e-9);
  EXPECT_NEAR(*strip({Straight{30}, Crease{Angle::degrees(90)}, Straight{20}}, 10, 2).volume,
              10 * (2 * 50 + 4), 1e-9);
  EXPECT_NEAR(*ring(20, 10, 2).volume, 2 * pi * 300, 1e-9);
  // A frustum's shell between two cones and two cones perpendicular to them (Pappus).
  const double slant = std::hypot(20, 50), mid = 30 - 0.75 * 50 / slant;
  EXPECT_NEAR(*truncated_cone(20, 40, 50, Angle::degrees(300), 1.5).volume,
              Angle::degrees(300).radians() * mid * slant * 1.5, 1e-8);
}

TEST(SupportSheets, DrawnAtRandomAreSound) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Sheet sheet = random_sheet(random, 1 + static_cast<int>(seed % 8));
    expect_sound(sheet);
    expect_sound(scaled(
        moved(sheet, Eigen::Isometry3d(Eigen::Translation3d(5, -3, 2) *
                                       Eigen::AngleAxisd(1, Vec3(1, 2, 3) / std::sqrt(14.0)))),
        10));
  }
}

TEST(SupportSheets, MeasureDistancesToTheirEdges) {
  const Sheet sheet = l_bracket();
  const EdgeDistance distance = edge_distance(sheet);
  EXPECT_NEAR(distance(*sheet.faces.front().loops[0][0].edge, {10, 0, 3}), 3.0, 1e-9);
  EXPECT_NEAR(distance(*sheet.faces.front().loops[0][0].edge, {10.3, 0, 0}), 0.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
