#include "refused_designs.hpp"

#include <string>
#include <vector>

// Anchors and ends that no strip reaches, each with its code, its place in the file, and numbers.

namespace planish::test {
namespace {

TEST(SlitRefuses, AnchorsOnMissingStripsAndRidges) {
  const Vec3 at(180, 450, 30);
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{0, 5, StripEdge::left, at}, {6, 5, StripEdge::left, at}};
      },
      code::unknown_strip, "/anchors/1/strip", "6");
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{-1, 5, StripEdge::left, at}};
      },
      code::unknown_strip, "/anchors/0/strip");
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{0, 11, StripEdge::left, at}};
      },
      code::unknown_ridge, "/anchors/0/ridge", "11");
  expect_chair_refused(
      [&](SlitDesign& d) {
        d.anchors = {{0, 5, StripEdge::left, {kNan, 0, 0}}};
      },
      code::invalid_input, "/anchors/0/at");
}

TEST(SlitRefuses, AnchorsOutOfReachSayingHowFar) {
  // From (360, 420, 0) up by 200 and on to the plane 360 away: 560 of 464 mm.
  expect_chair_refused(
      [](SlitDesign& d) {
        d.anchors = {{0, 5, StripEdge::left, {360, 620, 0}}};
      },
      code::out_of_reach, "/anchors/0/at", "96 mm");
  // The ridge on the panel does not move.
  expect_chair_refused(
      [](SlitDesign& d) {
        d.anchors = {{0, 0, StripEdge::left, {360, 423, 0}}};
      },
      code::out_of_reach, "/anchors/0/at", "3 mm");
  SlitSession session = started(chair());
  SlitDesign design = session.design();
  design.anchors = {{0, 5, StripEdge::left, {360, 620, 0}}};
  EXPECT_EQ(session.set_design(design).error().code, code::out_of_reach);
  EXPECT_TRUE(session.design().anchors.empty());
}

TEST(SlitRefuses, EndsThatCannotBePlaced) {
  SlitDesign design = chair();
  design.ends = {{.position = Vec3(0, 400, 30)}};
  expect_refused(design, code::bad_option, "/ends/0");
  design = asymmetric();
  design.ends[0].position = Vec3(-250, 200, 30);
  expect_refused(design, code::out_of_reach, "/ends/0/position");
  design = asymmetric();
  design.ends[2].direction = Vec3::Zero();
  expect_refused(design, code::invalid_input, "/ends/2/direction");
  design = asymmetric();
  design.ends[2].across = Vec3(1, 0, 1);
  expect_refused(design, code::invalid_input, "/ends/2/across", "135");
  design = asymmetric();
  design.ends.resize(7);
  design.ends[6].direction = Vec3(1, 0, 0);
  expect_refused(design, code::unknown_strip, "/ends/6");
}

TEST(SlitRefusesAsData, StripsAndRidgesFromZeroThatSentencesCountFromOne) {
  SlitDesign design = chair();
  design.anchors = {{2, 11, StripEdge::left, {180, 450, 30}}};
  const Error error = SlitSession::start(design).error();
  EXPECT_EQ(error.places[0], place::strip(2));
  EXPECT_EQ(error.places[1], place::ridge(11));
  EXPECT_EQ(pointers_in(error), std::vector<std::string>{"/anchors/0/ridge"});
  EXPECT_EQ(number_in(error, "last"), 10.0) << "as files count";
  EXPECT_EQ(number_in(error, "count"), 11.0);
  EXPECT_TRUE(error.message.starts_with("Strip 3 has no ridge 12:")) << error.message;
}

TEST(SlitRefusesAsData, AnAnchorOutOfReachWithItsPlaceAndDistances) {
  SlitDesign design = chair();
  design.anchors = {{0, 5, StripEdge::left, {360, 620, 0}}};
  const Error error = SlitSession::start(design).error();
  EXPECT_EQ(at_in(error, PlaceKind::point), (std::vector<double>{360, 620, 0}));
  EXPECT_NEAR(number_in(error, "missing"), 96.0, 1e-9);
  EXPECT_NEAR(number_in(error, "needed"), 560.0, 1e-9);
  EXPECT_NEAR(number_in(error, "available"), 464.0, 1e-9);
  EXPECT_EQ(unit_in(error, "missing"), "mm");
  EXPECT_EQ(ids_in(error, PlaceKind::strip), std::vector<std::string>{"1"});
  EXPECT_EQ(error.remedies.size(), 1u);
}

}  // namespace
}  // namespace planish::test
