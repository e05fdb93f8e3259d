#include "one_line.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

BrakeLine line_at(const Vec2& origin, const Vec2& along) {
  BrakeLine line;
  line.origin = origin;
  line.along = along.normalized();
  line.angle = Angle::degrees(90);
  line.inside_radius = 2.0;
  return line;
}

TEST(OneLine, TakesPiecesThatAreBentAlike) {
  const BrakeLine line = line_at({10, 20}, {3, 4});
  EXPECT_TRUE(lie_on_one_line(line, line_at({13, 24}, {3, 4})));
  EXPECT_TRUE(lie_on_one_line(line, line_at({4, 12}, {-3, -4})));  // run the other way
  EXPECT_FALSE(lie_on_one_line(line, line_at({13, 24.1}, {3, 4})));
  EXPECT_FALSE(lie_on_one_line(line, line_at({10, 20}, {3, 4.1})));
  EXPECT_FALSE(lie_on_one_line(line, line_at({10, 20}, {-4, 3})));
  BrakeLine other = line_at({13, 24}, {3, 4});
  other.reference_up = false;
  EXPECT_FALSE(lie_on_one_line(line, other));
  other = line_at({13, 24}, {3, 4});
  other.angle = Angle::degrees(91);
  EXPECT_FALSE(lie_on_one_line(line, other));
  other = line_at({13, 24}, {3, 4});
  other.inside_radius = 2.1;
  EXPECT_FALSE(lie_on_one_line(line, other));
  other = line_at({13, 24}, {3, 4});
  other.press_line = 0;
  EXPECT_FALSE(lie_on_one_line(line, other));
  EXPECT_FALSE(lie_on_one_line(other, line));
  other.press_line.reset();
  other.closes = 0;
  EXPECT_FALSE(lie_on_one_line(line, other));
  EXPECT_FALSE(lie_on_one_line(other, line));
}

/// A base whose flap at the left is bent up by a line across, with a bend at the edge of each: on
/// one line while the base is plane.
Sheet two_parts_with_flaps() {
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(Frame{}, {rectangle(60, 50)});
  const Rim across = builder.bend(builder.rim(base, 1),
                                  {Angle::degrees(90), 1.0, BendDirection::up});
  const FaceId beyond = builder.flange_behind(across, {rectangle(across.length, 60)});
  for (const auto& [face, side] : {std::pair{base, 0}, std::pair{beyond, 1}}) {
    const Rim rim = builder.bend(builder.rim(face, side),
                                 {Angle::degrees(90), 1.0, BendDirection::up});
    builder.flange_behind(rim, {rectangle(rim.length, 25)});
  }
  return builder.finish();
}

TEST(OneLine, EndsWhereWhatIsFormedTurnsItAway) {
  Room room(two_parts_with_flaps(), plain_tools());
  const int first = room.line_of(2), second = room.line_of(3);
  EXPECT_EQ(together(room.cache(), first, room.lines({})).size(), 2u);
  EXPECT_EQ(together(room.cache(), second, room.lines({})).size(), 2u);
  EXPECT_EQ(together(room.cache(), first, room.lines({1})), std::vector<int>{first});
  EXPECT_EQ(together(room.cache(), first, room.lines({3})), std::vector<int>{first});
}

/// The pieces of lines pressed together, along the first: as long as both, and as far apart.
TEST(OneLine, MeasuresThePiecesThatArePressed) {
  Room room(two_parts_with_flaps(), plain_tools());
  const LineSet flat = room.lines({});
  const double zone = room.work().lines[room.line_of(1)].bend.allowance;
  const Setting both{&flat, room.lines({2, 3}), std::min(room.line_of(2), room.line_of(3))};
  const auto pieces = pressed_pieces(room.cache(), both);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].size(), 60.0, 1e-9);
  EXPECT_NEAR(pieces[1].size(), 60.0, 1e-9);
  EXPECT_NEAR(pieces[1].lo - pieces[0].hi, zone, 1e-9);
  const Setting alone{&flat, room.lines({2}), room.line_of(2)};
  ASSERT_EQ(pressed_pieces(room.cache(), alone).size(), 1u);
  EXPECT_NEAR(pressed_pieces(room.cache(), alone).front().size(), 60.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
