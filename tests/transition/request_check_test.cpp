#include "request_check.hpp"

#include "sample_transitions.hpp"
#include "support/error_data.hpp"

#include <planish/transition/codes.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace planish::test {
namespace {

using transition_detail::check_request;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
const double kNoNumber = std::nan("");

TransitionSpec sound_request() {
  return between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
}

/// The field that a changed request is refused for; empty if it is not.
template <typename Change>
std::string refused_field(const Change& change) {
  TransitionSpec spec = sound_request();
  change(spec);
  const auto sound = check_request(spec);
  if (sound) return "";
  EXPECT_EQ(sound.error().code, code::invalid_input);
  EXPECT_TRUE(is_told(sound.error())) << sound.error().message;
  return sound.error().where;
}

TEST(TransitionRequest, AsksForAThicknessAboveZero) {
  const auto field = [](double thickness) {
    return refused_field([&](TransitionSpec& spec) { spec.thickness = thickness; });
  };
  for (const double wrong : {0.0, -1e-9, kInfinite, kNoNumber})
    EXPECT_EQ(field(wrong), "/thickness") << wrong;
  for (const double right : {1e-9, 0.5, 400.0})
    EXPECT_EQ(field(right), "") << right;
}

TEST(TransitionRequest, AsksForAKFactorFromZeroToOne) {
  const auto field = [](double k) {
    return refused_field([&](TransitionSpec& spec) { spec.k_factor = k; });
  };
  for (const double wrong : {-1e-9, 1.0 + 1e-9, kInfinite, kNoNumber})
    EXPECT_EQ(field(wrong), "/k_factor") << wrong;
  for (const double right : {0.0, 0.44, 1.0})
    EXPECT_EQ(field(right), "") << right;
}

TEST(TransitionRequest, AsksForPressLinesThatThereCanBe) {
  const auto field = [](const Pressing& pressing) {
    return refused_field([&](TransitionSpec& spec) { spec.pressing = pressing; });
  };
  for (const Pressing& wrong :
       {Pressing{PressCount{0}}, Pressing{PressCount{-2}}, Pressing{PressAngle{Angle()}},
        Pressing{PressAngle{Angle::degrees(-1)}}, Pressing{PressAngle{Angle::degrees(kNoNumber)}},
        Pressing{PressChord{0.0}}, Pressing{PressChord{-0.1}}, Pressing{PressChord{kNoNumber}}})
    EXPECT_EQ(field(wrong), "/press_lines") << wrong.index();
  for (const Pressing& right :
       {Pressing{}, Pressing{PressCount{1}}, Pressing{PressAngle{Angle::degrees(0.1)}},
        Pressing{PressChord{0.1}}})
    EXPECT_EQ(field(right), "") << right.index();
}

TEST(TransitionRequest, AsksForFiniteFrames) {
  for (Vec3 Frame::*part : {&Frame::origin, &Frame::x, &Frame::y, &Frame::z})
    for (const double wrong : {kNoNumber, kInfinite, -kInfinite}) {
      EXPECT_EQ(refused_field([&](TransitionSpec& s) { (s.from.frame.*part).y() = wrong; }),
                "/from/frame");
      EXPECT_EQ(refused_field([&](TransitionSpec& s) { (s.to.frame.*part).z() = wrong; }),
                "/to/frame");
    }
}

}  // namespace
}  // namespace planish::test
