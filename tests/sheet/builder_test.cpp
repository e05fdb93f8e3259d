#include "support/sheets.hpp"

#include <planish/sheet/builder.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

using test::rectangle;

BorderLoop borders(const Loop& loop) {
  BorderLoop result;
  for (const Curve2& curve : loop)
    result.push_back({.curve = curve, .edge_length = length(curve)});
  return result;
}

/// Two plates 30 × 20 at 90° along a crease that is sharp on the reference skin's inside.
SheetBuilder two_plates() {
  SheetBuilder builder(2.0);
  const Frame upright{{30, 0, 0}, Vec3::UnitZ(), Vec3::UnitY(), -Vec3::UnitX()};
  for (const Frame& frame : {Frame{}, upright}) {
    Face face;
    face.surface = frame;
    face.part_of = builder.add_flange();
    face.loops = {borders(rectangle(30, 20))};
    builder.add_face(std::move(face));
  }
  Bend fold;
  fold.kind = BendKind::sharp;
  fold.angle = Angle::degrees(90);
  fold.reference_inside = true;
  builder.join({FaceId{0}, 0, 1}, {FaceId{1}, 0, 3}, builder.add_bend(fold));
  return builder;
}

TEST(SheetBuilder, ListsEachFaceWithItsPart) {
  const auto sheet = two_plates().build();
  ASSERT_TRUE(sheet) << sheet.error().message;
  ASSERT_EQ(sheet->flanges.size(), 2u);
  EXPECT_EQ((*sheet)[FlangeId{1}].faces, std::vector{FaceId{1}});
  const auto pattern = flatten(*sheet, {.allowance = ConstantK{0.5, "test"}});
  ASSERT_TRUE(pattern) << pattern.error().message;
  EXPECT_NEAR(pattern->area, 20 * (60 + std::numbers::pi / 2 * 0.5 * 2.0), 1e-9);
}

TEST(SheetBuilder, NumbersEdgesInOrderAndSharesThemAcrossJoints) {
  SheetBuilder builder = two_plates();
  builder.number_edges();
  const Sheet sheet = std::move(builder).build().value();
  std::vector<int> numbers;
  for (const Face& face : sheet.faces)
    for (const Border& border : face.loops.front())
      numbers.push_back(border.edge.value());
  EXPECT_EQ(numbers, (std::vector{1, 2, 3, 4, 5, 6, 7, 2}));
}

TEST(SheetBuilder, ForgetsTheVolumeOfFormsWhenOneCannotBeMeasured) {
  SheetBuilder builder = two_plates();
  builder.add_form_volume(3.0);
  builder.add_form_volume(-1.0);
  EXPECT_EQ(builder.sheet().forms_volume, 2.0);
  builder.add_form_volume({});
  builder.add_form_volume(5.0);
  EXPECT_FALSE(builder.sheet().forms_volume);
}

TEST(SheetBuilder, RefusesASheetThatBreaksARule) {
  SheetBuilder builder(2.0);
  builder.add_flange();
  const auto sheet = std::move(builder).build();
  ASSERT_FALSE(sheet);
  EXPECT_EQ(sheet.error().code, code::invalid_sheet);
}

TEST(SheetBuilderDeathTest, StopsAtRowsThatAreNotThere) {
  SheetBuilder builder = two_plates();
  EXPECT_DEATH(builder.join({FaceId{0}, 0, 9}, {FaceId{1}, 0, 0}), "has\\(a\\)");
  Face face;
  face.part_of = FlangeId{5};
  EXPECT_DEATH(builder.add_face(face), "has\\(id\\)");
  EXPECT_DEATH(builder.add_feature({"pocket", FormSide::up, FaceId{7}, {}, {}, {}}), "face");
}

}  // namespace
}  // namespace planish
