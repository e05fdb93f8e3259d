#include "taken_shop.hpp"

#include <planish/base/text.hpp>

#include <gtest/gtest.h>

namespace planish::job {
using namespace shop;
namespace {

Shop two_metals() {
  Shop shop;
  shop.materials = {{.name = "Steel", .density = 7.8, .tensile_strength = 500.0, .gauges = {}},
                    {.name = "brass", .density = {}, .tensile_strength = {}, .gauges = {}}};
  return shop;
}

TEST(TakenShop, PutsWhatItSaysIntoTheRequest) {
  Shop shop = two_metals();
  shop.profile = LayerProfile::onshape;
  shop.release = DxfVersion::r12;
  shop.layers = LayerNames{};
  shop.layers->outer = "CUT";
  shop.rules = {{&Rules::opening_to_bend_t, 3.0}, {&Rules::k_low, 0.1}};
  shop.strict = true;
  shop.tools = BrakeTools{};
  shop.tools->machine.name = "ours";
  Request request;
  take_shop(request, shop);
  EXPECT_EQ(request.dxf.profile, LayerProfile::onshape);
  EXPECT_EQ(request.dxf.version, DxfVersion::r12);
  EXPECT_EQ(request.dxf.layers->outer, "CUT");
  EXPECT_EQ(request.rules.opening_to_bend_t, 3.0);
  EXPECT_EQ(request.rules.k_low, 0.1);
  EXPECT_EQ(request.rules.k_high, Rules{}.k_high);
  EXPECT_TRUE(request.rules.strict);
  EXPECT_EQ(request.bending.tools->machine.name, "ours");
  EXPECT_FALSE(request.shop->material) << "it has two";
  EXPECT_FALSE(request.density);
}

TEST(TakenShop, LeavesAloneWhatItDoesNotSay) {
  Request request;
  request.dxf.profile = LayerProfile::inventor;
  request.rules.strict = true;
  request.bending.tools = BrakeTools{};
  take_shop(request, two_metals());
  EXPECT_EQ(request.dxf.profile, LayerProfile::inventor);
  EXPECT_TRUE(request.rules.strict);
  EXPECT_TRUE(request.bending.tools);
  EXPECT_FALSE(request.dxf.layers);
}

TEST(TakenShop, TakesTheOnlyMaterial) {
  Shop shop = two_metals();
  shop.materials.pop_back();
  Request request;
  take_shop(request, shop);
  EXPECT_EQ(request.shop->material, 0);
  EXPECT_EQ(request.density, 7.8);
  EXPECT_EQ(request.bending.plan.tensile_strength, 500.0);
  EXPECT_FALSE(unchosen(request));
}

TEST(TakenShop, FindsMaterialsInUpperAndLowerCase) {
  Request request;
  take_shop(request, two_metals());
  EXPECT_FALSE(take_material(request, "stee"));
  EXPECT_FALSE(take_material(request, "steel2"));
  EXPECT_FALSE(request.shop->material);
  EXPECT_TRUE(take_material(request, "sTEEL"));
  EXPECT_EQ(request.shop->material, 0);
  EXPECT_TRUE(take_material(request, "BRASS"));
  EXPECT_EQ(request.shop->material, 1);
  EXPECT_FALSE(request.density) << "brass says none, and steel's is not its own";
  // Letters alone have two cases: '{' is no '['.
  request.shop->shop.materials[0].name = "a[";
  EXPECT_FALSE(take_material(request, "a{"));
  EXPECT_TRUE(take_material(request, "A["));
}

TEST(TakenShop, GivesWayToOptions) {
  Request request;
  take_shop(request, two_metals());
  request.density = 1.0;
  request.bending.plan.tensile_strength = 2.0;
  request.shop->density_given = true;
  EXPECT_TRUE(take_material(request, "steel"));
  EXPECT_EQ(request.density, 1.0);
  EXPECT_EQ(request.bending.plan.tensile_strength, 500.0);
  request.shop->density_given = false;
  request.shop->strength_given = true;
  request.bending.plan.tensile_strength = 2.0;
  EXPECT_TRUE(take_material(request, "steel"));
  EXPECT_EQ(request.density, 7.8);
  EXPECT_EQ(request.bending.plan.tensile_strength, 2.0);
}

/// A request with a shop of two metals and a list.
Request listed(const std::string& rows) {
  Request request;
  request.input = "in/Bracket.step";
  take_shop(request, two_metals());
  request.materials = PartMaterials::parse("part;material;density;quantity\n" + rows, "m.csv")
                          .value();
  return request;
}

TEST(TakenShop, TakesTheMaterialThatAListSaysOfThePart) {
  const Request request = listed("leg*;Brass;8.5;20\nbracket;STEEL;;\n");
  Report leg;
  leg.body = "Leg 1";
  leg.quantity = 4;
  leg.material = "oak";
  leg.density = 0.7;
  const auto mine = request_of_part(request, leg);
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_EQ(mine->shop->chosen().name, "brass");
  EXPECT_EQ(leg.material, "brass") << "as the shop spells it";
  EXPECT_EQ(leg.quantity, 20);
  EXPECT_EQ(mine->density, 8.5);
  EXPECT_FALSE(leg.density) << "that of the file is oak's";
  Report seat;
  seat.body = "seat";
  ASSERT_TRUE(request_of_part(request, seat)) << "called as its file";
  EXPECT_EQ(seat.material, "Steel");
  EXPECT_EQ(seat.quantity, 1);
  ASSERT_TRUE(request_of_part(listed("bracket.step;brass;;\n"), seat));
  EXPECT_EQ(seat.material, "brass") << "called as its file, suffix and all";
}

TEST(TakenShop, TakesTheMaterialForAllWhereAListSaysNothing) {
  Request request = listed("leg;brass;;\n");
  Report seat;
  seat.material = "Steel";
  EXPECT_EQ(request_of_part(request, seat)->shop->material, 0) << "as its file says";
  seat.material.clear();
  EXPECT_EQ(request_of_part(request, seat).error().code, code::bad_option);
  ASSERT_TRUE(take_material(request, "steel"));
  request.material = "Steel";
  EXPECT_EQ(request_of_part(request, seat)->shop->material, 0);
  EXPECT_EQ(seat.material, "Steel");
  Report leg;
  leg.body = "leg";
  EXPECT_EQ(request_of_part(request, leg)->shop->material, 1);
}

TEST(TakenShop, KeepsTheCurvesOfAMaterialToItsParts) {
  Request request;
  request.materials = PartMaterials::parse("part,material\nleg,brass\nseat,dc04\n", "m.csv")
                          .value();
  request.allowance = MaterialCurves{"DC04", {}, {}};
  request.material = "DC04";
  for (const auto& [body, curves] : {std::pair{"leg", false}, {"seat", true}, {"back", true}}) {
    Report part;
    part.body = body;
    EXPECT_EQ(request_of_part(request, part)->allowance.has_value(), curves) << body;
    EXPECT_EQ(lower_case(part.material), curves ? "dc04" : "brass") << body;
  }
}

TEST(TakenShop, RefusesAListWithWhatItDoesNotStock) {
  EXPECT_FALSE(unstocked(listed("leg;brass;;\n")));
  const auto wrong = unstocked(listed("leg;brass;;\nseat;oak;;\n"));
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->code, code::bad_option);
  EXPECT_EQ(wrong->where, "materials");
  EXPECT_NE(wrong->message.find("m.csv, line 3"), std::string::npos) << wrong->message;
  EXPECT_NE(wrong->message.find("oak"), std::string::npos);
}

TEST(TakenShop, AsksForAMaterialWhereThereAreSeveral) {
  Request request;
  EXPECT_FALSE(unchosen(request)) << "there is no shop";
  take_shop(request, two_metals());
  for (const std::string of_file : {"", "wood"}) {
    const auto error = unchosen(request, of_file);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, code::bad_option);
    EXPECT_EQ(error->where, "material");
    EXPECT_NE(error->message.find("Steel"), std::string::npos);
    EXPECT_EQ(error->message.find("wood") != std::string::npos, !of_file.empty());
  }
}

}  // namespace
}  // namespace planish::job
