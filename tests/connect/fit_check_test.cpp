#include "fit_check.hpp"

#include "sample_parts.hpp"
#include "support/error_data.hpp"

#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

namespace planish::test {
namespace {

using namespace connect_detail;

PlateStructure pair_with_radius(double radius) {
  PlateStructure s = angle_pair(20);
  s.bends = {{.between = {"A", "B"}, .inside_radius = radius}};
  return s;
}

TEST(CheckOnPlates, LetsPassWhatKeepsThePlates) {
  for (const PlateStructure& s : {angle_pair(20), cone_pair(), u_pair()}) {
    const Parts parts = parts_of(s);
    EXPECT_TRUE(check_on_plates(parts, 0));
    EXPECT_TRUE(check_flat(parts, 0, 0.44));
  }
}

TEST(CheckOnPlates, RefusesABendWhoseTangentLineCutsAPlate) {
  // The largest mid-surface radius at a gap of 20 is 20; the line is moved into the plate by hand.
  Parts parts = parts_of(pair_with_radius(10));
  ASSERT_TRUE(check_on_plates(parts, 0));
  BendFit& fit = parts.fits[0];
  fit.surface = tangent_surface(fit.report.frame, fit.report.edge_kind, {0.0, -35.0});
  const auto checked = check_on_plates(parts, 0);
  ASSERT_FALSE(checked);
  EXPECT_FALSE(ids_in(checked.error(), PlaceKind::plate).empty());
  EXPECT_TRUE(is_told(checked.error()));
}

/// Two plates at a right angle, 2 thick, an inside radius of 19 and so their edges at 20 from the
/// line where the planes meet. Beside the bend, A has an arm 20 wide that ends `beyond` that line;
/// B is 10 wider over the arm from 20 above its edge on.
PlateStructure arm_beside_bend(double beyond) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {
      {"A",
       {{0, 20, 0},
        {100, 20, 0},
        {100, 30, 0},
        {110, 30, 0},
        {110, -beyond, 0},
        {130, -beyond, 0},
        {130, 100, 0},
        {0, 100, 0}},
       {}},
      {"B", {{0, 0, 20}, {100, 0, 20}, {100, 0, 40}, {120, 0, 40}, {120, 0, 90}, {0, 0, 90}}, {}}};
  s.bends = {
      {.between = {"A", "B"}, .edges = {std::vector{0}, std::vector{0}}, .inside_radius = 19.0}};
  return s;
}

TEST(CheckFlat, FindsAnArmThatTheFlangeCoversWhenLaidFlat) {
  // B's step lies the bend allowance and 20 from A's edge: π/2 (19 + 0.44·2) + 20 − 20 beyond the
  // line. An arm that is 0.05 longer is covered on a width of 10.
  const double step = std::numbers::pi / 2 * (19 + 0.44 * 2);
  Parts parts = parts_of(arm_beside_bend(5));
  const auto with_arm = [&](double beyond, double k_factor = 0.44) {
    parts.plates[0] = laid(arm_beside_bend(beyond).plates[0]);
    return check_flat(parts, 0, k_factor);
  };
  EXPECT_TRUE(with_arm(step - 0.05));
  const auto checked = with_arm(step + 0.05);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, code::overlap);
  // Each is taken smaller by the clearance, 0.002.
  EXPECT_NEAR(number_in(checked.error(), "area"), 10 * 0.05, 10 * 2 * 0.002 + 0.01);
  EXPECT_EQ(ids_in(checked.error(), PlaceKind::plate),
            (std::vector<std::string>{"\"A\"", "\"B\""}));
  EXPECT_NEAR(number_in(with_arm(step + 6).error(), "area"), 10 * 6, 0.1);
  // The bend is longer by π/2·0.06·2 = 0.19 for a factor of 0.5, shorter for one of 0.38.
  EXPECT_TRUE(with_arm(step + 0.05, 0.5));
  EXPECT_FALSE(with_arm(step - 0.05, 0.38));
}

TEST(CheckRoom, FindsSheetsThatRunIntoEachOther) {
  // Edges at the line where the planes meet, sheets 4 thick: they share a square of 2 × 2.
  EXPECT_TRUE(check_room(parts_of(pair_with_radius(10)), 0));
  Parts parts = parts_of(pair_with_radius(10));
  parts.thickness = 60;  // half of it is more than the gap of 20
  const auto checked = check_room(parts, 0);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, code::plates_touch);
  EXPECT_EQ(number_in(checked.error(), "thickness"), 60);
  // At a right angle, as far from the line as half of the thickness and the smallest radius.
  EXPECT_NEAR(number_in(checked.error(), "least"), 30.001, 1e-9);
  EXPECT_EQ(at_in(checked.error(), PlaceKind::point).size(), 3u);
  EXPECT_EQ(at_in(checked.error(), PlaceKind::plate), at_in(checked.error(), PlaceKind::point));
  EXPECT_EQ(ids_in(checked.error(), PlaceKind::plate),
            (std::vector<std::string>{"\"A\"", "\"B\""}));
}

TEST(CheckOnPlates, WantsRoomInFrontOfABendRoundTheBack) {
  PlateStructure s = angle_pair(20);
  s.bends = {{.between = {"A", "B"}, .edges = {std::vector{0}, std::vector{2}}}};
  Parts parts = parts_of(s);
  ASSERT_EQ(parts.fits[0].report.edge_kind, EdgeKind::averted);
  EXPECT_TRUE(check_on_plates(parts, 0));
  parts.thickness = 60;  // half of it is more than the gap of 20
  const auto checked = check_on_plates(parts, 0);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, code::plates_touch);
  // In front the bend itself fills the gap.
  Parts facing = parts_of(angle_pair(20));
  facing.thickness = 60;
  EXPECT_TRUE(check_on_plates(facing, 0));
}

}  // namespace
}  // namespace planish::test
