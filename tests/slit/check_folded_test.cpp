#include "sample_sheets.hpp"

#include <planish/sheet/codes.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <functional>
#include <limits>

namespace planish::test {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Two strips of two quads beside each other in the plane z = 0, leaving a panel of one facet.
FoldedSlitSheet two_strips() {
  FoldedSlitSheet sheet;
  sheet.thickness = 2.0;
  sheet.reach = 100.0;
  sheet.symmetric = false;
  PanelFacet facet;
  facet.frame = Frame{};
  facet.corners = {Vec2(-50, 0), Vec2(0, 0), Vec2(0, 40), Vec2(-50, 40)};
  facet.strip = 1;
  sheet.panel = {facet};
  for (const double y : {0.0, 20.0}) {
    FoldedStrip strip;
    for (const double x : {0.0, 30.0, 60.0})
      strip.ridges.push_back(
          {{Vec2(x, y), Vec2(x, y + 20)}, {Vec3(x, y, 0), Vec3(x, y + 20, 0)}, {}});
    strip.quads = {Frame{}, Frame{}};
    sheet.strips.push_back(strip);
  }
  return sheet;
}

using Change = std::function<void(FoldedSlitSheet&)>;

/// Where a changed sheet is refused; empty if it is not.
std::string refused_where(const Change& change) {
  FoldedSlitSheet sheet = two_strips();
  change(sheet);
  const auto sound = check(sheet);
  if (sound) return "";
  EXPECT_EQ(sound.error().code, code::invalid_sheet) << sound.error().message;
  return sound.error().where;
}

TEST(FoldedSlitSheet, IsSoundAsItIsMade) {
  EXPECT_EQ(refused_where([](FoldedSlitSheet&) {}), "");
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) { s.panel[0].strip = -1; }), "")
      << "a facet between strips";
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) { s.second_panel = s.panel; }), "");
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) { s.symmetric = true; }), "");
  EXPECT_TRUE(check(solved(chair()).folded()));
  EXPECT_TRUE(check(solved(asymmetric()).folded()));
}

TEST(FoldedSlitSheet, HasAThicknessAndAReach) {
  for (const double wrong : {0.0, -1.0, kUnbounded, std::nan("")})
    EXPECT_EQ(refused_where([&](FoldedSlitSheet& s) { s.thickness = wrong; }), "sheet") << wrong;
  for (const double wrong : {kUnbounded, std::nan("")})
    EXPECT_EQ(refused_where([&](FoldedSlitSheet& s) { s.reach = wrong; }), "sheet") << wrong;
}

TEST(FoldedSlitSheet, HasFinitePanelsOfStripsThatAreThere) {
  for (const bool second : {false, true}) {
    const std::string where = second ? "second panel facet 0" : "panel facet 0";
    const auto refused = [&](const std::function<void(PanelFacet&)>& change) {
      return refused_where([&](FoldedSlitSheet& s) {
        if (second) s.second_panel = s.panel;
        change(second ? s.second_panel[0] : s.panel[0]);
      });
    };
    EXPECT_EQ(refused([](PanelFacet& f) { f.strip = -2; }), where);
    EXPECT_EQ(refused([](PanelFacet& f) { f.strip = 2; }), where);
    for (const int corner : {0, 3})
      EXPECT_EQ(refused([&](PanelFacet& f) { f.corners[corner].y() = std::nan(""); }), where);
    for (Vec3 Frame::*part : {&Frame::origin, &Frame::x, &Frame::y, &Frame::z})
      EXPECT_EQ(refused([&](PanelFacet& f) { (f.frame.*part).z() = kUnbounded; }), where);
  }
}

TEST(FoldedSlitSheet, OfAMirroredHalfHasOnePanel) {
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) {
              s.symmetric = true;
              s.second_panel = s.panel;
            }),
            "second panel");
}

TEST(FoldedSlitSheet, HasARidgeBeforeAndAfterEachQuad) {
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) { s.strips[1].ridges.pop_back(); }), "strip 1");
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) { s.strips[0].quads.pop_back(); }), "strip 0");
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) {
              s.strips[0].quads.clear();
              s.strips[0].ridges.resize(1);
            }),
            "strip 0");
}

TEST(FoldedSlitSheet, HasFiniteStrips) {
  for (const int side : {0, 1}) {
    EXPECT_EQ(refused_where(
                  [&](FoldedSlitSheet& s) { s.strips[1].ridges[2].flat[side].x() = kUnbounded; }),
              "strip 1");
    EXPECT_EQ(refused_where(
                  [&](FoldedSlitSheet& s) { s.strips[1].ridges[0].folded[side].z() = kUnbounded; }),
              "strip 1");
  }
  EXPECT_EQ(refused_where([](FoldedSlitSheet& s) {
              s.strips[0].ridges[1].fold = Angle::radians(std::nan(""));
            }),
            "strip 0");
  for (Vec3 Frame::*part : {&Frame::origin, &Frame::x, &Frame::y, &Frame::z})
    EXPECT_EQ(
        refused_where([&](FoldedSlitSheet& s) { (s.strips[1].quads[1].*part).x() = std::nan(""); }),
        "strip 1");
}

TEST(FoldedSlitSheet, NamesTheStripAsAPlace) {
  FoldedSlitSheet sheet = two_strips();
  sheet.strips[1].ridges.pop_back();
  const auto sound = check(sheet);
  ASSERT_FALSE(sound);
  ASSERT_FALSE(sound.error().places.empty());
  EXPECT_EQ(sound.error().places[0], place::strip(1));
}

TEST(FoldedSlitSheet, StopsWhatNeedsASoundOne) {
  FoldedSlitSheet sheet = two_strips();
  require_valid(sheet);
  sheet.thickness = 0.0;
  EXPECT_DEATH(require_valid(sheet), "sheet");
}

}  // namespace
}  // namespace planish::test
