#include "rim_refusal.hpp"

#include "recognised.hpp"

#include <planish/brep/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

Error refusal_at(const Recognised& seen, int face) {
  const RimPart& part = seen.rim.parts.at(seen.rim.part_of.at(face));
  EXPECT_FALSE(part.within);
  return part.refusal;
}

/// A plate with a spherical cap on it; faces: bottom, top, four walls, the cap.
SolidModel domed() {
  const auto corners = [](double z) {
    return std::vector<Vec3>{{0, 0, z}, {100, 0, z}, {100, 60, z}, {0, 60, z}};
  };
  const auto low = corners(0), high = corners(2);
  Frame centre;
  centre.origin = {50, 30, 2};
  SolidMaker maker;
  maker.plane(-Vec3::UnitZ(), {polygon_path({low[3], low[2], low[1], low[0]})});
  maker.plane(Vec3::UnitZ(), {polygon_path(high), {arc(centre, 10, 2 * pi, 0)}});
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    maker.plane((low[j] - low[i]).cross(Vec3::UnitZ()).normalized(),
                {polygon_path({low[i], low[j], high[j], high[i]})});
  }
  const Vec3 foot(60, 30, 2), pole(50, 30, 8);
  maker.doubly_curved("sphere", {{arc(centre, 10, 0, 2 * pi), line(foot, pole), line(pole, foot)}});
  return std::move(maker).build();
}

TEST(RimRefusal, NamesAFaceThatIsCurvedInTwoDirections) {
  const Error refusal = refusal_at(recognised(domed(), 2, 1), 6);
  EXPECT_EQ(refusal.code, code::doubly_curved);
  EXPECT_EQ(refusal.where, "face 7");
  ASSERT_EQ(refusal.places.size(), 1u);
  EXPECT_EQ(refusal.places[0].id, Place::Id(7));
  EXPECT_EQ(refusal.places[0].at.size(), 3u);
  EXPECT_NE(refusal.message.find("sphere"), std::string::npos);
}

TEST(RimRefusal, NamesAFaceBelowWhichTheThicknessChanges) {
  // The top rises by 3° behind 100 mm.
  const double high = 2 + 40 * std::tan(3 * pi / 180);
  const SolidModel wedge = prism(
      {{Segment{{0, 0}, {140, 0}}, Segment{{140, 0}, {140, high}}, Segment{{140, high}, {100, 2}},
        Segment{{100, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      60);
  const Error refusal = refusal_at(recognised(wedge, 2, 5), 4);
  EXPECT_EQ(refusal.code, code::thickness_not_constant);
  EXPECT_EQ(refusal.where, "face 5");
  ASSERT_EQ(refusal.places.size(), 2u);
  EXPECT_EQ(refusal.places[1].id, Place::Id(6));  // which it continues
  ASSERT_EQ(refusal.numbers.size(), 1u);
  EXPECT_NEAR(refusal.numbers[0].quantity.value, 2.0, 1e-9);
  EXPECT_EQ(refusal.numbers[0].quantity.unit, unit::mm);
}

TEST(RimRefusal, NamesTheFaceFarthestOutside) {
  // Of a sharp angle of 2 mm the upright leg is 3 mm thick above half of its height.
  const std::vector<Vec2> corners{{0, 0},  {60, 0}, {60, 2}, {2, 2},
                                  {2, 30}, {3, 30}, {3, 60}, {0, 60}};
  std::vector<Curve2> profile;
  for (std::size_t i = 0; i < corners.size(); ++i)
    profile.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  const Recognised seen = recognised(prism({profile}, 50), 2, 0);
  const Error refusal = refusal_at(seen, 1);
  EXPECT_EQ(refusal.code, code::not_a_sheet);
  EXPECT_EQ(refusal.where, "face 8") << refusal.message;  // after both ends and five sides
}

TEST(RimRefusal, IsOfAnotherBodyElsewhere) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 6}, {0, 6}}}}), 2,
                                     1);
  EXPECT_EQ(refusal_at(seen, 6).code, code::not_a_sheet);
}

}  // namespace
}  // namespace planish::brep::test
