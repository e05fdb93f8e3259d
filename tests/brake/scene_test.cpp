#include "scene.hpp"

#include "brake/checked_order.hpp"
#include "brake/hemming_tools.hpp"
#include "brake/right_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

using std::numbers::pi;

/// A place of the pattern's inside skin in the machine, at a moment, if it hangs on the held body.
Vec3 in_machine(const StrokeScene& scene, const StrokeMoment& moment, const Vec2& p) {
  const Vec2 d = p - scene.origin;
  const double side = scene.pattern_up ? 1.0 : -1.0;
  const double x = d.dot(scene.along);
  const double y = side * (scene.along.x() * d.y() - scene.along.y() * d.x());
  const double up = moment.slope.radians();
  return {x, std::cos(up) * y + moment.by.x(), std::sin(up) * y + moment.by.y()};
}

/// L of 50 and 30, r 3, t 2, K 0.44: with the gauge at either flange and either side up.
TEST(Scene, HasTheSheetInTheMachine) {
  BrakeTools tools = plain_tools();
  tools.machine.gauge = BackGauge{10, 500, 10, {{0, 5}, {0, -5}, {20, -5}, {20, 5}}};
  for (Sheet sheet : {l_bracket(), l_bracket_down()}) {
    Checked part(std::move(sheet), tools);
    const CheckedOrder checked = part.check(one_by_one({0}));
    ASSERT_TRUE(checked.feasible());
    const Stroke& stroke = checked.strokes[0].stroke;
    const StrokeScene& scene = checked.strokes[0].scene;
    ASSERT_TRUE(stroke.gauge);
    // What touches the gauge is where the gauge is, parallel to the machine, and faces up.
    const StrokeMoment &first = scene.moments.front(), &last = scene.moments.back();
    const Vec3 a = in_machine(scene, first, stroke.gauge->edge.a),
               b = in_machine(scene, first, stroke.gauge->edge.b);
    EXPECT_NEAR(a.y(), stroke.gauge->distance, 1e-9);
    EXPECT_NEAR(b.y(), stroke.gauge->distance, 1e-9);
    EXPECT_NEAR(a.z(), 0.0, 1e-9);
    EXPECT_NEAR(std::abs(a.x() - b.x()), 40.0, 1e-9);
    EXPECT_NEAR(first.die, -2.0, 1e-9);
    // Bent: the edge is a flange's length up a slope of 45° from the end of the inside radius.
    const double allowance = pi / 2 * (3.0 + 0.44 * 2.0);
    const double flange = stroke.gauge->distance - 0.5 * allowance;
    const Vec3 bent = in_machine(scene, last, stroke.gauge->edge.a);
    EXPECT_NEAR(last.turn.degrees(), 90.0, 1e-9);
    EXPECT_NEAR(bent.y(), (3.0 + flange) * kSin45, 1e-9);
    EXPECT_NEAR(bent.z(), 3.0 * (1.0 - kSin45) + flange * kSin45, 1e-9);
    EXPECT_NEAR(bent.x(), a.x(), 1e-9);
    // The shoulders, of radius 1.5, touch the outside from below.
    const double round = 1.5, opening = 6.0;
    const double center = opening + round * std::tan(pi / 180 * 25);  // of a corner of 130°
    const double below = -2.0 / kSin45 + 3.0 * (1.0 - 1.0 / kSin45);  // where the outsides meet
    const double height = below + center - round / kSin45;            // of the circle's middle
    EXPECT_NEAR(last.die, height + round, 1e-9);
    // Both rows press the line but for a shortfall of a thickness at each end.
    const double from = std::min(a.x(), b.x()), to = std::max(a.x(), b.x());
    for (const auto& row : {scene.punch, scene.die}) {
      ASSERT_FALSE(row.empty());
      EXPECT_LE(row.front().from, from + 2.0);
      EXPECT_GE(row.back().from + row.back().length, to - 2.0);
      for (std::size_t i = 1; i < row.size(); ++i)
        EXPECT_NEAR(row[i].from, row[i - 1].from + row[i - 1].length, 1e-9);
    }
    EXPECT_NEAR(scene.punch.front().from - from, stroke.punch_rows.front().from, 1e-9);
  }
}

/// The return of a hem under the flat punch, from 150° on: 40 | 180° r 0.5 | 15, t 1, K 0.44.
TEST(Scene, HasTheReturnOfAHemUnderThePunch) {
  Checked part(hem(), hemming_tools());
  const CheckedOrder checked = part.check({{{BendId(0)}}, {{BendId(0)}, std::nullopt, true}});
  ASSERT_TRUE(checked.feasible());
  const StrokeScene& scene = checked.strokes[1].scene;
  const double angle = 150.0 * pi / 180, allowance = pi * (0.5 + 0.44);
  const double r = allowance / angle - 0.44;
  const StrokeMoment &first = scene.moments.front(), &last = scene.moments.back();
  EXPECT_NEAR(first.punch, r * (1 - std::cos(angle)) + 15 * std::sin(angle) - std::cos(angle),
              1e-9);
  EXPECT_NEAR(last.punch, 2 * 0.5 + 1.0, 1e-9);
  EXPECT_NEAR(last.turn.degrees(), 30.0, 1e-9);
  EXPECT_EQ(last.die, -1.0);
  EXPECT_EQ(last.slope.radians(), 0.0);
  // The middle of the return is half its length back from the tangent line, whichever side that is.
  EXPECT_NEAR(std::abs(scene.across), 0.5 * allowance + 7.5, 1e-9);
}

}  // namespace
}  // namespace planish::test
