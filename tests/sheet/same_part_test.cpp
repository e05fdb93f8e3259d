#include "support/sheets.hpp"

#include <planish/sheet/same_part.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace planish {
namespace {

using namespace test;
using std::numbers::pi;

Isometry2 turn(double degrees, const Vec2& shift = Vec2::Zero()) {
  Isometry2 motion = Isometry2::Identity();
  motion.translate(shift);
  motion.rotate(Eigen::Rotation2Dd(degrees * pi / 180.0));
  return motion;
}

Isometry2 mirror() {
  Isometry2 motion = Isometry2::Identity();
  motion.linear() = Eigen::Vector2d(-1.0, 1.0).asDiagonal();
  return motion;
}

void move(std::vector<Segment>& lines, const Isometry2& motion) {
  for (Segment& line : lines)
    line = {motion * line.a, motion * line.b};
}

/// The pattern in another place; what a mirror does to the drawing, with the bends as they were.
FlatPattern moved_pattern(FlatPattern pattern, const Isometry2& motion) {
  const bool mirrors = motion.linear().determinant() < 0.0;
  const auto move_loop = [&](Loop& loop) {
    loop = transformed(loop, motion);
    if (mirrors) loop = reversed(loop);
    // Contours may begin anywhere.
    std::ranges::rotate(loop, loop.begin() + static_cast<std::ptrdiff_t>(loop.size() / 2));
  };
  move_loop(pattern.outer.loop);
  for (Contour& opening : pattern.openings)
    move_loop(opening.loop);
  std::ranges::reverse(pattern.openings);
  for (Curve2& slit : pattern.slits)
    slit = reversed(transformed(slit, motion));
  for (FlatBend& bend : pattern.bends) {
    move(bend.lines, motion);
    move(bend.tangent_lines, motion);
    std::ranges::reverse(bend.tangent_lines);
  }
  std::ranges::reverse(pattern.bends);
  for (FlatFeature& feature : pattern.features)
    for (Loop& outline : feature.outlines)
      move_loop(outline);
  return pattern;
}

FlatPattern turned_over(FlatPattern pattern) {
  pattern = moved_pattern(std::move(pattern), mirror());
  for (FlatBend& bend : pattern.bends)
    bend.direction = bend.direction == BendDirection::up ? BendDirection::down : BendDirection::up;
  for (FlatFeature& feature : pattern.features)
    feature.side = other_side(feature.side);
  return pattern;
}

FlatPattern plate(const Loop& outer, const std::vector<Loop>& openings = {}) {
  FlatPattern pattern;
  pattern.thickness = 2.0;
  pattern.outer.loop = outer;
  pattern.perimeter = length(outer);
  pattern.area = signed_area(outer);
  for (const Loop& opening : openings) {
    pattern.openings.push_back({opening, {}});
    pattern.perimeter += length(opening);
    pattern.area += signed_area(opening);
  }
  return pattern;
}

FlatPattern square_with_hole(const Vec2& at, double radius = 3.0) {
  return plate(rectangle(100, 100), {circular_opening(at, radius)});
}

/// Different when seen in a mirror.
Loop scalene() { return polygon({{0, 0}, {60, 0}, {20, 35}}); }

FlatPattern flat(const Sheet& sheet) {
  const auto pattern = flatten(sheet);
  EXPECT_TRUE(pattern) << pattern.error().message;
  return pattern.value_or(FlatPattern());
}

FlatBend across(const Segment& line, BendDirection direction) {
  FlatBend bend;
  bend.angle = Angle::degrees(90.0);
  bend.inside_radius = 2.0;
  bend.direction = direction;
  bend.lines = {line};
  bend.length = (line.b - line.a).norm();
  return bend;
}

TEST(SamePart, InAnyPlaceAndTurn) {
  for (const Sheet& sheet : {l_bracket(), z_profile(), box(), plate_with_holes(), ring(50, 20, 2),
                             cone_joined(), slot_across_bend(), hole_across_bend(20, 0.44)}) {
    const FlatPattern pattern = flat(sheet);
    for (const double degrees : {0.0, 17.0, 90.0, 180.0, 233.3})
      EXPECT_TRUE(is_same_part(pattern, moved_pattern(pattern, turn(degrees, {300, -70}))));
  }
}

TEST(SamePart, SeenFromItsOtherSide) {
  for (const Sheet& sheet : {l_bracket(), z_profile(), box(), plate_with_holes()}) {
    const FlatPattern pattern = flat(sheet);
    EXPECT_TRUE(is_same_part(pattern, turned_over(pattern)));
    EXPECT_TRUE(is_same_part(pattern, moved_pattern(turned_over(pattern), turn(40, {1, 2}))));
  }
  EXPECT_TRUE(is_same_part(plate(scalene()), moved_pattern(plate(scalene()), mirror())));
}

TEST(SamePart, OfTheSheetSeenFromEitherSkin) {
  // The same solid; the reference skin is inside the bend, or outside.
  const Sheet sheet = slot_into_bend();
  for (const auto up : {UpSide::reference, UpSide::other})
    for (const auto other_up : {UpSide::reference, UpSide::other})
      EXPECT_TRUE(is_same_part(*flatten(sheet, {.up = up}), *flatten(sheet, {.up = other_up})));
}

TEST(SamePart, NotItsMirrorImage) {
  // A left and a right part: the drawing mirrored, bends still up.
  FlatPattern left = plate(scalene());
  left.bends = {across({{10, 0}, {10, 10}}, BendDirection::up)};
  const FlatPattern right = moved_pattern(left, mirror());
  EXPECT_FALSE(is_same_part(left, right));
  EXPECT_FALSE(is_same_part(right, left));
  EXPECT_TRUE(is_same_part(left, turned_over(left)));
}

TEST(SamePart, IsItsOwnMirrorImageWhereItIsSymmetric) {
  // An L bracket is; the mirror takes each half of the box to the other.
  for (const Sheet& sheet : {l_bracket(), box()}) {
    const FlatPattern pattern = flat(sheet);
    EXPECT_TRUE(is_same_part(pattern, moved_pattern(pattern, mirror())));
  }
}

TEST(SamePart, BentUpIsNotBentDown) {
  FlatPattern up = plate(rectangle(100, 40), {circular_opening({10, 10}, 3)});
  up.bends = {across({{60, 0}, {60, 40}}, BendDirection::up)};
  FlatPattern down = up;
  down.bends[0].direction = BendDirection::down;
  EXPECT_FALSE(is_same_part(up, down));
  // Without the hole the plate turned over covers itself.
  up.openings.clear();
  down.openings.clear();
  EXPECT_TRUE(is_same_part(up, down));
}

TEST(SamePart, TriesEveryTurnOfASymmetricOutline) {
  // A hole off the diagonals has eight places on a square, four by turning, four by turning over.
  const FlatPattern one = square_with_hole({20, 30});
  for (const Vec2& at : {Vec2(20, 30), Vec2(70, 20), Vec2(80, 70), Vec2(30, 80)})
    EXPECT_TRUE(is_same_part(one, square_with_hole(at)));
  for (const Vec2& at : {Vec2(80, 30), Vec2(30, 20)}) {
    EXPECT_TRUE(is_same_part(one, square_with_hole(at)));
    FlatPattern bent = one, other = square_with_hole(at);
    bent.bends = {across({{50, 0}, {50, 100}}, BendDirection::up),
                  across({{0, 50}, {100, 50}}, BendDirection::up)};
    other.bends = bent.bends;
    EXPECT_FALSE(is_same_part(bent, other));
  }
  EXPECT_FALSE(is_same_part(one, square_with_hole({20, 30.01})));
}

TEST(SamePart, OfARoundBlank) {
  const Loop disc = reversed(circular_opening({0, 0}, 50));
  const auto drilled = [&](const std::vector<double>& degrees) {
    std::vector<Loop> holes;
    for (const double angle : degrees)
      holes.push_back(circular_opening(turn(angle) * Vec2(30, 0), 4));
    return plate(disc, holes);
  };
  EXPECT_TRUE(is_same_part(plate(disc), moved_pattern(plate(disc), turn(12, {5, 5}))));
  EXPECT_TRUE(is_same_part(drilled({0, 90, 200}), drilled({13, 103, 213})));
  // The gaps between the holes in the other order: the same after turning over.
  EXPECT_TRUE(is_same_part(drilled({0, 90, 200}), drilled({0, 110, 200})));
  EXPECT_FALSE(is_same_part(drilled({0, 90, 200}), drilled({0, 90, 201})));
  EXPECT_FALSE(is_same_part(drilled({0, 90, 200}), drilled({0, 90, 180})));
}

TEST(SamePart, WhereItsCirclesBeginAndEnd) {
  // Put together from arcs a circle may lack a rounding of its full turn.
  const auto turned_hole = [](double start, double lacking) {
    return plate(rectangle(100, 40), {{Arc{{20, 10}, 3.0, start, lacking - 2.0 * pi}}});
  };
  EXPECT_TRUE(is_same_part(turned_hole(0.0, 0.0), turned_hole(1.0, 4e-15)));
}

TEST(SamePart, DiffersInWhatIsDoneToIt) {
  const FlatPattern part = flat(z_profile());
  const auto changed = [&](auto change) {
    FlatPattern other = part;
    change(other);
    return is_same_part(part, other);
  };
  EXPECT_TRUE(changed([](FlatPattern&) {}));
  EXPECT_FALSE(changed([](FlatPattern& p) { p.thickness += 0.1; }));
  EXPECT_FALSE(changed([](FlatPattern& p) { p.bends[0].angle = Angle::degrees(89.9); }));
  EXPECT_FALSE(changed([](FlatPattern& p) { p.bends[0].inside_radius += 0.05; }));
  EXPECT_FALSE(changed([](FlatPattern& p) { p.bends[0].lines[0].a.y() += 0.05; }));
  EXPECT_FALSE(changed([](FlatPattern& p) { p.bends[0].tangent_lines.pop_back(); }));
  EXPECT_FALSE(changed([](FlatPattern& p) { p.slits.push_back(Segment{{5, 5}, {9, 5}}); }));
  EXPECT_FALSE(changed([](FlatPattern& p) {
    p.features.push_back({"countersink", FormSide::up, {circular_opening({9, 9}, 2)}});
  }));
  EXPECT_TRUE(changed([](FlatPattern& p) { p.bends[0].id = "hinge"; }));
  EXPECT_FALSE(is_same_part(FlatPattern(), FlatPattern()));
  EXPECT_FALSE(is_same_part(part, FlatPattern()));
  EXPECT_FALSE(is_same_part(FlatPattern(), part));
}

TEST(SamePart, DiffersInOneCurve) {
  const Loop straight = rectangle(100, 40);
  const auto with_last = [&](const Curve2& curve) {
    Loop loop = straight;
    loop.back() = curve;
    return plate(loop);
  };
  const Curve2 bulge = Arc{{100.0, 20.0},
                           std::hypot(100.0, 20.0),
                           pi - std::atan2(20.0, 100.0),
                           2.0 * std::atan2(20.0, 100.0)};
  const Curve2 cubic = CubicSpline{{{0, 40}, {-3, 27}, {-3, 13}, {0, 0}}};
  const Curve2 elevated = CubicSpline{{{0, 40}, {0, 80.0 / 3}, {0, 40.0 / 3}, {0, 0}}};
  EXPECT_FALSE(is_same_part(plate(straight), with_last(bulge)));
  EXPECT_FALSE(is_same_part(plate(straight), with_last(cubic)));
  EXPECT_FALSE(is_same_part(with_last(bulge), with_last(cubic)));
  EXPECT_TRUE(is_same_part(plate(straight), with_last(elevated)));
}

TEST(SamePart, HasItsFormsOnTheirSides) {
  FlatPattern up = plate(scalene());
  up.features.push_back({"countersink", FormSide::up, {circular_opening({22, 12}, 4)}});
  EXPECT_TRUE(is_same_part(up, moved_pattern(up, turn(70))));
  EXPECT_TRUE(is_same_part(up, turned_over(up)));
  EXPECT_FALSE(is_same_part(up, moved_pattern(up, mirror())));
  FlatPattern down = up;
  down.features[0].side = FormSide::down;
  EXPECT_FALSE(is_same_part(up, down));
  // Countersunk on both sides it is its own mirror image.
  up.features[0].side = FormSide::both;
  EXPECT_TRUE(is_same_part(up, moved_pattern(up, mirror())));
}

RC_GTEST_PROP(SamePart, HoldsForRandomSheetsAndNotForTheirMirrorImages, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const Sheet sheet = random_sheet(random, 4);
  const Eigen::Isometry3d motion = Eigen::Translation3d(10, -20, 30) *
                                   Eigen::AngleAxisd(
                                       1.0 + 0.001 * static_cast<double>(random() % 1000),
                                       Vec3(1, 2, 3).normalized());
  const FlatPattern pattern = flat(sheet), other = flat(moved(sheet, motion));
  RC_ASSERT(is_same_part(pattern, other));
  RC_ASSERT(is_same_part(pattern, turned_over(other)));
  // A hole beside everything else that a mirror could keep.
  FlatPattern left = pattern;
  const Box2 box = bounds(pattern.outer.loop);
  left.openings.push_back({circular_opening(box.lo - Vec2(7, 13), 1.0), {}});
  if (!pattern.bends.empty()) RC_ASSERT(!is_same_part(left, moved_pattern(left, mirror())));
}

/// Groups of patterns kept in memory.
std::vector<std::size_t> grouped(const std::vector<FlatPattern>& parts) {
  std::vector<const FlatPattern*> firsts;
  PartGroups groups([&](std::size_t group) { return *firsts[group]; });
  std::vector<std::size_t> result;
  for (const FlatPattern& part : parts) {
    result.push_back(groups.add(part));
    if (groups.size() > firsts.size()) firsts.push_back(&part);
  }
  return result;
}

TEST(PartGroups, JoinTheFirstThatIsEqual) {
  const FlatPattern a = square_with_hole({20, 30}), b = square_with_hole({20, 31}),
                    c = square_with_hole({20, 30}, 4.0), d = flat(l_bracket());
  const auto turned = [](const FlatPattern& pattern) {
    return moved_pattern(pattern, turn(31, {4, 5}));
  };
  EXPECT_EQ(grouped({a, b, turned(a), d, c, turned(b), turned(c), turned(d), a}),
            (std::vector<std::size_t>{0, 1, 0, 2, 3, 1, 3, 2, 0}));
}

TEST(PartGroups, OfThousandsAreFoundFast) {
  // Plates whose lengths differ by a hundredth of a millimetre, each three times.
  std::vector<FlatPattern> parts;
  for (int turned = 0; turned < 3; ++turned)
    for (int i = 0; i < 2000; ++i)
      parts.push_back(moved_pattern(plate(rectangle(100 + 0.01 * i, 40)), turn(50.0 * turned)));
  const std::vector<std::size_t> groups = grouped(parts);
  for (std::size_t i = 0; i < parts.size(); ++i)
    ASSERT_EQ(groups[i], i % 2000);
}

}  // namespace
}  // namespace planish
