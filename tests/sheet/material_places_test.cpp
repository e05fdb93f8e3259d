#include "support/sheets.hpp"

#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/material_places.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

FlatSheet laid_at_k(const Sheet& sheet) {
  auto flat = flat_sheet(sheet, {.allowance = ConstantK{0.4, ""}});
  EXPECT_TRUE(flat);
  return std::move(*flat);
}

/// The point of a face in the middle of the material, and where it comes from.
struct Point {
  FaceId face;
  Vec3 folded;
  Vec2 flat;
};

std::vector<Point> points_of(const Sheet& sheet, const Layout& layout) {
  std::vector<Point> points;
  for (const FaceId id : sheet.faces.ids()) {
    const Box2 box = parameter_box(sheet[id]);
    for (const double u : {0.1, 0.5, 0.93})
      for (const double v : {0.2, 0.7}) {
        const Vec2 uv = box.lo + Vec2(u, v).cwiseProduct(box.size());
        const Vec3 folded = skin_point(sheet[id], uv) -
                            (0.5 * sheet.thickness - sheet.reference_depth) *
                                outward_normal(sheet[id], uv);
        points.push_back({id, folded, layout.develop(sheet, id, uv)});
      }
  }
  return points;
}

TEST(MaterialPlaces, FindWhereAPointOfTheFoldedSheetComesFrom) {
  for (const Sheet& sheet :
       {l_bracket(), l_bracket_down(), u_channel(), box(), cone_joined(),
        moved(z_profile(), Eigen::Isometry3d(Eigen::Translation3d(9, -80, 4)))}) {
    const FlatSheet flat = laid_at_k(sheet);
    for (const Point& point : points_of(sheet, flat.layout)) {
      const auto places = material_places(sheet, flat.layout, point.folded, 0.1);
      ASSERT_FALSE(places.empty());
      EXPECT_EQ(places.front().part, sheet[point.face].part_of);
      EXPECT_LE((places.front().at - point.flat).norm(), 1e-6);
      EXPECT_EQ(places.front().away, 0.0);
    }
  }
}

TEST(MaterialPlaces, AreSeveralWhereTheSheetRunsThroughItself) {
  // 40 | 250° | 40: the second flange goes through the first.
  const double t = 1.2, r = 3.0, angle = 250 * std::numbers::pi / 180;
  const Sheet sheet = strip(
      {Straight{40}, Turn{Angle::radians(angle), r, BendDirection::up}, Straight{40}}, 20, t);
  const FlatSheet flat = laid_at_k(sheet);
  // The middle of the second flange begins at x = 40 + (r + t/2) sin α, at a height of
  // (r + t/2)(1 − cos α) above the middle of the first one, and goes on with the slope tan α.
  const double m = r + t / 2;
  const double x = 40 + m * std::sin(angle) -
                   m * (1 - std::cos(angle)) * std::cos(angle) / std::sin(angle);
  const auto places = material_places(sheet, flat.layout, {x, 10, -t / 2}, 0.1);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].away, 0.0);
  EXPECT_EQ(places[1].away, 0.0);
  EXPECT_NE(places[0].part, places[1].part);
  const double along = m * (1 - std::cos(angle)) / std::sin(-angle);  // the second flange
  EXPECT_NEAR((places[0].at - places[1].at).norm(), 40 - x + angle * (r + 0.4 * t) + along, 1e-9);
}

TEST(MaterialPlaces, CountTheTurnsOfABend) {
  const double t = 1.5, r = 20;
  const Sheet sheet = strip({Turn{Angle::degrees(400), r, BendDirection::up}}, 50, t);
  const FlatSheet flat = laid_at_k(sheet);
  // Within the first 40° the sheet lies twice.
  const double m = r + t / 2;
  for (const auto& [degrees, times] : {std::pair{20.0, 2}, {200.0, 1}}) {
    const double u = degrees * std::numbers::pi / 180;
    const Vec3 p(m * std::sin(u), 25, -t / 2 + m * (1 - std::cos(u)));
    const auto places = material_places(sheet, flat.layout, p, 0.1);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(times)) << degrees;
    if (times == 2) {
      EXPECT_NEAR((places[0].at - places[1].at).norm(), 2 * std::numbers::pi * (r + 0.4 * t), 1e-9);
    }
  }
}

TEST(MaterialPlaces, SayHowFarTheMaterialIs) {
  const Sheet sheet = plate_with_holes();  // from z = −3 to 0
  const FlatSheet flat = laid_at_k(sheet);
  const auto away = [&](const Vec3& p) {
    const auto places = material_places(sheet, flat.layout, p, 100.0);
    return places.empty() ? -1.0 : places.front().away;
  };
  EXPECT_NEAR(away({50, 20, 2.5}), 2.5, 1e-9);
  EXPECT_NEAR(away({50, 20, -4}), 1.0, 1e-9);
  EXPECT_NEAR(away({-3, 20, 4}), 5.0, 1e-9);
  EXPECT_NEAR(away({20, 30, -1}), 5.0, 0.01);  // in the middle of a hole of Ø10
  EXPECT_TRUE(material_places(sheet, flat.layout, {50, 20, 2.5}, 2.0).empty());
}

}  // namespace
}  // namespace planish::test
