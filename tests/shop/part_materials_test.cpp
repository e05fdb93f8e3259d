#include <planish/shop/part_materials.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::shop {
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

TEST(PartMaterials, AreThoseOfTheFirstRowThatFits) {
  const auto materials = PartMaterials::parse(
      "Material;Part;Density (kg/dm³)\nS235;leg*;7.85\noak;*;\n", "steel.csv");
  ASSERT_TRUE(materials) << materials.error().message;
  ASSERT_NE(materials->find({"Leg 1"}, ""), nullptr);
  EXPECT_EQ(materials->find({"Leg 1"}, "")->material, "S235");
  EXPECT_EQ(materials->find({"Leg 1"}, "")->density, 7.85);
  EXPECT_EQ(materials->find({"seat"}, "")->material, "oak");
  EXPECT_EQ(materials->find({"seat"}, "")->density, std::nullopt);
}

TEST(PartMaterials, MayLeavePartsOut) {
  const auto materials = PartMaterials::parse("part,material\nleg,S235\n", "steel.csv");
  ASSERT_TRUE(materials);
  EXPECT_EQ(materials->find({"seat"}, ""), nullptr);
}

TEST(PartMaterials, MayBeSaidByColour) {
  const auto materials = PartMaterials::parse(
      "colour,material,part\nFF8000,brass,\n\"#c0c0c0\",DC01,leg*\n,S235,leg*\n", "m.csv");
  ASSERT_TRUE(materials) << materials.error().message;
  EXPECT_EQ(materials->find({"seat"}, "#ff8000")->material, "brass");
  EXPECT_EQ(materials->find({"seat", "leg 1"}, "#c0c0c0")->material, "DC01");
  EXPECT_EQ(materials->find({"leg 1"}, "")->material, "S235");
  EXPECT_EQ(materials->find({"seat"}, "#c0c0c0"), nullptr);
}

TEST(PartMaterials, SayWhereTheyAreWrong) {
  const auto where = [](const std::string& text) {
    const auto materials = PartMaterials::parse(text, "m.csv");
    if (materials) return std::string("read");
    EXPECT_EQ(materials.error().code, code::invalid_input);
    return materials.error().where;
  };
  EXPECT_EQ(where("part,colour\n"), "m.csv:1");
  EXPECT_EQ(where("part,material\n\nleg,\n"), "m.csv:3");
  EXPECT_EQ(where("part,material,density\nleg,S235,0\n"), "m.csv:2");
  EXPECT_EQ(where("colour,material\nred,S235\n"), "m.csv:2");
  EXPECT_EQ(where("part,colour,material\n,,S235\n"), "m.csv:2");
  EXPECT_EQ(where(""), "m.csv:1");
  EXPECT_EQ(where("part,material,quantity\nleg,S235,2.5\n"), "m.csv:2");
  EXPECT_EQ(where("part,material,quantity\nleg,S235,0\n"), "m.csv:2");
  EXPECT_EQ(where("part,material,quantity\nleg,S235,20 pcs\n"), "m.csv:2");
}

TEST(PartMaterials, SayHowManyAreWanted) {
  const auto materials = PartMaterials::parse(
      "part;material;density;quantity\nleg;S235;7,85;20\nseat;oak;;\n", "m.csv");
  ASSERT_TRUE(materials) << materials.error().message;
  ASSERT_EQ(materials->rows().size(), 2u);
  EXPECT_EQ(materials->rows()[0].quantity, 20);
  EXPECT_EQ(materials->rows()[0].density, 7.85) << "a decimal comma";
  EXPECT_EQ(materials->rows()[0].line, 2);
  EXPECT_EQ(materials->rows()[1].quantity, std::nullopt);
}

TEST(PartMaterials, RefuseWhatNobodyReads) {
  const auto message = [](const std::string& text) {
    const auto materials = PartMaterials::parse(text, "m.csv");
    if (materials) return std::string("read");
    EXPECT_EQ(materials.error().code, code::invalid_input);
    EXPECT_EQ(materials.error().places.size(), 1u) << "the line";
    return materials.error().message;
  };
  using testing::AllOf, testing::HasSubstr;
  EXPECT_THAT(message("part,material,qty\nleg,S235,2\n"),
              AllOf(HasSubstr("m.csv, line 1"), HasSubstr("\"qty\""),
                    HasSubstr("part, colour, material, density, quantity")));
  EXPECT_THAT(message("part,material,name\nleg,S235,2\n"), HasSubstr("part is there twice"));
  EXPECT_THAT(message("part,material\nleg,S235\nseat,oak,20\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("\"20\"")));
  EXPECT_EQ(message("part,material,\nleg,S235,\n"), "read") << "a last comma is no column";
}

}  // namespace
}  // namespace planish::shop
