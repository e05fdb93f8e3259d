#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <planish/sheet/codes.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gmock/gmock.h>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// Sheets most of one skin of which is milled off. They are as thick as their rim, and their flat
// pattern is that of the sheet before; beyond 15 % the thickness has to be stated.

namespace planish::test {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

constexpr double kLong = 100, kBroad = 80;

struct Milled {
  double thickness, depth;
  double share;  ///< of the plate, in the middle
};

TopoDS_Shape less(const TopoDS_Shape& body, const TopoDS_Shape& tool) {
  return BRepAlgoAPI_Cut(body, tool).Shape();
}

/// From z = 0 up, or from the upper skin down.
TopoDS_Shape milled_below(const TopoDS_Shape& body, const Milled& of) {
  const double x = kLong * std::sqrt(of.share), y = kBroad * std::sqrt(of.share);
  return less(body,
              BRepPrimAPI_MakeBox(gp_Pnt((kLong - x) / 2, (kBroad - y) / 2, -1), x, y, of.depth + 1)
                  .Shape());
}
TopoDS_Shape milled_above(const TopoDS_Shape& body, const Milled& of) {
  const double x = kLong * std::sqrt(of.share), y = kBroad * std::sqrt(of.share);
  return less(
      body, BRepPrimAPI_MakeBox(gp_Pnt((kLong - x) / 2, (kBroad - y) / 2, of.thickness - of.depth),
                                x, y, of.depth + 1)
                .Shape());
}

/// Three bores of radius 2, from above of radius 4 to this depth.
TopoDS_Shape counterbored_above(TopoDS_Shape body, double thickness, double depth) {
  for (const double x : {25.0, 50.0, 75.0}) {
    const auto pin = [&](double z, double radius) {
      return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 40, z), gp_Dir(0, 0, 1)), radius, 40)
          .Shape();
    };
    body = less(less(body, pin(-5, 2)), pin(thickness - depth, 4));
  }
  return body;
}

TopoDS_Shape flat_sheet(double thickness) {
  return BRepPrimAPI_MakeBox(kLong, kBroad, thickness).Shape();
}

void expect_sheet(const TopoDS_Shape& shape, double thickness, double area,
                  const RecognizeOptions& options = {}) {
  const auto seen = unfolded_shape(shape, options);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->sheet.thickness, thickness, 1e-9);
  EXPECT_NEAR(seen->flat.area, area, 1e-6);
  EXPECT_NEAR(*seen->certificate.explained_ratio, 1.0, 1e-9);
  EXPECT_FALSE(seen->flat.features.empty());
}

TEST(MilledSheets, AreAsThickAsTheirRim) {
  for (const double thickness : {2.0, 5.0})
    for (const double share : {0.2, 0.5, 0.8, 0.95}) {
      const Milled of{thickness, 0.12 * thickness, share};
      const TopoDS_Shape below = milled_below(flat_sheet(thickness), of);
      const double area = kLong * kBroad;
      expect_sheet(below, thickness, area);
      expect_sheet(milled_above(flat_sheet(thickness), of), thickness, area);
      expect_sheet(counterbored_above(below, thickness, 0.4 * thickness), thickness,
                   area - 3 * pi * 4);
      const Milled half{thickness, 0.07 * thickness, share};
      expect_sheet(milled_above(milled_below(flat_sheet(thickness), half), half), thickness, area);
    }
}

TEST(MilledSheets, MayHaveIslands) {
  // As high as the rim, in a pocket of 0.3 mm above or below.
  for (const double z : {-1.0, 1.7})
    for (const double share : {0.3, 0.9})
      for (const int islands : {1, 2}) {
        const double x = kLong * std::sqrt(share), y = kBroad * std::sqrt(share);
        TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt((kLong - x) / 2, (kBroad - y) / 2, z), x, y,
                                                1.3)
                                .Shape();
        for (int i = 0; i < islands; ++i)
          tool = less(tool, BRepPrimAPI_MakeBox(gp_Pnt(30 + 20 * i, 35, -2), 10, 12, 9).Shape());
        expect_sheet(less(flat_sheet(2), tool), 2, kLong * kBroad);
      }
}

TEST(MilledSheets, MayBeBent) {
  for (const double radius : {1.0, 3.0}) {
    const BentBracket of{
        .thickness = 2, .inside_radius = radius, .first = 100, .second = 40, .width = 80};
    const double area = 80 * (140 + pi / 2 * (radius + 1));
    for (const double share : {0.5, 0.9, 0.95}) {
      expect_sheet(milled_below(bent_bracket(of), {2, 0.3, share}), 2, area);
      expect_sheet(milled_above(bent_bracket(of), {2, 0.3, share}), 2, area);
    }
  }
}

TEST(MilledSheets, AreToldByTheirThicknessWhereMoreIsMilledOff) {
  // 0.5 of 2 mm over 80 %: a fifth of the sheet.
  const TopoDS_Shape shape = milled_below(flat_sheet(2), {2, 0.5, 0.8});
  const auto refused = recognized_shape(shape);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::not_a_sheet);
  EXPECT_THAT(refused.error().message, HasSubstr("20 %"));
  ASSERT_FALSE(refused.error().remedies.empty());
  EXPECT_EQ(refused.error().remedies.back().option, "thickness");
  EXPECT_EQ(refused.error().remedies.back().value, "2");
  expect_sheet(shape, 2, kLong * kBroad, {.thickness = 2});
}

TEST(MilledSheets, AreNoTrays) {
  // 4.5 of 5 mm over 95 % leave a seventh of it.
  const TopoDS_Shape shape = milled_below(flat_sheet(5), {5, 4.5, 0.95});
  for (const RecognizeOptions& options : {RecognizeOptions{}, RecognizeOptions{.thickness = 5}}) {
    const auto refused = recognized_shape(shape, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, code::not_a_sheet);
    EXPECT_TRUE(refused.error().remedies.empty());
  }
}

TEST(MilledSheets, AreNotTheRimsOfHousings) {
  // A box of 1 mm above a rim of 5 mm: it has less volume than the plate below it, and stands out.
  const auto box = [](double inset, double from, double to) {
    return BRepPrimAPI_MakeBox(gp_Pnt(20 + inset, 15 + inset, from), 60 - 2 * inset, 50 - 2 * inset,
                               to - from)
        .Shape();
  };
  const TopoDS_Shape shape = less(BRepAlgoAPI_Fuse(flat_sheet(5), box(0, 0, 30)).Shape(),
                                  box(1, -1, 29));
  for (const RecognizeOptions& options : {RecognizeOptions{}, RecognizeOptions{.thickness = 5}}) {
    const auto refused = recognized_shape(shape, options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, code::not_a_sheet);
    EXPECT_TRUE(refused.error().remedies.empty());
  }
}

}  // namespace
}  // namespace planish::test
