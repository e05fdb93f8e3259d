#include "trim.hpp"

#include "flat_area.hpp"
#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// Plates drawn up to each other, as a designer draws a box.

namespace planish::test {
namespace {

using std::numbers::pi;

PlateStructure drawn_box(double a = 200, double b = 100, double h = 50, double thickness = 2) {
  PlateStructure s;
  s.thickness = thickness;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {a, 0, 0}, {0, b, 0}),
              rectangle_plate("front", {0, 0, 0}, {a, 0, 0}, {0, 0, h}),
              rectangle_plate("back", {0, b, 0}, {a, 0, 0}, {0, 0, h}),
              rectangle_plate("left", {0, 0, 0}, {0, b, 0}, {0, 0, h}),
              rectangle_plate("right", {a, 0, 0}, {0, b, 0}, {0, 0, h})};
  return s;
}

TEST(Trimming, MakesABoxOfPlatesThatShareEdges) {
  // Inside radius t: all shared edges are cut back by 1.5 t, at right angles.
  const double t = 2, cut = 1.5 * t, a = 200 - 2 * cut, b = 100 - 2 * cut;
  for (const double sign : {1.0, -1.0}) {
    PlateStructure box = drawn_box();
    for (Plate& plate : box.plates)
      for (Vec3& p : plate.outline)
        p.z() *= sign;
    const auto made = connect(box);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->bends.size(), 4u);
    for (const FittedBend& bend : made->bends)
      EXPECT_NEAR(bend.inside_radius, t, 1e-9);
    const double around = 2 * a + 2 * b;
    EXPECT_NEAR(area_when_flat(*made), a * b + around * (50 - cut) + around * pi / 2 * 1.5 * t,
                1e-6);
    EXPECT_EQ(made->trimmed.size(), 5u);
    for (const TrimmedPlate& plate : made->trimmed)
      EXPECT_NEAR(plate.by, cut, 1e-9);
    // The four upright edges stay open, each over all of its height.
    ASSERT_EQ(made->left_open.size(), 4u);
    for (const SharedEdge& edge : made->left_open)
      EXPECT_NEAR((edge.to - edge.from).norm(), 50.0, 1e-9);
  }
}

TEST(Trimming, KeepsTheNumbersOfEdgesThatCarryBends) {
  PlateStructure box = drawn_box();
  for (const char* wall : {"front", "back", "left", "right"})
    box.bends.push_back({.between = {"floor", wall}, .inside_radius = 3.0});
  box.bends[0].edges = {std::vector{0}, std::vector{0}};
  box.trim = true;
  const auto made = connect(box);
  ASSERT_TRUE(made) << made.error().message;
  const std::array wanted{0, 2, 3, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(made->bends[i].edges[0], std::vector{wanted[i]});
    EXPECT_EQ(made->bends[i].edges[1], std::vector{0});
    EXPECT_NEAR(made->bends[i].inside_radius, 3.0, 1e-9);
  }
}

TEST(Trimming, LetsFourTrianglesMeetInTheCornersOfTheirBase) {
  for (const double b : {200.0, 140.0}) {
    const double r = 120, h = 300, a = 200;
    const std::array<Vec3, 4> corners{Vec3(a, -b, 0), Vec3(a, b, 0), Vec3(-a, b, 0),
                                      Vec3(-a, -b, 0)};
    const std::array<Vec3, 4> tips{Vec3(r, 0, h), Vec3(0, r, h), Vec3(-r, 0, h), Vec3(0, -r, h)};
    PlateStructure s;
    s.thickness = 2;
    for (std::size_t i = 0; i < 4; ++i)
      s.plates.push_back({std::string(1, static_cast<char>('A' + i)),
                          {corners[i], corners[(i + 1) % 4], tips[i]},
                          {}});
    const auto made = connect(s);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->bends.size(), 3u);
    for (const FittedBend& bend : made->bends)
      EXPECT_EQ(bend.kind, BendKind::general);
  }
}

TEST(Trimming, TakesWallsThatStopShortOfTheCorners) {
  const double t = 2, cut = 1.5 * t;
  for (const double gap : {0.5, 1.0, 2.0, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0, 12.0})
    for (const int walls : {2, 4}) {
      PlateStructure box = drawn_box();
      for (int w = 1; w <= walls; ++w) {
        std::vector<Vec3>& o = box.plates[static_cast<std::size_t>(w)].outline;
        const Vec3 in = gap * (o[1] - o[0]).normalized();
        for (const std::size_t i : {0U, 3U})
          o[i] += in;
        for (const std::size_t i : {1U, 2U})
          o[i] -= in;
      }
      const auto made = connect(box);
      ASSERT_TRUE(made) << gap << ": " << made.error().message;
      ASSERT_EQ(made->bends.size(), 4u) << gap;
      for (const FittedBend& bend : made->bends) {
        EXPECT_NEAR(bend.inside_radius, t, 1e-9) << gap;
        EXPECT_NEAR(bend.angle.degrees(), 90.0, 1e-9) << gap;
      }
      EXPECT_NEAR(made->trimmed[0].by, cut, 1e-9);
    }
}

TEST(Trimming, TakesEdgesThatMissEachOtherByRounding) {
  for (const double off : {0.0005, 0.001, 0.01, 0.04, -0.01}) {
    PlateStructure box = drawn_box();
    for (Vec3& p : box.plates[1].outline)
      p += Vec3(0, -off, 0.5 * off);
    const auto made = connect(box);
    ASSERT_TRUE(made) << off << ": " << made.error().message;
    EXPECT_EQ(made->bends.size(), 4u);
    for (const FittedBend& bend : made->bends)
      EXPECT_NEAR(bend.inside_radius, 2.0, 0.1) << off;
  }
}

/// A prism without its lid, as a designer draws it: a regular floor of n edges and its walls.
PlateStructure drawn_prism(int n, double radius, double h, double thickness) {
  PlateStructure s;
  s.thickness = thickness;
  const auto corner = [&](int i) {
    return Vec3(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0);
  };
  s.plates.push_back({"floor", {}, {}});
  for (int i = 0; i < n; ++i) {
    s.plates[0].outline.push_back(corner(i));
    s.plates.push_back(rectangle_plate("wall" + std::to_string(i), corner(i),
                                       corner(i + 1) - corner(i), {0, 0, h}));
  }
  return s;
}

TEST(Trimming, FoldsABoxSharplyAndCutsItsCornersBack) {
  // A fold runs t/2 within the line where the planes meet. Floor and walls begin t from a corner.
  const double t = 2, k = 0.5, a = 200 - t, b = 100 - t, around = 2 * (a - t) + 2 * (b - t);
  for (const bool given : {false, true}) {
    PlateStructure box = drawn_box();
    box.defaults.inside_radius = 0.0;
    if (given)
      for (const char* wall : {"front", "back", "left", "right"})
        box.bends.push_back({.between = {"floor", wall}, .inside_radius = 0.0});
    const auto made = connect(box);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->bends.size(), 4u);
    for (const FittedBend& bend : made->bends)
      EXPECT_EQ(bend.kind, BendKind::sharp);
    EXPECT_EQ(made->left_open.size(), 4u);
    const double corners = 4 * (t / 2) * (t / 2);
    EXPECT_NEAR(area_when_flat(*made),
                a * b - corners + around * (50 - t / 2) + around * pi / 2 * k * t, 1e-6);
  }
}

TEST(Trimming, FoldsPrismsSharply) {
  const double t = 2, k = 0.5, h = 40, radius = 100;
  for (const int n : {3, 5, 6}) {
    PlateStructure prism = drawn_prism(n, radius, h, t);
    prism.defaults.inside_radius = 0.0;
    const auto made = connect(prism);
    ASSERT_TRUE(made) << n << ": " << made.error().message;
    ASSERT_EQ(made->bends.size(), static_cast<std::size_t>(n));
    // Where both folds of a corner begin: t/2 to each, t/tan of half the angle between walls.
    const double half = pi / 2 - pi / n, inner = radius * std::cos(pi / n) - t / 2;
    const double back = std::max(t / std::sin(2 * half), t / std::tan(half));
    const double side = 2 * radius * std::sin(pi / n) - 2 * back;
    const double ear = (back - t / 2 / std::tan(half)) * (back * std::tan(half) - t / 2);
    const double floor = n * inner * inner * std::tan(pi / n) - n * ear;
    EXPECT_NEAR(area_when_flat(*made), floor + n * side * (h - t / 2 + pi / 2 * k * t), 1e-6) << n;
  }
}

TEST(Trimming, CutsOpeningsBackForTabsDrawnFromTheirEdges) {
  // t 2, cut 3 deep; the reliefs beside the tab reach 1 before its edge and 1 deeper.
  const double t = 2, k = 0.5, bend = 100 * pi / 2 * (t + k * t);
  const std::vector<Vec3> hole{{50, 20, 0}, {150, 20, 0}, {150, 80, 0}, {50, 80, 0}};
  for (const bool reversed : {false, true}) {
    PlateStructure s;
    s.thickness = t;
    s.plates = {rectangle_plate("frame", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
                rectangle_plate("tab", {50, 20, 0}, {100, 0, 0}, {0, 0, -30})};
    s.plates[0].holes = {hole};
    if (reversed) std::ranges::reverse(s.plates[0].holes[0]);
    const auto made = connect(s);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->bends.size(), 1u);
    EXPECT_EQ(made->bends[0].edges[0], std::vector{reversed ? 6 : 4});
    EXPECT_NEAR(area_when_flat(*made),
                200 * 100 - 100 * (60 + 3) - 2 * t * (1 + 3 + 1) + 100 * (30 - 3) + bend, 1e-6);
    // The frame is as one with a notch up to its edge.
    s.plates[0].holes.clear();
    s.plates[0].outline = {{0, 0, 0},    {200, 0, 0}, {200, 80, 0}, {150, 80, 0},
                           {150, 20, 0}, {50, 20, 0}, {50, 80, 0},  {0, 80, 0}};
    const auto notched = connect(s);
    ASSERT_TRUE(notched) << notched.error().message;
    EXPECT_NEAR(area_when_flat(*notched), area_when_flat(*made) - 200 * 20, 1e-6);
  }
}

TEST(PlatesThatTouch, AreNotJoinedRoundTheirBacks) {
  // A wall of 5 mm on a sheet of 4 mm leaves no room for a bend of that radius.
  PlateStructure s;
  s.thickness = 4;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
              rectangle_plate("wall", {0, 0, 0}, {200, 0, 0}, {0, 0, 5})};
  const auto refused = connect(s);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::no_bend_fits);
  const auto number = [&](const char* name) {
    const auto& numbers = refused.error().numbers;
    const auto found = std::ranges::find(numbers, name, &NamedQuantity::name);
    return found == numbers.end() ? 0.0 : found->quantity.value;
  };
  EXPECT_NEAR(number("width"), 5.0, 1e-9);
  EXPECT_NEAR(number("needed"), 1.5 * 4, 1e-9);
  s.plates[1] = rectangle_plate("wall", {0, 0, 0}, {200, 0, 0}, {0, 0, 6.5});
  EXPECT_TRUE(connect(s));
  s.plates[1] = rectangle_plate("wall", {0, 0, 0}, {200, 0, 0}, {0, 0, 40});
  const auto made = connect(s);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->bends[0].edge_kind, EdgeKind::facing);
}

TEST(Trimming, JoinsPlatesThatTouchThoughOthersDoNot) {
  PlateStructure s;
  s.thickness = 2;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
              rectangle_plate("front", {0, 0, 0}, {200, 0, 0}, {0, 0, 40}),
              rectangle_plate("back", {0, 105, 5}, {200, 0, 0}, {0, 0, 40})};
  const auto made = connect(s);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->bends.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(made->bends[i].plates, (std::vector{0, static_cast<int>(i) + 1}));
    EXPECT_NEAR(made->bends[i].angle.degrees(), 90.0, 1e-9);
  }
  s.trim = false;
  const auto drawn = connect(s);
  EXPECT_TRUE(!drawn || drawn->trimmed.empty());
}

TEST(Trimming, IsLeftOutWherePlatesAreApart) {
  const auto apart = connect(tray());
  ASSERT_TRUE(apart);
  EXPECT_TRUE(apart->trimmed.empty());
  PlateStructure box = drawn_box();
  box.trim = false;
  const auto untouched = connect(box);
  EXPECT_TRUE(!untouched || untouched->trimmed.empty());
}

}  // namespace
}  // namespace planish::test
