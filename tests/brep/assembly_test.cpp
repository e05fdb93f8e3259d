#include "assembly.hpp"

#include "recognised.hpp"

#include <planish/brep/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

Result<Sheet> sheet_from(SolidModel model, double thickness, int reference) {
  const Recognised seen = recognised(std::move(model), thickness, reference);
  return assemble_sheet(seen.view());
}

/// Two legs of 50 and 30 mm, 40 mm wide, 2 mm thick. Faces: 2 … 4 the outside.
SolidModel angle(double turn, double inside_radius) {
  return prism({strip_profile(2, {{50, turn, inside_radius}, {30}})}, 40);
}

TEST(AssembleSheet, OfABentStripHasItsFlangesAndItsBend) {
  const auto sheet = sheet_from(angle(pi / 2, 3), 2, 2);
  ASSERT_TRUE(sheet) << sheet.error().message;
  EXPECT_EQ(sheet->flanges.size(), 2u);
  ASSERT_EQ(sheet->bends.size(), 1u);
  const Bend& bend = sheet->bends.front();
  EXPECT_NEAR(bend.angle.degrees(), 90.0, 1e-9);
  EXPECT_NEAR(bend.inside_radius, 3.0, 1e-9);
  EXPECT_FALSE(bend.reference_inside);
  EXPECT_EQ(sheet->joints.size(), 2u);
  EXPECT_NEAR(sheet->volume.value(), 40 * (2 * 80 + pi / 4 * (25 - 9)), 1e-8);
}

TEST(AssembleSheet, LiesFlatInItsBendAllowanceFromEitherSkin) {
  const double flat = 50 + 30 + pi / 2 * (3 + 0.5 * 2);
  for (const int reference : {2, 6}) {
    const auto sheet = sheet_from(angle(pi / 2, 3), 2, reference);
    ASSERT_TRUE(sheet) << sheet.error().message;
    const auto pattern = flatten(*sheet, {.allowance = ConstantK{0.5, "test"}});
    ASSERT_TRUE(pattern) << pattern.error().message;
    EXPECT_NEAR(pattern->area, 40 * flat, 1e-7);
  }
}

TEST(AssembleSheet, PutsABendInPiecesOnOneTurn) {
  const SolidModel model = prism(
      {{Segment{{0, 0}, {50, 0}}, Arc{{50, 5}, 5, -pi / 2, 1.5}, Arc{{50, 5}, 5, 1.5 - pi / 2, 1.5},
        Segment{{50 + 5 * std::sin(3.0), 5 - 5 * std::cos(3.0)},
                {50 + 3 * std::sin(3.0), 5 - 3 * std::cos(3.0)}},
        Arc{{50, 5}, 3, 3.0 - pi / 2, -3.0}, Segment{{50, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  const auto sheet = sheet_from(model, 2, 2);
  ASSERT_TRUE(sheet) << sheet.error().message;
  ASSERT_EQ(sheet->bends.size(), 1u);
  EXPECT_EQ(sheet->bends.front().faces.size(), 2u);
  EXPECT_NEAR(sheet->bends.front().angle.radians(), 3.0, 1e-9);
}

TEST(AssembleSheet, CountsWhatAMitredCornerHoldsMore) {
  const SolidModel model = prism(
      {{Segment{{0, 0}, {50, 0}}, Segment{{50, 0}, {50, 30}}, Segment{{50, 30}, {48, 30}},
        Segment{{48, 30}, {48, 2}}, Segment{{48, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  const auto sheet = sheet_from(model, 2, 5);
  ASSERT_TRUE(sheet) << sheet.error().message;
  ASSERT_EQ(sheet->bends.size(), 1u);
  EXPECT_EQ(sheet->bends.front().kind, BendKind::sharp);
  EXPECT_TRUE(sheet->bends.front().reference_inside);
  EXPECT_NEAR(sheet->bends.front().angle.degrees(), 90.0, 1e-9);
  ASSERT_EQ(sheet->joints.size(), 1u);
  EXPECT_EQ(sheet->joints.front().sharp, BendId{0});
  EXPECT_NEAR(sheet->mitres_volume, 40 * 4 * (1 - pi / 4), 1e-9);
}

TEST(AssembleSheet, CountsNothingMoreInARoundedCorner) {
  const auto sheet = sheet_from(angle(pi / 2, 0), 2, 6);
  ASSERT_TRUE(sheet) << sheet.error().message;
  EXPECT_EQ(sheet->mitres_volume, 0.0);
  EXPECT_EQ(sheet->bends.front().kind, BendKind::sharp);
}

TEST(AssembleSheet, RefusesFacesThatMeetSmoothlyAlongACurve) {
  // A flange and a bend of 1 m radius, joined along an arc that bulges by some 5 mm.
  Frame circle, axis;
  const double radius = (20 * 20 + 5 * 5) / 10.0;  // over a chord of 40 mm
  circle.x = Vec3::UnitX();
  circle.y = Vec3::UnitZ();
  circle.z = -Vec3::UnitY();
  circle.origin = {55 - radius, 0, 20};
  axis.origin = {50, 1000, 0};
  const double half = std::asin(20 / radius);
  SolidMaker maker;
  const Vec3 a(50, 0, 0), b(50, 0, 40);
  maker.plane(-Vec3::UnitY(), {{line({0, 0, 0}, a), arc(circle, radius, -half, half),
                                line(b, {0, 0, 40}), line({0, 0, 40}, {0, 0, 0})}});
  const double turn = 0.05;
  Frame low = axis, high = axis;
  high.origin.z() = 40;
  const auto at = [&](double z) {
    return Vec3(50 + 1000 * std::sin(turn), 1000 - 1000 * std::cos(turn), z);
  };
  maker.curved(Cylinder{axis, 1000}, 1,
               {{arc(low, 1000, -pi / 2, -pi / 2 + turn), line(at(0), at(40)),
                 arc(high, 1000, -pi / 2 + turn, -pi / 2), arc(circle, radius, half, -half)}});
  Recognised seen{std::move(maker).build_open(), {}, {}, {}, {}, Skin::first};
  seen.outlines = outlines_of(seen.model);
  seen.skins.thickness = 2;
  seen.skins.skin_of.assign(2, Skin::first);
  seen.skins.partners.resize(2);
  seen.rim = find_rim(seen.model, seen.outlines, seen.skins);
  seen.groups = group_faces(seen.model, seen.outlines, seen.skins, Skin::first);
  const auto sheet = assemble_sheet(seen.view());
  ASSERT_FALSE(sheet);
  EXPECT_EQ(sheet.error().code, code::doubly_curved);
  EXPECT_EQ(sheet.error().where, "faces 1 and 2");
  ASSERT_EQ(sheet.error().places.size(), 3u);
  EXPECT_EQ(sheet.error().places[0], place::face(1));
  EXPECT_EQ(sheet.error().places[1], place::face(2));
  EXPECT_EQ(sheet.error().places[2].kind, PlaceKind::edge);
}

}  // namespace
}  // namespace planish::brep::test
