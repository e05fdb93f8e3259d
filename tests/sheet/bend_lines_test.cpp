#include "bend_lines.hpp"

#include "support/sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

// A strip along x laid out from its first flange, which keeps its coordinates: bend lines run along
// y.

namespace planish::test {
namespace {

constexpr double kLinesK = 0.4;

std::vector<FlatBend> lines_of(const Sheet& sheet) {
  FlattenOptions options;
  options.allowance = ConstantK{kLinesK, "test"};
  options.root = FaceId{0};
  const auto layout = lay_out(sheet, options);
  if (!layout) throw std::runtime_error(layout.error().message);
  return sheet_detail::flat_bends(sheet, *layout);
}

/// Each line is at `x`, its ends at these y, in any order.
void expect_along_y(const std::vector<Segment>& lines, double x,
                    std::vector<std::pair<double, double>> ends, double tolerance = 1e-9) {
  ASSERT_EQ(lines.size(), ends.size());
  std::vector<std::pair<double, double>> found;
  for (const Segment& line : lines) {
    EXPECT_NEAR(line.a.x(), x, tolerance);
    EXPECT_NEAR(line.b.x(), x, tolerance);
    found.push_back(std::minmax(line.a.y(), line.b.y()));
  }
  std::ranges::sort(found);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_NEAR(found[i].first, ends[i].first, tolerance);
    EXPECT_NEAR(found[i].second, ends[i].second, tolerance);
  }
}

std::vector<Segment> at_x(const std::vector<Segment>& lines, double x) {
  std::vector<Segment> found;
  for (const Segment& line : lines)
    if (std::abs(line.a.x() - x) < 1e-3) found.push_back(line);
  return found;
}

TEST(BendLines, LieInTheMiddleOfTheBendBetweenItsTangentLines) {
  const Turn turn{Angle::degrees(70), 3.0, BendDirection::down};
  const FlatBend bend = lines_of(strip({Straight{50}, turn, Straight{30}}, 40.0, 2.0)).front();
  const double allowance = turn.angle.radians() * (3.0 + kLinesK * 2.0);
  expect_along_y(bend.lines, 50 + allowance / 2, {{0, 40}});
  expect_along_y(at_x(bend.tangent_lines, 50), 50, {{0, 40}});
  expect_along_y(at_x(bend.tangent_lines, 50 + allowance), 50 + allowance, {{0, 40}});
  EXPECT_EQ(bend.tangent_lines.size(), 2u);
  EXPECT_NEAR(bend.length, 40, 1e-9);
  EXPECT_EQ(bend.direction, BendDirection::down);
  ASSERT_EQ(bend.line_angles.size(), 1u);
  EXPECT_NEAR(bend.line_angles[0].degrees(), 70, 1e-12);
  EXPECT_EQ(bend.id, "B1");
}

TEST(BendLines, EndWhereThereIsNoMaterial) {
  // The slot is 12 of 60 wide; it begins 8 mm before the bend.
  const Opened part;
  const FlatBend across = lines_of(slot_across_bend(12.0, part)).front();
  const double allowance = part.turn.angle.radians() *
                           (part.turn.inside_radius + kLinesK * part.thickness);
  for (const double x : {part.first, part.first + allowance})
    expect_along_y(at_x(across.tangent_lines, x), x, {{0, 24}, {36, 60}});
  expect_along_y(across.lines, part.first + allowance / 2, {{0, 24}, {36, 60}});
  EXPECT_NEAR(across.length, 48, 1e-9);
  EXPECT_EQ(across.line_angles.size(), 2u);
  // The slot ends half-way round: the far tangent line is whole.
  const FlatBend into = lines_of(slot_into_bend(12.0, part)).front();
  expect_along_y(at_x(into.tangent_lines, part.first), part.first, {{0, 24}, {36, 60}});
  expect_along_y(at_x(into.tangent_lines, part.first + allowance), part.first + allowance,
                 {{0, 60}});
}

TEST(BendLines, EndAtARoundHole) {
  const Opened part;
  const double allowance = part.turn.angle.radians() *
                           (part.turn.inside_radius + kLinesK * part.thickness);
  const FlatBend bend = lines_of(hole_in_bend(4.0, kLinesK, part)).front();
  expect_along_y(bend.lines, part.first + allowance / 2, {{0, 28}, {32, 60}}, 1e-5);
  EXPECT_EQ(bend.tangent_lines.size(), 2u);
}

TEST(BendLines, OfPressesLieAtTheirRulings) {
  const Turn turn{Angle::degrees(80), 20.0, BendDirection::up};
  Sheet sheet = strip({Straight{50}, turn, Straight{30}}, 40.0, 2.0);
  const Box2 box = parameter_box(sheet[sheet[BendId{0}].faces.front()]);
  const std::vector<double> shares{0.125, 0.5, 0.9};
  for (const double share : shares)
    sheet.bends[BendId{0}].press_lines.push_back(
        {std::lerp(box.lo.x(), box.hi.x(), share), Angle::degrees(10 + 20 * share)});
  const FlatBend bend = lines_of(sheet).front();
  const double allowance = turn.angle.radians() * (20.0 + kLinesK * 2.0);
  ASSERT_EQ(bend.lines.size(), 3u);
  ASSERT_EQ(bend.line_angles.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_along_y({bend.lines[i]}, 50 + shares[i] * allowance, {{0, 40}});
    EXPECT_NEAR(bend.line_angles[i].degrees(), 10 + 20 * shares[i], 1e-9);
  }
  EXPECT_NEAR(bend.length, 40, 1e-9) << "the mean of the three";
}

TEST(BendLines, OfASharpBendLieBetweenTheBordersItJoins) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    Sheet sheet = strip({Straight{50}, Crease{Angle::degrees(90), direction}, Straight{30}}, 40, 2);
    const auto flat = flat_sheet(sheet, {.allowance = ConstantK{kLinesK, "test"},
                                         .root = FaceId{0},
                                         .keep_root = true,
                                         .up = UpSide::reference});
    ASSERT_TRUE(flat);
    const FlatBend& bend = flat->pattern.bends.front();
    const double allowance = std::acos(-1.0) / 2 * kLinesK * 2.0;
    const double from = direction == BendDirection::up ? 50.0 : 48.0;
    expect_along_y(bend.lines, from + allowance / 2, {{0, 40}});
    expect_along_y(at_x(bend.tangent_lines, from), from, {{0, 40}});
    expect_along_y(at_x(bend.tangent_lines, from + allowance), from + allowance, {{0, 40}});
    EXPECT_EQ(bend.tangent_lines.size(), 2u);
    EXPECT_NEAR(bend.length, 40, 1e-9);
    EXPECT_EQ(bend.line_angles.size(), 1u);
  }
}

TEST(BendLines, OfASharpBendWithATrimmedWallLieHalfWayBetweenTheirEnds) {
  SheetBuilder builder(2.0);
  const FaceId base = builder.flange({}, {rectangle(50, 40)});
  Rim rim = builder.crease(builder.rim(base, 1), {Angle::degrees(90), BendDirection::up});
  rim.frame.origin += 12 * rim.frame.y;
  rim.length = 20;
  builder.flange_behind(rim, {rectangle(20, 30)});
  const FlatBend bend = lines_of(builder.finish()).front();
  const double allowance = std::acos(-1.0) / 2 * kLinesK * 2.0;
  expect_along_y(bend.lines, 50 + allowance / 2, {{6, 36}});
  expect_along_y(at_x(bend.tangent_lines, 50), 50, {{0, 40}});
  expect_along_y(at_x(bend.tangent_lines, 50 + allowance), 50 + allowance, {{12, 32}});
}

/// A strip 50 | 90°, r 6 | 30, 40 wide, with an opening in its bend. Corners: the share of the bend
/// and the distance from its side y = 0, counter-clockwise.
Sheet opened_in_bend(const std::vector<Vec2>& corners) {
  Sheet sheet = strip(
      {Straight{50}, Turn{Angle::degrees(90), 6.0, BendDirection::up}, Straight{30}}, 40.0, 2.0);
  Face& face = sheet.faces[sheet[BendId{0}].faces.front()];
  const Box2 box = parameter_box(face);
  std::vector<Vec2> ring;
  for (const Vec2& p : corners)
    ring.emplace_back(box.lo.x() + p.x() * box.size().x(), box.hi.y() - p.y());
  BorderLoop loop;
  for (std::size_t i = 0; i < ring.size(); ++i)
    loop.push_back({.curve = Segment{ring[i], ring[(i + 1) % ring.size()]}});
  face.loops.push_back(std::move(loop));
  return sheet;
}

const double kOpenedAllowance = std::acos(-1.0) / 2 * (6.0 + kLinesK * 2.0);

TEST(BendLines, EndOnTheSidesOfAnObliqueOpening) {
  // A parallelogram that climbs 20 mm across the bend: half-way it is 20 to 26 from the side.
  const Sheet oblique = opened_in_bend({{0.1, 10}, {0.9, 30}, {0.9, 36}, {0.1, 16}});
  const FlatBend bend = lines_of(oblique).front();
  expect_along_y(bend.lines, 50 + kOpenedAllowance / 2, {{0, 20}, {26, 40}});
  EXPECT_NEAR(bend.length, 34, 1e-9);
  EXPECT_EQ(bend.tangent_lines.size(), 2u) << "it reaches neither of them";
  // A triangle that narrows towards the far end, its lower side along the bend.
  const FlatBend narrowing = lines_of(opened_in_bend({{0.2, 10}, {0.8, 10}, {0.2, 22}})).front();
  expect_along_y(narrowing.lines, 50 + kOpenedAllowance / 2, {{0, 10}, {16, 40}});
  // And one whose upper side lies along it.
  const FlatBend rising = lines_of(opened_in_bend({{0.2, 10}, {0.8, 22}, {0.2, 22}})).front();
  expect_along_y(rising.lines, 50 + kOpenedAllowance / 2, {{0, 16}, {22, 40}});
}

TEST(BendLines, OnTheEndOfAnOpeningAreCutByWhatLiesBehindThem) {
  const auto lines = [](const std::vector<Vec2>& corners) {
    return lines_of(opened_in_bend(corners)).front().lines;
  };
  const double x = 50 + kOpenedAllowance / 2;
  expect_along_y(lines({{0.2, 10}, {0.5, 10}, {0.5, 20}, {0.2, 20}}), x, {{0, 40}});
  expect_along_y(lines({{0.5, 10}, {0.8, 10}, {0.8, 20}, {0.5, 20}}), x, {{0, 10}, {20, 40}});
  // A slot that jumps by 4 on the bend line, on one side or on both.
  expect_along_y(
      lines(
          {{0.2, 10}, {0.5, 10}, {0.5, 14}, {0.8, 14}, {0.8, 24}, {0.5, 24}, {0.5, 20}, {0.2, 20}}),
      x, {{0, 14}, {24, 40}});
  expect_along_y(lines({{0.2, 10}, {0.5, 10}, {0.5, 14}, {0.8, 14}, {0.8, 20}, {0.2, 20}}), x,
                 {{0, 14}, {20, 40}});
  expect_along_y(lines({{0.2, 10}, {0.8, 10}, {0.8, 24}, {0.5, 24}, {0.5, 20}, {0.2, 20}}), x,
                 {{0, 10}, {24, 40}});
}

}  // namespace
}  // namespace planish::test
