#include "taken_shop.hpp"

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
  EXPECT_EQ(request.density, 7.8) << "brass says none";
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
