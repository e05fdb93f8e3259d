#include "reference_skin.hpp"

#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

/// Whether the skin of this face is the reference.
bool is_reference(const SolidModel& model, int face) {
  const auto outlines = outlines_of(model);
  const Skins skins = find_skins(model, outlines, 2, 0.02).value();
  return skins.skin_of[face] == reference_skin(model, outlines, skins);
}

TEST(ReferenceSide, IsTheSkinInOnePiece) {
  // A groove parts the top in two; the bottom is one face.
  const SolidModel model = prism(
      {{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 2}}, Segment{{100, 2}, {61, 2}},
        Segment{{61, 2}, {61, 1}}, Segment{{61, 1}, {60, 1}}, Segment{{60, 1}, {60, 2}},
        Segment{{60, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  EXPECT_TRUE(is_reference(model, 2));
  EXPECT_FALSE(is_reference(model, 4));
}

TEST(ReferenceSide, IsTheInsideOfASharpFold) {
  const SolidModel model = prism(
      {{Segment{{0, 0}, {50, 0}}, Segment{{50, 0}, {50, 30}}, Segment{{50, 30}, {48, 30}},
        Segment{{48, 30}, {48, 2}}, Segment{{48, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  EXPECT_TRUE(is_reference(model, 5));
  EXPECT_FALSE(is_reference(model, 2));
}

TEST(ReferenceSide, IsTheSkinWithTheNarrowerOpenings) {
  const Turned countersink{{30, 30}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}};
  EXPECT_TRUE(is_reference(plate(2, {100, 60}, {countersink}), 0));
  const Turned from_below{{30, 30}, {{2.5, 2}, {2.5, 1.5}, {4, 0}}};
  EXPECT_TRUE(is_reference(plate(2, {100, 60}, {from_below}), 1));
}

/// A plate that is narrower below, by this much all round, and whole there; a pocket is in its top.
SolidModel plate_with_draft(double d) {
  return plate(
      2, {{{rectangle_at({d, d}, {100 - d, 60 - d}), rectangle_at({0, 0}, {100, 60})}, {0, 2}}},
      {{{30, 30}, {{20, 2}, {20, 1.5}, {0, 1.5}}}});
}

TEST(ReferenceSide, IsTheWiderSkinWhateverIsMilledIntoIt) {
  EXPECT_TRUE(is_reference(plate_with_draft(2 * std::tan(std::numbers::pi / 36)), 1));
  EXPECT_TRUE(is_reference(plate_with_draft(1e-4), 0)) << "a rounded outline is not wider";
}

TEST(ReferenceSide, ComparesBendsAtTheirNeutralSurface) {
  // The outside of a bend is longer, but holds no more material: the first skin stays.
  const SolidModel model = prism({strip_profile(2, {{50, std::numbers::pi / 2, 3}, {30}})}, 40);
  const auto outlines = outlines_of(model);
  Skins skins = find_skins(model, outlines, 2, 0.02).value();
  EXPECT_EQ(reference_skin(model, outlines, skins), Skin::first);
  for (Skin& skin : skins.skin_of)
    skin = skin == Skin::first ? Skin::second : skin == Skin::second ? Skin::first : skin;
  EXPECT_EQ(reference_skin(model, outlines, skins), Skin::first);
}

}  // namespace
}  // namespace planish::brep::test
