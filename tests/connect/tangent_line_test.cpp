#include "tangent_line.hpp"

#include "sample_fits.hpp"
#include "support/error_data.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace planish::test {
namespace {

using namespace connect_detail;

Result<TangentLine> line_for(const PairTask& pair) {
  const auto choice = search_pair(pair.task, {});
  EXPECT_TRUE(choice) << (choice ? "" : choice.error().message);
  if (!choice) return tl::unexpected(choice.error());
  return tangent_line(pair.task, *choice, {});
}

TEST(TangentLineOf, ParallelEdgesLiesOnThem) {
  const auto line = line_for(PairTask(angle_pair(14.0)));
  ASSERT_TRUE(line);
  EXPECT_EQ(line->slope, 0.0);
  EXPECT_NEAR(line->at(0), 14.0, 1e-9);
}

TEST(TangentLineOf, EdgesThatRunApartFollowsThem) {
  const auto line = line_for(PairTask(cone_pair(0.2)));
  ASSERT_TRUE(line);
  EXPECT_NEAR(std::abs(line->slope), 0.2, 1e-12);
}

TEST(TangentLineOf, EdgesThatHardlyRunApartIsLevel) {
  const auto line = line_for(PairTask(cone_pair(5e-4)));
  ASSERT_FALSE(line) << "the plates would touch";
  PlateStructure s = angle_pair(14.0);
  for (Plate& plate : s.plates)
    plate.outline[plate.id == "A" ? 2 : 1] += (plate.id == "A"
                                                   ? Vec3(0, -0.1, 0)
                                                   : Vec3(0, 0, 0.1));  // a slope of 5e-4
  const auto level = line_for(PairTask(s));
  ASSERT_TRUE(level);
  EXPECT_EQ(level->slope, 0.0);
  const auto cone = line_for(PairTask(s, {.surface = SurfaceChoice::cone}));
  ASSERT_TRUE(cone);
  EXPECT_NEAR(std::abs(cone->slope), 5e-4, 1e-9) << "asked for";
}

TEST(TangentLineOf, TwoRadiiIsLinearBetweenThem) {
  const auto line = line_for(
      PairTask(angle_pair(14.0, 200, 4.0), {.inside_radii = std::array{4.0, 10.0}}));
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope, 6.0 / 200, 1e-12);
  EXPECT_NEAR(line->at(-100), 6.0, 1e-9);
  EXPECT_NEAR(line->at(100), 12.0, 1e-9);
}

TEST(TangentLineOf, TwoRadiiThatCutAPlateIsRefused) {
  const auto line = line_for(
      PairTask(angle_pair(14.0, 200, 4.0), {.inside_radii = std::array{4.0, 12.1}}));
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().code, code::no_bend_fits);
  EXPECT_EQ(line.error().where, "/inside_radii");
  EXPECT_NEAR(number_in(line.error(), "room"), 12.0, 1e-9);
  EXPECT_EQ(ids_in(line.error(), PlaceKind::plate), (std::vector<std::string>{"\"A\"", "\"B\""}));
}

TEST(TangentLineOf, TwoRadiiThatCutAPlateLearnTheRoomAtEachEnd) {
  // Over the line where the planes meet, A's edge rises from 14 to 26 and B's falls from 20 to 10:
  // the lower of both decides at each end. Sheets 4 thick at a right angle: an inside radius 2
  // smaller.
  PlateStructure s = angle_pair(14.0, 200, 4.0);
  s.plates[0].outline[2].y() = 88;
  s.plates[1].outline[0] += Vec3(0, 0, 6);
  s.plates[1].outline[1] -= Vec3(0, 0, 4);
  for (const auto& [asked, fits] :
       {std::pair{std::array{11.9, 7.9}, true}, std::pair{std::array{12.1, 7.9}, false},
        std::pair{std::array{11.9, 8.1}, false}}) {
    const auto line = line_for(PairTask(s, {.inside_radii = asked}));
    ASSERT_EQ(line.has_value(), fits) << asked[0] << ' ' << asked[1];
    if (fits) continue;
    const Error& error = line.error();
    EXPECT_EQ(numbers_in(error, "asked"), (std::vector<double>{asked[0], asked[1]}));
    const auto room = numbers_in(error, "room");
    ASSERT_EQ(room.size(), 2u);
    EXPECT_NEAR(room[0], 12.0, 1e-9);
    EXPECT_NEAR(room[1], 8.0, 1e-9);
    // The steepest lines between the axis and the edges: through a corner of one end and zero at
    // the other.
    EXPECT_NEAR(number_in(error, "least_slope"), -14.0 / 200, 1e-9);
    EXPECT_NEAR(number_in(error, "most_slope"), 10.0 / 200, 1e-9);
  }
}

TEST(TangentLineOf, TwoRadiiRoundTheBackReachTheFartherEdge) {
  // The edges that look away lie 114 from the line where the planes meet; B's falls to 104.
  PlateStructure s = angle_pair(14.0, 200, 4.0);
  s.plates[1].outline[2].z() -= 10;
  const auto with = [&](double left, double right) {
    return line_for(PairTask(
        s, {.edges = {std::vector{0}, std::vector{2}}, .inside_radii = std::array{left, right}}));
  };
  const auto line = with(112, 118);
  ASSERT_TRUE(line) << "the edge itself is on the bend";
  EXPECT_NEAR(line->at(-100), 114.0, 1e-9);
  EXPECT_NEAR(line->at(100), 120.0, 1e-9);
  for (const auto& refused : {with(111.9, 118), with(118, 111.9)}) {
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, code::no_bend_fits);
    EXPECT_TRUE(std::ranges::none_of(refused.error().numbers, [](const NamedQuantity& number) {
      return number.name == "most_slope";
    })) << "any slope is possible far enough behind the plates";
  }
}

TEST(TangentLineOf, AnApertureHasThatHalfAngle) {
  const double half = 3.0 * std::numbers::pi / 180;
  const auto line = line_for(PairTask(angle_pair(14.0), {.aperture = Angle::degrees(6)}));
  ASSERT_TRUE(line);
  // math.md#tangent-cone with β = 90°: sin φ is the tangent of the half-angle.
  EXPECT_NEAR(std::sin(std::atan(std::abs(line->slope))), std::tan(half), 1e-12);
}

TEST(TangentLineOf, AMiddleRadiusHasItInTheMiddle) {
  const auto line = line_for(PairTask(angle_pair(14.0), {.inside_radius = 6.0, .slope = 0.02}));
  ASSERT_TRUE(line);
  EXPECT_EQ(line->slope, 0.02);
  EXPECT_NEAR(line->at(0.0), 8.0, 1e-9);
}

TEST(TangentLineOf, AMiddleRadiusHasItInTheMiddleOfTheEdgesNotOfThePlates) {
  // Both edges are 100 long, at one end of plates of 200.
  PlateStructure s = angle_pair(14.0);
  s.plates[0].outline = {{0, 0, 0},    {200, 0, 0},   {200, 60, 0},
                         {100, 60, 0}, {100, 100, 0}, {0, 100, 0}};
  s.plates[1].outline = {{0, 114, 14},   {100, 114, 14},  {100, 114, 60},
                         {200, 114, 60}, {200, 114, 100}, {0, 114, 100}};
  const PairTask pair(s, {.inside_radius = 6.0, .slope = 0.02});
  const auto choice = search_pair(pair.task, {});
  ASSERT_TRUE(choice);
  const auto line = tangent_line(pair.task, *choice, {});
  ASSERT_TRUE(line);
  const double middle = (Vec3(50, 114, 0) - choice->frame.origin).dot(choice->frame.d);
  EXPECT_NEAR(std::abs(middle), 50.0, 1e-9) << "the frame lies between the plates' middles";
  EXPECT_NEAR(line->at(middle), 8.0, 1e-9);
}

TEST(TangentLineOf, PlatesThatTouchOrAreTooThickIsRefused) {
  EXPECT_EQ(line_for(PairTask(angle_pair(0.0))).error().code, code::plates_touch);
  const auto thick = line_for(PairTask(angle_pair(1.9, 200, 4.0)));
  ASSERT_FALSE(thick);
  EXPECT_EQ(thick.error().code, code::radius_too_small);
  EXPECT_NE(thick.error().message.find("1.9 mm"), std::string::npos) << thick.error().message;
}

TEST(TangentLineOf, ParallelPlatesLiesBeyondBoth) {
  const auto line = line_for(PairTask(u_pair()));
  ASSERT_TRUE(line);
  EXPECT_EQ(line->slope, 0.0);
}

TEST(WithRange, SaysWhatWouldFit) {
  const Error nothing{code::no_bend_fits, "nothing fits", {}};
  const auto said = [&](const BendRequest& request) {
    const PairTask pair(angle_pair(14.0, 200, 4.0), request);
    return with_range(pair.task, {}, nothing);
  };
  EXPECT_NEAR(number_in(said({.inside_radius = 20.0}), "largest"), 12.0, 1e-9);
  // Between a height of 2.001 at one end and of 14 at the other, 200 mm away.
  EXPECT_NEAR(number_in(said({.slope = 0.5}), "high"), (14 - 2.001) / 200, 1e-9);
  EXPECT_EQ(said({.slope = 0.5}).where, "/slope");
  EXPECT_EQ(said({.apex = 0.0}).code, code::apex_in_span);
  EXPECT_EQ(said({}).message, "nothing fits") << "nothing was given";
  // However small it is.
  const PairTask near(angle_pair(2.5, 200, 4.0), {.inside_radius = 20.0});
  EXPECT_NEAR(number_in(with_range(near.task, {}, nothing), "largest"), 0.5, 1e-9);
}

TEST(WithRange, SaysFromWhereOnABendGoesRoundTheBack) {
  // The nearest of the edges that look away: 74 from the line on A, beyond a step, 34 on B.
  PlateStructure s = angle_pair(14.0, 200, 4.0);
  s.plates[0].outline = {{0, 0, 0},    {100, 0, 0},   {100, 40, 0},
                         {200, 40, 0}, {200, 100, 0}, {0, 100, 0}};
  s.plates[1] = rectangle_plate("B", {0, 114, 14}, {200, 0, 0}, {0, 0, 20});
  const PairTask pair(s, {.inside_radius = 20.0});
  const Error said = with_range(pair.task, {}, {code::no_bend_fits, "nothing fits", {}});
  EXPECT_NEAR(number_in(said, "largest"), 12.0, 1e-9);
  EXPECT_NEAR(number_in(said, "smallest"), 72.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
