#include "materials.hpp"

#include <gtest/gtest.h>

namespace planish::pack {
namespace {

TEST(NamePatterns, StandForNames) {
  EXPECT_TRUE(fits("leg", "LEG"));
  EXPECT_FALSE(fits("leg", "leg 2"));
  EXPECT_TRUE(fits("leg*", "leg 2"));
  EXPECT_TRUE(fits("leg ?", "Leg 2"));
  EXPECT_FALSE(fits("leg ?", "leg 12"));
  EXPECT_TRUE(fits("*panel*", "side panel left"));
  EXPECT_TRUE(fits("*", ""));
  EXPECT_FALSE(fits("?", ""));
  // A star that took too little takes more.
  EXPECT_TRUE(fits("a*b*c", "a-b-bc-c"));
  EXPECT_FALSE(fits("a*b*c", "a-b-bc-d"));
  EXPECT_TRUE(fits("**x", "yx"));
}

TEST(Materials, AreThoseOfTheFirstRowThatFits) {
  const auto materials = Materials::parse(
      {"steel.csv", "Material;Part;Density (kg/dm³)\nS235;leg*;7.85\noak;*;\n"});
  ASSERT_TRUE(materials) << materials.error().message;
  ASSERT_NE(materials->find({"Leg 1"}, ""), nullptr);
  EXPECT_EQ(materials->find({"Leg 1"}, "")->material, "S235");
  EXPECT_EQ(materials->find({"Leg 1"}, "")->density, 7.85);
  EXPECT_EQ(materials->find({"seat"}, "")->material, "oak");
  EXPECT_EQ(materials->find({"seat"}, "")->density, std::nullopt);
}

TEST(Materials, MayLeavePartsOut) {
  const auto materials = Materials::parse({"steel.csv", "part,material\nleg,S235\n"});
  ASSERT_TRUE(materials);
  EXPECT_EQ(materials->find({"seat"}, ""), nullptr);
}

TEST(Materials, MayBeSaidByColour) {
  const auto materials = Materials::parse(
      {"m.csv", "colour,material,part\nFF8000,brass,\n\"#c0c0c0\",DC01,leg*\n,S235,leg*\n"});
  ASSERT_TRUE(materials) << materials.error().message;
  EXPECT_EQ(materials->find({"seat"}, "#ff8000")->material, "brass");
  EXPECT_EQ(materials->find({"seat", "leg 1"}, "#c0c0c0")->material, "DC01");
  EXPECT_EQ(materials->find({"leg 1"}, "")->material, "S235");
  EXPECT_EQ(materials->find({"seat"}, "#c0c0c0"), nullptr);
}

TEST(Materials, SayWhereTheyAreWrong) {
  const auto where = [](const std::string& text) {
    const auto materials = Materials::parse({"m.csv", text});
    if (materials) return std::string("read");
    EXPECT_EQ(materials.error().code, code::invalid_input);
    return materials.error().where;
  };
  EXPECT_EQ(where("part,thickness\n"), "m.csv:1");
  EXPECT_EQ(where("part,material\n\nleg,\n"), "m.csv:3");
  EXPECT_EQ(where("part,material,density\nleg,S235,0\n"), "m.csv:2");
  EXPECT_EQ(where("colour,material\nred,S235\n"), "m.csv:2");
  EXPECT_EQ(where("part,colour,material\n,,S235\n"), "m.csv:2");
  EXPECT_EQ(where(""), "m.csv:1");
}

}  // namespace
}  // namespace planish::pack
