#include "form_side.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::brep::test {
namespace {

constexpr int kBottomFace = 0, kTopFace = 1;

/// The side on which the only feature of a plate of 2 mm stands out, seen on a face.
FormSide side_seen_from(const Turned& form, int reference) {
  const Recognised seen = recognised(plate(2, {100, 60}, {form}), 2, reference);
  const auto part = std::ranges::find_if(seen.rim.parts, [&](const RimPart& p) {
    return std::ranges::any_of(p.faces, [&](int f) {
      return !std::holds_alternative<Frame>(seen.model.faces[f].surface);
    });
  });
  if (part == seen.rim.parts.end()) {
    ADD_FAILURE() << "no part";
    return FormSide::both;
  }
  return raised_side(seen.view(), *part);
}

Turned turned_at_30(std::vector<Vec2> profile) { return {{30, 30}, std::move(profile)}; }

TEST(RaisedSide, IsWhereACollarStands) {
  const Turned above = turned_at_30({{5, 2}, {5, 6}, {3, 6}, {3, 0}});
  EXPECT_EQ(side_seen_from(above, kTopFace), FormSide::up);
  EXPECT_EQ(side_seen_from(above, kBottomFace), FormSide::down);
  const Turned below = turned_at_30({{3, 2}, {3, -4}, {5, -4}, {5, 0}});
  EXPECT_EQ(side_seen_from(below, kTopFace), FormSide::down);
  EXPECT_EQ(side_seen_from(below, kBottomFace), FormSide::up);
}

TEST(RaisedSide, IsWhereItStandsOutFarther) {
  const auto both = [](double up, double down) {
    return turned_at_30({{5, 2}, {5, 2 + up}, {3, 2 + up}, {3, -down}, {5, -down}, {5, 0}});
  };
  EXPECT_EQ(side_seen_from(both(3, 1), kTopFace), FormSide::up);
  EXPECT_EQ(side_seen_from(both(1, 3), kTopFace), FormSide::down);
  EXPECT_EQ(side_seen_from(both(2, 2), kTopFace), FormSide::both);
  // A twentieth of the thickness is as far.
  EXPECT_EQ(side_seen_from(both(2.09, 2), kTopFace), FormSide::both);
  EXPECT_EQ(side_seen_from(both(2.11, 2), kTopFace), FormSide::up);
}

TEST(WiderSide, ComparesAreas) {
  const auto circle = [](double radius) {
    return BorderLoop{Border{Arc{{0, 0}, radius, 0, -2 * std::numbers::pi}}};
  };
  // Radii of 3 and 2: areas of 9 to 4.
  EXPECT_EQ(wider_side(circle(3), circle(2), 2.2), FormSide::up);
  EXPECT_EQ(wider_side(circle(2), circle(3), 2.2), FormSide::down);
  EXPECT_EQ(wider_side(circle(3), circle(2), 2.3), FormSide::both);
  EXPECT_EQ(wider_side(circle(2), circle(3), 2.3), FormSide::both);
}

}  // namespace
}  // namespace planish::brep::test
