#include "bend_text.hpp"

#include <gtest/gtest.h>

namespace planish::io_detail {
namespace {

FlatBend a_bend() {
  FlatBend bend;
  bend.id = "B1";
  bend.direction = BendDirection::up;
  bend.angle = Angle::degrees(90);
  bend.inside_radius = 2.5;
  bend.lines = {{{0, 0}, {30, 40}}};
  return bend;
}

TEST(BendText, SaysDirectionAngleAndRadius) {
  FlatBend bend = a_bend();
  EXPECT_EQ(bend_text(bend), "B1 UP 90° R2.5");
  bend.direction = BendDirection::down;
  bend.angle = Angle::degrees(22.456);
  bend.inside_radius = 0.0;
  EXPECT_EQ(bend_text(bend), "B1 DOWN 22.46° R0");
}

TEST(BendText, PutsTheFirstStrokeBeforeIt) {
  FlatBend bend = a_bend();
  bend.stroke = 3;
  EXPECT_EQ(bend_text(bend), "3: B1 UP 90° R2.5");
}

TEST(BendText, CountsThePressLinesOfABendThatIsPressedPieceByPiece) {
  FlatBend bend = a_bend();
  bend.line_angles.assign(8, Angle::degrees(11.25));
  EXPECT_EQ(bend_text(bend), "B1 UP 8 × 11.25°");
  bend.line_angles[2] = Angle::degrees(12.5);
  bend.line_angles[5] = Angle::degrees(10);
  EXPECT_EQ(bend_text(bend), "B1 UP 8 × 10 … 12.5°");
  bend.line_angles = {Angle::degrees(90)};
  EXPECT_EQ(bend_text(bend), "B1 UP 90° R2.5");
  // Parts of one bend, each of its whole angle: pressed at once.
  bend.line_angles.assign(2, Angle::degrees(90));
  EXPECT_EQ(bend_text(bend), "B1 UP 90° R2.5");
}

}  // namespace
}  // namespace planish::io_detail
