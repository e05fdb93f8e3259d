#include "collision/solid_meshes.hpp"

#include <planish/collision/self_intersections.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDepth = 0.05;    // mm, what counts
constexpr double kChord = 0.01;    // mm, of arcs
constexpr double kClimbed = 0.01;  // of the depth: the climb stops a little before the widest ball

double deepest(const MeshOfFaces& surface, double depth = kDepth) {
  double most = 0.0;
  for (const SelfIntersection& found : find_self_intersections(surface, depth))
    most = std::max(most, found.depth);
  return most;
}

MeshOfFaces together(const std::vector<MeshOfFaces>& solids) {
  MeshOfFaces all;
  for (const MeshOfFaces& solid : solids)
    append(all, solid);
  return all;
}

Eigen::Isometry3d turned(double angle, const Vec3& axis) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// In a general position, so that nothing lies along an axis.
Eigen::Isometry3d askew() {
  return Eigen::Translation3d(31.7, -12.9, 5.3) * turned(1.1, {0.3, -0.8, 0.5});
}

void expect_nothing(const MeshOfFaces& surface) {
  EXPECT_EQ(deepest(surface), 0.0);
  EXPECT_EQ(deepest(moved(surface, askew())), 0.0);
}

void expect_depth(const MeshOfFaces& surface, double depth, double within) {
  EXPECT_NEAR(deepest(surface), depth, within);
  EXPECT_NEAR(deepest(moved(surface, askew())), depth, within);
}

/// 60 × 40, 2 thick, from z = −2 to 0.
MeshOfFaces base(int cells = 1) { return block({0, 0, -2}, {60, 40, 0}, cells); }

// ---- what runs through itself

TEST(SelfIntersections, FindsAPlateThroughAnother) {
  const MeshOfFaces through = block({20, 10, -10}, {22, 30, 15});
  expect_depth(together({base(), through}), 2.0, 2.0 * kClimbed);
}

TEST(SelfIntersections, FindsOneThroughAnotherAtAnyAngle) {
  for (const double degrees : {5.0, 20.0, 45.0, 70.0, 89.0}) {
    // The plate of 1 mm is thinner than the one it goes through.
    const MeshOfFaces through = moved(
        block({-60, 10, -0.5}, {60, 30, 0.5}),
        Eigen::Translation3d(30, 0, -1) * turned(degrees * kPi / 180, Vec3::UnitY()));
    EXPECT_NEAR(deepest(together({base(), through})), 1.0, kClimbed) << degrees;
  }
}

TEST(SelfIntersections, NamesTheFacesThatMeetAndThePlace) {
  const MeshOfFaces through = block({20, 10, -10}, {22, 30, 15});  // top and bottom: 6 and 7
  const auto found = find_self_intersections(together({base(), through}), kDepth);
  ASSERT_FALSE(found.empty());
  for (const SelfIntersection& one : found) {
    EXPECT_LE(one.faces[0], 1);  // the base's skins
    EXPECT_GE(one.faces[1], 8);  // the other's walls
    EXPECT_NEAR(one.centre.x(), 21.0, 0.02);
    EXPECT_NEAR(one.centre.z(), -1.0, 0.02);
    EXPECT_GE(one.centre.y(), 11.0 - 0.02);
    EXPECT_LE(one.centre.y(), 29.0 + 0.02);
  }
}

TEST(SelfIntersections, FindsCrossingsThatRunAlongEdgesOfTheMesh) {
  // The planes x = 20 and x = 25 are edges of the base's cells, and in the second case corners of
  // both meshes coincide.
  EXPECT_NEAR(deepest(together({base(12), block({20, 10, -10}, {25, 30, 15}, 5)})), 2.0, 0.02);
  const MeshOfFaces like = block({20, 0, -22}, {25, 40, 18}, 20);
  EXPECT_NEAR(deepest(together({block({0, 0, -2}, {60, 40, 0}, 20), like})), 2.0, 0.02);
}

TEST(SelfIntersections, FindsADuplicate) {
  expect_depth(together({base(), base(7)}), 2.0, 2.0 * kClimbed);
  // Shifted within its plane, and a smaller one exactly within the larger one's skins.
  const MeshOfFaces smaller = block({7.3, 5.1, -2}, {31.7, 22.2, 0});
  expect_depth(together({base(), smaller}), 2.0, 2.0 * kClimbed);
}

TEST(SelfIntersections, FindsACornerThatDipsIn) {
  // A square edge at 45°: the largest ball in a right triangle of height h has the diameter
  // 2 h (√2 − 1).
  const double height = 0.6;
  const MeshOfFaces edge = moved(
      block({0, 5, 0}, {30, 35, 30}),
      Eigen::Translation3d(30, 0, -height) * turned(-kPi / 4, Vec3::UnitY()));
  expect_depth(together({base(), edge}), 2 * height * (std::sqrt(2.0) - 1), kClimbed * height);
}

RC_GTEST_PROP(SelfIntersections, MeasuresHowFarAPlateIsPushedIn, ()) {
  const double pushed = 0.001 * *rc::gen::inRange(100, 4000);
  const double turn = 0.001 * *rc::gen::inRange(0, 3142);
  const Vec3 axis(*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10), 10);
  const MeshOfFaces plate = block({20.3, 10.1, -pushed}, {23.3, 30.7, 15});
  const auto motion = Eigen::Translation3d(100, -50, 3) * turned(turn, axis);
  const double depth = deepest(moved(together({base(), plate}), motion));
  RC_ASSERT(std::abs(depth - std::min(pushed, 2.0)) <= kClimbed * depth);
}

TEST(SelfIntersections, TellsWhatCountsFromWhatDoesNot) {
  for (const double pushed : {0.9 * kDepth, 1.1 * kDepth}) {
    const auto found = find_self_intersections(
        together({base(), block({20, 10, -pushed}, {22, 30, 15})}), kDepth);
    EXPECT_EQ(found.empty(), pushed < kDepth) << pushed;
  }
}

// ---- strips, bent in section

/// A strip bent back by 225° and then by 45° to the other side, so that its end lies parallel to
/// its beginning, `gap` away from it.
MeshOfFaces drop_hem(double gap) {
  constexpr double t = 1.0, r = 1.5;
  const auto path = [&](double between) {
    return Path()
        .straight(40)
        .arc(r, 225 * kPi / 180, t, kChord)
        .straight(between)
        .arc(r, -45 * kPi / 180, t, kChord)
        .straight(12);
  };
  const double high = path(1.0).at().y(), slope = path(2.0).at().y() - high;
  return path(1.0 + (t + gap - high) / slope).sheet(t, 20);
}

TEST(SelfIntersections, AcceptsHemsThatAreOpenOrClosed) {
  for (const double gap : {1.0, 0.02, 0.0})
    expect_nothing(drop_hem(gap));
}

TEST(SelfIntersections, FindsAHemPressedIntoItself) {
  for (const double shared : {2 * kDepth, 0.3, 0.9})
    expect_depth(drop_hem(-shared), shared, kClimbed * shared + kChord);
}

TEST(SelfIntersections, AcceptsATubeUpToAFullTurn) {
  for (const double degrees : {300.0, 359.0, 360.0})
    expect_nothing(Path().arc(20, degrees * kPi / 180, 1.5, kChord).sheet(1.5, 50));
}

TEST(SelfIntersections, FindsATubeRolledOntoItself) {
  for (const double degrees : {400.0, 700.0})
    expect_depth(Path().arc(20, degrees * kPi / 180, 1.5, kChord).sheet(1.5, 50), 1.5,
                 1.5 * kClimbed + 2 * kChord);
}

/// Half turns, each wider than the one before by half of `pitch`.
MeshOfFaces spiral(double pitch, double thickness) {
  Path path;
  for (int i = 0; i < 7; ++i)  // chords differ, so that corners of the skins do not coincide
    path.arc(6 + i * pitch / 2, kPi, thickness, kChord * (1 - 0.07 * i));
  return path.sheet(thickness, 15);
}

TEST(SelfIntersections, AcceptsASpiralWhoseTurnsTouch) {
  expect_nothing(spiral(2.5, 1.0));
  expect_nothing(spiral(1.0, 1.0));
}

TEST(SelfIntersections, FindsASpiralWoundTooTight) {
  expect_depth(spiral(0.75, 1.0), 0.25, 0.25 * kClimbed + 2 * kChord);
}

TEST(SelfIntersections, FindsAFlangeFoldedThroughTheFirst) {
  const auto folded = [](double degrees) {
    return Path().straight(40).arc(3, degrees * kPi / 180, 1.2, kChord).straight(30).sheet(1.2, 20);
  };
  expect_nothing(folded(179));
  expect_depth(folded(250), 1.2, 1.2 * kClimbed);
}

// ---- what only touches

TEST(SelfIntersections, AcceptsAButtedCorner) {
  expect_nothing(
      together({base(), block({0, 0, 0}, {60, 2, 30}), block({58, 2, 0}, {60, 40, 30})}));
}

TEST(SelfIntersections, AcceptsAMitredCorner) {
  const MeshOfFaces one = quad_prism({Vec2(0, 0), Vec2(60, 0), Vec2(58, 2), Vec2(2, 2)}, 0, 30);
  const MeshOfFaces other = quad_prism({Vec2(60, 0), Vec2(60, 40), Vec2(58, 38), Vec2(58, 2)}, 0,
                                       30, 4);
  expect_nothing(together({one, other}));
}

TEST(SelfIntersections, AcceptsATabInASlotOfItsSize) {
  const MeshOfFaces frame = together(
      {block({0, 0, -2}, {60, 10, 0}), block({0, 12, -2}, {60, 40, 0}),
       block({0, 10, -2}, {20, 12, 0}), block({35, 10, -2}, {60, 12, 0})});
  expect_nothing(together({frame, block({20, 10, -6}, {35, 12, 20})}));
}

TEST(SelfIntersections, AcceptsPlatesThatTouchAlongAnEdgeOrInACorner) {
  expect_nothing(together({base(), block({60, 0, 0}, {90, 40, 2})}));
  expect_nothing(together({base(), block({60, 40, 0}, {90, 60, 2})}));
}

TEST(SelfIntersections, AcceptsARolledSheetOnAFlatOne) {
  // A cylinder touches a plane, and another one, along a line.
  const MeshOfFaces roll = moved(Path().arc(20, 1.9 * kPi, 1.5, kChord).sheet(1.5, 50),
                                 Eigen::Isometry3d(Eigen::Translation3d(0, 0.75, 0)));
  const MeshOfFaces floor = block({-40, -2, -5}, {40, 0, 60});
  const MeshOfFaces beside = moved(roll, Eigen::Isometry3d(Eigen::Translation3d(41.5, 0, 0)));
  expect_nothing(together({roll, floor, beside}));
  const MeshOfFaces pressed = moved(floor, Eigen::Isometry3d(Eigen::Translation3d(0, 0.2, 0)));
  expect_depth(together({roll, pressed}), 0.2, 0.2 * kClimbed + 2 * kChord);
}

TEST(SelfIntersections, TakesEverySizeAlike) {
  for (const double scale : {0.1, 1.0, 100.0}) {
    MeshOfFaces surface = together({base(), block({20, 10, -0.5}, {22, 30, 15})});
    for (Vec3& p : surface.mesh.points)
      p *= scale;
    EXPECT_NEAR(deepest(surface, scale * kDepth), 0.5 * scale, kClimbed * scale) << scale;
  }
}

TEST(SelfIntersections, OfNothingAreNone) {
  EXPECT_TRUE(find_self_intersections({}, kDepth).empty());
}

// A gap in the mesh that a ray meets makes nothing enclosed twice.
TEST(SelfIntersections, AreNotInventedWhereAFaceIsMissing) {
  MeshOfFaces open = together({base(), block({20, 0, 0}, {22, 40, 15})});
  for (int face = 0; face < 12; ++face) {
    MeshOfFaces without;
    without.mesh.points = open.mesh.points;
    for (std::size_t t = 0; t < open.face.size(); ++t)
      if (open.face[t] != face) {
        without.mesh.triangles.push_back(open.mesh.triangles[t]);
        without.face.push_back(open.face[t]);
      }
    EXPECT_EQ(deepest(without), 0.0) << face;
  }
}

}  // namespace
}  // namespace planish::test
