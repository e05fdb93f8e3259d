#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

/// A part in a stage.
PlacedPart placed_in(const PartTree& tree, int number, const LineSet& formed) {
  const PartTree::Part& part = tree.parts()[number];
  if (part.before < 0) return tree.placed(number, nullptr, PartTree::State::flat);
  const PlacedPart before = placed_in(tree, part.before, formed);
  return tree.placed(number, &before,
                     holds(formed, part.over) ? PartTree::State::formed : PartTree::State::flat);
}

/// Points in the middle of the material of a face of a flange: in the pattern and in space.
struct PlacedPoint {
  int body = 0;
  Vec3 pattern, space;
};

std::vector<PlacedPoint> points_of(const Sheet& sheet, const Layout& layout,
                                   const Workpiece& work) {
  std::vector<PlacedPoint> points;
  for (int body = 0; body < std::ssize(work.bodies); ++body)
    for (const FaceId face : work.bodies[body].faces)
      for (const Curve2& curve : layout.outline(face)) {
        const Vec2 p = start_of(curve), uv = layout.fold(sheet, face, p);
        const double depth = 0.5 * sheet.thickness - sheet.reference_depth;
        points.push_back({body, Vec3(p.x(), p.y(), 0.0),
                          skin_point(sheet[face], uv) - depth * outward_normal(sheet[face], uv)});
      }
  return points;
}

/// With every line formed but the one it is seen from, which is turned by hand, the workpiece is
/// the sheet as it is folded: distances between all points are those in space.
void expect_folded_as_drawn(const Sheet& sheet, const FlattenOptions& options) {
  Room room(sheet, plain_tools(), {}, options);
  const Workpiece& work = room.work();
  const std::vector<PlacedPoint> points = points_of(sheet, room.layout(), work);
  const int lines = static_cast<int>(work.lines.size());
  LineSet all = no_lines(lines);
  for (int i = 0; i < lines; ++i)
    insert(all, i);
  for (int seen_from = 0; seen_from < lines; ++seen_from) {
    const PartTree tree(work, seen_from);
    // Both sides of the line by themselves: the line is not formed.
    for (const bool left : {false, true}) {
      std::vector<Vec3> placed, space;
      for (const PlacedPoint& point : points) {
        const int part = tree.part_of_body(point.body);
        if (tree.parts()[part].left != left) continue;
        placed.push_back(tree.place(part, all) * point.pattern);
        space.push_back(point.space);
      }
      for (size_t i = 0; i < placed.size(); ++i)
        for (size_t j = 0; j < i; ++j)
          EXPECT_NEAR((placed[i] - placed[j]).norm(), (space[i] - space[j]).norm(), 1e-6)
              << "seen from line " << seen_from;
      // And it is no mirror image.
      for (size_t i = 3; i < placed.size(); ++i) {
        const auto volume = [&](const std::vector<Vec3>& at) {
          return (at[1] - at[0]).cross(at[2] - at[0]).dot(at[i] - at[0]);
        };
        EXPECT_NEAR(volume(placed), volume(space), 1e-4) << "seen from line " << seen_from;
      }
    }
  }
}

TEST(StagePose, FoldsTheSheetAsItIsDrawn) {
  for (const UpSide up : {UpSide::reference, UpSide::other}) {
    FlattenOptions options;
    options.up = up;
    for (const Sheet& sheet : {u_channel(), z_profile(), staircase(3), box(),
                               box({}, BendDirection::down), l_bracket_down()})
      expect_folded_as_drawn(sheet, options);
    std::mt19937 random(17);
    for (int i = 0; i < 25; ++i)
      expect_folded_as_drawn(random_sheet(random, 6), options);
  }
}

/// Which side a flange is bent to: the second flange of an L lies above the first, as seen from
/// the skin that is inside, and the frame of the line has that side up.
TEST(StagePose, BendsTowardsTheInside) {
  for (const UpSide up : {UpSide::reference, UpSide::other})
    for (const Sheet& sheet : {u_channel(), l_bracket_down(), z_profile()}) {
      FlattenOptions options;
      options.up = up;
      Room room(sheet, plain_tools(), {}, options);
      const Workpiece& work = room.work();
      for (int line = 0; line < std::ssize(work.lines); ++line)
        for (int other = 0; other < std::ssize(work.lines); ++other) {
          if (other == line) continue;
          const PartTree tree(work, line);
          LineSet formed = no_lines(static_cast<int>(work.lines.size()));
          insert(formed, other);
          const bool same = work.lines[line].up == work.lines[other].up;
          for (int part = 0; part < std::ssize(tree.parts()); ++part) {
            if (tree.parts()[part].is_zone || disjoint(tree.parts()[part].path, formed)) continue;
            for (const Block3& block : placed_in(tree, part, formed).blocks)
              for (const Vec3& p : block.upper) {
                if (same) {
                  EXPECT_GT(p.z(), 0.0);
                } else {
                  EXPECT_LT(p.z(), 0.0);
                }
              }
          }
        }
    }
}

/// A formed zone is an arc between its flanges: its corners are at r and r + T from the axis.
TEST(StagePose, BendsZonesToTheirRadii) {
  Room room(u_channel(), plain_tools());  // r 2, T 1.5, web 40
  const Workpiece& work = room.work();
  const PartTree tree(work, 0);
  LineSet formed = no_lines(2);
  insert(formed, 1);
  int zones = 0;
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    if (!tree.parts()[part].is_zone || tree.parts()[part].index != 1) continue;
    ++zones;
    // From the pressed line: half of BA, the web, then the arc about (…, r).
    const Vec2 axis(0.5 * work.lines[0].bend.allowance + 40.0, 2.0);
    for (const Block3& block : placed_in(tree, part, formed).blocks) {
      for (const Vec3& p : block.upper)
        EXPECT_NEAR((Vec2(p.y(), p.z()) - axis).norm(), 2.0, 1e-9);
      for (const Vec3& p : block.lower)
        EXPECT_NEAR((Vec2(p.y(), p.z()) - axis).norm(), 3.5, 1e-9);
    }
  }
  EXPECT_EQ(zones, 1);
}

/// The strips of the zone that is being pressed.
std::vector<ArcStrip> strips_of(const Room& room, int line) {
  const PartTree tree(room.work(), line);
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    if (tree.parts()[part].is_zone && tree.parts()[part].before < 0)
      return tree.placed(part, nullptr, PartTree::State::flat).strips;
  return {};
}

/// The zone that is pressed is strips from the bend line outwards, as wide as its material; those
/// of both sides reach from the line to half of the allowance, and never beyond.
TEST(StagePose, CutsThePressedZoneIntoStripsFromTheLineOutwards) {
  for (const double angle : {30.0, 90.0, 135.0})
    for (const double radius : {0.8, 2.0, 7.3}) {
      const Room room(strip({Straight{60}, Turn{Angle::degrees(angle), radius, BendDirection::up},
                             Straight{45}},
                            80, 1.5),
                      plain_tools());
      const double half = 0.5 * room.work().lines[0].bend.allowance;
      std::array<std::vector<Interval>, 2> across;
      for (const ArcStrip& strip : strips_of(room, 0)) {
        EXPECT_LT(strip.from, strip.to);
        EXPECT_LE(strip.to, half);
        EXPECT_NEAR(strip.along.size(), 80.0, 1e-9);
        across[strip.left].push_back({strip.from, strip.to});
      }
      EXPECT_EQ(across[0].size(), across[1].size());
      for (auto& side : across) {
        std::ranges::sort(side, {}, &Interval::lo);
        ASSERT_FALSE(side.empty());
        EXPECT_NEAR(side.front().lo, 0.0, 1e-9);
        EXPECT_NEAR(side.back().hi, half, 1e-9);
        for (size_t k = 0; k + 1 < side.size(); ++k)
          EXPECT_NEAR(side[k].hi, side[k + 1].lo, 1e-9);
        // Chords of the outside stay near their arc: the sagitta of a step of the bend is small.
        const double step = room.work().lines[0].angle.radians() /
                            (2.0 * static_cast<double>(side.size()));
        EXPECT_LT((radius + 1.5) * (1.0 - std::cos(step / 2)), 0.05);
      }
    }
}

/// A circle across the bend takes its material out of the strips: what they cover is what is left,
/// but for the corners of their ends.
TEST(StagePose, CutsStripsAtOpenings) {
  const Room room(slot_across_bend(12.0), plain_tools());
  const double half = 0.5 * room.work().lines[0].bend.allowance;
  double covered = 0.0;
  for (const ArcStrip& strip : strips_of(room, 0)) {
    EXPECT_NEAR(strip.along.size(), 24.0, 1e-6);
    covered += (strip.to - strip.from) * strip.along.size();
  }
  EXPECT_NEAR(covered, 2 * half * 48.0, 1e-6);
}

}  // namespace
}  // namespace planish::test
