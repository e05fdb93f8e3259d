#include "drawn_forms.hpp"

#include "support/unfolded_shape.hpp"

#include <planish/geometry/region.hpp>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Panels of round dimples: caps of balls about one middle, a thickness apart. Their volume is that
// of the panel and of caps, and a pattern is the panel with its holes.

namespace planish::test {
namespace {

using std::numbers::pi;

constexpr double kDimplePitch = 20, kDimpleColumns = 4, kDimpleRows = 3, kDimpleThickness = 1,
                 kDimpleFoot = 8;
constexpr double kDimplePanel = kDimpleColumns * kDimpleRows * kDimplePitch * kDimplePitch;

TopoDS_Shape cuboid_of_panel(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

struct Dimples {
  double depth = 4;
  bool hollow = true;
  double radius() const { return (kDimpleFoot * kDimpleFoot + depth * depth) / (2 * depth); }
  double middle() const { return kDimpleThickness + depth - radius(); }
};

TopoDS_Shape dimpled(const Dimples& of) {
  TopoDS_Shape panel = cuboid_of_panel(
      {0, 0, 0}, {kDimpleColumns * kDimplePitch, kDimpleRows * kDimplePitch, kDimpleThickness});
  const auto cap = [&](const gp_Pnt& middle, double radius, double from) {
    const TopoDS_Shape above = cuboid_of_panel({middle.X() - 10, middle.Y() - 10, from},
                                               {middle.X() + 10, middle.Y() + 10, 40});
    return BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(middle, radius).Shape(), above).Shape();
  };
  for (double x = kDimplePitch / 2; x < kDimpleColumns * kDimplePitch; x += kDimplePitch)
    for (double y = kDimplePitch / 2; y < kDimpleRows * kDimplePitch; y += kDimplePitch) {
      const gp_Pnt middle(x, y, of.middle());
      panel = BRepAlgoAPI_Fuse(panel, cap(middle, of.radius(), kDimpleThickness)).Shape();
      if (of.hollow)
        panel = BRepAlgoAPI_Cut(panel, cap(middle, of.radius() - kDimpleThickness, -1)).Shape();
    }
  return panel;
}

/// Of a ball above a plane at that height over its middle.
double cap_volume(double radius, double height) {
  const double high = radius - height;
  return pi * high * high * (3 * radius - high) / 3;
}

/// Volume of all dimples beyond the panel, as a share of the panel's.
double excess(const Dimples& of) {
  const double dome = cap_volume(of.radius(), kDimpleThickness - of.middle());
  const double hollow = cap_volume(of.radius() - kDimpleThickness, -of.middle());
  return kDimpleColumns * kDimpleRows * (dome - hollow) / (kDimplePanel * kDimpleThickness);
}

TEST(DrawnForms, OfAPanelOfDimplesAreOutlinedWhateverTheyAddToItsVolume) {
  for (const double depth : {2.0, 4.0, 6.0}) {
    const Dimples of{depth};
    const auto made = unfolded_shape(dimpled(of));
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_NEAR(made->flat.area, kDimplePanel, 1e-6);
    EXPECT_EQ(made->flat.features.size(), std::size_t(kDimpleColumns * kDimpleRows));
    for (const FlatFeature& feature : made->flat.features)
      EXPECT_EQ(feature.kind, "formed");
    EXPECT_TRUE(made->flat.openings.empty());
    EXPECT_NEAR(1 / made->certificate.volume_ratio.value_or(0), 1 + excess(of), 1e-6);
    EXPECT_NEAR(made->certificate.explained_ratio.value_or(0), 1, 1e-6);
  }
  EXPECT_GT(excess({4.0}), 0.1);
  EXPECT_GT(excess({6.0}), 0.25);
}

TEST(DrawnForms, HideNoHoleThatIsWrong) {
  TopoDS_Shape panel = dimpled({6.0});
  for (const double x : {20.0, 40.0, 60.0}) {
    const gp_Ax2 axis(gp_Pnt(x, 20, -1), gp_Dir(0, 0, 1));
    panel = BRepAlgoAPI_Cut(panel, BRepPrimAPI_MakeCylinder(axis, 1.5, 3).Shape()).Shape();
  }
  const auto made = unfolded_shape(panel);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(made->flat.area, kDimplePanel - 3 * pi * 2.25, 1e-6);
  EXPECT_LT(made->certificate.opening_error.value_or(1), 1e-9);
  ASSERT_EQ(made->flat.openings.size(), 3u);
  for (Contour wrong : made->flat.openings)
    for (const double by : {-0.1, 0.1}) {  // of the radius
      FlatPattern falsified = made->flat;
      const Box2 size = bounds(wrong.loop);
      for (Contour& opening : falsified.openings)
        if ((bounds(opening.loop).lo - size.lo).norm() < 1e-9)
          opening.loop = scaled(opening.loop, 1 + by / 1.5, (size.lo + size.hi) / 2);
      const auto noticed = certify(made->sheet, falsified, {});
      ASSERT_TRUE(noticed);
      EXPECT_NEAR(noticed->opening_error.value_or(0), 0.1, 0.01);
    }
}

TEST(DrawnForms, AreNoBosses) {
  // Caps of balls without hollows, as many as the dimples: a cast plate.
  EXPECT_FALSE(unfolded_shape(dimpled({4.0, false})));
}

}  // namespace
}  // namespace planish::test
