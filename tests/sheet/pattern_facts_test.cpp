#include <planish/sheet/pattern_facts.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

TEST(PatternFacts, HaveAWordForEachKindAndDirection) {
  EXPECT_EQ(kind_name(BendKind::cylinder), "cylinder");
  EXPECT_EQ(kind_name(BendKind::cone), "cone");
  EXPECT_EQ(kind_name(BendKind::general), "general");
  EXPECT_EQ(kind_name(BendKind::sharp), "sharp");
  EXPECT_EQ(direction_name(BendDirection::up), "up");
  EXPECT_EQ(direction_name(BendDirection::down), "down");
}

TEST(PatternFacts, CutSlitsOnceAndOpeningsAllAround) {
  FlatPattern flat;
  flat.outer.loop = {Arc{Vec2(0, 0), 50, 0, 2 * pi}};
  EXPECT_EQ(inner_cutting_length(flat), 0.0);
  flat.openings.push_back({{Arc{Vec2(0, 0), 4, 0, -2 * pi}}, {}});
  flat.openings.push_back({{Arc{Vec2(20, 0), 3, 0, -2 * pi}}, {}});
  EXPECT_NEAR(inner_cutting_length(flat), 14 * pi, 1e-9);
  flat.slits = {Segment{{-30, 0}, {-10, 0}}, Segment{{-30, 5}, {-27, 9}}};
  EXPECT_NEAR(inner_cutting_length(flat), 14 * pi + 25, 1e-9);
  EXPECT_NEAR(outer_cutting_length(flat), 100 * pi, 1e-9);
}

TEST(PatternFacts, CountSlitsOfSeveralCurvesOnce) {
  FlatPattern flat;
  EXPECT_EQ(slit_count(flat), 0);
  flat.slits = {Segment{{0, 0}, {10, 0}}, Segment{{10, 0}, {15, 5}}, Segment{{20, 5}, {30, 5}}};
  EXPECT_EQ(slit_count(flat), 2);
}

TEST(PatternFacts, TakeTheLongestOfABendsLines) {
  FlatBend bend;
  EXPECT_FALSE(longest_line(bend));
  bend.lines = {{{0, 0}, {0, 10}}, {{0, 20}, {9, 32}}, {{0, 40}, {0, 54}}};  // 10, 15, 14
  EXPECT_EQ(longest_line(bend)->a, Vec2(0, 20));
}

FlatFeature feature(const std::string& kind, FormSide side) { return {kind, side, {}}; }

TEST(PatternFacts, CountFormsByKindAndSide) {
  FlatPattern flat;
  EXPECT_EQ(forms_text(flat), "");
  flat.features = {feature("countersink", FormSide::up), feature("pocket", FormSide::down),
                   feature("countersink", FormSide::up), feature("countersink", FormSide::down)};
  EXPECT_EQ(forms_text(flat), "2 countersinks up, 1 countersink down, 1 pocket down");
  flat.features = {feature("formed", FormSide::both), feature("contact", FormSide::both)};
  EXPECT_EQ(forms_text(flat), "1 formed feature") << "a contact is no form";
}

}  // namespace
}  // namespace planish::test
