#include "support/sheets.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(SheetRows, HasTheBordersThatThereAre) {
  const Sheet sheet = plate_with_holes();
  EXPECT_TRUE(sheet.has({FaceId{0}, 0, 3}));
  EXPECT_FALSE(sheet.has({FaceId{0}, 0, 4}));
  EXPECT_FALSE(sheet.has({FaceId{0}, 0, -1}));
  EXPECT_TRUE(sheet.has({FaceId{0}, 3, 0}));
  EXPECT_FALSE(sheet.has({FaceId{0}, 4, 0}));
  EXPECT_FALSE(sheet.has({FaceId{0}, -1, 0}));
  EXPECT_FALSE(sheet.has({FaceId{1}, 0, 0}));
  EXPECT_FALSE(sheet.has({FaceId{-1}, 0, 0}));
  const Border& side = sheet[{FaceId{0}, 0, 1}];
  EXPECT_EQ(start_of(side.curve), Vec2(100, 0));
}

TEST(SheetRows, KnowTheFacesOfAPart) {
  const Sheet sheet = l_bracket();
  for (const FaceId id : sheet.faces.ids()) {
    const std::vector<FaceId>& faces = sheet.faces_of(sheet[id].part_of);
    EXPECT_EQ(faces, std::vector<FaceId>{id});
  }
}

TEST(SheetNormal, PointsAwayFromTheMaterial) {
  // The first flange has it along z; over an up bend, whose inside is up, it turns towards −x.
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const Sheet sheet = strip(
        {Straight{50}, Turn{Angle::degrees(90), 3.0, direction}, Straight{30}}, 40, 2);
    const double way = direction == BendDirection::up ? -1.0 : 1.0;
    for (const FaceId id : sheet.faces.ids()) {
      const Box2 box = parameter_box(sheet[id]);
      if (std::holds_alternative<FlangeId>(sheet[id].part_of)) continue;
      const Vec3 middle = outward_normal(sheet[id], 0.5 * (box.lo + box.hi));
      EXPECT_LT((middle - Vec3(way, 0, 1).normalized()).norm(), 1e-9);
    }
    const Vec3 last = outward_normal(sheet[FaceId{2}], {0, 0});
    EXPECT_LT((last - Vec3(way, 0, 0)).norm(), 1e-9);
  }
}

TEST(SheetForms, OnTheOtherSide) {
  EXPECT_EQ(other_side(FormSide::up), FormSide::down);
  EXPECT_EQ(other_side(FormSide::down), FormSide::up);
  EXPECT_EQ(other_side(FormSide::both), FormSide::both);
  EXPECT_EQ(side_name(FormSide::up), "up");
  EXPECT_EQ(side_name(FormSide::down), "down");
  EXPECT_EQ(side_name(FormSide::both), "both");
}

}  // namespace
}  // namespace planish::test
