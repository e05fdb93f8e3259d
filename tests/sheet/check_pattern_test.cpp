#include "support/sheets.hpp"

#include <planish/sheet/certificate.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/facets.hpp>
#include <planish/sheet/topology.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace planish::test {
namespace {

/// One broken rule of `check` for patterns.
struct PatternDamage {
  std::string rule, where;
  Place place;
  std::function<void(FlatPattern&)> inflict;
};

std::vector<PatternDamage> pattern_damages() {
  const double nan = std::nan("");
  return {
      {"thickness", "pattern", place::pointer(""), [](FlatPattern& p) { p.thickness = -1.0; }},
      {"Area, perimeter", "pattern", place::pointer(""), [=](FlatPattern& p) { p.area = nan; }},
      {"Area, perimeter", "pattern", place::pointer(""), [](FlatPattern& p) { p.closure = -1.0; }},
      {"has curves", "opening 0", place::pointer("/openings/0"),
       [](FlatPattern& p) { p.openings.push_back({}); }},
      {"finite size", "outer contour", place::pointer("/outer"),
       [](FlatPattern& p) { p.outer.loop[0] = CubicSpline{}; }},
      {"finite size", "opening 0", place::pointer("/openings/0"),
       [](FlatPattern& p) {
         p.openings.push_back({{Arc{{5, 5}, 0.0, 0.0, 6.0}}, {}});
       }},
      {"finite size", "opening 0", place::pointer("/openings/0"),
       [](FlatPattern& p) {
         p.openings.push_back({{Arc{{5, 5}, 1.0, 0.0, 1e9}}, {}});
       }},
      {"Slits", "slits", place::pointer("/slits"),
       [=](FlatPattern& p) {
         p.slits.push_back(Segment{{0, nan}, {1, 1}});
       }},
      {"lines of a bend", "bend B1", place::bend("B1"),
       [=](FlatPattern& p) { p.bends[0].lines[0].a.x() = nan; }},
      {"has its angle", "bend B1", place::bend("B1"),
       [](FlatPattern& p) { p.bends[0].line_angles.resize(7); }},
      {"Angle, inside radius", "bend B2", place::bend("B2"),
       [=](FlatPattern& p) { p.bends[1].length = nan; }},
      {"finite size", "feature 0", place::pointer("/features/0"),
       [](FlatPattern& p) {
         p.features.push_back({"pocket", FormSide::up, {{CubicSpline{}}}});
       }},
      {"label", "label A", place::pointer("/labels/0"),
       [=](FlatPattern& p) {
         p.labels.push_back({{nan, 0}, "A"});
       }},
  };
}

FlatPattern sound() { return flatten(u_channel()).value(); }

TEST(CheckPattern, FindsNothingWrongWithSoundPatterns) {
  for (const Sheet& sheet : {l_bracket(), u_channel(), cone_joined(), hem(), plate_with_holes()})
    EXPECT_TRUE(check(flatten(sheet).value()));
}

TEST(CheckPattern, NamesTheRuleAndTheRow) {
  for (const PatternDamage& damage : pattern_damages()) {
    FlatPattern pattern = sound();
    damage.inflict(pattern);
    const auto result = check(pattern);
    ASSERT_FALSE(result) << damage.rule;
    EXPECT_EQ(result.error().code, code::invalid_sheet);
    EXPECT_NE(result.error().message.find(damage.rule), std::string::npos)
        << result.error().message << " instead of: " << damage.rule;
    EXPECT_EQ(result.error().where, damage.where);
    ASSERT_EQ(result.error().places.size(), 1u);
    EXPECT_EQ(result.error().places[0], damage.place);
  }
}

TEST(CheckPattern, StandsBeforeTheCertificate) {
  const EdgeDistance none = [](int, const Vec3&) { return 0.0; };
  for (const PatternDamage& damage : pattern_damages()) {
    FlatPattern pattern = sound();
    damage.inflict(pattern);
    const auto result = certify(u_channel(), pattern, none);
    ASSERT_FALSE(result) << damage.rule;
    EXPECT_TRUE(result.error().code == code::invalid_sheet ||
                result.error().code == code::pattern_wrong)
        << damage.rule;
  }
}

TEST(Certify, RefusesARootOrAToleranceThatMeansNothing) {
  const EdgeDistance none = [](int, const Vec3&) { return 0.0; };
  FlatPattern pattern = sound();
  for (const double tolerance : {0.0, -1.0, std::nan("")})
    EXPECT_EQ(certify(u_channel(), pattern, none, tolerance).error().code, code::bad_option);
  pattern.root = FaceId{99};
  EXPECT_EQ(certify(u_channel(), pattern, none).error().code, code::pattern_wrong);
}

TEST(RequireValid, StopsWithTheRuleAndTheRow) {
  Sheet sheet = u_channel();
  sheet.flanges.clear();
  EXPECT_DEATH(require_valid(sheet), "face 0: A face names a flange or bend");
  FlatPattern pattern = sound();
  pattern.openings.push_back({});
  EXPECT_DEATH(require_valid(pattern), "opening 0: A contour has curves");
}

TEST(FacetsOf, StopAtASheetALayoutOrAShareThatIsNone) {
  const Sheet sheet = u_channel();
  const FlatSheet flat = flat_sheet(sheet).value();
  Sheet broken = sheet;
  broken.bends.clear();
  EXPECT_DEATH(facets_of(broken, flat.layout), "names a flange or bend");
  Layout layout = flat.layout;
  layout.tree[0] = 99;
  EXPECT_DEATH(facets_of(sheet, layout), "joint >= 0");
  EXPECT_DEATH(folded(facets_of(sheet, flat.layout), std::nan("")), "isfinite");
}

TEST(LayoutImage, StopsAtABorderThatTheFaceDoesNotHave) {
  const Layout layout = flat_sheet(u_channel()).value().layout;
  for (const BorderRef& ref :
       {BorderRef{FaceId{0}, 0, -1}, BorderRef{FaceId{0}, 0, 99}, BorderRef{FaceId{0}, -1, 0}})
    EXPECT_DEATH((void)layout.image(ref), "ref.loop");
}

TEST(TopologyOfASheet, StopsAtNodesThatItDoesNotHave) {
  const Topology topology(u_channel());
  EXPECT_DEATH((void)topology.joints_of(99), "node");
  EXPECT_DEATH((void)topology.node_of(PartId(BendId{99})), "row");
  EXPECT_DEATH((void)topology.node_of(PartId(FlangeId{-1})), "row");
}

}  // namespace
}  // namespace planish::test
