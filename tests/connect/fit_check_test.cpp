#include "fit_check.hpp"

#include "sample_parts.hpp"
#include "support/error_data.hpp"

#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

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

TEST(CheckRoom, FindsSheetsThatRunIntoEachOther) {
  // Edges at the line where the planes meet, sheets 4 thick: they share a square of 2 × 2.
  EXPECT_TRUE(check_room(parts_of(pair_with_radius(10)), 0));
  Parts parts = parts_of(pair_with_radius(10));
  parts.thickness = 60;  // half of it is more than the gap of 20
  const auto checked = check_room(parts, 0);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, code::plates_touch);
  EXPECT_EQ(number_in(checked.error(), "thickness"), 60);
  EXPECT_EQ(at_in(checked.error(), PlaceKind::point).size(), 3u);
  EXPECT_EQ(at_in(checked.error(), PlaceKind::plate), at_in(checked.error(), PlaceKind::point));
  EXPECT_EQ(ids_in(checked.error(), PlaceKind::plate),
            (std::vector<std::string>{"\"A\"", "\"B\""}));
}

}  // namespace
}  // namespace planish::test
