#include "collision/solid_meshes.hpp"
#include "support/sheets.hpp"

#include <planish/collision/meeting_faces.hpp>
#include <planish/collision/self_intersections.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::test {
namespace {

constexpr double kShared = 0.05;  // mm

TEST(MeetingFaces, AreNoneInSheetsThatCanBeMade) {
  for (const Sheet& sheet :
       {l_bracket(),
        l_bracket_down(),
        u_channel(),
        z_profile(),
        staircase(3),
        hem(),
        turn_of_250(),
        two_turns_of_270(),
        rolled(),
        box(),
        box({}, BendDirection::down),
        cone_joined(),
        truncated_cone(30, 60, 80, Angle::degrees(359.9), 2),
        lofted_corner(),
        slot_across_bend(),
        slot_into_bend(),
        hole_in_bend(6, 0.44),
        plate_with_holes(),
        strip({Turn{Angle::degrees(359.99), 20, BendDirection::up}}, 50, 1.5),
        strip({Straight{30}, Crease{Angle::degrees(90), BendDirection::down}, Straight{20}}, 20, 2),
        strip({Straight{30}, Crease{Angle::degrees(150), BendDirection::up}, Straight{20}}, 20,
              2)}) {
    const auto found = meeting_faces(sheet, kShared);
    EXPECT_TRUE(found.empty()) << index_of(found.front().faces[0]) << " and "
                               << index_of(found.front().faces[1]);
  }
}

TEST(MeetingFaces, AreFlangesThatRunThroughEachOther) {
  const Sheet sheet = strip(
      {Straight{40}, Turn{Angle::degrees(250), 3.0, BendDirection::up}, Straight{40}}, 20, 1.2);
  const auto found = meeting_faces(sheet, kShared);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(sheet[found[0].faces[0]].part_of, PartId(FlangeId{0}));
  EXPECT_EQ(sheet[found[0].faces[1]].part_of, PartId(FlangeId{1}));
  // Their middles cross at 70°, (r + t/2)(1 − cos α)/sin α before the end of the first.
  const double angle = 250 * std::numbers::pi / 180;
  const Vec3 crossing(40 + 3.6 * (1 - std::cos(angle)) / std::sin(angle), 10, -0.6);
  EXPECT_TRUE(found[0].where.contains(crossing));
}

TEST(MeetingFaces, AreOneFaceTwiceInATubeRolledOntoItself) {
  for (const double degrees : {361.0, 400.0, 700.0}) {
    const Sheet sheet = strip({Turn{Angle::degrees(degrees), 20, BendDirection::up}}, 50, 1.5);
    const auto found = meeting_faces(sheet, kShared);
    ASSERT_EQ(found.size(), 1u) << degrees;
    EXPECT_EQ(found[0].faces[0], found[0].faces[1]);
  }
}

/// Moves the corners of a border towards each other, by `by` each; the loop has segments only.
void shorten(BorderLoop& loop, int border, double by) {
  const int n = static_cast<int>(loop.size());
  auto& own = std::get<Segment>(loop[border].curve);
  const Vec2 along = by * (own.b - own.a).normalized();
  own = {own.a + along, own.b - along};
  std::get<Segment>(loop[(border + n - 1) % n].curve).b = own.a;
  std::get<Segment>(loop[(border + 1) % n].curve).a = own.b;
}

BorderLoop clockwise(double x0, double y0, double x1, double y1) {
  const std::array<Vec2, 4> ring{Vec2(x0, y0), Vec2(x0, y1), Vec2(x1, y1), Vec2(x1, y0)};
  BorderLoop loop;
  for (int i = 0; i < 4; ++i)
    loop.push_back({.curve = Segment{ring[i], ring[(i + 1) % 4]}});
  return loop;
}

TEST(MeetingFaces, AreNoneWhereAnOpeningLetsTheOtherThrough) {
  // The first flange meets the second, which narrows to its end, in the first's slot.
  const double t = 1.2, angle = 250 * std::numbers::pi / 180;
  Sheet sheet = strip(
      {Straight{40}, Turn{Angle::radians(angle), 3.0, BendDirection::up}, Straight{40}}, 20, t);
  const FaceId first = sheet.flanges[FlangeId{0}].faces.front();
  const FaceId second = sheet.flanges[FlangeId{1}].faces.front();
  for (const Joint& joint : sheet.joints)
    for (const BorderRef& ref : {joint.a, joint.b})
      if (ref.face == second) shorten(sheet.faces[second].loops.front(), (ref.border + 2) % 4, 9.0);
  ASSERT_EQ(meeting_faces(sheet, kShared).size(), 1u);
  // 5.1 mm from its start, where it is 17.7 wide.
  const double at = 40 + 3.6 * (1 - std::cos(angle)) / std::sin(angle);
  const double half = 0.5 * t * (1 + std::abs(std::cos(angle))) / std::abs(std::sin(angle));
  Sheet slotted = sheet;
  slotted.faces[first].loops.push_back(clockwise(at - half, 1.0, at + half, 19.0));
  EXPECT_TRUE(meeting_faces(slotted, kShared).empty());
  // A slot that is 0.2 too narrow.
  slotted.faces[first].loops.back() = clockwise(at - half, 1.0, at + half - 0.2, 19.0);
  EXPECT_EQ(meeting_faces(slotted, kShared).size(), 1u);
}

/// Straight pieces and bends of a strip, as a sheet and as the triangles of its solid.
RC_GTEST_PROP(MeetingFaces, AreFoundWhereTheSolidRunsThroughItselfAndOnlyThere, ()) {
  const double t = *rc::gen::inRange(5, 30) / 10.0, width = 10;
  std::vector<StripPart> parts;
  Path path;
  const int bends = *rc::gen::inRange(1, 5);
  for (int i = 0; i <= bends; ++i) {
    const double length = *rc::gen::inRange(5, 600) / 10.0;
    parts.emplace_back(Straight{length});
    path.straight(length);
    if (i == bends) break;
    const double degrees = *rc::gen::inRange(20, 260);
    const double radius = *rc::gen::inRange(2, 120) / 10.0;
    const bool up = *rc::gen::inRange(0, 4) > 0;
    parts.emplace_back(
        Turn{Angle::degrees(degrees), radius, up ? BendDirection::up : BendDirection::down});
    path.arc(radius + t / 2, (up ? 1 : -1) * degrees * std::numbers::pi / 180, t, 0.002);
  }
  const bool meets = !meeting_faces(strip(parts, width, t), kShared).empty();
  double deepest = 0.0;
  for (const SelfIntersection& found : find_self_intersections(path.sheet(t, width), 0.5 * kShared))
    deepest = std::max(deepest, found.depth);
  if (deepest > 1.5 * kShared) RC_ASSERT(meets);
  if (deepest == 0.0) RC_ASSERT(!meets);
  RC_CLASSIFY(meets);
}

}  // namespace
}  // namespace planish::test
