#include "stroke_inputs.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Each way in which a line looks has a number, and no two numbers look the same way.
TEST(StrokeInputs, NumberDirections) {
  Room room(box(), plain_tools());
  const StrokeInputs& inputs = room.inputs();
  EXPECT_EQ(inputs.directions.size(), 4u);  // of two pairs of parallel lines
  std::set<int> numbers;
  for (const BrakeLine& line : inputs.work.lines)
    for (const Vec2& way : {line.across(), Vec2(-line.across())}) {
      const int number = direction_number(inputs, way);
      ASSERT_GE(number, 0);
      EXPECT_NEAR(inputs.directions[number].dot(way), 1.0, 1e-6);
      numbers.insert(number);
    }
  EXPECT_EQ(numbers.size(), 4u);
  EXPECT_EQ(direction_number(inputs, Vec2(1, 1).normalized()), -1);
}

TEST(StrokeInputs, TurnSpringbackFurther) {
  PlanOptions options;
  options.springback = Angle::degrees(3);
  Room room(l_bracket(), plain_tools(), options);
  EXPECT_NEAR(most_turn(room.inputs(), 0), 93.0 * std::numbers::pi / 180.0, 1e-12);
}

TEST(StrokeInputs, LeaveOutOneThicknessUnlessTold) {
  PlanOptions options;
  Room room(l_bracket(), plain_tools(), options);  // t 2
  EXPECT_EQ(shortfall(room.inputs()), 2.0);
  options.shortfall = 0.0;
  Room told(l_bracket(), plain_tools(), options);
  EXPECT_EQ(shortfall(told.inputs()), 0.0);
}

/// The gauge is on the left of the line or on its right, as the direction's number says.
TEST(StrokeInputs, SetTheGaugeOnASide) {
  Room room(box(), plain_tools());
  const StrokeInputs& inputs = room.inputs();
  const LineSet flat = room.lines({});
  for (int line = 0; line < inputs.lines(); ++line)
    for (const int side : {1, -1}) {
      StrokeChoice choice{only(inputs.lines(), line), 0, 0, true};
      choice.direction = direction_number(inputs, side * inputs.work.lines[line].across());
      const Setting at = setting(inputs, flat, choice);
      EXPECT_EQ(at.line, line);
      EXPECT_EQ(at.direction, side);
      EXPECT_EQ(at.formed, &flat);
      EXPECT_EQ(motion(inputs, at).bend().allowance, inputs.work.lines[line].bend.allowance);
      // The sheet lies on the die's top before it is bent.
      EXPECT_NEAR(motion(inputs, at).die_height(0.0), -inputs.work.thickness, 1e-9);
    }
}

}  // namespace
}  // namespace planish::test
