#include "request_check.hpp"

#include "sample_fits.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

void expect_refused(const BendRequest& request, const std::string& key) {
  const auto refused = check_numbers(request, "/bends/4");
  ASSERT_FALSE(refused) << key;
  EXPECT_EQ(refused.error().code, code::invalid_input);
  EXPECT_EQ(refused.error().where, "/bends/4" + key) << refused.error().message;
}

TEST(CheckNumbers, TakesWhatGoesTogether) {
  EXPECT_TRUE(check_numbers({}, ""));
  EXPECT_TRUE(
      check_numbers({.surface = SurfaceChoice::cone, .inside_radius = 5.0, .slope = 0.1}, ""));
  EXPECT_TRUE(check_numbers({.slope = 0.1, .apex = 30.0}, ""));
  EXPECT_TRUE(check_numbers(
      {.surface = SurfaceChoice::general, .apex = 3.0, .tangent_point = Vec3(1, 2, 3)}, ""));
}

TEST(CheckNumbers, RefusesSizesOutOfTheirRange) {
  expect_refused({.trade_off = -0.1}, "/trade_off");
  expect_refused({.trade_off = std::nan("")}, "/trade_off");
  expect_refused({.inside_radius = -1.0}, "/inside_radius");
  expect_refused({.inside_radii = std::array{1.0, -1.0}}, "/inside_radii");
  expect_refused({.aperture = Angle::degrees(0)}, "/aperture");
  expect_refused({.aperture = Angle::degrees(180)}, "/aperture");
}

TEST(CheckNumbers, RefusesWhatTheSurfaceCannotHave) {
  expect_refused({.surface = SurfaceChoice::cylinder, .apex = 1.0}, "/surface");
  expect_refused({.surface = SurfaceChoice::general, .inside_radius = 1.0}, "/surface");
  expect_refused({.tangent_point = Vec3(1, 2, 3)}, "/tangent_point");
}

TEST(CheckNumbers, RefusesTheSameThingGivenTwice) {
  expect_refused({.aperture = Angle::degrees(10), .slope = 0.1}, "");
  expect_refused({.inside_radii = std::array{1.0, 2.0}, .aperture = Angle::degrees(10)}, "");
  expect_refused({.inside_radius = 4.0, .apex = 30.0}, "/inside_radius");
}

TEST(RowsOf, AreThePlatesInTheOrderOfTheRequest) {
  const PlateStructure s = tray();
  EXPECT_EQ(rows_of(s, {.between = {"left", "floor"}}, "/bends/0").value(), (std::vector{3, 0}));
  EXPECT_TRUE(rows_of(s, {}, "/bends/0")->empty());
}

TEST(RowsOf, RefusesPlatesThatDoNotExistOrAreOne) {
  const PlateStructure s = angle_pair(14.0);
  const auto unknown = rows_of(s, {.between = {"A", "X"}}, "/bends/2");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, code::unknown_plate);
  EXPECT_EQ(unknown.error().where, "/bends/2/between/1");
  EXPECT_EQ(rows_of(s, {.between = {"A", "A"}}, "/bends/2").error().where, "/bends/2/between");
  EXPECT_EQ(rows_of(s, {.between = {"A", "B", "A"}}, "/bends/2").error().where, "/bends/2/between");
}

TEST(CheckEdges, WantsEdgesThatThePlateHas) {
  PairTask pair(angle_pair(14.0), {.edges = {std::vector{2}, std::vector{0, 3}}});
  EXPECT_TRUE(check_edges(pair.task));
  pair.task.request.edges[1] = {0, 4};
  EXPECT_EQ(check_edges(pair.task).error().code, code::unknown_edge);
  EXPECT_EQ(check_edges(pair.task).error().where, "/bends/0/edges/B/1");
  pair.task.request.edges[1] = std::vector<int>{};
  EXPECT_EQ(check_edges(pair.task).error().code, code::invalid_input);
}

TEST(CheckEdges, EscapesIdsInPointers) {
  PlateStructure s = angle_pair(14.0);
  s.plates[0].id = "a/b~c";
  PairTask pair(s, {.edges = {std::vector{9}, std::nullopt}});
  EXPECT_EQ(check_edges(pair.task).error().where, "/bends/0/edges/a~1b~0c/0");
}

}  // namespace
}  // namespace planish::test
