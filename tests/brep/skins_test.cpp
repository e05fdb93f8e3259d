#include "skins.hpp"

#include "solid_models.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

Result<Skins> skins_of(const SolidModel& model, double thickness) {
  return find_skins(model, outlines_of(model), thickness, 0.02);
}

std::vector<int> faces_on(const Skins& skins, Skin skin) {
  std::vector<int> faces;
  for (int f = 0; f < std::ssize(skins.skin_of); ++f)
    if (skins.skin_of[f] == skin) faces.push_back(f);
  return faces;
}

using Faces = std::vector<int>;

TEST(FindSkins, OfAPlateAreTopAndBottom) {
  const auto skins = skins_of(plate(2, {100, 60}), 2);
  ASSERT_TRUE(skins) << skins.error().message;
  EXPECT_EQ(faces_on(*skins, Skin::none), Faces({2, 3, 4, 5}));
  EXPECT_NE(skins->skin_of[0], skins->skin_of[1]);
  EXPECT_NEAR(skins->thickness, 2.0, 1e-12);
  EXPECT_NEAR(skins->spread, 0.0, 1e-12);
}

TEST(FindSkins, GrowOverTheBendsAndStartWithTheLarger) {
  const auto skins = skins_of(prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40), 2);
  ASSERT_TRUE(skins) << skins.error().message;
  EXPECT_EQ(faces_on(*skins, Skin::first), Faces({2, 3, 4})) << "the outside is larger";
  EXPECT_EQ(faces_on(*skins, Skin::second), Faces({6, 7, 8}));
  EXPECT_NEAR(skins->area_first, 40 * (80 + 5 * pi / 2), 1e-9);
  EXPECT_NEAR(skins->area_second, 40 * (80 + 3 * pi / 2), 1e-9);
}

TEST(FindSkins, GrowOverSharpFolds) {
  const auto skins = skins_of(prism({strip_profile(2, {{50, pi / 2, 0}, {30}})}, 40), 2);
  ASSERT_TRUE(skins) << skins.error().message;
  EXPECT_EQ(faces_on(*skins, Skin::first), Faces({2, 3, 4})) << "with the rounded outside";
  EXPECT_EQ(faces_on(*skins, Skin::second), Faces({6, 7}));
  EXPECT_EQ(skins->sharp.size(), 1u);
}

TEST(FindSkins, MeasureThicknessAndSpread) {
  // 2 mm over 60 mm, 2.02 mm over 40 mm: weighted by area, spread by the difference.
  const SolidModel model = prism(
      {{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 2.02}}, Segment{{100, 2.02}, {60, 2.02}},
        Segment{{60, 2.02}, {60, 2}}, Segment{{60, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  const auto skins = skins_of(model, 2);
  ASSERT_TRUE(skins) << skins.error().message;
  EXPECT_NEAR(skins->thickness, 0.6 * 2 + 0.4 * 2.02, 1e-9);
  EXPECT_NEAR(skins->spread, 0.02, 1e-9);
}

TEST(FindSkins, AdoptFacesThatAreCutOffFromTheirSkin) {
  // The top is two faces with a groove between, deeper than the sheet is thin; the bottom is one.
  const SolidModel model = prism(
      {{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 2}}, Segment{{100, 2}, {61, 2}},
        Segment{{61, 2}, {61, 1}}, Segment{{61, 1}, {60, 1}}, Segment{{60, 1}, {60, 2}},
        Segment{{60, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  const auto skins = skins_of(model, 2);
  ASSERT_TRUE(skins) << skins.error().message;
  EXPECT_EQ(faces_on(*skins, skins->skin_of[2]), Faces({2})) << "the bottom";
  EXPECT_EQ(faces_on(*skins, skins->skin_of[4]), Faces({4, 8})) << "both tops";
  EXPECT_EQ(skins->islands_first + skins->islands_second, 1);
}

TEST(FindSkins, RefuseASolidWithoutFacesAtTheThickness) {
  const auto skins = skins_of(plate(20, {100, 60}), 2);
  ASSERT_FALSE(skins);
  EXPECT_EQ(skins.error().code, code::not_a_sheet);
}

TEST(FindSkins, TakeARoundedEndForACutEdge) {
  const Vec3 along = 40 * Vec3::UnitZ();
  const auto strip = [&](const Vec3& a, const Vec3& b) {
    return polygon_path({a, b, b + along, a + along});
  };
  const auto axis = [](double z) {
    Frame frame;
    frame.origin = {50, 1, z};
    return frame;
  };
  SolidMaker maker;
  maker.plane(-Vec3::UnitY(), {strip({0, 0, 0}, {50, 0, 0})});
  maker.plane(Vec3::UnitY(), {strip({50, 2, 0}, {0, 2, 0})});
  maker.curved(Cylinder{axis(0), 1.0}, 1,
               {{arc(axis(0), 1.0, -pi / 2, pi / 2), line({50, 2, 0}, {50, 2, 40}),
                 arc(axis(40), 1.0, pi / 2, -pi / 2), line({50, 0, 40}, {50, 0, 0})}});
  const auto skins = skins_of(std::move(maker).build_open(), 2);
  ASSERT_TRUE(skins) << skins.error().message;
  EXPECT_EQ(skins->skin_of[2], Skin::none) << "tangent to both skins, and no part of either";
  EXPECT_NE(skins->skin_of[0], skins->skin_of[1]);
}

}  // namespace
}  // namespace planish::brep::test
