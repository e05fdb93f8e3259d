#include "sample_transitions.hpp"
#include "support/error_data.hpp"

#include <planish/transition/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

// Each refusal with its code, its place in the file, and numbers in its message.

namespace planish::test {
namespace {

using ::testing::ElementsAre;

void expect_refused(const TransitionSpec& spec, ErrorCode code, const std::string& where,
                    const std::string& in_message = "") {
  const auto transition = make_transition(spec);
  ASSERT_FALSE(transition) << "made, but " << code_name(code) << " was due at " << where;
  EXPECT_EQ(code_name(transition.error().code), code_name(code)) << transition.error().message;
  EXPECT_EQ(transition.error().where, where) << transition.error().message;
  EXPECT_NE(transition.error().message.find(in_message), std::string::npos)
      << transition.error().message;
  EXPECT_TRUE(is_told(transition.error())) << transition.error().message;
  EXPECT_FALSE(pointers_in(transition.error()).empty()) << transition.error().message;
}

Error refusal_of(const TransitionSpec& spec) {
  const auto transition = make_transition(spec);
  EXPECT_FALSE(transition);
  return transition ? Error{} : transition.error();
}

TransitionSpec square_to_round() {
  return between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
}

void expect_profile_refused(const Profile& profile, ErrorCode code, const std::string& where,
                            const std::string& in_message = "") {
  TransitionSpec spec = square_to_round();
  spec.from.profile = profile;
  expect_refused(spec, code, "/from/profile" + where, in_message);
  spec = square_to_round();
  spec.to.profile = profile;
  expect_refused(spec, code, "/to/profile" + where, in_message);
}

TEST(TransitionRefuses, PolygonsThatAreNone) {
  // Two corners are a ridge, and one an apex, of the second profile.
  TransitionSpec roof = square_to_round();
  roof.to.profile = PolygonProfile{{{5, 5}, {5, 5}}};
  expect_refused(roof, code::repeated_corner, "/to/profile/polygon/1");
  roof.to.profile = PolygonProfile{{{0, std::nan("")}}};
  expect_refused(roof, code::invalid_input, "/to/profile/polygon");
  expect_profile_refused(PolygonProfile{}, code::too_few_corners, "/polygon", "0");
  expect_profile_refused(PolygonProfile{{{0, 0}, {100, 0}, {100, 0}, {0, 100}}},
                         code::repeated_corner, "/polygon/2", "(100 mm, 0 mm)");
  expect_profile_refused(PolygonProfile{{{0, 0}, {100, 0}, {0, 100}, {0, 0}}},
                         code::repeated_corner, "/polygon/0");
  expect_profile_refused(PolygonProfile{{{0, 0}, {100, 0}, {0, 100}, {110, 100}}},
                         code::self_crossing, "/polygon");
  expect_profile_refused(PolygonProfile{{{0, 0}, {50, 0}, {100, 0}}}, code::invalid_input,
                         "/polygon");
  expect_profile_refused(PolygonProfile{{{0, 0}, {std::nan(""), 0}, {100, 50}}},
                         code::invalid_input, "/polygon");
}

TEST(TransitionRefuses, ProfilesThatAreNotConvex) {
  const std::vector<Vec2> notched{{0, 0}, {100, 0}, {40, 30}, {0, 100}};
  expect_profile_refused(PolygonProfile{notched}, code::profile_not_convex, "/polygon/2",
                         "corner 3");
  expect_profile_refused(PolygonProfile{{notched.rbegin(), notched.rend()}},
                         code::profile_not_convex, "/polygon/1", "(40 mm, 30 mm)");
  // A pentagram winds round twice.
  PolygonProfile star;
  for (int i = 0; i < 5; ++i)
    star.corners.push_back(regular_polygon(5, 50).corners[2 * i % 5]);
  expect_profile_refused(star, code::self_crossing, "/polygon");

  SplineProfile spline{regular_polygon(8, 50).corners};
  spline.points[3] *= 0.7;
  TransitionSpec spec = square_to_round();
  spec.from.profile = spline;
  const auto transition = make_transition(spec);
  ASSERT_FALSE(transition);
  EXPECT_EQ(transition.error().code, code::profile_not_convex);
  EXPECT_TRUE(transition.error().where == "/from/profile/spline/2" ||
              transition.error().where == "/from/profile/spline/3")
      << transition.error().where;
}

TEST(TransitionRefuses, SplinesThatAreNone) {
  expect_profile_refused(SplineProfile{{{0, 0}, {100, 0}}}, code::too_few_corners, "/spline", "2");
  expect_profile_refused(SplineProfile{{{0, 0}, {0, 0}, {100, 0}, {0, 100}}}, code::repeated_corner,
                         "/spline/1");
  expect_profile_refused(SplineProfile{{{0, 0}, {100, 0}, {0, 100}, {110, 100}}},
                         code::self_crossing, "/spline");
}

TEST(TransitionRefuses, SizesThatAreNone) {
  for (const double wrong : {0.0, -3.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    expect_profile_refused(EllipseProfile{wrong, wrong}, code::invalid_input,
                           std::isnan(wrong) ? "/ellipse" : "/circle");
    expect_profile_refused(EllipseProfile{20, wrong}, code::invalid_input, "/ellipse");
    expect_profile_refused(RoundedRectangleProfile{wrong, 50, 5}, code::invalid_input,
                           "/rounded_rectangle");
    expect_profile_refused(RoundedRectangleProfile{50, wrong, 5}, code::invalid_input,
                           "/rounded_rectangle");
    expect_profile_refused(ObroundProfile{wrong, 20}, code::invalid_input, "/obround");
    expect_profile_refused(ObroundProfile{90, wrong}, code::invalid_input, "/obround");
    TransitionSpec spec = square_to_round();
    spec.thickness = wrong;
    expect_refused(spec, code::invalid_input, "/thickness");
  }
  expect_profile_refused(RoundedRectangleProfile{50, 30, 16}, code::invalid_input,
                         "/rounded_rectangle/radius", "15 mm");
  expect_profile_refused(RoundedRectangleProfile{50, 30, -1}, code::invalid_input,
                         "/rounded_rectangle/radius");
  expect_profile_refused(ObroundProfile{20, 30}, code::invalid_input, "/obround/length", "30 mm");
}

TEST(TransitionRefuses, NumbersThatMakeNoSense) {
  TransitionSpec spec = square_to_round();
  for (const double k : {-0.1, 1.1, std::nan("")}) {
    spec.k_factor = k;
    expect_refused(spec, code::invalid_input, "/k_factor");
  }
  spec = square_to_round();
  spec.pressing = PressCount{0};
  expect_refused(spec, code::invalid_input, "/press_lines");
  spec.pressing = PressAngle{Angle()};
  expect_refused(spec, code::invalid_input, "/press_lines");
  for (const double chord : {0.0, -1.0, std::nan("")}) {
    spec.pressing = PressChord{chord};
    expect_refused(spec, code::invalid_input, "/press_lines");
  }
  spec = square_to_round();
  spec.to.frame.origin.x() = std::nan("");
  expect_refused(spec, code::invalid_input, "/to/frame");
  spec = square_to_round();
  spec.from.frame.z.setConstant(std::numeric_limits<double>::infinity());
  expect_refused(spec, code::invalid_input, "/from/frame");
}

TEST(TransitionRefuses, ThicknessTooLargeForAProfileOrABend) {
  TransitionSpec spec = square_to_round();
  spec.to.profile = EllipseProfile{3, 3};
  spec.thickness = 10.0;
  spec.k_factor = 0.4;
  spec.sizes_are = SizesAre::outside;
  expect_refused(spec, code::radius_too_small, "/to/profile/circle", "3 mm");
  spec.to.profile = EllipseProfile{30, 10};  // 10² / 30 at its ends
  expect_refused(spec, code::radius_too_small, "/to/profile/ellipse", "3.333 mm");
  spec.to.profile = RoundedRectangleProfile{60, 60, 4};
  expect_refused(spec, code::radius_too_small, "/to/profile/rounded_rectangle");
  spec.to.profile = ObroundProfile{60, 8};
  expect_refused(spec, code::radius_too_small, "/to/profile/obround");
  spec.to.profile = rectangle(60, 8);
  expect_refused(spec, code::radius_too_small, "/to/profile/polygon");
  // The neutral surface of a tube 5 mm thick, 4 mm about the axis in the middle, has room for 2.5
  // mm only.
  TransitionSpec tube = between(EllipseProfile{2.4, 2.4}, EllipseProfile{2.4, 2.4}, {0, 0, 50});
  tube.thickness = 5.0;
  expect_refused(tube, code::radius_too_small, "/thickness", "2.5 mm");
  tube.from.profile = tube.to.profile = EllipseProfile{2.6, 2.6};
  EXPECT_TRUE(make_transition(tube));
}

TEST(TransitionRefuses, ProfilesThatMeet) {
  TransitionSpec spec = square_to_round();
  spec.to.frame = frame_at(Vec3::Zero());
  expect_refused(spec, code::profiles_meet, "/to/frame", "the same plane");
  spec.to.frame = frame_at({500, 0, 0}, kPi);
  expect_refused(spec, code::profiles_meet, "/to/frame");
  // The circle's lowest point in the square's plane.
  spec.to.frame = frame_at({0, 80, 30}, kPi / 2);
  expect_refused(spec, code::profiles_meet, "/to/frame", "touches");
  std::swap(spec.from, spec.to);
  expect_refused(spec, code::profiles_meet, "/to/frame", "touches");
}

TEST(TransitionRefuses, ProfilesOnBothSidesOfTheOthersPlane) {
  TransitionSpec spec = square_to_round();
  spec.to.frame = frame_at({0, 80, 20}, kPi / 2);
  expect_refused(spec, code::profile_hidden, "/to/frame", "10 mm and 50 mm");
  std::swap(spec.from, spec.to);
  expect_refused(spec, code::profile_hidden, "/to/frame");
  // Above the square's plane, but its own plane cuts the square.
  spec = square_to_round();
  spec.to.frame = frame_at({0, 0, 80}, kPi / 3);
  expect_refused(spec, code::profile_hidden, "/to/frame");
}

TEST(TransitionRefuses, CurvesThatDipThroughThePlaneBetweenTheirQuarters) {
  // Turned by 0.5 rad, so that the lowest point of the circle is none where its quarters meet.
  for (const double below : {0.1, 1e-3, 1e-6}) {
    const double tilt = 0.3, radius = 100;
    TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{radius, radius}, {0, 0, 0});
    spec.to.frame = frame_at({0, 0, radius * std::sin(tilt) - below}, tilt, 0.5);
    expect_refused(spec, code::profile_hidden, "/to/frame");
    spec.to.frame = frame_at({0, 0, radius * std::sin(tilt) + below}, tilt, 0.5);
    EXPECT_TRUE(make_transition(spec)) << below;
  }
}

TEST(TransitionRefuses, SeamsThatDoNotExist) {
  TransitionSpec spec = square_to_round();
  for (const int none : {-1, 4}) {
    spec.seam = SeamEdge{none};
    expect_refused(spec, code::unknown_seam, "/seam/edge", "0 to 3");
    spec.seam = SeamCorner{none};
    expect_refused(spec, code::unknown_seam, "/seam/corner", "0 to 3");
  }
  for (const double none : {-0.1, 1.1, std::nan("")}) {
    spec.seam = SeamParameter{none};
    expect_refused(spec, code::unknown_seam, "/seam/parameter");
  }
  std::swap(spec.from.profile, spec.to.profile);
  spec.seam = SeamEdge{0};
  expect_refused(spec, code::unknown_seam, "/seam/edge", "no edges");
  spec.seam = SeamCorner{0};
  expect_refused(spec, code::unknown_seam, "/seam/corner", "no corners");
}

TEST(TransitionRefuses, APieceForEachSideOfWhatHasNone) {
  TransitionSpec spec = between(EllipseProfile{50, 50}, EllipseProfile{30, 30}, {0, 0, 80});
  spec.pieces = Division::per_side;
  expect_refused(spec, code::invalid_input, "/pieces");
}

TEST(TransitionRefusesAsData, ACornerThatTurnsInwardsFromOneAndItsPlaceInTheFile) {
  TransitionSpec spec = square_to_round();
  spec.from.profile = PolygonProfile{{{0, 0}, {100, 0}, {50, 50}, {100, 100}, {0, 100}}};
  const Error error = refusal_of(spec);
  EXPECT_THAT(pointers_in(error), ElementsAre("/from/profile/polygon/2"));
  EXPECT_EQ(number_in(error, "corner"), 3.0);
  EXPECT_EQ(number_in(error, "x"), 50.0);
  EXPECT_NEAR(number_in(error, "angle"), 90.0, 1e-9);
  EXPECT_EQ(unit_in(error, "angle"), unit::degrees);
  EXPECT_EQ(error.remedies.size(), 1u);
}

TEST(TransitionRefusesAsData, WhereAProfileReachesThroughThePlaneOfTheOther) {
  TransitionSpec spec = square_to_round();
  spec.to.frame = frame_at({0, 80, 20}, kPi / 2);
  const Error error = refusal_of(spec);
  EXPECT_NEAR(number_in(error, "below"), 10.0, 1e-9);
  EXPECT_NEAR(number_in(error, "above"), 50.0, 1e-9);
  const std::vector<double> at = at_in(error, PlaceKind::point);
  ASSERT_EQ(at.size(), 3u);
  EXPECT_NEAR(at[2], -10.0, 1e-9) << "the lowest point of the circle";
  EXPECT_NEAR(at[1], 80.0, 1e-9);
}

TEST(TransitionRefuses, TolerancesThatAreNotPositive) {
  for (const double wrong : {0.0, -1e-9, std::nan("")}) {
    EXPECT_EQ(make_transition(square_to_round(), {.tolerance = wrong}).error().code,
              code::bad_option);
    EXPECT_EQ(folded_pieces(square_to_round(), {.tolerance = wrong}).error().code,
              code::bad_option);
  }
}

}  // namespace
}  // namespace planish::test
