#include "connect/random_sides.hpp"
#include "connect/sample_plates.hpp"
#include "support/round_trip.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>
#include <planish/job/plates_of.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

// Plates → connect → solid → STEP → recognise → flatten gives the flat pattern that connect gave.

namespace planish::test {
namespace {

void expect_connect_round_trip(const PlateStructure& structure, double tolerance = 1e-6) {
  const auto connection = connect(structure);
  ASSERT_TRUE(connection) << connection.error().message << " at " << connection.error().where;
  expect_round_trip(connection->sheet, tolerance);
}

TEST(ConnectRoundTrip, GivesBackWhatWasJoined) {
  for (const PlateStructure& s : {angle_pair(14.0), tray(), u_pair()})
    expect_connect_round_trip(s);
}

PlateStructure folded(std::vector<Plate> plates) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = std::move(plates);
  for (std::size_t p = 1; p < s.plates.size(); ++p)
    s.bends.push_back({.between = {"A", s.plates[p].id}, .inside_radius = 0.0});
  return s;
}

const Plate kFloor = rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 50, 0});

TEST(ConnectRoundTrip, GivesBackFolds) {
  // Up and down; inside an edge at both ends, at one, from a wall that turns to either side.
  for (const Plate& wall : {rectangle_plate("B", {0, 0, 0}, {100, 0, 0}, {0, 0, 40}),
                            rectangle_plate("B", {20, 0, 0}, {50, 0, 0}, {0, 0, 40}),
                            rectangle_plate("B", {0, 0, 0}, {50, 0, 0}, {0, -20, 40}),
                            rectangle_plate("B", {20, 0, 0}, {80, 0, 0}, {0, 20, -40})})
    expect_connect_round_trip(folded({kFloor, wall}));
  expect_connect_round_trip(
      folded({kFloor, rectangle_plate("B", {0, 0, 0}, {100, 0, 0}, {0, 0, 40}),
              rectangle_plate("C", {0, 50, 0}, {100, 0, 0}, {0, 0, -40})}));
}

TEST(ConnectRoundTrip, PlatesOfFoldsAreThosePutIn) {
  // Of a sheet whose faces end where the inner skins meet, and where one fold is seen from outside.
  const PlateStructure put_in = folded({kFloor,
                                        rectangle_plate("B", {20, 0, 0}, {50, 0, 0}, {0, -20, 40}),
                                        rectangle_plate("C", {0, 50, 0}, {100, 0, 0}, {0, 0, 40})});
  const auto joined = connect(put_in);
  ASSERT_TRUE(joined) << joined.error().message;
  const PlateStructure taken_out = job::plates_of(joined->sheet, {.with_bends = true});
  ASSERT_EQ(taken_out.plates.size(), put_in.plates.size());
  for (std::size_t p = 0; p < put_in.plates.size(); ++p) {
    EXPECT_EQ(taken_out.plates[p].outline.size(), 4u);
    for (const Vec3& corner : put_in.plates[p].outline) {
      double nearest = HUGE_VAL;
      for (const Vec3& other : taken_out.plates[p].outline)
        nearest = std::min(nearest, (other - corner).norm());
      EXPECT_LT(nearest, 1e-9) << "plate " << p;
    }
  }
  for (const BendRequest& bend : taken_out.bends)
    EXPECT_EQ(bend.inside_radius, 0.0);
  EXPECT_TRUE(connect(taken_out));
}

TEST(ConnectRoundTrip, GivesBackCones) { expect_connect_round_trip(cone_pair(), 1e-5); }

TEST(ConnectRoundTrip, GivesBackObliqueCones) {
  PlateStructure s = lofted();
  for (const LateralBoundary lateral : {LateralBoundary::arc, LateralBoundary::straight}) {
    s.bends[0].lateral = lateral;
    expect_connect_round_trip(s, 1e-5);
  }
}

TEST(ConnectRoundTrip, GivesBackPipesAndCones) {
  PlateStructure pipe;
  pipe.thickness = 2.0;
  pipe.bends = {{.inside_radius = 49.0, .angle = Angle::degrees(350), .length = 300.0}};
  expect_connect_round_trip(pipe);
  pipe.bends[0].inside_radius.reset();
  pipe.bends[0].inside_radii = std::array{60.0, 30.0};
  expect_connect_round_trip(pipe);
}

TEST(ConnectRoundTrip, GivesBackEveryLateralBoundary) {
  for (const LateralBoundary lateral :
       {LateralBoundary::straight, LateralBoundary::arc, LateralBoundary::corner}) {
    PlateStructure cylinder = angle_pair(14.0);
    cylinder.plates[1] = rectangle_plate("B", {30, 114, 20}, {140, 0, 0}, {0, 0, 100});
    cylinder.bends = {{.between = {"A", "B"}, .lateral = lateral}};
    expect_connect_round_trip(cylinder, 1e-5);
    PlateStructure cone = cone_pair();
    for (Vec3& p : cone.plates[1].outline)
      p.x() += p.x() < 300 ? 30 : -20;
    cone.bends = {{.between = {"A", "B"}, .lateral = lateral}};
    expect_connect_round_trip(cone, 1e-5);
  }
}

/// A rectangle at the line where two planes meet, turned a little.
struct TurnedPlate {
  double width, height, away, turn, shift;

  Plate plate(const std::string& id, const Vec3& e, const Vec3& d) const {
    const Vec3 along = std::cos(turn) * d + std::sin(turn) * e,
               up = std::cos(turn) * e - std::sin(turn) * d;
    const double lowest = std::min(0.0, std::sin(turn) * width);
    return rectangle_plate(id, shift * d + (away - lowest) * e, width * along, height * up);
  }
};

/// With random size and distance.
Plate random_plate(const std::string& id, const Vec3& e, const Vec3& d) {
  const auto number = [](int low, int high) {
    return 0.1 * *rc::gen::inRange(10 * low, 10 * high);
  };
  const double width = number(60, 200), height = number(50, 150), away = number(15, 60);
  const double turn = 0.01 * *rc::gen::inRange(-30, 30), shift = number(-40, 40);
  return TurnedPlate{width, height, away, turn, shift}.plate(id, e, d);
}

/// Its bend is so near a cone that its splines are read as cones, which do not lie a thickness
/// apart.
TEST(ConnectRoundTrip, GivesBackAGeneralBendNearACone) {
  const double beta = 0.6;
  PlateStructure s;
  s.thickness = 0.8;
  s.plates = {TurnedPlate{60.3, 52.3, 15.7, -0.3, -38.2}.plate("A", Vec3::UnitY(), Vec3::UnitX()),
              TurnedPlate{62.8, 52.0, 15.4, -0.3, -39.3}.plate(
                  "B", {0, std::cos(beta), std::sin(beta)}, Vec3::UnitX())};
  const auto connection = connect(s);
  ASSERT_TRUE(connection);
  expect_round_trip(connection->sheet, 1e-5);
}

RC_GTEST_PROP(ConnectRoundTrip, GivesBackRandomPairs, ()) {
  const double beta = 0.01 * *rc::gen::inRange(60, 250);
  PlateStructure s;
  s.thickness = 0.1 * *rc::gen::inRange(8, 30);
  const Vec3 d = Vec3::UnitX();
  s.plates = {random_plate("A", Vec3::UnitY(), d),
              random_plate("B", {0, std::cos(beta), std::sin(beta)}, d)};
  const auto connection = connect(s);
  if (!connection) {
    // Plates may be too near for the thickness, or lie so far beside each other that the extension
    // of one would run over it; nothing else may go wrong.
    const ErrorCode code = connection.error().code;
    RC_ASSERT(code == code::radius_too_small || code == code::no_common_width ||
              code == code::overlap);
    RC_DISCARD();
  }
  expect_round_trip(connection->sheet, 1e-5);
  RC_ASSERT(!::testing::Test::HasFailure());
}

/// An irregular plate whose edges look towards the line through the origin along d.
Plate irregular_plate(const std::string& id, std::mt19937& random, const Vec3& e, const Vec3& d) {
  std::uniform_int_distribution<int> count(1, 6);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Plate plate{id, {}, {}};
  for (const Vec2& p :
       random_outline(random, {count(random), 25.0 * unit(random), 0.3 * unit(random) - 0.15,
                               unit(random) < 0.5, false}))
    plate.outline.push_back(p.x() * d + p.y() * e);
  return plate;
}

RC_GTEST_PROP(ConnectRoundTrip, GivesBackIrregularPairs, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const double beta = 0.01 * *rc::gen::inRange(60, 250);
  PlateStructure s;
  s.thickness = 0.1 * *rc::gen::inRange(8, 30);
  s.plates = {irregular_plate("A", random, Vec3::UnitY(), Vec3::UnitX()),
              irregular_plate("B", random, {0, std::cos(beta), std::sin(beta)}, Vec3::UnitX())};
  s.bends = {{.between = {"A", "B"},
              .lateral = *rc::gen::element(LateralBoundary::automatic, LateralBoundary::arc,
                                           LateralBoundary::corner),
              .trade_off = *rc::gen::element(0.0, 1.0, 3.0)}};
  const auto connection = connect(s);
  if (!connection) {
    RC_LOG() << connection.error().message;
    RC_ASSERT(connection.error().code == code::radius_too_small ||
              connection.error().code == code::no_common_width ||
              connection.error().code == code::overlap);
    RC_DISCARD();
  }
  RC_ASSERT(connection->bends[0].extension_area >= 0.0);
  expect_round_trip(connection->sheet, 1e-5);
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace planish::test
