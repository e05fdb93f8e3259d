#include "support/sheets.hpp"

#include <planish/sheet/places.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

/// A base of 50 × 40 at z = 0 and a wall 30 high at x = 50, folded sharply.
Sheet creased_wall() {
  return strip({Straight{50}, Crease{Angle::degrees(90)}, Straight{30}}, 40, 2);
}

/// The same with numbers as a solid gives them: faces 11 and 12, the border at y = 0 of face 13.
Sheet numbered_wall() {
  Sheet sheet = creased_wall();
  sheet.faces[FaceId{0}].source_face = 11;
  sheet.faces[FaceId{1}].source_face = 12;
  sheet.faces[FaceId{0}].loops[0][0].source_face = 13;
  return sheet;
}

void expect_point(const Place& place, const Vec3& wanted) {
  ASSERT_EQ(place.at.size(), 3u);
  EXPECT_LT((Vec3(place.at[0], place.at[1], place.at[2]) - wanted).norm(), 1e-9)
      << place.at[0] << ' ' << place.at[1] << ' ' << place.at[2];
}

Place without_point(Place place) {
  place.at.clear();
  return place;
}

TEST(SheetPointers, AreThePathsOfRowsFromZero) {
  EXPECT_EQ(pointer_to(FaceId{3}), "/faces/3");
  EXPECT_EQ(pointer_to(BorderRef{FaceId{3}, 1, 2}), "/faces/3/loops/1/borders/2");
  EXPECT_EQ(pointer_to(BendId{0}), "/bends/0");
}

TEST(SheetPlaces, OfAFaceIsItsNumberInTheSolidOrItsRow) {
  const Sheet sheet = numbered_wall();
  const Place place = place_of(sheet, FaceId{1});
  EXPECT_EQ(without_point(place), place::face(12));
  // The middle of the wall's first border, which is the fold.
  expect_point(place, {50, 20, 0});
  EXPECT_EQ(without_point(place_of(creased_wall(), FaceId{1})), place::pointer("/faces/1"));
}

TEST(SheetPlaces, AtABorderIsTheFaceThatItBelongedTo) {
  const Sheet sheet = numbered_wall();
  const Place place = face_at(sheet, {FaceId{0}, 0, 0});
  EXPECT_EQ(without_point(place), place::face(13));
  expect_point(place, {25, 0, 0});
  EXPECT_EQ(without_point(face_at(sheet, {FaceId{0}, 0, 2})), place::face(11));
  EXPECT_EQ(without_point(face_at(creased_wall(), {FaceId{0}, 0, 2})), place::pointer("/faces/0"));
}

TEST(SheetPlaces, OfABendHasItsNameAndAPointOnIt) {
  // 50 | 90° up r 3 | 30: the middle of the bend is at 45° about its axis at (50, y, 3).
  const Place round = place_of(l_bracket(), BendId{0});
  EXPECT_EQ(without_point(round), place::bend("B1"));
  expect_point(round, {50 + 3 * std::sqrt(0.5), 20, 3 - 3 * std::sqrt(0.5)});
  const Place sharp = place_of(creased_wall(), BendId{0});
  EXPECT_EQ(without_point(sharp), place::bend("B1"));
  expect_point(sharp, {50, 20, 0});
  EXPECT_EQ(place_of(creased_wall(), BendId{7}), place::bend("B8")) << "one that is not there";
}

TEST(SheetPlaces, OfASharpBendIsOnItsOwnFold) {
  const Crease fold{Angle::degrees(90)};
  const Sheet sheet = strip({Straight{50}, fold, Straight{30}, fold, Straight{20}}, 40, 2);
  expect_point(place_of(sheet, BendId{1}), {50, 20, 30});
  EXPECT_EQ(without_point(place_of(sheet, BendId{1})), place::bend("B2"));
}

TEST(SheetPlaces, OfAnEdgeNamesTheFacesOnBothSidesIfBothAreKnown) {
  Sheet sheet = numbered_wall();
  const Place place = edge_at(sheet, sheet.joints[0], 21);
  EXPECT_EQ(without_point(place), place::edge(21, {11, 12}));
  expect_point(place, {50, 20, 0});
  sheet.faces[FaceId{1}].source_face.reset();
  EXPECT_EQ(without_point(edge_at(sheet, sheet.joints[0], 21)), place::edge(21));
  sheet[sheet.joints[0].b].source_face = 14;
  EXPECT_EQ(without_point(edge_at(sheet, sheet.joints[0], 21)), place::edge(21, {11, 14}));
}

}  // namespace
}  // namespace planish::test
